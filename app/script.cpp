// Reading and playing scripts.
#include "app/script.h"

#include "graph/problem.h"
#include "ui/keys.h"

#include <array>
#include <fstream>
#include <map>
#include <sstream>

namespace fieldwright::app {
namespace {

using Kind = ui::InputEvent::Kind;

constexpr int frames_between_actions = 3;  // hovering and popups need two
constexpr int frames_of_patience = 600;    // for a widget to appear
constexpr int drag_steps = 6;

struct Verb {
    std::size_t fewest_words;
    bool free_text = false;  // the rest of the line is one text
};

const std::map<std::string, Verb, std::less<>>& verbs()
{
    static const std::map<std::string, Verb, std::less<>> known = {
        {"click", {1}},      {"double_click", {1}}, {"right_click", {1}}, {"move", {1}},       {"drag", {3}},
        {"connect", {2}},    {"wheel", {2}},        {"key", {1}},         {"type", {1, true}}, {"settle", {0}},
        {"screenshot", {1}}, {"drop", {1}},         {"resize", {1}},      {"quit", {0}}};
    return known;
}

std::map<std::string, int, std::less<>> all_key_names()
{
    namespace key = ui::key;
    std::map<std::string, int, std::less<>> names = {
        {"space", key::space},
        {"enter", key::enter},
        {"escape", key::escape},
        {"tab", key::tab},
        {"backspace", key::backspace},
        {"insert", key::insert},
        {"delete", key::del},
        {"home", key::home},
        {"end", key::end},
        {"page_up", key::page_up},
        {"page_down", key::page_down},
        {"left", key::left},
        {"right", key::right},
        {"up", key::up},
        {"down", key::down},
        {"apostrophe", key::apostrophe},
        {"comma", key::comma},
        {"minus", key::minus},
        {"period", key::period},
        {"slash", key::slash},
        {"equal", key::equal},
        {"left_bracket", key::left_bracket},
        {"right_bracket", key::right_bracket},
        {"backquote", key::backquote},
        {"keypad_decimal", key::keypad_decimal},
        {"keypad_enter", key::keypad_enter},
    };
    for (char letter = 'a'; letter <= 'z'; ++letter) names[std::string(1, letter)] = key::a + letter - 'a';
    for (int digit = 0; digit <= 9; ++digit) {
        names[std::to_string(digit)] = key::zero + digit;
        names["keypad_" + std::to_string(digit)] = key::keypad_0 + digit;
    }
    for (int number = 1; number <= 12; ++number) names["f" + std::to_string(number)] = key::f1 + number - 1;
    return names;
}

const std::map<std::string, int, std::less<>>& key_names()
{
    static const std::map<std::string, int, std::less<>> names = all_key_names();
    return names;
}

// Of UTF-8; empty when it is not.
std::vector<int> code_points(std::string_view text)
{
    constexpr std::array<int, 5> lowest = {0, 0, 0x80, 0x800, 0x10000};  // by length: shorter would do for less
    std::vector<int> points;
    while (!text.empty()) {
        auto first = static_cast<unsigned char>(text[0]);
        int length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
        if (length == 0 || text.size() < static_cast<std::size_t>(length)) return {};
        int point = length == 1 ? first : first & (0x7f >> length);
        for (int i = 1; i < length; ++i) {
            auto next = static_cast<unsigned char>(text[static_cast<std::size_t>(i)]);
            if (next >> 6 != 2) return {};
            point = point << 6 | (next & 0x3f);
        }
        if (point < lowest[static_cast<std::size_t>(length)] || point > 0x10ffff || point >> 11 == 0x1b) return {};
        points.push_back(point);
        text.remove_prefix(static_cast<std::size_t>(length));
    }
    return points;
}

void push_button(ui::InputQueue& input, int button, bool down)
{
    input.push({.kind = Kind::button, .code = button, .down = down});
}

void click(ui::InputQueue& input, glm::vec2 at, int button)
{
    input.push({.kind = Kind::move, .at = at});
    push_button(input, button, true);
    push_button(input, button, false);
}

void press(ui::InputQueue& input, const KeyChord& chord)
{
    const std::array<std::pair<bool, int>, 3> modifiers = {
        {{chord.control, ui::key::left_control}, {chord.shift, ui::key::left_shift}, {chord.alt, ui::key::left_alt}}};
    auto modify = [&](bool down) {
        for (auto [wanted, code] : modifiers)
            if (wanted) input.push({.kind = Kind::key, .code = code, .down = down});
    };
    modify(true);
    input.push({.kind = Kind::key, .code = chord.key, .down = true});
    input.push({.kind = Kind::key, .code = chord.key, .down = false});
    modify(false);
}

}  // namespace

std::optional<KeyChord> parse_key_chord(std::string_view text)
{
    KeyChord chord;
    for (std::size_t plus; (plus = text.find('+')) != text.npos && plus > 0; text.remove_prefix(plus + 1)) {
        std::string_view modifier = text.substr(0, plus);
        if (modifier == "ctrl") chord.control = true;
        else if (modifier == "shift") chord.shift = true;
        else if (modifier == "alt") chord.alt = true;
        else return std::nullopt;
    }
    auto found = key_names().find(text);
    if (found == key_names().end()) return std::nullopt;
    chord.key = found->second;
    return chord;
}

Script::Script(const std::filesystem::path& file) : name_(file.filename().string())
{
    std::ifstream lines(file);
    if (!lines) throw graph::Failure(2, "the script " + file.string() + " cannot be read; check the path");
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (!line.empty() && line[0] != '#') actions_.push_back(parse(line, number));
    }
}

Script::Action Script::parse(const std::string& line, int number) const
{
    Action action{.line = number, .verb = {}, .words = {}, .rest = {}};
    std::istringstream words(line);
    words >> action.verb;
    for (std::string word; words >> word;) action.words.push_back(word);
    std::size_t start = line.find(' ');
    if (start != line.npos) action.rest = line.substr(start + 1);
    auto verb = verbs().find(action.verb);
    if (verb == verbs().end()) fail(action, "`" + action.verb + "` is not an action", 2);
    if (action.words.size() < verb->second.fewest_words) fail(action, "`" + action.verb + "` needs more words", 2);
    if (action.verb == "type" && code_points(action.rest).empty()) fail(action, "the text is not UTF-8", 2);
    if (action.verb == "key" && !parse_key_chord(action.words[0]))
        fail(action, "`" + action.words[0] + "` is not a key", 2);
    return action;
}

void Script::fail(const Action& action, const std::string& what, int code) const
{
    throw graph::Failure(code, name_ + ":" + std::to_string(action.line) + ": " + what);
}

std::optional<glm::vec2> Script::place(const std::string& widget, const Stage& stage) const
{
    auto rect = stage.rects.find(widget);
    if (!rect) return std::nullopt;
    return rect->centre();
}

void Script::play(Stage& stage)
{
    quiet_ = stage.input.empty() ? quiet_ + 1 : 0;
    if (finished() || quiet_ < (actions_.front().verb == "resize" ? 1 : frames_between_actions)) return;
    const Action& action = actions_.front();
    if (!perform(action, stage)) {
        if (++patience_ > frames_of_patience && action.verb != "settle")
            fail(action, "the widget of `" + action.verb + " " + action.rest + "` does not appear", 1);
        return;
    }
    actions_.pop_front();
    patience_ = quiet_ = 0;
}

// Whether it was done; else it is tried again in the next frame.
bool Script::perform(const Action& action, Stage& stage)
{
    const std::string& verb = action.verb;
    if (verb == "settle") return stage.settled;
    if (verb == "quit") return stage.quit(), true;
    if (verb == "screenshot") return stage.take_screenshot(action.words[0]), true;
    if (verb == "drop") return stage.drop(action.words[0]), true;
    if (verb == "type") {
        for (int letter : code_points(action.rest)) stage.input.push({.kind = Kind::character, .code = letter});
        return true;
    }
    if (verb == "key") return press(stage.input, *parse_key_chord(action.words[0])), true;
    if (verb == "resize") {
        glm::ivec2 size{0, 0};
        char cross = 0;
        std::istringstream(action.words[0]) >> size.x >> cross >> size.y;
        if (size.x < 1 || size.y < 1 || cross != 'x') fail(action, "a size is written WIDTHxHEIGHT", 2);
        return stage.resize(size), true;
    }
    auto at = place(action.words[0], stage);
    if (!at) return false;
    if (verb == "move") stage.input.push({.kind = Kind::move, .at = *at});
    if (verb == "click") click(stage.input, *at, 0);
    if (verb == "right_click") click(stage.input, *at, 1);
    if (verb == "double_click") click(stage.input, *at, 0), click(stage.input, *at, 0);
    if (verb == "drag") drag(*at, *at + glm::vec2(std::stof(action.words[1]), std::stof(action.words[2])), stage.input);
    if (verb == "connect") {
        auto target = place(action.words[1], stage);
        if (!target) return false;
        drag(*at, *target, stage.input);
    }
    if (verb == "wheel") {
        stage.input.push({.kind = Kind::move, .at = *at});
        stage.input.push({.kind = Kind::wheel, .at = {0, std::stof(action.words[1])}});
    }
    return true;
}

// The queue merges moves that follow each other, so the way is told in frames of its own: a wheel of zero stands between.
void Script::drag(glm::vec2 from, glm::vec2 to, ui::InputQueue& input)
{
    input.push({.kind = Kind::move, .at = from});
    push_button(input, 0, true);
    for (int i = 1; i <= drag_steps; ++i) {
        input.push({.kind = Kind::move, .at = from + (to - from) * (static_cast<float>(i) / drag_steps)});
        input.push({.kind = Kind::wheel, .at = {0, 0}});
    }
    push_button(input, 0, false);
}

}  // namespace fieldwright::app

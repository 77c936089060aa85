// The strict JSON reader: nlohmann's parser drives a handler that builds the tree and keeps the limits.
#include "graph/json.h"

#include "graph/problem.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace fieldwright::graph {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_word(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
           c == '+' || c == '.';
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::string path_step(std::string_view key)
{
    bool plain = !key.empty() && key.size() <= 64 &&
                 std::all_of(key.begin(), key.end(), [](char c) { return is_word(c) || c == '$'; });
    return plain ? "." + std::string(key) : "[" + in_quotes(key) + "]";
}

}  // namespace

// Receives the parser's events. The parser has checked the grammar before each of them, so the place of a token is
// found by walking the text beside it.
class JsonBuilder {
public:
    explicit JsonBuilder(JsonTree& tree) : tree_(tree), text_(tree.text_)
    {
        if (text_.starts_with(byte_order_mark)) cursor_ = byte_order_mark.size();
    }

    bool null() { return word(JsonKind::null, 4); }
    bool boolean(bool truth)
    {
        word(JsonKind::boolean, truth ? 4 : 5);
        tree_.values_.back().truth = truth;
        return true;
    }
    bool number_integer(std::int64_t) { return number(); }
    bool number_unsigned(std::uint64_t) { return number(); }
    bool number_float(double, const std::string&) { return number(); }
    bool binary(nlohmann::json::binary_t&) { return false; }

    bool string(std::string& unescaped)
    {
        std::size_t begin = token();
        std::string_view value = take_string(unescaped);
        tree_.values_[add(JsonKind::string, begin)].string = value;
        return true;
    }

    bool key(std::string& unescaped)
    {
        key_begin_ = token();
        key_ = take_string(unescaped);
        has_key_ = true;
        return true;
    }

    bool start_object(std::size_t) { return open(JsonKind::object); }
    bool start_array(std::size_t) { return open(JsonKind::array); }
    bool end_array() { return close(); }
    bool end_object()
    {
        refuse_duplicates(tree_.values_[open_.back().index]);
        return close();
    }

    template <typename Exception>
    bool parse_error(std::size_t position, const std::string&, const Exception& exception)
    {
        std::size_t offset = std::min(position - 1, text_.size());
        std::string_view reason = exception.what();
        if (exception.id == 406)
            tree_.fail_at(token(), here() + "holds a number that is too large; write a finite one");
        if (reason.find("UTF-8") != reason.npos && offset < text_.size())
            tree_.fail_at(offset, here() + "holds bytes that are not UTF-8; save the file as UTF-8");
        if (offset >= text_.size()) tree_.fail_at(offset, here() + "the text ends too early; the file is cut off");
        if (open_.empty() && !tree_.values_.empty()) trailing(offset);
        unexpected(offset);
    }

    void finish()
    {
        token();
        if (cursor_ < text_.size()) trailing(cursor_);
    }

private:
    struct Open {
        std::size_t index;
        std::int32_t last_child = -1;
    };

    // Moves to the next token and returns its place.
    std::size_t token()
    {
        cursor_ = std::min(text_.find_first_not_of(" \t\r\n,:", cursor_), text_.size());
        return cursor_;
    }

    bool word(JsonKind kind, std::size_t size)
    {
        std::size_t begin = token();
        cursor_ += size;
        add(kind, begin);
        return true;
    }

    bool number()
    {
        std::size_t begin = token();
        while (cursor_ < text_.size() && is_word(text_[cursor_])) ++cursor_;
        add(JsonKind::number, begin);
        return true;
    }

    std::string_view take_string(std::string& unescaped)
    {
        std::size_t begin = ++cursor_;
        bool escaped = false;
        for (cursor_ = text_.find_first_of("\"\\", cursor_); text_[cursor_] == '\\';
             cursor_ = text_.find_first_of("\"\\", cursor_ + 2))
            escaped = true;
        std::size_t end = cursor_++;
        if (unescaped.size() > json_string_limit)
            tree_.fail_at(begin - 1, here() + "holds a text of more than 65536 bytes; shorten it");
        if (!escaped) return text_.substr(begin, end - begin);
        return tree_.unescaped_.emplace_back(std::move(unescaped));
    }

    std::size_t add(JsonKind kind, std::size_t begin)
    {
        std::size_t index = tree_.values_.size();
        if (index >= json_value_limit)
            tree_.fail_at(begin, here() + "is beyond the limit of 1000000 values; split the scene");
        JsonValue& value = tree_.values_.emplace_back();
        value.kind = kind;
        value.begin = value.key_begin = static_cast<std::uint32_t>(begin);
        value.end = static_cast<std::uint32_t>(cursor_);
        if (has_key_) value.key = key_, value.key_begin = static_cast<std::uint32_t>(key_begin_);
        has_key_ = false;
        if (!open_.empty()) append(open_.back(), static_cast<std::int32_t>(index));
        return index;
    }

    void append(Open& parent, std::int32_t child)
    {
        JsonValue& holder = tree_.values_[parent.index];
        tree_.values_[static_cast<std::size_t>(child)].parent = static_cast<std::int32_t>(parent.index);
        ++holder.count;
        if (parent.last_child < 0) holder.first = child;
        else tree_.values_[static_cast<std::size_t>(parent.last_child)].next = child;
        parent.last_child = child;
    }

    bool open(JsonKind kind)
    {
        std::size_t begin = token();
        if (open_.size() >= json_depth_limit)
            tree_.fail_at(begin, here() + "is nested more than 32 deep; a scene never is");
        ++cursor_;
        open_.push_back({add(kind, begin)});
        return true;
    }

    bool close()
    {
        token();
        tree_.values_[open_.back().index].end = static_cast<std::uint32_t>(++cursor_);
        open_.pop_back();
        return true;
    }

    void refuse_duplicates(const JsonValue& object)
    {
        std::vector<const JsonValue*>& members = members_;
        members.clear();
        for (const JsonValue* child = tree_.first_child(object); child; child = tree_.next_sibling(*child))
            members.push_back(child);
        std::sort(members.begin(), members.end(),
                  [](const JsonValue* a, const JsonValue* b) { return a->key != b->key ? a->key < b->key : a < b; });
        auto twice = std::adjacent_find(members.begin(), members.end(),
                                        [](const JsonValue* a, const JsonValue* b) { return a->key == b->key; });
        if (twice != members.end())
            tree_.fail_at_key(**std::next(twice), "is written twice in the same object; remove one of them");
    }

    // The path of what is being read, for messages.
    std::string here() const
    {
        std::string path = open_.empty() ? "$" : tree_.path(tree_.values_[open_.back().index]);
        return path + (has_key_ ? path_step(key_) : "") + ": ";
    }

    [[noreturn]] void trailing(std::size_t offset) const
    {
        tree_.fail_at(offset, "$: more text follows the end of the scene; remove it");
    }

    [[noreturn]] void unexpected(std::size_t offset) const
    {
        std::size_t begin = offset, end = offset + 1;
        while (begin > 0 && is_word(text_[begin]) && is_word(text_[begin - 1])) --begin;
        while (end < text_.size() && ((is_word(text_[offset]) && is_word(text_[end])) || is_continuation(text_[end])))
            ++end;
        std::string_view word = text_.substr(begin, end - begin);
        std::string_view bare = word.substr(std::min(word.find_first_not_of("+-"), word.size()));
        bool endless =
            bare.starts_with("NaN") || bare.starts_with("nan") || bare.starts_with("Inf") || bare.starts_with("inf");
        tree_.fail_at(begin, here() + "unexpected " + in_quotes(word) +
                                 (endless ? "; numbers must be finite" : "; the text is not JSON here"));
    }

    JsonTree& tree_;
    std::string_view text_;
    std::size_t cursor_ = 0;  // in text_, after the last token
    std::vector<Open> open_;
    std::vector<const JsonValue*> members_;
    std::string_view key_;
    std::size_t key_begin_ = 0;
    bool has_key_ = false;
};

JsonTree::JsonTree(std::string_view text, std::string_view name) : text_(text), name_(name)
{
    if (text.size() > json_text_limit) throw Failure(3, name_ + ": is larger than 16 MB; split the scene");
    values_.reserve(text.size() / 24);
    JsonBuilder builder(*this);
    nlohmann::json::sax_parse(text.data(), text.data() + text.size(), &builder);
    builder.finish();
}

const JsonValue* JsonTree::member(const JsonValue& object, std::string_view key) const
{
    for (const JsonValue* child = first_child(object); child; child = next_sibling(*child))
        if (child->key == key) return child;
    return nullptr;
}

std::string JsonTree::path(const JsonValue& value) const
{
    std::vector<std::string> steps;
    for (const JsonValue* at_value = &value; const JsonValue* parent = at(at_value->parent); at_value = parent) {
        if (parent->kind == JsonKind::object) {
            steps.push_back(path_step(at_value->key));
            continue;
        }
        std::size_t index = 0;
        for (const JsonValue* child = first_child(*parent); child != at_value; child = next_sibling(*child)) ++index;
        steps.push_back("[" + std::to_string(index) + "]");
    }
    std::string path = "$";
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) path += *step;
    return path;
}

bool JsonTree::boolean(const JsonValue& value) const
{
    if (value.kind != JsonKind::boolean) fail(value, "must be true or false");
    return value.truth;
}

float JsonTree::number(const JsonValue& value) const
{
    if (value.kind != JsonKind::number) fail(value, "must be a number; write e.g. 1.0");
    std::string_view text = source(value);
    float number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc()) return number;
    // Beyond float on one side or the other; the parser has refused what is beyond double.
    double wide = 0;
    std::from_chars(text.data(), text.data() + text.size(), wide);
    if (std::abs(wide) > 1) fail(value, "is too large; write a number between -3.4e38 and 3.4e38");
    return static_cast<float>(wide);
}

std::int64_t JsonTree::integer(const JsonValue& value) const
{
    if (value.kind != JsonKind::number) fail(value, "must be a whole number; write e.g. 1");
    std::string_view text = source(value);
    std::int64_t number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end != text.data() + text.size())
        fail(value, "must be a whole number; write e.g. 1, without a point or exponent");
    constexpr std::int64_t largest = std::int64_t(1) << 53;
    if (error != std::errc() || number > largest || number < -largest)
        fail(value, "is too large; write a whole number between -2^53 and 2^53");
    return number;
}

std::string_view JsonTree::string(const JsonValue& value) const
{
    if (value.kind != JsonKind::string) fail(value, "must be a text in double quotes");
    return value.string;
}

const JsonValue& JsonTree::object(const JsonValue& value) const
{
    if (value.kind != JsonKind::object) fail(value, "must be an object; write { ... }");
    return value;
}

const JsonValue& JsonTree::array(const JsonValue& value) const
{
    if (value.kind != JsonKind::array) fail(value, "must be a list; write [ ... ]");
    return value;
}

void JsonTree::fail(const JsonValue& value, const std::string& sentence) const
{
    fail_at(value.begin, path(value) + ": " + sentence);
}

void JsonTree::fail_at_key(const JsonValue& value, const std::string& sentence) const
{
    fail_at(value.key_begin, path(value) + ": " + sentence);
}

// Columns count characters, not bytes.
void JsonTree::fail_at(std::size_t offset, const std::string& sentence) const
{
    std::string_view before = text_.substr(0, offset);
    if (before.starts_with(byte_order_mark)) before.remove_prefix(byte_order_mark.size());
    auto line = 1 + std::count(before.begin(), before.end(), '\n');
    std::string_view on_line = before.substr(before.rfind('\n') + 1);
    auto column = 1 + std::count_if(on_line.begin(), on_line.end(), [](char c) { return !is_continuation(c); });
    throw Failure(3, name_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + sentence);
}

void append_json_string(std::string& out, std::string_view text)
{
    static constexpr char digits[] = "0123456789abcdef";
    out += '"';
    for (char c : text) {
        if (c == '"' || c == '\\') out += '\\', out += c;
        else if (c == '\n') out += "\\n";
        else if (c == '\t') out += "\\t";
        else if (static_cast<unsigned char>(c) < 0x20) out += "\\u00", out += digits[c >> 4], out += digits[c & 15];
        else out += c;
    }
    out += '"';
}

void append_json_number(std::string& out, float number, bool point)
{
    char buffer[32];
    auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, number);
    std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
    out += text;
    if (point && text.find_first_of(".e") == text.npos) out += ".0";
}

bool is_utf8(std::string_view text)
{
    while (!text.empty()) {
        auto lead = static_cast<unsigned char>(text.front());
        std::size_t size = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
        if (size == 0 || size > text.size()) return false;
        if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), is_continuation))
            return false;
        unsigned char second = size > 1 ? static_cast<unsigned char>(text[1]) : 0;
        bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
        bool outside = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
        if (overlong || outside) return false;
        text.remove_prefix(size);
    }
    return true;
}

std::string in_quotes(std::string_view text)
{
    std::size_t end = std::min<std::size_t>(text.size(), 64);
    while (end > 0 && end < text.size() && is_continuation(text[end])) --end;
    std::string result = "`";
    for (char c : text.substr(0, end)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return result + (end < text.size() ? "...`" : "`");
}

}  // namespace fieldwright::graph

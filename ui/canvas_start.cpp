// What an empty canvas offers: words, the first node, and examples with their pictures.
#include "ui/canvas.h"

#include "ui/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

constexpr float button_width = 140, card_width = 208, smallest_card = 128, card_gap = 12;  // design px
constexpr const char *empty_words =
                         "A scene is made of nodes: shapes and what is done to them, wired to an output. "
                         "Press Space or right-click here to add one.",
                     *empty_words_short = "Press Space or right-click here to add a node.";
constexpr std::size_t card_limit = 5, fewest_cards = 3;

void centred_text(const char* words, ImU32 tint)
{
    float room = ImGui::GetWindowWidth(), width = ImGui::CalcTextSize(words).x;
    ImGui::SetCursorPosX(std::max(std::floor(0.5f * (room - width)), 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Text, tint);
    ImGui::TextUnformatted(words);
    ImGui::PopStyleColor();
}

// A row of cards, in px: as large as the pane allows, none when they would be too small to be seen.
struct CardRow {
    std::size_t count = 0;
    glm::vec2 picture{0, 0};
    float gap = 0;
    float width() const { return static_cast<float>(count) * (picture.x + gap) - gap; }

    CardRow(const Theme& theme, std::size_t offered, glm::vec2 room) : gap(theme.px(card_gap))
    {
        auto least = static_cast<float>(std::min(offered, fewest_cards));
        float width = std::min(
            {theme.px(card_width), (room.x + gap) / std::max(least, 1.0f) - gap, (room.y - theme.row()) * 16 / 9});
        if (width < theme.px(smallest_card)) return;
        picture = glm::floor(glm::vec2(width, width * 9 / 16));
        count = std::min({offered, card_limit, static_cast<std::size_t>((room.x + gap) / (picture.x + gap))});
    }
};

// True when it was clicked.
bool card(FrameContext& frame, const Example& example, glm::vec2 picture)
{
    const Theme& theme = frame.theme;
    bool pressed = ImGui::InvisibleButton(example.name.c_str(), {picture.x, picture.y + theme.row()});
    ImVec2 low = ImGui::GetItemRectMin(), high(low.x + picture.x, low.y + picture.y);
    bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float rounding = theme.px(5);
    if (example.picture) list.AddImageRounded(example.picture, low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
    else list.AddRectFilled(low, high, colour::field, rounding);
    list.AddRect(low, high, hovered ? colour::text : colour::line, rounding, 0, theme.px(hovered ? 1.5f : 1.0f));
    std::string title = fitted(example.title, picture.x);
    float left = low.x + std::floor(0.5f * (picture.x - ImGui::CalcTextSize(title.c_str()).x));
    list.AddText({left, high.y + theme.px(6)}, hovered ? colour::text : colour::quiet_text, title.c_str());
    if (hovered) frame.view.hint = example.sentence;
    frame.rects.mark("canvas/empty/example/" + example.name);
    return pressed;
}

void cards(FrameContext& frame, const CardRow& row)
{
    ImGui::SetCursorPosX(std::floor(0.5f * (ImGui::GetWindowWidth() - row.width())));
    for (std::size_t i = 0; i < row.count; ++i) {
        const Example& example = frame.readings.examples[i];
        if (i) ImGui::SameLine(0, row.gap);
        if (card(frame, example, row.picture)) frame.requests.push_back(OpenExample{example.name});
    }
}

struct FirstStep {
    const char *words, *mark;
};

// Buttons side by side in the middle; which one was clicked.
int first_steps(FrameContext& frame, std::initializer_list<FirstStep> steps)
{
    const Theme& theme = frame.theme;
    auto count = static_cast<float>(steps.size());
    float gap = theme.padding(), room = ImGui::GetWindowWidth() - 2 * theme.padding();
    float width = std::floor(std::min(theme.px(button_width), (room + gap) / count - gap));
    ImGui::SetCursorPosX(std::floor(0.5f * (ImGui::GetWindowWidth() - count * (width + gap) + gap)));
    int chosen = -1, index = 0;
    for (const FirstStep& step : steps) {
        if (index) ImGui::SameLine(0, gap);
        if (text_button(frame, step.mark, step.words, width)) chosen = index;
        frame.rects.mark(step.mark);
        ++index;
    }
    return chosen;
}

}  // namespace

void Canvas::empty_state(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    ImVec2 room = ImGui::GetWindowSize();
    float words = 2 * ImGui::GetTextLineHeightWithSpacing() + 2 * theme.row() + theme.px(36), inset = theme.padding();
    CardRow row(theme, frame.readings.examples.size(), {room.x - 2 * inset, room.y - words - 2 * inset});
    float height = words + (row.count ? row.picture.y + theme.row() : -theme.row());
    ImGui::SetCursorPosY(std::max(std::floor(0.5f * (room.y - height)), inset));
    ImGui::PushFont(theme.fonts.heading);
    centred_text("Nothing here yet", colour::text);
    ImGui::PopFont();
    bool roomy = ImGui::CalcTextSize(empty_words).x < room.x;
    centred_text(roomy ? empty_words : empty_words_short, colour::quiet_text);
    ImGui::Dummy({0, theme.px(4)});
    int step = first_steps(frame, {{"Add a sphere", "canvas/empty/sphere"},
                                   {"Add a box", "canvas/empty/box"},
                                   {"See all nodes…", "canvas/empty/menu"}});
    glm::vec2 below(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y);
    if (row.count) {
        ImGui::Dummy({0, theme.px(8)});
        centred_text("or begin with an example", colour::quiet_text);
        ImGui::Dummy({0, theme.px(4)});
        cards(frame, row);
    }
    glm::vec2 middle = space_.canvas(space_.pane_px().centre()) - 0.5f * glm::vec2(node_width, node_header);
    const char* shapes[] = {"sphere", "box"};
    if (step == 0 || step == 1) add_and_show(frame, *frame.draft.library.type(shapes[step]), {.position = middle});
    if (step == 2) add_menu_.open(below, {.position = middle});
}

}  // namespace fieldwright::ui

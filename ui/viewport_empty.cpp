// Saying what is missing between shapes and output.
#include "ui/viewport_empty.h"

#include "graph/scene_parts.h"

namespace fieldwright::ui {

using graph::Shown;

namespace {

struct Advice {
    const char *sentence, *button;  // no button: null
};

Advice advice(Shown shown)
{
    switch (shown) {
        case Shown::no_shape: return {"The scene has no shape. Add one, and it appears here.", "Add a shape…"};
        case Shown::no_output: return {"The scene has no output, which says what is drawn.", "Add an output"};
        case Shown::nothing_wired: return {"No shape is wired to the output.", "Wire the shapes to it"};
        case Shown::nothing_made:
            return {"What is wired to the output is muted, or made of shapes that are not wired.", nullptr};
        case Shown::something: break;
    }
    return {"", nullptr};
}

void centred(const WidgetRect& pane, float y, const char* text, ImU32 ink)
{
    float width = ImGui::CalcTextSize(text).x;
    ImGui::GetWindowDrawList()->AddText({std::round(pane.centre().x - 0.5f * width), y}, ink, text);
}

void help(FrameContext& frame, Shown shown)
{
    if (shown == Shown::no_shape) {
        frame.view.add_request = true;
        return;
    }
    graph::Placed placed = graph::show_shape(frame.draft.document, frame.draft.library);
    bool adds = shown == Shown::no_output;
    if (frame.draft.done(adds ? "Add output" : "Connect", placed.refusal)) frame.view.frame_request = placed.node;
}

}  // namespace

void draw_nothing_to_see(FrameContext& frame, const WidgetRect& pane)
{
    if (!frame.draft.document.entered.empty()) return;  // the picture is that of the scene, the graph is not
    Shown shown = graph::shown_by_output(frame.draft.document, frame.draft.library);
    if (shown == Shown::something) return;
    const Theme& theme = frame.theme;
    Advice advised = advice(shown);
    float line = ImGui::GetFontSize(), pad = theme.px(16), gap = theme.px(8);
    float width = ImGui::CalcTextSize(advised.sentence).x + 2 * pad;
    float height = 2 * line + gap + 2 * pad + (advised.button ? theme.px(28) + pad : 0);
    glm::vec2 low = glm::round(pane.centre() - 0.5f * glm::vec2(width, height));
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y}, {low.x + width, low.y + height}, colour::veil,
                                              theme.px(6));
    frame.rects.mark("viewport/nothing", {low, low + glm::vec2(width, height)});
    ImGui::PushFont(theme.fonts.heading);
    centred(pane, low.y + pad, "Nothing to see yet", colour::text);
    ImGui::PopFont();
    centred(pane, low.y + pad + line + gap, advised.sentence, colour::quiet_text);
    if (!advised.button) return;
    float button = ImGui::CalcTextSize(advised.button).x + 2 * pad;
    ImGui::SetCursorScreenPos({std::round(pane.centre().x - 0.5f * button), low.y + height - pad - theme.px(28)});
    bool pressed = ImGui::Button(advised.button, {button, theme.px(28)});
    frame.rects.mark("viewport/nothing/help");
    if (pressed) help(frame, shown);
}

}  // namespace fieldwright::ui

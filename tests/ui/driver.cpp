// Driving the editor through its input queue.
#include "tests/ui/driver.h"

#include "graph/group_types.h"
#include "ui/keys.h"

#include "graph/adapt.h"
#include "graph/own_types.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using Kind = ui::InputEvent::Kind;

// Letters are drawn once for all tests of a program.
struct SharedFonts {
    ImFontAtlas atlas;
    ui::Theme theme;

    SharedFonts()
    {
        ImGuiContext* context = ImGui::CreateContext(&atlas);
        theme = ui::make_theme(1);
        unsigned char* pixels;
        int width, height;
        atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
        ImGui::DestroyContext(context);
    }
};

SharedFonts& shared_fonts()
{
    static SharedFonts fonts;
    return fonts;
}

}  // namespace

Driver::Driver(graph::Document start, glm::vec2 size_px)
    : library(graph::Library::embedded()),
      document(std::move(start)),
      context_(ImGui::CreateContext(&shared_fonts().atlas)),
      theme_(shared_fonts().theme)
{
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;
    io.DisplaySize = ImVec2(size_px.x, size_px.y);
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ui::map_keys(io);
    ui::set_style(theme_.scale);
    io.FontDefault = theme_.fonts.text;
    editor.rects.listening = true;
    readings.views = {{{"beauty", "Beauty", "Surfaces in their light."}, true},
                      {{"steps", "Steps heatmap", "Steps of rays."}, false, "Steps per ray"},
                      {{"glow", "Beauty with glow", "Steps as light."}, true},
                      {{"depth", "Depth", "How far surfaces are."}},
                      {{"gradient", "Gradient heatmap", "Length of the gradient."}, false, "Gradient length", 2},
                      {{"slice", "Distance slice", "The field on a plane."}}};
    readings.stereo_modes = {
        {{"off", "No stereo", "One eye."}},
        {{"naive", "Plain red-cyan anaglyph", "Red and cyan."}, true, 1, 1, 0xff0000ff, 0xffffff00},
        {{"dubois", "Dubois red-cyan anaglyph", "Truer."}, true, 1, 1, 0xff0000ff, 0xffffff00},
        {{"side-by-side", "Side by side", "Both pictures."}, false, 2, 1}};
    readings.colour_maps = {{{"viridis", "Viridis", "Even."}, {0xff540144, 0xff8c9121, 0xff25e7fd}},
                            {{"turbo", "Turbo", "Fine."}, {0xff3b1230, 0xff03047a}}};
    readings.slice_styles = {{"sign", "Inside and outside", "Blue and amber."},
                             {"grey", "Distance as grey", "Grey."},
                             {"gradient", "Gradient error", "Errors."}};
    readings.export_targets = {"glsl", "shadertoy"};
    readings.file_name = "test.scene.json";
    steps.emplace_back(document, "start");
    follow_types();
    refresh_readings();
    frames(2);
}

Driver::~Driver() { ImGui::DestroyContext(context_); }

// As the program's session does.
void Driver::follow_types()
{
    bool others = document.own_types != library->own_types();
    if (others) {
        library = graph::with_own_types(*library, document.own_types);
        document = graph::adapted(document, *library);
    }
    if (others || document.groups != known_groups_) library = graph::with_groups(*library, document);
    known_groups_ = document.groups;
}

void Driver::refresh_readings()
{
    readings.program = std::make_shared<graph::Program>(graph::lower(document, library));
    readings.problems = readings.program->problems;
    readings.step_names.clear();
    for (const auto& [_, name] : steps) readings.step_names.push_back(name);
    readings.step = step;
}

void Driver::perform(const ui::Request& request)
{
    if (std::holds_alternative<ui::Undo>(request) && step > 0) document = steps[--step].first;
    else if (std::holds_alternative<ui::Redo>(request) && step + 1 < steps.size()) document = steps[++step].first;
    else if (const auto* jump = std::get_if<ui::JumpTo>(&request); jump && jump->step < steps.size())
        document = steps[step = jump->step].first;
    else requests.push_back(request);
    follow_types();
    refresh_readings();
}

void Driver::frame()
{
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = frame_s;
    queue.pass(io);
    ImGui::NewFrame();
    ui::Editor::Output output = editor.draw(document, *library, readings, theme_);
    ImGui::Render();
    if (output.text_expected) queue.wait_for_text();
    if (output.document_changed) follow_types();
    if (output.document_changed) refresh_readings();
    if (!output.settled_step.empty() && document != steps[step].first) {
        steps.resize(step + 1);
        steps.emplace_back(document, output.settled_step);
        ++step;
        refresh_readings();
    }
    for (const ui::Request& request : output.requests) perform(request);
}

void Driver::frames(int count)
{
    for (int i = 0; i < count; ++i) frame();
}

void Driver::run_until_quiet()
{
    while (!queue.empty()) frame();
    frames(2);
}

void Driver::move(glm::vec2 at)
{
    queue.push({.kind = Kind::move, .at = at});
    run_until_quiet();
}

void Driver::press(int button)
{
    queue.push({.kind = Kind::button, .code = button, .down = true});
    run_until_quiet();
}

void Driver::release(int button)
{
    queue.push({.kind = Kind::button, .code = button, .down = false});
    run_until_quiet();
}

void Driver::click(glm::vec2 at, int button)
{
    move(at);
    press(button);
    release(button);
}

void Driver::click(std::string_view widget, int button) { click(place(widget), button); }

void Driver::double_click(glm::vec2 at)
{
    move(at);
    for (int i = 0; i < 2; ++i) {
        queue.push({.kind = Kind::button, .code = 0, .down = true});
        queue.push({.kind = Kind::button, .code = 0, .down = false});
    }
    run_until_quiet();
}

void Driver::drag(glm::vec2 from, glm::vec2 to, int button, int count)
{
    move(from);
    press(button);
    for (int i = 1; i <= count; ++i) move(from + (to - from) * (static_cast<float>(i) / static_cast<float>(count)));
    release(button);
}

void Driver::wheel(float notches)
{
    queue.push({.kind = Kind::wheel, .at = {0, notches}});
    run_until_quiet();
}

void Driver::key(int code, bool control, bool shift, bool alt)
{
    const std::pair<bool, int> modifiers[] = {
        {control, ui::key::left_control}, {shift, ui::key::left_shift}, {alt, ui::key::left_alt}};
    for (auto [wanted, modifier] : modifiers)
        if (wanted) queue.push({.kind = Kind::key, .code = modifier, .down = true});
    queue.push({.kind = Kind::key, .code = code, .down = true});
    queue.push({.kind = Kind::key, .code = code, .down = false});
    for (auto [wanted, modifier] : modifiers)
        if (wanted) queue.push({.kind = Kind::key, .code = modifier, .down = false});
    run_until_quiet();
}

void Driver::type(std::string_view text)
{
    for (unsigned char c : text) queue.push({.kind = Kind::character, .code = c});
    run_until_quiet();
}

glm::vec2 Driver::place(std::string_view widget) const
{
    auto rect = editor.rects.find(widget);
    if (!rect) {
        ADD_FAILURE() << "no widget is named " << widget;
        return {0, 0};
    }
    return rect->centre();
}

}  // namespace fieldwright::tests

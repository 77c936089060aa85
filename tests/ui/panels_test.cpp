// Hands on the panels: lists of nodes, view settings, shader text, problems and history.
#include "graph/compose.h"
#include "tests/ui/driver.h"
#include "ui/glsl_highlight.h"
#include "ui/keys.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <random>

namespace fieldwright::tests {
namespace {

using graph::NodeId;
using ui::Panel;

graph::Document lit_sphere()
{
    graph::Document document;
    auto library = graph::Library::embedded();
    graph::add_primitive_to_output(document, *library, "sphere", {0, 0});
    graph::add_to_output(document, *library, "perspective", {0, 200});
    graph::add_alone(document, *library, "sun", {0, 400});
    return document;
}

NodeId node_of(const graph::Document& document, std::string_view type)
{
    for (const graph::Node& node : document.root.nodes)
        if (node.type == type) return node.id;
    return {};
}

struct OnPanel : Driver {
    explicit OnPanel(Panel panel, graph::Document start = lit_sphere()) : Driver(std::move(start), {1280, 1000})
    {
        editor.view.panel = panel;
        editor.view.panes.inspector_share = 0.3f;
        readings.has_camera = true;
        frames(2);
    }
    std::string row(NodeId id, std::string_view part = {}) const
    {
        const char* paths[] = {"panel/materials/", "panel/lights/", "panel/camera/"};
        std::string name = paths[static_cast<int>(editor.view.panel)] + std::to_string(id.number);
        return part.empty() ? name : name + "/" + std::string(part);
    }
};

TEST(Panels, every_tab_opens_its_panel)
{
    OnPanel driver(Panel::materials);
    const char* names[] = {"materials", "lights", "camera", "cost", "field", "stereo", "shader", "problems", "history"};
    for (int i = 8; i >= 0; --i) {
        driver.click(std::string("panel/tab/") + names[i]);
        EXPECT_EQ(static_cast<int>(driver.editor.view.panel), i);
    }
}

TEST(Panels, tabs_stay_inside_the_narrowest_column)
{
    OnPanel driver(Panel::problems);
    driver.editor.view.panes.side_width = 280;
    driver.readings.problems.assign(120, {{}, "is wrong", graph::Problem::Severity::error});
    driver.frames(2);
    float end = 0;
    for (const auto& [name, rect] : driver.editor.rects.all()) {
        if (!name.starts_with("panel/tab/")) continue;
        EXPECT_GE(rect.high.x - rect.low.x, 20) << name;
        end = std::max(end, rect.high.x);
    }
    EXPECT_LE(end, 1280);
}

TEST(LightsPanel, adding_a_sun_is_one_step_and_undo_takes_it_back)
{
    OnPanel driver(Panel::lights);
    graph::Document before = driver.document;
    driver.click("panel/lights/add");
    driver.click("panel/lights/add/sun");
    ASSERT_EQ(driver.steps.size(), 2u);
    EXPECT_EQ(driver.steps[1].second, "Add sun");
    EXPECT_EQ(driver.document.root.nodes.size(), before.root.nodes.size() + 1);
    EXPECT_EQ(driver.document.root.find(driver.editor.view.selection.active())->type, "sun");
    driver.editor.view.panel = Panel::history;
    driver.frames(2);
    driver.click("panel/history/undo");
    EXPECT_EQ(driver.document, before);
}

TEST(LightsPanel, a_lamp_is_placed_before_what_is_seen_and_lights_it_gently)
{
    for (float size : {0.1f, 1.0f, 20.0f}) {
        OnPanel driver(Panel::lights);
        driver.editor.view.through_camera = false;
        driver.editor.view.camera.pivot = {5, 1, -3};
        driver.editor.view.camera.distance = 6 * size;
        driver.frames(2);
        driver.click("panel/lights/add");
        driver.click("panel/lights/add/point");
        driver.frames(2);
        const graph::Node& lamp = *driver.document.root.find(node_of(driver.document, "point"));
        glm::vec3 way = std::get<glm::vec3>(*lamp.parameter("position")) - driver.editor.view.camera.pivot;
        float distance = glm::length(way);
        EXPECT_NEAR(std::get<float>(*lamp.parameter("intensity")) / (distance * distance), 0.3f, 0.02f) << size;
        EXPECT_GT(glm::dot(way, driver.editor.view.camera.backward()), 0) << "in front";
        EXPECT_GT(way.y, 0.3f * distance) << "above";
        EXPECT_LT(distance, 6 * size) << "nearer than the eye";
        EXPECT_EQ(driver.steps.size(), 2u);
    }
}

TEST(LightsPanel, without_lights_it_offers_a_sun)
{
    OnPanel driver(Panel::lights, {});
    driver.click("panel/lights/offer");
    EXPECT_TRUE(node_of(driver.document, "sun"));
    EXPECT_EQ(driver.steps.size(), 2u);
    driver.frames(2);
    EXPECT_FALSE(driver.shows("panel/lights/offer"));
}

TEST(LightsPanel, a_light_is_chosen_edited_muted_and_deleted)
{
    OnPanel driver(Panel::lights);
    NodeId sun = node_of(driver.document, "sun");
    driver.click(driver.row(sun));
    EXPECT_EQ(driver.editor.view.selection.active(), sun);
    glm::vec2 from = driver.place("panel/lights/intensity");
    driver.drag(from, from + glm::vec2(40, 0));
    EXPECT_GT(std::get<float>(*driver.document.root.find(sun)->parameter("intensity")), 1.0f);
    driver.click(driver.row(sun, "mute"));
    EXPECT_TRUE(driver.document.root.find(sun)->muted);
    driver.click(driver.row(sun, "delete"));
    EXPECT_FALSE(node_of(driver.document, "sun"));
    EXPECT_EQ(driver.steps.size(), 4u);
}

TEST(LightsPanel, a_double_click_renames_in_place)
{
    OnPanel driver(Panel::lights);
    NodeId sun = node_of(driver.document, "sun");
    driver.double_click(driver.place(driver.row(sun)));
    driver.key('A', true);
    driver.type("Evening");
    driver.key(ui::key::enter);
    EXPECT_EQ(driver.document.root.find(sun)->name, "Evening");
    EXPECT_EQ(driver.steps.size(), 2u);
    EXPECT_TRUE(driver.shows(driver.row(sun)));
}

TEST(LightsPanel, a_duplicate_is_a_light_of_its_own)
{
    OnPanel driver(Panel::lights);
    NodeId sun = node_of(driver.document, "sun");
    driver.click(driver.row(sun));
    driver.click(driver.row(sun, "duplicate"));
    NodeId copy = driver.editor.view.selection.active();
    ASSERT_NE(copy, sun);
    EXPECT_EQ(driver.document.root.find(copy)->parameters, driver.document.root.find(sun)->parameters);
    EXPECT_EQ(driver.steps.size(), 2u);
}

TEST(MaterialsPanel, a_material_added_on_a_selected_shape_paints_it)
{
    OnPanel driver(Panel::materials);
    driver.editor.view.selection.only(node_of(driver.document, "sphere"));
    driver.frames(2);
    driver.click("panel/materials/add");
    driver.click("panel/materials/add/phong");
    NodeId material = node_of(driver.document, "phong"), paint = node_of(driver.document, "paint");
    ASSERT_TRUE(material);
    ASSERT_TRUE(paint);
    EXPECT_EQ(driver.document.root.find(paint)->input("material"), material);
    EXPECT_EQ(driver.steps.size(), 2u);
    EXPECT_EQ(graph::validate(driver.document, *driver.library), std::nullopt);
}

TEST(MaterialsPanel, an_empty_list_offers_one_for_the_selected_shape)
{
    OnPanel driver(Panel::materials);
    EXPECT_FALSE(driver.shows("panel/materials/offer"));
    driver.editor.view.selection.only(node_of(driver.document, "sphere"));
    driver.frames(2);
    driver.click("panel/materials/offer");
    driver.click("panel/materials/add/phong");
    EXPECT_TRUE(node_of(driver.document, "paint"));
    EXPECT_EQ(driver.steps.back().second, "Add phong to sphere");
}

TEST(MaterialsPanel, a_material_added_on_nothing_stands_alone)
{
    OnPanel driver(Panel::materials);
    driver.click("panel/materials/add");
    driver.click("panel/materials/add/checker");
    EXPECT_TRUE(node_of(driver.document, "checker"));
    EXPECT_FALSE(node_of(driver.document, "paint"));
}

TEST(CameraPanel, the_output_uses_the_camera_that_is_chosen)
{
    OnPanel driver(Panel::camera);
    NodeId first = node_of(driver.document, "perspective"), output = node_of(driver.document, "output");
    driver.click("panel/camera/add");
    driver.click("panel/camera/add/orthographic");
    EXPECT_EQ(driver.document.root.find(output)->input("camera"), node_of(driver.document, "orthographic"));
    driver.click(driver.row(first, "use"));
    EXPECT_EQ(driver.document.root.find(output)->input("camera"), first);
    EXPECT_EQ(driver.steps.size(), 3u);
}

TEST(CameraPanel, the_camera_is_set_from_the_view)
{
    OnPanel driver(Panel::camera);
    driver.editor.view.camera.pivot = {1, 2, 3};
    driver.click("panel/camera/from_view");
    const graph::Node& camera = *driver.document.root.find(node_of(driver.document, "perspective"));
    glm::vec3 position = std::get<glm::vec3>(*camera.parameter("position"));
    EXPECT_LT(glm::distance(position, driver.editor.view.camera.position()), 1e-4f);
    EXPECT_EQ(std::get<glm::vec3>(*camera.parameter("target")), glm::vec3(1, 2, 3));
    EXPECT_EQ(driver.steps.back().second, "Set camera from view");
}

TEST(CameraPanel, looking_through_the_camera_is_no_step)
{
    OnPanel driver(Panel::camera);
    driver.click("panel/camera/view/own");
    EXPECT_FALSE(driver.editor.view.through_camera);
    driver.click("panel/camera/view/camera");
    EXPECT_TRUE(driver.editor.view.through_camera);
    EXPECT_EQ(driver.steps.size(), 1u);
}

TEST(CostPanel, the_heatmap_is_switched_on_and_off)
{
    OnPanel driver(Panel::cost);
    driver.click("panel/cost/heatmap");
    EXPECT_EQ(driver.editor.view.view, "steps");
    driver.click("panel/cost/heatmap");
    EXPECT_EQ(driver.editor.view.view, "beauty");
    driver.click("panel/cost/glow");
    EXPECT_EQ(driver.editor.view.view, "glow");
    driver.click("panel/cost/colour_map");
    driver.click("panel/cost/colour_map/choice/turbo");
    EXPECT_EQ(driver.editor.view.colour_map, "turbo");
}

TEST(CostPanel, shows_the_steps_beside_the_picture_but_not_beside_themselves)
{
    OnPanel driver(Panel::cost);
    EXPECT_FALSE(driver.shows("panel/cost/side_picture"));
    driver.readings.steps_picture = {reinterpret_cast<ImTextureID>(1), 160, 90};
    driver.frames(1);
    EXPECT_TRUE(driver.shows("panel/cost/side_picture"));
    EXPECT_TRUE(driver.shows("panel/cost/legend")) << "which number is which colour";
    driver.click("panel/cost/heatmap");
    EXPECT_FALSE(driver.shows("panel/cost/side_picture"));
    EXPECT_TRUE(driver.shows("panel/cost/legend"));
}

TEST(CostPanel, measures_nodes_when_asked_and_leads_to_the_dearest)
{
    OnPanel driver(Panel::cost);
    driver.editor.view.panes.inspector_share = 0.1f;
    driver.frames(2);
    driver.click("panel/cost/measure");
    ASSERT_EQ(driver.requests.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<ui::MeasureNodes>(driver.requests[0]));
    NodeId sphere = node_of(driver.document, "sphere");
    driver.readings.node_costs.picture_ms = 20;
    driver.readings.node_costs.by_node = {{sphere, 12.5}, {NodeId{999}, 3}};
    driver.frames(2);
    driver.click("panel/cost/node/" + std::to_string(sphere.number));
    EXPECT_EQ(driver.editor.view.selection.active(), sphere);
    EXPECT_FALSE(driver.shows("panel/cost/node/999")) << "no node of the graph that is shown";
}

TEST(FieldPanel, shows_a_slice_and_chooses_its_plane_and_style)
{
    OnPanel driver(Panel::field);
    driver.click("panel/field/slice");
    EXPECT_EQ(driver.editor.view.view, "slice");
    driver.click("panel/field/plane/zx");
    EXPECT_EQ(driver.editor.view.slice.plane, "zx");
    driver.click("panel/field/style");
    driver.click("panel/field/style/choice/grey");
    EXPECT_EQ(driver.editor.view.slice.style, "grey");
    EXPECT_TRUE(driver.shows("panel/field/gamma"));
    glm::vec2 from = driver.place("panel/field/offset");
    driver.drag(from, from + glm::vec2(40, 0));
    EXPECT_GT(driver.editor.view.slice.offset, 0);
    driver.click("panel/field/slice");
    EXPECT_EQ(driver.editor.view.view, "beauty");
    EXPECT_EQ(driver.steps.size(), 1u);
}

TEST(FieldPanel, lists_the_steps_of_a_ray_and_shows_them_on_the_plane_through_it)
{
    OnPanel driver(Panel::field);
    EXPECT_FALSE(driver.shows("panel/field/steps"));
    driver.click("panel/field/inspect");
    EXPECT_EQ(driver.editor.view.click, ui::Click::inspect);
    auto ray = std::make_shared<ui::RayReading>();
    ray->origin = {0, 0, 5};
    ray->steps = {{0.01f, 3.9f, 390}, {3.91f, 0.09f, 0.02f}, {4.0f, 0.0f, 0.0f}};
    ray->end = ui::RayReading::End::hit;
    ray->t_end = 4;
    driver.readings.ray = ray;
    driver.frames(2);
    EXPECT_TRUE(driver.shows("panel/field/plot"));
    EXPECT_TRUE(driver.shows("panel/field/steps"));
    driver.click("panel/field/show_ray");
    EXPECT_EQ(driver.editor.view.view, "slice");
    EXPECT_EQ(driver.editor.view.slice.plane, "ray");
}

TEST(StereoPanel, mode_and_eyes_belong_to_the_view)
{
    OnPanel driver(Panel::stereo);
    driver.click("panel/stereo/mode");
    driver.click("panel/stereo/mode/choice/dubois");
    EXPECT_EQ(driver.editor.view.stereo, "dubois");
    driver.click("panel/stereo/space/gamma");
    EXPECT_FALSE(driver.editor.view.eyes.linear);
    driver.click("panel/stereo/swap");
    EXPECT_TRUE(driver.editor.view.eyes.swap);
    driver.click("panel/stereo/cameras/toe_in");
    EXPECT_TRUE(driver.editor.view.eyes.toe_in);
    driver.click("panel/stereo/converge");
    EXPECT_EQ(driver.editor.view.click, ui::Click::converge);
    driver.double_click(driver.place("panel/stereo/interaxial"));
    driver.type("32");
    driver.key(ui::key::enter);
    EXPECT_FLOAT_EQ(driver.editor.view.interaxial, 0.032f);
    glm::vec2 from = driver.place("panel/stereo/convergence");
    driver.drag(from, from + glm::vec2(30, 0));
    EXPECT_GT(driver.editor.view.convergence, 5.0f);
    EXPECT_EQ(driver.steps.size(), 1u);
}

TEST(ShaderPanel, copies_the_text_and_asks_where_to_export)
{
    OnPanel driver(Panel::shader);
    driver.readings.shader_text = std::make_shared<const std::string>("float a;\nvoid main() {}\n");
    driver.frames(2);
    driver.click("panel/shader/copy");
    EXPECT_EQ(std::string(ImGui::GetClipboardText()), *driver.readings.shader_text);
    driver.click("panel/shader/export/shadertoy");
    ASSERT_EQ(driver.requests.size(), 1u);
    const auto* asked = std::get_if<ui::ChooseFile>(&driver.requests[0]);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->then, ui::ChooseFile::Then::export_shader);
    EXPECT_EQ(asked->target, "shadertoy");
}

TEST(ShaderPanel, a_long_shader_draws_only_what_is_in_view)
{
    OnPanel driver(Panel::shader);
    driver.frames(2);
    auto vertices = [] { return ImGui::GetDrawData()->TotalVtxCount; };
    std::string text = "float distance(vec3 p)\n{\n";
    for (int i = 0; i < 20000; ++i) text += "    float v" + std::to_string(i) + " = min(v0, 1.0f);\n";
    driver.readings.shader_text = std::make_shared<const std::string>(text + "}\n");
    driver.frames(2);
    EXPECT_GT(vertices(), 1000);
    EXPECT_LT(vertices(), 30000);
}

TEST(ProblemsPanel, a_click_selects_the_node_and_shows_it)
{
    OnPanel driver(Panel::problems);
    NodeId sphere = node_of(driver.document, "sphere");
    driver.readings.problems = {{{}, "has no output", graph::Problem::Severity::note},
                                {sphere, "is broken", graph::Problem::Severity::error}};
    driver.editor.view.canvas.pan_px = {-9000, -9000};
    driver.frames(2);
    std::string name = "canvas/node/" + std::to_string(sphere.number);
    ASSERT_LT(driver.place(name).x, 0);
    driver.click("panel/problems/1");
    EXPECT_EQ(driver.editor.view.selection.active(), sphere);
    driver.frames(60);
    EXPECT_GT(driver.place(name).x, 0);
}

TEST(HistoryPanel, a_click_jumps_to_the_step)
{
    OnPanel driver(Panel::lights);
    for (int i = 0; i < 3; ++i) {
        driver.click("panel/lights/add");
        driver.click("panel/lights/add/point");
    }
    ASSERT_EQ(driver.steps.size(), 4u);
    driver.click("panel/tab/history");
    driver.click("panel/history/1");
    EXPECT_EQ(driver.step, 1u);
    EXPECT_EQ(driver.document, driver.steps[1].first);
    driver.click("panel/history/redo");
    EXPECT_EQ(driver.step, 2u);
    driver.click("panel/history/0");
    EXPECT_EQ(driver.document, driver.steps[0].first);
}

// Anything a hand may do on the right column leaves a valid document whose steps undo.
TEST(RightColumn, random_hands_leave_a_valid_document)
{
    OnPanel driver(Panel::materials);
    driver.editor.view.panes.inspector_share = 0.5f;
    std::mt19937 random(7);
    auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const int keys[] = {ui::key::enter, ui::key::escape, ui::key::tab, ui::key::backspace};
    int edits = 0;
    for (int i = 0; i < 1500; ++i) {
        graph::Document before = driver.document;
        driver.editor.view.panes.shown = true;  // hands that reach the menus hide them
        // Mostly on a widget.
        glm::vec2 at(900 + below(380), 28 + below(950));
        if (const auto& rects = driver.editor.rects.all(); below(4))
            at = std::next(rects.begin(), below(static_cast<int>(rects.size())))->second.centre();
        glm::vec2 to = at + glm::vec2(below(160) - 80, below(40) - 20);
        const auto& nodes = driver.document.root.nodes;
        switch (below(8)) {
            case 0: driver.drag(at, to, 0, 2); break;
            case 1: driver.double_click(at); break;
            case 2: driver.type(below(2) ? "0.5" : "-x9"); break;
            case 3: driver.key(keys[below(4)]); break;
            case 4: driver.editor.view.panel = static_cast<Panel>(below(8)); break;
            case 5:
                if (!nodes.empty()) driver.editor.view.selection.only(nodes[random() % nodes.size()].id);
                break;
            default: driver.click(at); break;
        }
        ASSERT_EQ(graph::validate(driver.document, *driver.library), std::nullopt) << "after event " << i;
        edits += driver.document != before;
    }
    EXPECT_GT(edits, 50);
}

std::vector<std::pair<std::string, ui::GlslKind>> words(std::string_view line, bool open = false)
{
    std::vector<std::pair<std::string, ui::GlslKind>> result;
    for (const ui::GlslToken& token : ui::glsl_tokens(line, open))
        result.emplace_back(line.substr(token.first, token.last - token.first), token.kind);
    return result;
}

TEST(GlslHighlight, tells_words_apart)
{
    using K = ui::GlslKind;
    using Words = std::vector<std::pair<std::string, K>>;
    EXPECT_EQ(words("return vec3(1.5e-3f, x0, max(y, .5)); // end"), (Words{{"return", K::keyword},
                                                                            {"vec3", K::type},
                                                                            {"(", K::plain},
                                                                            {"1.5e-3f", K::number},
                                                                            {",", K::plain},
                                                                            {"x0,", K::plain},
                                                                            {"max", K::function},
                                                                            {"(y,", K::plain},
                                                                            {".5", K::number},
                                                                            {"));", K::plain},
                                                                            {"// end", K::comment}}));
    EXPECT_EQ(words("#version 330 core"), (Words{{"#version 330 core", K::preprocessor}}));
    EXPECT_EQ(words("Ray ray;").front(), (std::pair<std::string, K>{"Ray", K::type}));
    EXPECT_EQ(words("a */ b", true).front(), (std::pair<std::string, K>{"a */", K::comment}));
}

TEST(GlslHighlight, a_block_comment_goes_on_to_the_next_line)
{
    bool open = false;
    ui::glsl_tokens("float a; /* begins", open);
    EXPECT_TRUE(open);
    EXPECT_EQ(ui::glsl_tokens("all of it", open).size(), 1u);
    EXPECT_TRUE(open);
    ui::glsl_tokens("ends */ float b;", open);
    EXPECT_FALSE(open);
}

}  // namespace
}  // namespace fieldwright::tests

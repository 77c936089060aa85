// Small pictures as they should be: a table of title -> scene, and every example. FIELDWRIGHT_WRITE_GOLDENS=1 draws them
// anew; look at what changed before you keep it.
#include "graph/scene_file.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <functional>
#include <map>

namespace fieldwright::tests {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::View;

NodeId wired(Scene& s, std::string_view type, NodeId d, std::initializer_list<Scene::Setting> settings = {})
{
    NodeId id = s.node(type, settings);
    s.wire(d, id, "d");
    return id;
}

NodeId both(Scene& s, std::string_view type, NodeId a, NodeId b, std::initializer_list<Scene::Setting> settings = {})
{
    NodeId id = s.node(type, settings);
    s.wire(a, id, "a");
    s.wire(b, id, "b");
    return id;
}

NodeId painted(Scene& s, NodeId field, vec3 colour)
{
    return s.node("paint", {{"d", field}, {"material", s.node("phong", {{"albedo", colour}})}});
}

NodeId red_ball(Scene& s)
{
    NodeId ball = wired(s, "translate", s.node("sphere", {{"radius", 0.8f}}), {{"offset", vec3(-0.5f, 0.3f, 0.3f)}});
    return painted(s, ball, {0.8f, 0.1f, 0.05f});
}

NodeId blue_box(Scene& s)
{
    NodeId box = wired(s, "translate", s.node("box", {{"half_size", vec3(0.6f, 0.5f, 0.6f)}}),
                       {{"offset", vec3(0.3f, -0.2f, 0)}});
    return painted(s, box, {0.05f, 0.2f, 0.8f});
}

using Make = std::function<NodeId(Scene&)>;

Make alone(const char* type)
{
    return [type](Scene& s) { return s.node(type); };
}

Make combined(const char* type)
{
    return [type](Scene& s) { return both(s, type, red_ball(s), blue_box(s)); };
}

Make applied(const char* type)
{
    return [type](Scene& s) { return wired(s, type, s.node("box", {{"half_size", vec3(0.4f, 0.8f, 0.25f)}})); };
}

Make extruded(const char* type)
{
    return [type](Scene& s) { return wired(s, "extrude", s.node(type)); };
}

Make applied_flat(const char* type)
{
    return [type](Scene& s) { return wired(s, "extrude", wired(s, type, s.node("rectangle"))); };
}

const std::map<std::string, Make>& scenes()
{
    static const std::map<std::string, Make> table = [] {
        std::map<std::string, Make> made;
        auto library = graph::Library::embedded();
        for (const graph::NodeType* type : library->types()) {
            const char* name = type->name.c_str();
            if (type->category == "primitive") made[type->name] = alone(name);
            else if (type->category == "shape2d") made[type->name] = extruded(name);
            else if (type->category == "combine") made[type->name] = combined(name);
            else if (type->category == "domain" && type->output == graph::SocketKind::field2d)
                made[type->name] = applied_flat(name);
            else if (type->category == "domain" || type->category == "modify") made[type->name] = applied(name);
        }
        made["revolve"] = [](Scene& s) { return wired(s, "revolve", s.node("rectangle")); };
        for (const char* convert : {"extrude_tapered", "extrude_twisted", "revolve_partial"})
            made[convert] = [convert](Scene& s) { return wired(s, convert, s.node("rectangle")); };
        made["sweep"] = [](Scene& s) {
            return wired(s, "sweep", s.node("rectangle", {{"half_size", glm::vec2(0.2f, 0.08f)}}));
        };
        made["project"] = [](Scene& s) { return wired(s, "extrude", wired(s, "project", s.node("torus_knot"))); };
        made["slice"] = [](Scene& s) { return wired(s, "extrude", wired(s, "slice", s.node("torus"))); };
        made["three_extrusions"] = [](Scene& s) {
            NodeId square = s.node("rectangle", {{"half_size", vec2(0.6f)}}),
                   round = s.node("circle", {{"radius", 0.6f}}),
                   pointed = s.node("isosceles_triangle", {{"half_width", 0.6f}, {"height", 1.2f}});
            return s.node("three_extrusions", {{"a", pointed}, {"b", square}, {"c", round}});
        };
        // What shows only where something is cut, or cuts.
        made["nested_shells"] = [](Scene& s) {
            return wired(s, "clip_plane", wired(s, "nested_shells", s.node("box")));
        };
        made["bounded"] = [](Scene& s) {
            NodeId balls = wired(s, "repeat", s.node("sphere", {{"radius", 0.2f}}), {{"spacing", vec3(0.45f)}});
            return both(s, "bounded", balls, s.node("box"));
        };
        made["invert"] = [](Scene& s) {
            return both(s, "intersect", s.node("sphere", {{"radius", 0.65f}}), wired(s, "invert", s.node("box")));
        };
        made["nothing"] = [](Scene& s) { return s.node("union"); };
        return made;
    }();
    return table;
}

std::filesystem::path golden(const std::string& title)
{
    return std::filesystem::path(FIELDWRIGHT_SOURCE_DIR) / "tests/goldens" / (title + ".png");
}

void compare(const std::string& title, const renderer::Picture& drawn)
{
    if (std::getenv("FIELDWRIGHT_WRITE_GOLDENS")) return renderer::write_png(golden(title), drawn);
    ASSERT_TRUE(std::filesystem::exists(golden(title)))
        << title << ": draw it with FIELDWRIGHT_WRITE_GOLDENS=1 and look at it";
    EXPECT_LE(share_apart(drawn, renderer::read_png(golden(title))), 0.001) << title;
}

Scene composed(const Make& make)
{
    Scene s;
    NodeId output = s.show(make(s));
    s.wire(s.node("perspective", {{"position", vec3(2.0f, 1.6f, 3.1f)}, {"target", vec3(0)}}), output, "camera");
    s.wire(s.node("gradient", {{"ground", vec3(0.02f, 0.02f, 0.03f)}}), output, "sky");
    s.node("sun");
    return s;
}

TEST(Goldens, of_every_field_type)
{
    for (const auto& [title, make] : scenes()) compare(title, picture_of(composed(make)));
}

TEST(Goldens, of_coverage)
{
    Scene scene = composed(combined("union"));
    scene.document.march.coverage = true;
    compare("coverage", picture_of(scene));
}

TEST(Goldens, of_every_view)
{
    Scene scene = composed(combined("smooth_union"));
    for (const std::string& view : renderer::view_names())
        compare("view_" + view, picture_of(scene, *renderer::view_from_name(view)));
}

// What lights and shows a scene; the categories are the names of the output's sockets.
bool is_setting(std::string_view category) { return category == "light" || category == "camera" || category == "sky"; }

TEST(Goldens, of_every_light_camera_and_sky)
{
    auto library = graph::Library::embedded();
    for (const graph::NodeType* type : library->types()) {
        if (!is_setting(type->category)) continue;
        Scene scene;
        NodeId output = scene.show(combined("union")(scene));
        NodeId made = scene.node(type->name);
        if (type->category != "light") scene.wire(made, output, type->category);
        if (type->category != "light") scene.node("sun");
        compare(type->category + "_" + type->name, picture_of(scene));
    }
}

// A ball of some material before a red ball and a blue box, on a checkered floor.
Scene staged(std::string_view material, std::initializer_list<Scene::Setting> settings)
{
    Scene scene = composed([&](Scene& s) {
        NodeId ball = wired(s, "translate", s.node("sphere", {{"radius", 0.55f}}), {{"offset", vec3(0.7f, 0, 0.9f)}});
        NodeId shown = s.node("paint", {{"d", ball}, {"material", s.node(material, settings)}});
        NodeId floor = s.node("paint", {{"d", s.node("plane", {{"height", -0.75f}})}, {"material", s.node("checker")}});
        return both(s, "union", both(s, "union", both(s, "union", red_ball(s), blue_box(s)), floor), shown);
    });
    scene.document.bounces = 3;
    return scene;
}

const std::map<std::string, Scene>& optics()
{
    static const std::map<std::string, Scene> table = [] {
        std::map<std::string, Scene> made;
        made.emplace("optics_glass", staged("glass", {}));
        made.emplace("optics_glass_milky",
                     staged("glass", {{"transmission", 0.5f}, {"colour", vec3(0.3f, 0.8f, 0.6f)}}));
        made.emplace("optics_mirror", staged("phong", {{"reflection", 0.8f}}));
        made.emplace("optics_metal", staged("metallic_roughness", {{"roughness", 0.1f}}));
        made.emplace("optics_fog", staged("phong", {})).first->second.document.fog = {.density = 0.35f, .start = 2.5f};
        return made;
    }();
    return table;
}

TEST(Goldens, of_mirrors_glass_and_fog)
{
    for (const auto& [title, scene] : optics()) compare(title, picture_of(scene));
}

TEST(Goldens, of_every_example)
{
    auto library = graph::Library::embedded();
    for (const auto& entry : std::filesystem::directory_iterator(FIELDWRIGHT_SOURCE_DIR "/examples")) {
        std::string file = entry.path().filename().string();
        if (!file.ends_with(".scene.json")) continue;
        Scene scene;
        scene.document = graph::open_scene(entry.path(), *library);
        compare("example_" + file.substr(0, file.find('.')), picture_of(scene));
    }
}

TEST(Goldens, are_all_drawn_by_some_test)
{
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FIELDWRIGHT_SOURCE_DIR "/tests/goldens"))
        files += entry.path().extension() == ".png" ? 1 : 0;
    std::size_t expected =
        scenes().size() + renderer::view_names().size() + optics().size() + 1;  // and that of coverage
    for (const graph::NodeType* type : graph::Library::embedded()->types())
        expected += is_setting(type->category) ? 1 : 0;
    for (const auto& entry : std::filesystem::directory_iterator(FIELDWRIGHT_SOURCE_DIR "/examples"))
        expected += entry.path().string().ends_with(".scene.json") ? 1 : 0;
    EXPECT_EQ(files, expected) << "a picture without a scene, or a scene without a picture";
}

}  // namespace
}  // namespace fieldwright::tests

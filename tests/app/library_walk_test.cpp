// Every node type through the command line, and a file dropped into a node folder.
#include "app/node_pages.h"
#include "app/scene_arguments.h"
#include "app/starter_scene.h"
#include "graph/scene_file.h"
#include "renderer/devices.h"
#include "renderer/picture.h"
#include "tests/app/program.h"

#include <nlohmann/json.hpp>
#include <set>

namespace fieldwright::tests {
namespace {

using Json = nlohmann::json;

class LibraryWalk : public InFolder {};

constexpr const char* all_categories[] = {"primitive", "shape2d",  "convert", "combine", "domain", "modify",
                                          "value",     "material", "light",   "camera",  "sky",    "output"};

Json node_types(const std::string& options = {})
{
    Outcome outcome = run_program(options + " nodes --json");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return Json::parse(outcome.output);
}

TEST_F(LibraryWalk, nodes_lists_at_least_240_types_of_12_categories)
{
    Json types = node_types();
    EXPECT_GE(types.size(), 240u);
    std::set<std::string> categories;
    for (const Json& type : types) {
        categories.insert(type.at("category").get<std::string>());
        EXPECT_FALSE(type.at("help").get<std::string>().empty()) << type.at("name");
        EXPECT_TRUE(type.contains("inputs") && type.contains("output") && type.contains("synonyms")) << type.at("name");
        for (const Json& parameter : type.at("parameters")) {
            EXPECT_FALSE(parameter.at("help").get<std::string>().empty()) << type.at("name") << parameter.at("name");
            EXPECT_TRUE(parameter.contains("default") || parameter.at("kind") == "material") << type.at("name");
        }
    }
    EXPECT_EQ(categories, std::set<std::string>(std::begin(all_categories), std::end(all_categories)));
}

TEST_F(LibraryWalk, one_type_of_every_category_makes_a_valid_small_scene_that_draws)
{
    std::set<std::string> walked;
    for (const Json& type : node_types()) {
        if (!walked.insert(type.at("category").get<std::string>()).second) continue;
        std::string name = type.at("name"), scene = path(name + ".scene.json"), picture = path(name + ".png");
        Outcome made = run_program("new -o " + scene + " --node " + name);
        ASSERT_EQ(made.code, 0) << name << ": " << made.errors;
        EXPECT_NE(read_text(scene).find("\"type\": \"" + name + "\""), std::string::npos) << name;
        Outcome checked = run_program("check --json " + scene);
        EXPECT_EQ(checked.code, 0) << name << ": " << checked.output;
        for (const Json& problem : Json::parse(checked.output).at("problems"))
            EXPECT_EQ(problem.at("severity"), "note") << name << checked.output;
        Outcome drawn = run_program("render " + scene + " --size 64x36 --device cpu -o " + picture);
        EXPECT_EQ(drawn.code, 0) << name << ": " << drawn.errors;
        EXPECT_TRUE(std::filesystem::exists(picture)) << name;
    }
    EXPECT_EQ(walked.size(), std::size(all_categories));
}

// The same in this process: a start of the program for each of some 250 types takes minutes.
TEST(LibraryScenes, every_type_makes_a_valid_small_scene_that_draws)
{
    auto library = graph::Library::embedded();
    for (const graph::NodeType* type : library->types()) {
        SCOPED_TRACE(type->name);
        app::StarterScene starter(library, *type);
        starter.compose();
        graph::Document read = graph::read_scene(graph::write_scene(starter.document, *library), *library);
        EXPECT_TRUE(read == starter.document);
        ASSERT_NE(read.root.find(starter.shown()), nullptr);
        graph::Program program = graph::lower(read, library);
        for (const graph::Problem& problem : program.problems)
            EXPECT_EQ(problem.severity, graph::Problem::Severity::note) << problem.sentence;
        renderer::Frame frame = renderer::render_on_cpu(program, {.width = 64, .height = 36});
        renderer::Picture picture = renderer::picture(frame, renderer::View::beauty, program.march.step_limit);
        if (type->name == "invert") continue;  // it fills the space in which the camera stands
        EXPECT_GT(std::set<std::uint8_t>(picture.rgb.begin(), picture.rgb.end()).size(), 4u);
    }
}

// A node dropped on the default box (or what it takes instead) shows at once what it is for, in a picture without holes.
TEST(LibraryScenes, every_operator_and_material_changes_the_picture_clearly)
{
    auto library = graph::Library::embedded();
    const std::set<std::string> walked = {"combine", "convert", "domain", "modify", "material"};
    for (const graph::NodeType* type : library->types()) {
        if (!walked.contains(type->category)) continue;
        SCOPED_TRACE(type->name);
        app::StarterScene starter(library, *type);
        starter.compose();
        auto drawn = [&] {
            return renderer::render_on_cpu(graph::lower(starter.document, library), {.width = 64, .height = 36});
        };
        renderer::Frame with = drawn();
        ASSERT_EQ(graph::set_muted(starter.document, starter.shown(), true), std::nullopt);
        renderer::Frame without = drawn();
        std::size_t pixels = with.colour.size(), changed = 0, holes = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            EXPECT_TRUE(std::isfinite(with.colour[i].x + with.colour[i].y + with.colour[i].z));
            changed += glm::distance(with.colour[i], without.colour[i]) > 0.03f ? 1 : 0;
            holes += with.exhausted[i] ? 1 : 0;
        }
        EXPECT_GE(100 * changed, pixels) << "changed " << changed << " of " << pixels << " pixels";
        EXPECT_LE(50 * holes, pixels) << holes << " of " << pixels << " rays ran out of steps";
    }
}

// In this process, with the functions of `new`: some 300 scenes.
TEST_F(LibraryWalk, every_number_can_be_set_to_both_ends_of_its_range)
{
    auto library = graph::Library::embedded();
    for (const Json& type : node_types())
        for (const Json& parameter : type.at("parameters")) {
            std::string kind = parameter.at("kind");
            if (kind != "number" && kind != "integer" && kind != "angle") continue;
            for (const char* end : {"minimum", "maximum"}) {
                std::string name = parameter.at("name"), value = parameter.at(end).dump();
                if (kind == "integer") value = value.substr(0, value.find('.'));
                SCOPED_TRACE(type.at("name").get<std::string>() + "." + name + "=" + value);
                app::StarterScene scene(library, *library->type(type.at("name").get<std::string>()));
                ASSERT_NO_THROW(app::set_from_text(scene.document, *library, scene.shown(), name, value));
                ASSERT_NO_THROW(scene.compose());
                EXPECT_EQ(graph::validate(scene.document, *library), std::nullopt);
            }
        }
}

TEST(NodeReference, has_the_page_and_picture_of_every_type_as_its_file_stands)
{
    std::filesystem::path folder = source_folder() / "docs/nodes";
    auto library = graph::Library::embedded();
    EXPECT_EQ(read_text(folder / "README.md"), app::node_index(*library)) << "run ./dev docs";
    std::size_t pages = 0;
    for (const graph::NodeType* type : library->types()) {
        std::string stem = (folder / app::node_page_stem(*type)).string();
        EXPECT_EQ(read_text(stem + ".md"), app::node_page(*type)) << type->name << ": run ./dev docs";
        EXPECT_TRUE(std::filesystem::exists(stem + ".png")) << type->name << ": run ./dev docs";
        ++pages;
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 2 * pages + 1) << "pages of types that are gone; remove them";
}

TEST_F(LibraryWalk, a_file_dropped_into_a_node_folder_is_a_new_node)
{
    std::filesystem::copy(source_folder() / "shaders", path("shaders"), std::filesystem::copy_options::recursive);
    write_text(path("shaders/nodes/primitive/pebble.glsl"),
               "// Pebble: a flattened ball.\n"
               "// field: bound\n"
               "float pebble_distance(\n"
               "    vec3 p,\n"
               "    float size)   // 1.0 [0.01, 10] m  Half of the width.\n"
               "{\n"
               "    return 0.5f * (length(vec3(p.x, 2.0f * p.y, p.z)) - size);\n"
               "}\n"
               "\n"
               "Box pebble_bounds(float size)\n"
               "{\n"
               "    return make_box(vec3(0.0f), vec3(size, 0.5f * size, size));\n"
               "}\n");
    std::string shaders = "--shaders " + path("shaders"), scene = path("pebble.scene.json");
    Json types = node_types(shaders);
    auto pebble =
        std::find_if(types.begin(), types.end(), [](const Json& type) { return type.at("name") == "pebble"; });
    ASSERT_NE(pebble, types.end());
    EXPECT_EQ(pebble->at("category"), "primitive");
    EXPECT_EQ(pebble->at("parameters").at(0).at("name"), "size");

    Outcome made = run_program("new " + shaders + " -o " + scene + " --node pebble --set size=0.8");
    ASSERT_EQ(made.code, 0) << made.errors;
    for (const char* device : {"gpu", "auto"}) {
        Outcome drawn = run_program("render " + scene + " " + shaders + " --size 64x36 --device " + device + " -o " +
                                    path("pebble.png"));
        EXPECT_EQ(drawn.code, 0) << drawn.errors;
    }
    Outcome refused =
        run_program("render " + scene + " " + shaders + " --size 64x36 --device cpu -o " + path("cpu.png"));
    EXPECT_EQ(refused.code, 1) << refused.errors;
    EXPECT_NE(refused.errors.find("pebble"), std::string::npos) << refused.errors;

    Outcome unknown = run_program("check " + scene);
    EXPECT_EQ(unknown.code, 3);
    EXPECT_NE(unknown.output.find("pebble"), std::string::npos) << unknown.output;
}

TEST_F(LibraryWalk, a_broken_node_file_is_named_with_its_line)
{
    std::filesystem::copy(source_folder() / "shaders", path("shaders"), std::filesystem::copy_options::recursive);
    write_text(
        path("shaders/nodes/primitive/broken.glsl"),
        "// Broken: not a node.\n// field: exact\nfloat broken_distance(vec3 p, float r)\n{\n    return 1.0f;\n}\n");
    Outcome outcome = run_program("--shaders " + path("shaders") + " nodes");
    EXPECT_EQ(outcome.code, 6);
    EXPECT_NE(outcome.errors.find("broken.glsl:3:"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace fieldwright::tests

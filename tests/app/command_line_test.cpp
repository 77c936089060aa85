// The command line's promises: what goes to which stream, the exit codes, refusals in one sentence.
#include "renderer/picture.h"
#include "tests/app/program.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace fieldwright::tests {
namespace {

using Json = nlohmann::json;

std::string first_example() { return (source_folder() / "examples/first.scene.json").string(); }

class CommandLine : public InFolder {
protected:
    // A refusal: the code, nothing on stdout, one sentence on stderr.
    void expect_refusal(const std::string& arguments, int code, const std::string& part, const std::string& input = {})
    {
        Outcome outcome = run_program(arguments, input);
        EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.errors;
        EXPECT_EQ(outcome.output, "") << arguments;
        EXPECT_TRUE(outcome.errors.starts_with("fieldwright: ")) << outcome.errors;
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << arguments << "\n" << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }

    std::string new_scene(const std::string& node, const std::string& more = {})
    {
        std::string scene = path(node + ".scene.json");
        Outcome outcome = run_program("new -o " + scene + " --node " + node + " " + more);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return scene;
    }
};

TEST_F(CommandLine, a_unit_sphere_answers_the_six_queries)
{
    std::string scene = new_scene("sphere");
    std::string third = "0.57735026918962576", half = "0.70710678118654752";
    Outcome outcome = run_program("eval " + scene, "0 0.75 0\n0 1.25 0\n\n# a comment\n0 1 0\n" + third + " " + third +
                                                       " " + third + "\n" + half + " 0 " + half + "\n0.40 0.00 0.30\n");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    std::istringstream answers(outcome.output);
    for (double expected : {-0.25, 0.25, 0.0, 0.0, 0.0, -0.5}) {
        double answer = 1e9;
        ASSERT_TRUE(answers >> answer);
        EXPECT_NEAR(answer, expected, 2e-6);
    }
    std::string rest;
    EXPECT_FALSE(answers >> rest) << rest;
}

TEST_F(CommandLine, eval_answers_a_thousand_points_in_order)
{
    std::string scene = new_scene("sphere"), points;
    for (int i = 0; i < 1000; ++i) points += std::to_string(i) + " 0 0\n";
    std::istringstream answers(run_program("eval " + scene, points).output);
    for (int i = 0; i < 1000; ++i) {
        double answer = 0;
        ASSERT_TRUE(answers >> answer);
        ASSERT_EQ(answer, i - 1.0);
    }
}

TEST_F(CommandLine, eval_names_the_line_that_is_no_point)
{
    std::string scene = new_scene("sphere");
    for (const char* line : {"1 2", "1 2 3 4", "1,2,3", "nan 0 0", "1e999 0 0", "x y z"}) {
        Outcome outcome = run_program("eval " + scene, std::string("2 0 0\n") + line + "\n");
        EXPECT_EQ(outcome.code, 3) << line;
        EXPECT_EQ(outcome.output, "1\n") << line;
        EXPECT_NE(outcome.errors.find("stdin:2:"), std::string::npos) << outcome.errors;
    }
}

TEST_F(CommandLine, the_cpu_refuses_shading_that_it_was_not_built_with)
{
    std::string scene = new_scene("sphere"), shaders = path("shaders"), picture = path("a.png");
    std::filesystem::copy(source_folder() / "shaders", shaders, std::filesystem::copy_options::recursive);
    std::string render = "--shaders " + shaders + " render " + scene + " --size 32x18 -q -o " + picture + " --device ";
    EXPECT_EQ(run_program(render + "cpu").code, 0) << "the same text is the same shading";
    std::filesystem::remove(picture);
    write_text(shaders + "/render/shading.glsl", read_text(shaders + "/render/shading.glsl") + "\n// Changed.\n");
    expect_refusal(render + "cpu", 1, "--device gpu");
    EXPECT_FALSE(std::filesystem::exists(picture));
    EXPECT_EQ(run_program(render + "auto").code, 0);
    EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST_F(CommandLine, usage_errors_exit_with_2)
{
    std::string scene = new_scene("sphere"), out = " -o " + path("a.png");
    expect_refusal("render " + scene, 2, "--output");
    expect_refusal("render " + scene + " -o " + path("a.gif"), 2, ".png");
    expect_refusal("render " + scene + " --view depth -o " + path("a.exr"), 2, "layer");
    expect_refusal("render " + scene + " --exposure 1 -o " + path("a.hdr"), 2, "light");
    expect_refusal("render " + scene + out + " --frames 1-2", 2, "####");
    expect_refusal("render " + scene + out + " --frames 2-1", 2, "frames");
    expect_refusal("render " + scene + out + " --tile 5/4", 2, "tile");
    expect_refusal("render " + scene + out + " --samples 0", 2, "samples");
    expect_refusal("render " + scene + out + " --samples 4 --grid 2", 2, "grid");
    expect_refusal("render " + scene + out + " --backdrop bright", 2, "bright");
    expect_refusal("render " + scene + out + " --anti-aliasing much", 2, "much");
    expect_refusal("render " + scene + " --enlarge 2 -o " + path("a.exr"), 2, "--enlarge");
    expect_refusal("render " + scene + " --backdrop transparent -o " + path("a.jpg"), 2, ".png");
    for (const char* size : {"0x1", "20000x10", "9000x9000", "big", "10x", "10x10x10", "-4x4"})
        expect_refusal("render " + scene + out + " --size " + size, 2, "");
    expect_refusal("render " + scene + out + " --device tpu", 2, "tpu");
    expect_refusal("render " + scene + out + " --view wrong", 2, "wrong");
    expect_refusal("render " + scene + out + " --time nan", 2, "finite");
    expect_refusal("render " + scene + " extra" + out, 2, "extra");
    expect_refusal("export " + scene + " --target basic" + out, 2, "basic");
    expect_refusal("new --node sphere", 2, "--output");
    expect_refusal("new --node no_such_node -o " + path("a.scene.json"), 2, "no_such_node");
    expect_refusal("rendr " + scene, 2, "rendr");
    expect_refusal(scene + " extra", 2, "extra");
}

TEST_F(CommandLine, without_a_display_the_window_is_refused_in_one_sentence)
{
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    std::string scene = new_scene("sphere");
    for (const std::string& words : {scene, "edit " + scene, std::string()}) expect_refusal(words, 4, "window");
}

TEST_F(CommandLine, a_bad_change_is_refused_with_its_reason)
{
    std::string scene = new_scene("sphere"), out = "render " + scene + " -o " + path("a.png") + " --set ";
    expect_refusal(out + "sphere.radius", 2, "no value");
    expect_refusal(out + "radius=1", 2, "names no node");
    expect_refusal(out + "cube.radius=1", 2, "cube");
    expect_refusal(out + "999.radius=1", 2, "999");
    expect_refusal(out + "sphere.size=1", 2, "size");
    expect_refusal(out + "sphere.radius=wide", 2, "wide");
    expect_refusal(out + "sphere.radius=nan", 2, "nan");
    expect_refusal(out + "sphere.radius=-1", 2, "must lie between");
    EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(CommandLine, set_changes_a_parameter_for_one_run)
{
    std::string scene = new_scene("sphere");
    std::string before = read_text(scene);
    EXPECT_EQ(run_program("eval " + scene + " --set sphere.radius=0.25", "1 0 0\n").output, "0.75\n");
    EXPECT_EQ(read_text(scene), before);
}

TEST_F(CommandLine, bad_scene_files_exit_with_3)
{
    write_text(path("bad.scene.json"), "{\"format\": ");
    for (const char* command : {"check ", "eval "})
        expect_refusal(command + path("bad.scene.json"), 3, "bad.scene.json");
    expect_refusal("render " + path("bad.scene.json") + " -o " + path("a.png"), 3, "bad.scene.json");
    expect_refusal("check " + path("missing.scene.json"), 3, "missing.scene.json");
    Outcome json = run_program("check --json " + path("bad.scene.json"));
    EXPECT_EQ(json.code, 3);
    EXPECT_FALSE(Json::parse(json.output).at("valid"));
}

TEST_F(CommandLine, a_place_that_cannot_hold_the_file_exits_with_5)
{
    std::string scene = new_scene("sphere");
    expect_refusal("render " + scene + " -o " + path("no/such/a.png"), 5, "does not exist");
    std::filesystem::create_directory(path("folder.png"));
    expect_refusal("render " + scene + " -o " + path("folder.png"), 5, "is a folder");
    expect_refusal("export " + scene + " --target glsl -o " + path("no/a.glsl"), 5, "does not exist");
    expect_refusal("new --node sphere -o " + path("no/a.scene.json"), 5, "does not exist");
}

TEST_F(CommandLine, without_gl_the_gpu_exits_with_4_and_auto_draws)
{
    std::string scene = new_scene("sphere"),
                no_gl = "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null LIBGL_ALWAYS_SOFTWARE=1 ";
    std::string render = no_gl + FIELDWRIGHT_BINARY + " render " + scene + " --size 16x16 -o " + path("a.png");
    EXPECT_EQ(run_shell(render + " --device gpu").code, 4);
    EXPECT_FALSE(std::filesystem::exists(path("a.png")));
    EXPECT_EQ(run_shell(render).code, 0);
    EXPECT_TRUE(std::filesystem::exists(path("a.png")));
}

TEST_F(CommandLine, render_is_silent_on_stdout_and_repeats_its_bytes)
{
    std::string render = "render " + first_example() + " --device cpu --size 64x36 -o ";
    Outcome outcome = run_program(render + path("a.png"));
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(run_program(render + path("b.png") + " --quiet").errors, "");
    EXPECT_EQ(read_text(path("a.png")), read_text(path("b.png")));
    EXPECT_GT(read_text(path("a.png")).size(), 100u);
}

TEST_F(CommandLine, time_and_set_change_the_picture)
{
    std::string render = "render " + first_example() + " --device cpu --size 64x36 -o ";
    ASSERT_EQ(run_program(render + path("a.png")).code, 0);
    ASSERT_EQ(run_program(render + path("b.png") + " --time 0.7").code, 0);
    EXPECT_NE(read_text(path("a.png")), read_text(path("b.png")));
}

TEST_F(CommandLine, check_counts_nodes_and_cost)
{
    Outcome outcome = run_program("check --json " + first_example());
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    Json json = Json::parse(outcome.output);
    EXPECT_TRUE(json.at("valid"));
    EXPECT_TRUE(json.at("problems").empty());
    EXPECT_GT(json.at("nodes"), 10);
    EXPECT_GT(json.at("cost"), 1);
    EXPECT_GT(json.at("step_budget"), 100);
}

TEST_F(CommandLine, info_and_version_are_json_on_request)
{
    Json info = Json::parse(run_program("info --json").output);
    for (const char* key : {"version", "gl_renderer", "instruction_set", "nodes", "threads"})
        EXPECT_TRUE(info.contains(key)) << key;
    EXPECT_GE(info.at("nodes"), 40);
    EXPECT_EQ(Json::parse(run_program("--version --json").output).at("version"), info.at("version"));
    EXPECT_TRUE(run_program("--version").output.starts_with("fieldwright "));
    for (const char* help : {"--help", "render --help", "new --help"}) {
        Outcome outcome = run_program(help);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_NE(outcome.output.find("--shaders"), std::string::npos) << help;
    }
}

TEST_F(CommandLine, slice_draws_the_field_on_a_plane)
{
    std::string scene = new_scene("sphere"), picture = path("slice.png");
    Outcome outcome =
        run_program("slice " + scene + " -o " + picture + " --style grey --size 80x40 --plane zx --offset 0.5");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    renderer::Picture drawn = renderer::read_png(picture);
    ASSERT_EQ(drawn.width, 80);
    ASSERT_EQ(drawn.height, 40);
    // Beside the middle: a unit sphere at 0.5 above its middle, 0.05 m to either side.
    double distance = 1 - std::sqrt(0.25 + 2 * 0.05 * 0.05);
    EXPECT_NEAR(drawn.rgb[3 * (20 * 80 + 40)], 255 * std::pow(distance, 1 / 2.2), 1.5);
    expect_refusal("slice " + scene + " -o " + path("slice.exr"), 2, ".png or .jpg");
    expect_refusal("slice " + scene + " -o " + picture + " --plane xz", 2, "--plane");
}

TEST_F(CommandLine, side_by_side_is_twice_as_wide_and_swaps_its_halves)
{
    std::string scene = new_scene("torus"), picture = path("eyes.png");
    std::string eyes = " --samples 1 --size 64x36 --interaxial 0.2 --stereo ";
    ASSERT_EQ(run_program("render " + scene + " -o " + picture + eyes + "side-by-side").code, 0);
    renderer::Picture both = renderer::read_png(picture);
    EXPECT_EQ(both.width, 128);
    EXPECT_EQ(both.height, 36);
    ASSERT_EQ(run_program("render " + scene + " -o " + picture + eyes + "side-by-side --swap-eyes").code, 0);
    renderer::Picture crossed = renderer::read_png(picture);
    bool differ = false;
    for (std::size_t y = 0; y < 36; ++y)
        for (std::size_t x = 0; x < 3 * 64; ++x) {
            ASSERT_EQ(both.rgb[3 * 128 * y + x], crossed.rgb[3 * 128 * y + 3 * 64 + x]);
            differ = differ || both.rgb[3 * 128 * y + x] != both.rgb[3 * 128 * y + 3 * 64 + x];
        }
    EXPECT_TRUE(differ) << "both eyes see the same";
    for (const char* option :
         {"--stereo-space gamma --stereo gray", "--toe-in --stereo naive", "--rivalry --stereo naive",
          "--view glow --full-scale 40", "--view steps --colour-map turbo"})
        EXPECT_EQ(run_program("render " + scene + " -o " + picture + " --samples 1 --size 64x36 " + option).code, 0)
            << option;
    expect_refusal("render " + scene + " -o " + picture + " --stereo 3d", 2, "--stereo");
}

}  // namespace
}  // namespace fieldwright::tests

// Every example as an export: it compiles where it is going to.
#include "tests/app/program.h"

namespace fieldwright::tests {
namespace {

class Export : public InFolder {
protected:
    void expect_compiles(const std::string& shader)
    {
        Outcome outcome = run_shell("glslangValidator " + shader);
        EXPECT_EQ(outcome.code, 0) << outcome.output;
    }
};

TEST_F(Export, every_example_compiles_as_glsl)
{
    for (const auto& scene : example_scenes()) {
        std::string shader = path(scene.stem().stem().string() + ".frag");
        Outcome outcome = run_program("export " + scene.string() + " --target glsl -o " + shader);
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        expect_compiles(shader);
    }
}

// As the site does: its declarations, our text, nothing else.
TEST_F(Export, every_example_compiles_in_the_shadertoy_wrapper)
{
    std::string wrapper = read_text(source_folder() / "tests/app/shadertoy_wrapper.glsl");
    ASSERT_FALSE(wrapper.empty());
    for (const auto& scene : example_scenes()) {
        std::string shader = path(scene.stem().stem().string());
        Outcome outcome = run_program("export " + scene.string() + " --target shadertoy -o " + shader);
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        write_text(shader + ".frag", wrapper + "\n" + read_text(shader));
        expect_compiles(shader + ".frag");
    }
}

TEST_F(Export, the_same_scene_gives_the_same_text)
{
    std::string scene = (source_folder() / "examples/first.scene.json").string();
    for (const char* name : {"a", "b"})
        ASSERT_EQ(run_program("export " + scene + " --target glsl -o " + path(name)).code, 0);
    EXPECT_EQ(read_text(path("a")), read_text(path("b")));
}

}  // namespace
}  // namespace fieldwright::tests

// What a scene does not use is not in its shader's text.
#include "codegen/features.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/shader_parts.h"
#include "tests/support/glslang.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using codegen::Placement;

std::string text_of(const Scene& scene, bool layers = false, bool counts = false)
{
    graph::Program program = scene.program();
    return codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), Placement::buffer, layers,
                                          counts);
}

// A sphere of one material.
Scene ball(std::string_view material, std::initializer_list<Scene::Setting> settings = {})
{
    Scene s;
    s.show(s.node("paint", {{"d", s.node("sphere")}, {"material", s.node(material, settings)}}));
    return s;
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(ShaderParts, keep_what_is_wanted_and_no_directive)
{
    std::string_view text = "a\n#if X\nb\n#if Y\nc\n#endif\n#else\nd\n#endif\ne";
    EXPECT_EQ(graph::with_parts(text, {}), "a\nd\ne");
    EXPECT_EQ(graph::with_parts(text, {"X"}), "a\nb\ne");
    EXPECT_EQ(graph::with_parts(text, {"X", "Y"}), "a\nb\nc\ne");
    EXPECT_EQ(graph::line_of_whole(text, {}, 2), 8) << "d";
    EXPECT_EQ(graph::line_of_whole(text, {"X", "Y"}, 4), 10) << "e";
    EXPECT_EQ(codegen::parts_of_shader(codegen::parts_comment({"X", "Y"}) + text.data()),
              (graph::ShaderParts{"X", "Y"}));
    EXPECT_EQ(graph::with_all_parts(text), "a\n\nb\n\nc\n\n\n\n\ne");
}

TEST(Features, of_a_painted_ball_are_none)
{
    Scene s = ball("phong");
    std::string text = text_of(s);
    for (std::string_view word :
         {"Bounce", "microfacet_highlight", "roughness;", "transmission;", "Fog", "Layers", "#if"})
        EXPECT_FALSE(has(text, word)) << word;
}

TEST(Features, evaluations_are_counted_when_asked_for_and_with_layers)
{
    Scene s = ball("phong");
    EXPECT_FALSE(has(text_of(s), "evaluations"));
    EXPECT_TRUE(has(text_of(s, false, true), "evaluations"));
    EXPECT_EQ(text_of(s, true, false), text_of(s, true, true));
}

TEST(Features, bounces_cost_nothing_where_nothing_mirrors)
{
    Scene s = ball("phong");
    std::string before = text_of(s);
    s.document.bounces = 8;
    EXPECT_EQ(text_of(s), before);
}

TEST(Features, bounces_are_in_the_text_where_something_mirrors)
{
    for (auto make : {+[] {
                          return ball("phong", {{"reflection", 0.1f}});
                      },
                      +[] { return ball("glass"); }, +[] { return ball("metallic_roughness"); }}) {
        Scene s = make();
        EXPECT_FALSE(has(text_of(s), "mirrored_bounce("));
        s.document.bounces = 3;
        std::string text = text_of(s);
        EXPECT_TRUE(has(text, "mirrored_bounce("));
        EXPECT_TRUE(has(text, "const int BOUNCES = 3;"));
    }
}

TEST(Features, a_mirror_is_dragged_without_a_change_of_the_text)
{
    Scene weak = ball("phong", {{"reflection", 0.1f}}), strong = ball("phong", {{"reflection", 0.7f}});
    weak.document.bounces = strong.document.bounces = 2;
    EXPECT_EQ(text_of(weak), text_of(strong));
}

TEST(Features, fog_is_in_the_text_only_when_there_is_any)
{
    Scene s = ball("phong");
    std::string before = text_of(s);
    s.document.fog.colour = glm::vec3(1, 0, 0);
    s.document.fog.start = 3;
    EXPECT_EQ(text_of(s), before);
    s.document.fog.density = 0.1f;
    std::string foggy = text_of(s);
    EXPECT_TRUE(has(foggy, "fog_transmittance"));
    s.document.fog.density = 0.2f;
    EXPECT_EQ(text_of(s), foggy);
}

TEST(Features, tinted_shadows_take_glass_that_casts_them_bounces_and_a_shadow)
{
    auto text = [](std::initializer_list<Scene::Setting> glass, int bounces, std::string shadow) {
        Scene s = ball("glass", glass);
        s.document.bounces = bounces;
        s.set(s.node("sun"), "shadow", std::move(shadow));
        return text_of(s);
    };
    EXPECT_TRUE(has(text({}, 2, "hard"), "beam_behind("));
    EXPECT_TRUE(has(text({{"shadow", std::string("none")}}, 2, "soft"), "beam_behind("));
    for (const std::string& plain :
         {text({{"shadow", std::string("full")}}, 2, "hard"), text({}, 0, "hard"), text({}, 2, "off")})
        for (std::string_view word : {"Beam", "tints_shadows", "last_ratio", "float shadow;"})
            EXPECT_FALSE(has(plain, word)) << word;
    Scene opaque = ball("phong", {{"reflection", 0.5f}});
    opaque.document.bounces = 2;
    opaque.node("sun");
    for (std::string_view word : {"Beam", "with_shadow"}) EXPECT_FALSE(has(text_of(opaque), word)) << word;
}

TEST(Features, a_lens_is_turned_where_there_is_one)
{
    auto text = [](float aperture) {
        Scene s = ball("phong");
        s.wire(s.node("perspective", {{"aperture", aperture}}), s.show(s.node("sphere")), "camera");
        return text_of(s);
    };
    EXPECT_FALSE(has(text(0), "turned_lens"));
    EXPECT_TRUE(has(text(0.1f), "turned_lens"));
    EXPECT_EQ(text(0.1f), text(0.2f)) << "a drag links nothing";
}

TEST(Features, coverage_is_in_the_text_only_when_it_is_chosen)
{
    Scene s = ball("phong");
    std::string before = text_of(s);
    for (std::string_view word : {"Edge", "Footprint", "covered", "COVERAGE"}) EXPECT_FALSE(has(before, word)) << word;
    s.document.march.coverage = true;
    EXPECT_TRUE(has(text_of(s), "beyond_ray("));
    s.document.march.coverage = false;
    EXPECT_EQ(text_of(s), before);
}

TEST(Features, in_all_combinations_give_valid_shaders_and_exports)
{
    std::vector<std::string> shaders;
    for (std::string_view material : {"phong", "glass", "metallic_roughness"})
        for (int bounces : {0, 2})
            for (int others = 0; others < 4; ++others) {
                float density = others % 2 ? 0.1f : 0.0f;
                Scene s = ball(material);
                s.document.march.coverage = others >= 2;
                s.document.picture.backdrop = bounces ? graph::Backdrop::colour : graph::Backdrop::sky;
                s.node("sun");
                s.document.bounces = bounces;
                s.document.fog.density = density;
                graph::Program program = s.program();
                for (bool layers : {false, true}) shaders.push_back(text_of(s, layers));
                shaders.push_back(
                    codegen::print_export(program, s.document, field::evaluate_frame(program, 0), "glsl"));
            }
    EXPECT_EQ(glslang_errors(shaders), "");
}

}  // namespace
}  // namespace fieldwright::tests

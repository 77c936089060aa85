// Settings in files, and the switches that became choices.
#include "graph/settings.h"
#include "graph/edits.h"
#include "graph/program.h"
#include "graph/scene_file.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

const Library& library() { return *Library::embedded(); }

std::string scene(const std::string& members)
{
    return R"({"format": "fieldwright", "version": 1, )" + members + R"("graphs": {"root": {"nodes": {}}}})";
}

std::string message(const std::string& text)
{
    try {
        read_scene(text, library(), "s");
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "accepted";
}

// Changes one setting, writes, reads, and expects that one to have come through.
template <typename Settings, typename Change>
void expect_kept(Settings Document::*settings, const Change& change)
{
    Document document;
    change(document.*settings);
    ASSERT_NE(document.*settings, Settings{});
    EXPECT_EQ(read_scene(write_scene(document, library()), library()), document);
}

template <typename Settings>
void expect_all_kept(Settings Document::*settings, const SettingTable<Settings>& table)
{
    for (const auto& count : table.counts)
        expect_kept(settings, [&](Settings& changed) { changed.*count.member += 3; });
    for (const auto& number : table.numbers)
        expect_kept(settings,
                    [&](Settings& changed) { changed.*number.member = changed.*number.member * 0.5f + 0.0078125f; });
    for (const auto& choice : table.choices)
        for (std::size_t i = 0; i < choice.words.size(); ++i) {
            if (i == choice.chosen(Settings{})) continue;
            expect_kept(settings, [&](Settings& changed) { choice.choose(changed, i); });
        }
    for (const auto& colour : table.colours)
        expect_kept(settings, [&](Settings& changed) { changed.*colour.member = {0.5f, 0.25f, 2.0f}; });
}

TEST(Settings, every_one_is_written_and_read)
{
    expect_all_kept(&Document::march, march_table);
    expect_all_kept(&Document::occlusion, occlusion_table);
    expect_all_kept(&Document::fog, fog_table);
    expect_all_kept(&Document::picture, picture_table);
    expect_all_kept(&Document::animation, animation_table);
}

TEST(Settings, have_limits_that_are_told)
{
    EXPECT_NE(message(scene(R"("march": {"step_scale": 9}, )")).find("$.march.step_scale: must lie between 0.01 and 4"),
              std::string::npos);
    EXPECT_NE(message(scene(R"("occlusion": {"samples": 0}, )")).find("$.occlusion.samples: must lie between 1 and 32"),
              std::string::npos);
    EXPECT_NE(message(scene(R"("march": {"normals": "none"}, )")).find(R"(must be `tetrahedron` or `central`)"),
              std::string::npos);
    EXPECT_NE(message(scene(R"("march": {"anti_aliasing": "much"}, )"))
                  .find("$.march.anti_aliasing: must be `none` or `coverage`"),
              std::string::npos);
    EXPECT_NE(message(scene(R"("march": {"steps": 1}, )")).find("`step_limit`"), std::string::npos);
    Document document;
    OcclusionSettings occlusion;
    occlusion.samples = 33;
    EXPECT_EQ(set_occlusion(document, occlusion), "“Samples” must lie between 1 and 32");
}

Shadow shadow_in_file(const std::string& value)
{
    Document document =
        read_scene(R"({"format": "fieldwright", "version": 1, "graphs": {"root": {"nodes": {"1": {"type":
        "sun", "parameters": {"shadow": )" +
                       value + "}}}}}}",
                   library());
    return lower(document, Library::embedded()).lights.at(0).shadow;
}

TEST(Shadow, switches_of_older_files_are_hard_or_off)
{
    EXPECT_EQ(shadow_in_file("true"), Shadow::hard);
    EXPECT_EQ(shadow_in_file("false"), Shadow::off);
    EXPECT_EQ(shadow_in_file(R"("soft")"), Shadow::soft);
    EXPECT_EQ(shadow_in_file(R"("soft_corrected")"), Shadow::soft_corrected);
    EXPECT_THROW(shadow_in_file(R"("true")"), Failure);
    EXPECT_THROW(shadow_in_file("1"), Failure);
}

TEST(Lowering, leaves_constants_undivided_for_ones_own_step_scale)
{
    Document document;
    NodeId box = add_node(document, library(), "box"), twist = add_node(document, library(), "twist"),
           output = add_node(document, library(), "output");
    ASSERT_EQ(connect(document, library(), box, twist, "d"), std::nullopt);
    ASSERT_EQ(connect(document, library(), twist, output, "d"), std::nullopt);
    auto divides = [&] {
        Program program = lower(document, Library::embedded());
        return std::any_of(program.instructions.begin(), program.instructions.end(), [](const Instruction& call) {
            return call.function && call.function->name == "divide_distance";
        });
    };
    EXPECT_TRUE(divides());
    document.march.own_step_scale = true;
    EXPECT_FALSE(divides());
}

}  // namespace
}  // namespace fieldwright::graph

// Texts and the outlines that documents keep of them.
#include "app/baking.h"
#include "graph/contours.h"
#include "graph/edits.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "graph/scene_file.h"
#include "tests/app/program.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

namespace fieldwright::tests {
namespace {

using app::Baking;
using graph::PointList;

class BakingTest : public InFolder {
protected:
    PointList outlines(NodeId node) const
    {
        return std::get<PointList>(*scene.document.root.find(node)->parameter("outlines"));
    }
    void bake() { baking.bake(scene.document, *scene.library); }
    std::vector<graph::Problem> notes() { return baking.notes(scene.document, *scene.library); }

    Scene scene;
    NodeId first = scene.node("text"), second = scene.node("text");
    Baking baking;
};

TEST_F(BakingTest, remakes_the_outlines_of_what_was_written_anew_and_of_nothing_else)
{
    baking.follow(scene.document, *scene.library);
    PointList before = outlines(first);
    bake();
    EXPECT_EQ(outlines(first), before);
    scene.set(first, "text", std::string("LIFT"));
    bake();
    EXPECT_EQ(outlines(first).size(), 6u + 4 + 10 + 8);
    EXPECT_EQ(outlines(second), before);
    scene.set(second, "letter_spacing", 0.5f);
    bake();
    EXPECT_NE(outlines(second), before);
    scene.set(second, "letter_spacing", 0.0f);
    bake();
    EXPECT_EQ(outlines(second).size(), before.size()) << "the default outlines are those of the default text";
}

TEST_F(BakingTest, leaves_texts_it_has_not_seen_before_as_they_are)
{
    scene.set(first, "text", std::string("LIFT"));
    PointList kept = outlines(first);
    bake();
    EXPECT_EQ(outlines(first), kept);
}

class GroupedText : public BakingTest {
protected:
    // One text in a group that lets its words be set, and two nodes of that group.
    GroupedText()
    {
        baking.follow(scene.document, *scene.library);
        one = graph::group_nodes(scene.document, *scene.library, {first}, "Sign").node;
        learn_groups();
        EXPECT_EQ(graph::expose(scene.document, *scene.library, "Sign", first, "text"), std::nullopt);
        learn_groups();
        other = scene.node("group:Sign");
        scene.show(scene.node("extrude", {{"d", scene.node("union", {{"a", one}, {"b", other}})}}));
        bake();
    }
    void learn_groups() { scene.library = graph::settle_groups(scene.document, *scene.library); }
    // By the words that the copies of the text have in the scene without groups.
    std::map<std::string, std::size_t> sides_drawn() const
    {
        std::map<std::string, std::size_t> sides;
        for (const graph::Node& node : graph::expanded(scene.document, *scene.library).document.root.nodes)
            if (node.type == "text" && node.id != second)
                sides[std::get<std::string>(*node.parameter("text"))] =
                    std::get<PointList>(*node.parameter("outlines")).size();
        return sides;
    }

    NodeId one, other;
};

TEST_F(GroupedText, has_the_outlines_of_its_own_words_in_every_node)
{
    scene.set(one, "text", std::string("LIFT"));
    scene.set(other, "text", std::string("I"));
    bake();
    EXPECT_EQ(sides_drawn(), (std::map<std::string, std::size_t>{{"LIFT", 28}, {"I", 4}}));
    EXPECT_EQ(
        std::get<PointList>(*graph::find_group(scene.document, "Sign")->graph.nodes[0].parameter("outlines")).size(),
        16u)
        << "those inside stay";
}

TEST_F(GroupedText, follows_what_is_changed_inside)
{
    ASSERT_EQ(graph::expose(scene.document, *scene.library, "Sign", first, "letter_spacing"), std::nullopt);
    learn_groups();
    scene.set(one, "text", std::string("LIFT"));
    bake();
    auto outlines_of = [&](NodeId node) {
        std::string name = graph::ready_made_name(first, "outlines");
        return std::get<PointList>(*scene.document.root.find(node)->parameter(name));
    };
    PointList before = outlines_of(one);
    {
        graph::Entered entered(scene.document, "Sign");
        scene.set(first, "alignment", 1.0f);
        scene.set(first, "line_spacing", 2.0f);
    }
    scene.set(one, "text", std::string("L\nIFT"));
    bake();
    EXPECT_NE(outlines_of(one), before);
    scene.set(other, "letter_spacing", 0.5f);
    bake();
    EXPECT_NE(outlines_of(other), outlines_of(one));
}

TEST_F(GroupedText, writes_through_groups_in_groups)
{
    NodeId outer = graph::group_nodes(scene.document, *scene.library, {other}, "Wall").node;
    learn_groups();
    NodeId inner = graph::find_group(scene.document, "Wall")->graph.nodes[0].id;
    ASSERT_EQ(graph::expose(scene.document, *scene.library, "Wall", inner, "text"), std::nullopt);
    learn_groups();
    scene.set(outer, "text", std::string("LIFT"));
    bake();
    EXPECT_EQ(sides_drawn(), (std::map<std::string, std::size_t>{{"LIFT", 28}, {"HI", 16}}));
}

TEST_F(GroupedText, keeps_its_outlines_when_it_is_saved_and_when_the_group_is_dissolved)
{
    scene.set(one, "text", std::string("LIFT"));
    bake();
    auto drawn = sides_drawn();
    auto plain = graph::Library::embedded();
    graph::Document read = graph::read_scene(graph::write_scene(scene.document, *scene.library), *plain);
    EXPECT_TRUE(read == scene.document);
    ASSERT_EQ(graph::ungroup(scene.document, one).refusal, std::nullopt);
    learn_groups();
    EXPECT_EQ(sides_drawn(), drawn);
}

TEST_F(GroupedText, says_on_its_node_which_font_is_missing)
{
    ASSERT_EQ(graph::expose(scene.document, *scene.library, "Sign", first, "font"), std::nullopt);
    learn_groups();
    scene.set(other, "font", std::string("No Such Font"));
    bake();
    ASSERT_EQ(notes().size(), 1u);
    EXPECT_EQ(notes()[0].node, other);
}

TEST_F(BakingTest, keeps_the_outlines_and_says_so_when_the_font_is_missing)
{
    baking.follow(scene.document, *scene.library);
    PointList kept = outlines(first);
    EXPECT_TRUE(notes().empty());
    scene.set(first, "font", std::string("No Such Font"));
    scene.set(first, "text", std::string("LIFT"));
    bake();
    EXPECT_EQ(outlines(first), kept);
    ASSERT_EQ(notes().size(), 1u);
    EXPECT_EQ(notes()[0].node, first);
    EXPECT_EQ(notes()[0].severity, graph::Problem::Severity::note);
    EXPECT_NE(notes()[0].sentence.find("`No Such Font` is not installed"), std::string::npos);
    scene.set(first, "font", std::string());
    bake();
    EXPECT_NE(outlines(first), kept);
    EXPECT_TRUE(notes().empty());
}

TEST_F(BakingTest, of_a_text_made_and_changed_by_the_command_line_is_saved_with_the_scene)
{
    std::string made = path("text.scene.json");
    ASSERT_EQ(run_program("new -o " + made + " --node text --set text=LIFT").code, 0);
    graph::Document document = graph::open_scene(made, *scene.library);
    PointList saved;
    for (const graph::Node& node : document.root.nodes)
        if (node.type == "text") saved = std::get<PointList>(*node.parameter("outlines"));
    EXPECT_EQ(saved.size(), 28u);
    auto distance = [&](const std::string& changes) {
        Outcome outcome = run_program("eval " + made + changes, "0 0 0\n");
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return outcome.output;
    };
    EXPECT_NE(distance(""), distance(" --set text.text=O"));
}

TEST_F(BakingTest, a_scene_whose_font_is_missing_opens_draws_and_notes_it_once)
{
    scene.set(first, "font", std::string("No Such Font"));
    scene.show(scene.node("extrude", {{"d", first}}));
    std::string file = path("missing.scene.json");
    graph::save_scene(file, scene.document, *scene.library);
    Outcome checked = run_program("check --json " + file);
    EXPECT_EQ(checked.code, 0) << checked.output;
    nlohmann::json problems = nlohmann::json::parse(checked.output).at("problems");
    ASSERT_EQ(problems.size(), 1u) << checked.output;
    EXPECT_EQ(problems[0].at("severity"), "note");
    Outcome drawn = run_program("render " + file + " --size 32x18 --device cpu -o " + path("missing.png"));
    EXPECT_EQ(drawn.code, 0) << drawn.errors;
    EXPECT_NE(drawn.errors.find("is not installed"), std::string::npos) << drawn.errors;
}

}  // namespace
}  // namespace fieldwright::tests

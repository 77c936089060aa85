// Node types that belong to a document: their texts, names, files and copies.
#include "graph/own_types.h"
#include "graph/adapt.h"
#include "graph/fragment.h"
#include "graph/own_type_edits.h"
#include "graph/program.h"
#include "graph/scene_file.h"
#include "tests/graph/small_library.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

#define EXPECT_SAYS(sentence, part) EXPECT_NE((sentence).find(part), std::string::npos) << (sentence)

// A sphere with another name.
std::string ball_text(const std::string& name, const std::string& body = "return length(p) - radius;")
{
    return "// Ball: round.\n// field: exact\nfloat " + name + "_distance(\n    vec3 p,\n" +
           "    float radius)   // 1.0 [0.01, 10] m  Distance from the centre to the surface.\n{\n    " + body +
           "\n}\n\n" + "Box " + name + "_bounds(float radius) { return make_box(vec3(0.0f), vec3(radius)); }\n";
}

class OwnTypes : public testing::Test {
protected:
    void add_ball(const std::string& name = "ball")
    {
        ASSERT_EQ(add_own_type(document, *library, {name, ball_text(name)}), std::nullopt);
        follow();
    }
    void set_text(const std::string& text)
    {
        ASSERT_EQ(set_own_type_text(document, "ball", text), std::nullopt);
        follow();
    }
    void follow()
    {
        library = with_own_types(*library, document.own_types);
        document = adapted(document, *library);
    }
    // What is wrong with the text as the document's own type `ball`.
    std::string refusal(const std::string& text)
    {
        auto extended = with_own_types(*library, {{"ball", text}});
        const TextError* error = extended->left_out("ball");
        return error ? sentence(*error) : "accepted";
    }

    std::shared_ptr<const Library> library = small_library();
    Document document;
};

TEST_F(OwnTypes, is_a_type_like_any_other_but_not_compiled)
{
    add_ball();
    const NodeType* type = library->type("ball");
    ASSERT_TRUE(type);
    EXPECT_EQ(type->category, "primitive");
    EXPECT_EQ(type->origin, Origin::document);
    EXPECT_FALSE(type->compiled);
    NodeId ball = add_node(document, *library, "ball");
    ASSERT_TRUE(ball);
    EXPECT_EQ(set_parameter(document, *library, ball, "radius", 2.0f), std::nullopt);
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_FALSE(small_library()->type("ball")) << "the library it stands on is as it was";
}

TEST_F(OwnTypes, the_library_of_another_document_does_not_know_them)
{
    add_ball();
    auto other = with_own_types(*library, {{"disc", ball_text("disc")}});
    EXPECT_FALSE(other->type("ball"));
    EXPECT_TRUE(other->type("disc"));
    EXPECT_EQ(library_for(library, document.own_types), library) << "the same types need no new library";
}

TEST_F(OwnTypes, survive_the_file)
{
    add_ball();
    NodeId ball = add_node(document, *library, "ball");
    ASSERT_EQ(set_parameter(document, *library, ball, "radius", 2.5f), std::nullopt);
    std::string text = write_scene(document, *library);
    EXPECT_EQ(read_scene(text, *small_library()), document);
    EXPECT_EQ(read_scene(text, *library), document);
    EXPECT_EQ(write_scene(read_scene(text, *small_library()), *library), text);
}

TEST_F(OwnTypes, a_scene_without_them_is_read_without_those_of_another)
{
    add_ball();
    Document plain = read_scene(R"({"format": "fieldwright", "version": 1, "graphs": {"root": {"nodes": {
        "1": {"type": "ball"}}}}})",
                                *library);
    EXPECT_FALSE(plain.root.nodes.front().unknown_source.empty());
}

TEST_F(OwnTypes, a_broken_text_keeps_nodes_values_and_wires)
{
    add_ball();
    NodeId ball = add_node(document, *library, "ball"), output = add_node(document, *library, "output");
    ASSERT_EQ(set_parameter(document, *library, ball, "radius", 2.5f), std::nullopt);
    ASSERT_EQ(connect(document, *library, ball, output, "d"), std::nullopt);
    Document whole = document;
    std::string good = document.own_types.front().text;
    set_text("// Ball: round.\n// field: exact\nfloat ball_distance(vec3 p) { return length(p) - 1.5; }\n");
    ASSERT_TRUE(library->left_out("ball"));
    EXPECT_EQ(sentence(*library->left_out("ball")), "line 3, column 50: the number 1.5 needs the suffix f, as in 1.5f");
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_EQ(read_scene(write_scene(document, *library), *small_library()), document);
    set_text(good);
    EXPECT_EQ(document, whole);
}

TEST_F(OwnTypes, a_node_with_a_broken_text_says_where_and_the_rest_is_lowered)
{
    auto base = Library::embedded();
    document.own_types = {{"ball", ball_text("ball", "return length(p) - radius")}};
    library = with_own_types(*base, document.own_types);
    NodeId sphere = add_node(document, *library, "sphere"), join = add_node(document, *library, "union");
    NodeId output = add_node(document, *library, "output");
    ASSERT_EQ(connect(document, *library, sphere, join, "a"), std::nullopt);
    ASSERT_EQ(connect(document, *library, join, output, "d"), std::nullopt);
    std::int64_t alone = lower(document, library).expanded_cost;
    document.own_types.front().text = "// Ball\n";
    library = with_own_types(*base, document.own_types);
    document.root.nodes.push_back(
        {.id = {document.next_id++}, .type = "ball", .unknown_source = R"({"type": "ball"})"});
    NodeId ball = document.root.nodes.back().id;
    ASSERT_EQ(connect(document, *library, ball, join, "b"), std::nullopt);
    Program program = lower(document, library);
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].node, ball);
    EXPECT_SAYS(program.problems[0].sentence, "line 1: the first line must read");
    EXPECT_EQ(program.expanded_cost, alone);
}

TEST_F(OwnTypes, a_held_back_type_has_sockets_and_counts_as_unconnected)
{
    auto base = Library::embedded();
    document.own_types = {{"ball", ball_text("ball")}};
    library = with_own_types(*base, document.own_types, {.refuse = [](const OwnType&) {
        return TextError{0, 0, "its code waits for your word"};
    }});
    NodeId ball = add_node(document, *library, "ball"), output = add_node(document, *library, "output");
    ASSERT_EQ(connect(document, *library, ball, output, "d"), std::nullopt);
    Program held = lower(document, library);
    EXPECT_FALSE(held.gpu_only);
    ASSERT_EQ(held.problems.size(), 1u);
    EXPECT_EQ(held.problems[0], (Problem{ball, "its code waits for your word; it counts as unconnected"}));
    LowerOptions its_bounds{.bounds = true, .root = ball};
    EXPECT_EQ(lower(document, library, its_bounds).bounds, no_value);
    Program free = lower(document, with_own_types(*base, document.own_types));
    EXPECT_TRUE(free.gpu_only);
}

TEST_F(OwnTypes, a_former_text_stands_in_for_one_that_may_not_run)
{
    auto base = Library::embedded();
    OwnType broken{"ball", "// Ball\n"}, other{"ball", ball_text("ball", "return 1.0f;")};
    OwnTypeRules rules{.former = {{"ball", ball_text("ball")}}};
    document.own_types = {broken};
    library = with_own_types(*base, {broken}, rules);
    ASSERT_TRUE(library->type("ball"));
    EXPECT_EQ(library->type("ball")->source.text, ball_text("ball"));
    NodeId ball = add_node(document, *library, "ball"), output = add_node(document, *library, "output");
    ASSERT_EQ(connect(document, *library, ball, output, "d"), std::nullopt);
    Program program = lower(document, library);
    EXPECT_TRUE(program.gpu_only) << "it is drawn";
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_SAYS(program.problems[0].sentence, "what it was before is shown");

    rules.refuse = [](const OwnType&) { return TextError{2, 0, "the driver does not like it"}; };
    library = with_own_types(*base, {other}, rules);
    EXPECT_TRUE(library->type("ball")->former);
    EXPECT_EQ(sentence(*library->left_out("ball")), "line 2: the driver does not like it");
    rules.refuse = {};
    library = with_own_types(*base, {other}, rules);
    EXPECT_FALSE(library->type("ball")->former);
    EXPECT_EQ(library->type("ball")->source.text, other.text);
    EXPECT_FALSE(library->left_out("ball"));
}

TEST_F(OwnTypes, refuses_what_could_hang_or_break_a_compiler)
{
    EXPECT_EQ(refusal(ball_text("ball")), "accepted");
    auto body = [&](const std::string& text) { return refusal(ball_text("ball", text)); };
    EXPECT_SAYS(refusal("// Ball: round.\n#define A B\n"), "line 2, column 1: preprocessor lines are not part");
    EXPECT_SAYS(body("while (true) { }\n    return 1.0f;"), "line 7, column 5: `while` is not part of the dialect");
    EXPECT_SAYS(body("for (int i = 0; i < 8; ) { }\n    return 1.0f;"), "expected `i`");
    EXPECT_SAYS(body("for (int i = 0; i < n; i++) { }\n    return 1.0f;"), "whole numbers");
    EXPECT_SAYS(body("for (int i = 0; i < 100000; i++) { }\n    return 1.0f;"), "loops 100000 times");
    for (const char* change : {"i = 0;", "i += 1;", "i--;", "++i;", "(i) = 0;", "(i)--;", "int i = 3;", "i <<= 1;",
                               "if (i == 3) i = 0;", "if (i == 3) { } else (i) = 0;", "i // here\n = 0;"})
        EXPECT_SAYS(body("for (int i = 0; i < 8; i++) { " + std::string(change) + " }\n    return 1.0f;"),
                    "the loop's counter `i` is changed");
    EXPECT_EQ(body("float s = 0.0f;\n    for (int i = 0; i < 8; i++) { s += float(i) * (1.0f - float(i + 1)); }\n"
                   "    return s;"),
              "accepted");
    EXPECT_SAYS(body("// hidden \\\n    return 1.0f;"), "a comment does not end with \\");
    EXPECT_SAYS(body("// hidden \r#define A B\n    return 1.0f;"), "lines end with a line feed");
    EXPECT_SAYS(body("return ball_distance(p, radius);"), "recursion");
}

// Each function calls the one before twice: a compiler that inlines has 2^30 of them.
TEST_F(OwnTypes, refuses_functions_that_grow_beyond_bounds_when_inlined)
{
    std::string helpers = "// Ball: round.\n// field: exact\nfloat ball_0(vec3 p) { return length(p); }\n";
    for (int i = 1; i < 30; ++i)
        helpers += "float ball_" + std::to_string(i) + "(vec3 p) { return ball_" + std::to_string(i - 1) +
                   "(p) + ball_" + std::to_string(i - 1) + "(p); }\n";
    helpers +=
        "float ball_distance(vec3 p) { return ball_29(p); }\nBox ball_bounds() { return make_box(vec3(0.0f), "
        "vec3(1.0f)); }\n";
    EXPECT_SAYS(refusal(helpers), "is too long with all the functions it calls");
}

TEST_F(OwnTypes, names_the_function_or_argument_that_does_not_fit)
{
    std::string bounds = "Box ball_bounds() { return make_box(vec3(0.0f), vec3(1.0f)); }\n";
    std::string head = "// Ball: round.\n// field: exact\n";
    EXPECT_SAYS(refusal(head + "vec3 ball_distance(vec3 p) { return p; }\n" + bounds),
                "line 3: `ball_distance` returns `float`");
    EXPECT_SAYS(refusal(head + "float ball_distance(vec3 p, vec2 uv) { return 1.0f; }\n" + bounds),
                "`uv` is a reserved");
    EXPECT_SAYS(refusal(head + "float ball_distance(float p) { return p; }\n" + bounds), "`vec3` or `vec2`");
    EXPECT_SAYS(refusal(head + "float disc_distance(vec3 p) { return 1.0f; }\n" + bounds), "must begin with `ball_`");
}

// The CPU, which divides steepness out, does not run the code: its author says how steep it is.
TEST(OwnSteepness, is_what_the_text_says_or_taken_as_four)
{
    auto lipschitz = [](const std::string& line, const std::string& function) {
        std::string text = "// Lump: steep.\n// field: bound\n" + line +
                           "float lump_distance(vec3 p) { return 3.0f * length(p) - 1.0f; }\n" + function +
                           "Box lump_bounds() { return make_box(vec3(0.0f), vec3(1.0f)); }\n";
        tests::Scene scene;
        EXPECT_EQ(add_own_type(scene.document, *scene.library, {"lump", text}), std::nullopt);
        scene.library = with_own_types(*scene.library, scene.document.own_types);
        scene.show(scene.node("lump"));
        Program program = scene.program();
        if (program.lipschitz == no_value) return 1.0f;
        return program
            .block[static_cast<std::size_t>(program.values[static_cast<std::size_t>(program.lipschitz)].slot)];
    };
    const std::string function = "float lump_lipschitz() { return 3.0f; }\n";
    EXPECT_EQ(lipschitz("", ""), 1);
    EXPECT_EQ(lipschitz("", function), 4);
    EXPECT_EQ(lipschitz("// lipschitz: 3\n", ""), 3);
    EXPECT_EQ(lipschitz("// lipschitz: 2.5\n", function), 2.5f);
}

TEST_F(OwnTypes, says_how_steep_it_is_in_numbers)
{
    for (const char* number : {"0.5", "steep", "2000"}) {
        std::string text = ball_text("ball");
        text.insert(text.find("// field"), std::string("// lipschitz: ") + number + "\n");
        EXPECT_SAYS(refusal(text), "line 2: `lipschitz` is a number from 1 to 1000");
    }
}

TEST_F(OwnTypes, names_never_collide)
{
    EXPECT_SAYS(*add_own_type(document, *library, {"sphere", ball_text("sphere")}), "that of a built-in node");
    EXPECT_SAYS(*add_own_type(document, *library, {"Ball", ""}), "a-z");
    EXPECT_SAYS(*add_own_type(document, *library, {"scene", ""}), "shaders use");
    add_ball();
    EXPECT_SAYS(*add_own_type(document, *library, {"ball", ""}), "already");
    // A type in a file may have any name: the node says what is wrong.
    auto extended = with_own_types(*library, {{"sphere", ball_text("sphere")}});
    EXPECT_SAYS(extended->left_out("sphere")->rule, "that of a built-in node");
    EXPECT_EQ(extended->type("sphere")->origin, Origin::program);
    // ball_x_distance as a helper of `ball` and as the meaning of `ball_x`.
    std::string helper = ball_text("ball") + "float ball_x_distance(vec3 p) { return 1.0f; }\n";
    auto both = with_own_types(*library, {{"ball", helper}, {"ball_x", ball_text("ball_x")}});
    EXPECT_SAYS(both->left_out("ball_x")->rule, "another node has a function `ball_x_distance`");
}

TEST_F(OwnTypes, a_fresh_name_is_free_and_counts_on)
{
    EXPECT_EQ(fresh_own_name(document, *library, "ball"), "ball");
    add_ball();
    EXPECT_EQ(fresh_own_name(document, *library, "ball"), "ball_2");
    add_ball("ball_2");
    EXPECT_EQ(fresh_own_name(document, *library, "ball_2"), "ball_3");
    EXPECT_EQ(fresh_own_name(document, *library, "sphere"), "sphere_2");
    EXPECT_EQ(fresh_own_name(document, *library, "My Ball!"), "my_ball_2");
    EXPECT_EQ(fresh_own_name(document, *library, "__"), "custom_2");
}

TEST_F(OwnTypes, renaming_goes_through_text_and_nodes)
{
    add_ball();
    NodeId node = add_node(document, *library, "ball");
    ASSERT_EQ(rename_own_type(document, *library, "ball", "pearl"), std::nullopt);
    follow();
    EXPECT_EQ(document.own_types, (std::vector<OwnType>{{"pearl", ball_text("pearl")}}));
    EXPECT_EQ(document.root.find(node)->type, "pearl");
    EXPECT_EQ(validate(document, *library), std::nullopt);
    EXPECT_SAYS(*rename_own_type(document, *library, "pearl", "sphere"), "built-in");
}

TEST_F(OwnTypes, a_type_in_use_is_not_removed)
{
    add_ball();
    NodeId node = add_node(document, *library, "ball");
    EXPECT_SAYS(*remove_own_type(document, "ball"), "is used by 1 node; remove it first");
    ASSERT_EQ(remove_node(document, node), std::nullopt);
    EXPECT_EQ(remove_own_type(document, "ball"), std::nullopt);
    EXPECT_TRUE(document.own_types.empty());
}

TEST_F(OwnTypes, one_node_of_several_gets_a_type_of_its_own)
{
    add_ball();
    NodeId first = add_node(document, *library, "ball"), second = add_node(document, *library, "ball");
    ASSERT_EQ(make_type_single(document, *library, second), std::nullopt);
    follow();
    EXPECT_EQ(document.root.find(first)->type, "ball");
    EXPECT_EQ(document.root.find(second)->type, "ball_2");
    EXPECT_EQ(find_own_type(document, "ball_2")->text, ball_text("ball_2"));
    EXPECT_EQ(validate(document, *library), std::nullopt);
}

TEST_F(OwnTypes, travel_with_copied_nodes)
{
    add_ball();
    NodeId node = add_node(document, *library, "ball");
    ASSERT_EQ(set_parameter(document, *library, node, "radius", 3.0f), std::nullopt);
    std::string text = copy_nodes(document, *library, {node});
    Document other;
    auto plain = small_library();
    Pasted pasted = paste_nodes(other, *plain, text, {0, 0});
    ASSERT_EQ(pasted.refusal, std::nullopt);
    auto known = with_own_types(*plain, other.own_types);
    EXPECT_EQ(other.own_types, document.own_types);
    EXPECT_EQ(validate(other, *known), std::nullopt);
    EXPECT_EQ(*other.root.find(pasted.nodes[0])->parameter("radius"), Value(3.0f));
    // Once more: the type is there already.
    ASSERT_EQ(paste_nodes(other, *known, text, {0, 0}).refusal, std::nullopt);
    EXPECT_EQ(other.own_types.size(), 1u);
    // Where the name means something else they come under another.
    ASSERT_EQ(set_own_type_text(other, "ball", ball_text("ball", "return 1.0f;")), std::nullopt);
    pasted = paste_nodes(other, *with_own_types(*plain, other.own_types), text, {0, 0});
    ASSERT_EQ(pasted.refusal, std::nullopt);
    EXPECT_EQ(other.root.find(pasted.nodes[0])->type, "ball_2");
    EXPECT_EQ(find_own_type(other, "ball_2")->text, ball_text("ball_2"));
    EXPECT_EQ(validate(other, *with_own_types(*plain, other.own_types)), std::nullopt);
}

TEST_F(OwnTypes, only_types_in_use_are_copied)
{
    add_ball();
    NodeId sphere = add_node(document, *library, "sphere");
    EXPECT_EQ(copy_nodes(document, *library, {sphere}).find("ball"), std::string::npos);
}

TEST_F(OwnTypes, the_folder_of_a_user_adds_nodes_that_documents_stand_on)
{
    auto with_user = with_user_nodes(*library, {{"primitive/pearl.glsl", ball_text("pearl")},
                                                {"broken.glsl", "// Broken\n"},
                                                {"mine/sphere.glsl", ball_text("sphere")}});
    ASSERT_TRUE(with_user->type("pearl"));
    EXPECT_EQ(with_user->type("pearl")->origin, Origin::user_folder);
    EXPECT_SAYS(sentence(*with_user->left_out("broken")), "line 1: the first line must read");
    EXPECT_SAYS(sentence(*with_user->left_out("sphere")), "built-in node");
    EXPECT_SAYS(*add_own_type(document, *with_user, {"pearl", ball_text("pearl")}), "a node in your folder");
    auto own = with_own_types(*with_user, {{"ball", ball_text("ball")}});
    EXPECT_TRUE(own->type("pearl") && own->type("ball"));
    EXPECT_TRUE(own->left_out("broken"));
    EXPECT_FALSE(with_user_nodes(*own, {})->type("pearl"));
    // A scene opens as it was, whatever the folder holds by now.
    std::string mine = ball_text("pearl", "return 1.0f;");
    auto scene = with_own_types(*with_user, {{"pearl", mine}});
    EXPECT_EQ(scene->type("pearl")->source.text, mine);
    EXPECT_EQ(with_own_types(*with_user, {})->type("pearl")->origin, Origin::user_folder);
}

TEST_F(OwnTypes, the_category_is_what_the_functions_mean)
{
    std::string bounds = "Box ball_bounds(Box child) { return child; }\n", head = "// Ball: round.\n// field: exact\n";
    auto category = [&](const std::string& text) {
        auto extended = with_own_types(*Library::embedded(), {{"ball", text}});
        const NodeType* type = extended->type("ball");
        return type ? type->category : sentence(*extended->left_out("ball"));
    };
    EXPECT_EQ(category(head + "float ball_distance(vec2 p) { return length(p); }\n" + bounds), "shape2d");
    EXPECT_EQ(category(head + "float ball_distance(float d) { return d; }\n" + bounds), "modify");
    EXPECT_EQ(category(head + "vec3 ball_point(vec3 p) { return p; }\n" + bounds), "domain");
    EXPECT_EQ(category(head + "vec2 ball_point(vec3 p) { return vec2(p.x, p.y); }\n" + bounds), "convert");
    EXPECT_EQ(category(head +
                       "float ball_distance(float a, float b) { return min(a, b); }\nfloat ball_blend(float a, "
                       "float b) { return 0.0f; }\n" +
                       bounds),
              "combine");
    EXPECT_EQ(category("// Ball: round.\nfloat ball_value() { return 1.0f; }\n"), "value");
    EXPECT_EQ(category("// Ball: round.\nMaterial ball_material() { return default_material(); }\n"), "material");
}

}  // namespace
}  // namespace fieldwright::graph

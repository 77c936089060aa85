// The parser of node files: what it reads, and what it refuses with file, line and rule.
#include "graph/library.h"
#include "graph/node_declaration.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

const char* const torus = R"(// Torus: a ring around the y axis.
// field: exact; bound
// synonyms: donut, ring
float torus_distance(
    vec3 p,
    float major,   // 1.0 [0.01, 10] m  Distance from the centre to the middle of the tube.
    float minor)   // 0.25 [0.01, 5] [0.1, 1] m  Radius of the tube.
{
    vec2 q = vec2(length(vec2(p.x, p.z)) - major, p.y);
    return length(q) - minor;
}

Box torus_bounds(float major, float minor) { return make_box(vec3(0.0f), vec3(major + minor, minor, major + minor)); }
)";

NodeType declare(const std::string& text, const std::string& path = "nodes/primitive/torus.glsl")
{
    return declare_node(parse_source(path, text, {"Box", "Material", "Light", "Ray", "Camera", "Sky"}));
}

std::string refusal(const std::string& text, const std::string& path = "nodes/primitive/bad.glsl")
{
    try {
        declare(text, path);
    } catch (const DialectError& error) {
        return error.what();
    }
    return "accepted";
}

// A node `bad` with one line in its body.
std::string with_body(const std::string& line)
{
    return refusal("// Bad: a test.\n// field: exact\nfloat bad_distance(vec3 p)\n{\n    " + line +
                   "\n    return p.x;\n}\n"
                   "Box bad_bounds() { return everywhere(); }\n");
}

TEST(Dialect, ASignatureIsTheDeclarationOfItsNode)
{
    NodeType type = declare(torus);
    EXPECT_EQ(type.name, "torus");
    EXPECT_EQ(type.category, "primitive");
    EXPECT_EQ(type.title, "Torus");
    EXPECT_EQ(type.help, "A ring around the y axis.");
    EXPECT_EQ(type.synonyms, (std::vector<std::string>{"donut", "ring"}));
    EXPECT_EQ(type.quality_outside, Quality::exact);
    EXPECT_EQ(type.quality_inside, Quality::bound);
    EXPECT_EQ(type.output, SocketKind::field3d);
    ASSERT_EQ(type.parameters.size(), 2u);
    EXPECT_EQ(type.parameters[1].name, "minor");
    EXPECT_EQ(std::get<float>(type.parameters[1].initial), 0.25f);
    EXPECT_EQ(type.parameters[1].maximum, 5);
    EXPECT_EQ(type.parameters[1].soft_maximum, 1);
    EXPECT_EQ(type.parameters[1].unit, "m");
    EXPECT_EQ(type.parameters[1].help, "Radius of the tube.");
    EXPECT_EQ(type.inputs.size(), 2u);
}

TEST(Dialect, inputs_may_have_points_and_titles_of_their_own)
{
    const std::string text =
        "// Bad: a test.\n// field: bound\n// inputs: Front, Inner part\n"
        "vec2 bad_point_a(vec3 p)\n{\n    return vec2(p.x, p.y);\n}\n"
        "float bad_distance(float a, float b)\n{\n    return max(a, b);\n}\n"
        "float bad_blend(float a, float b)\n{\n    return a;\n}\n"
        "Box bad_bounds()\n{\n    return everywhere();\n}\n";
    NodeType type = declare(text, "nodes/convert/bad.glsl");
    EXPECT_EQ(type.output, SocketKind::field3d);
    ASSERT_EQ(type.inputs.size(), 2u);
    EXPECT_EQ(type.inputs[0].kind, SocketKind::field2d);
    EXPECT_EQ(type.inputs[0].title, "Front");
    EXPECT_EQ(type.inputs[1].kind, SocketKind::field3d);
    EXPECT_EQ(type.inputs[1].title, "Inner part");
    std::string one_word = text;
    one_word.replace(one_word.find(", Inner part"), 12, "");
    EXPECT_NE(refusal(one_word).find("a word for every field input"), std::string::npos);
}

TEST(Dialect, a_combiner_of_three_says_how_much_of_the_third_shows)
{
    std::string text =
        "// Bad: a test.\n// field: bound\n"
        "float bad_distance(float a, float b, float c)\n{\n    return max(a, max(b, c));\n}\n"
        "float bad_blend(float a, float b)\n{\n    return a;\n}\n"
        "Box bad_bounds()\n{\n    return everywhere();\n}\n";
    EXPECT_NE(refusal(text).find("`bad_blend_c`"), std::string::npos);
    EXPECT_EQ(refusal(text + "float bad_blend_c(float c)\n{\n    return c;\n}\n"), "accepted");
}

std::string join(const std::string& inputs, const std::string& more = {})
{
    return "// Join: all of them.\n// field: bound\n// inputs: " + inputs +
           "\nfloat join_distance(float a, float b) { return min(a, b); }\n"
           "float join_blend(float a, float b) { return 0.0f; }\n" +
           more + "Box join_bounds(Box box_a, Box box_b) { return box_a; }\n";
}

TEST(Dialect, a_combiner_of_many_has_so_many_inputs)
{
    NodeType type = declare(join("up to 5"), "nodes/combine/join.glsl");
    EXPECT_EQ(type.most_inputs, 5);
    std::vector<std::string> names;
    for (const Socket& socket : type.inputs) names.push_back(socket.name);
    EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "shape_3", "shape_4", "shape_5"}));
    for (const Socket& socket : type.inputs) EXPECT_EQ(socket.kind, SocketKind::field_any);
    for (const char* count : {"up to 2", "up to 65", "up to many"})
        EXPECT_NE(refusal(join(count), "nodes/combine/join.glsl").find("a whole number from 3 to 64"),
                  std::string::npos)
            << count;
    std::string moving = "vec3 join_point(vec3 p) { return p; }\n";
    EXPECT_NE(refusal(join("up to 5", moving), "nodes/combine/join.glsl").find("moves no point"), std::string::npos);
}

TEST(Dialect, the_comment_of_the_first_function_is_no_help)
{
    NodeType type = declare(
        "// Dot: A point.\n// It is small.\n// field: exact\n// How small.\n"
        "float dot_size() { return 0.0f; }\n"
        "float dot_distance(vec3 p) { return length(p) - dot_size(); }\n"
        "Box dot_bounds() { return everywhere(); }\n",
        "nodes/primitive/dot.glsl");
    EXPECT_EQ(type.help, "A point. It is small.");
}

TEST(Dialect, loops_that_leave_off_at_the_end_of_a_list_are_counted_apart)
{
    SourceFile file = parse_source("nodes/shape2d/x.glsl",
                                   "// X: a test.\nfloat x_sum(List points)\n{\n    float sum = 0.0f;\n"
                                   "    for (int i = 0; i < 64; i++) {\n        // Until here.\n"
                                   "        if (i >= points.count) {\n            break;\n        }\n"
                                   "        sum += list_at(points, i).x;\n    }\n"
                                   "    for (int i = 0; i < 5; i++) { sum += 1.0f; }\n    return sum;\n}\n"
                                   "float x_twice(List points)\n{\n    return x_sum(points) + x_sum(points);\n}\n");
    EXPECT_EQ(file.functions[0].loop_iterations, 64 + 5);
    EXPECT_EQ(file.functions[0].list_iterations, 64);
    EXPECT_EQ(file.functions[0].list_loops, 1);
    EXPECT_EQ(file.functions[1].loop_iterations, 2 * 69);
    EXPECT_EQ(file.functions[1].list_loops, 2);
}

TEST(Dialect, a_list_in_cells_needs_a_canvas)
{
    auto text = [](const std::string& more) {
        return "// Bad: a test.\n// field: bound\nfloat bad_distance(\n    vec2 p,\n" + more +
               "    List points)  // [] [-64, 64] cells  Rectangles.\n{\n    return p.x;\n}\n"
               "Box bad_bounds()\n{\n    return everywhere();\n}\n";
    };
    EXPECT_NE(refusal(text("")).find("int parameter `cells`"), std::string::npos);
    EXPECT_EQ(refusal(text("    int cells,  // 16 [1, 64]  Side of the canvas.\n")), "accepted");
}

TEST(Dialect, LoopIterationsMultiplyThroughNestingAndCalls)
{
    SourceFile file = parse_source(
        "nodes/primitive/x.glsl",
        "// X: a test.\nfloat x_inner(float v)\n{\n    for (int i = 0; i < 4; i++) { v += 1.0f; }\n"
        "    return v;\n}\nfloat x_outer(float v)\n{\n    for (int i = 0; i < 3; i++) { v = x_inner(v); }\n"
        "    return v;\n}\n");
    EXPECT_EQ(file.functions[0].loop_iterations, 4);
    EXPECT_EQ(file.functions[1].loop_iterations, 3 + 3 * 4);
}

TEST(Dialect, RefusalsNameFileLineAndRule)
{
    EXPECT_NE(with_body("float x = 1.0;").find("nodes/primitive/bad.glsl:5: the number 1.0 needs the suffix f"),
              std::string::npos);
    EXPECT_NE(with_body("vec2 q = p.xz;").find(":5: the swizzle .xz"), std::string::npos);
    EXPECT_NE(with_body("while (true) { }").find("`while`"), std::string::npos);
    EXPECT_NE(with_body("float x = round(p.x);").find("floor(x + 0.5f)"), std::string::npos);
    EXPECT_NE(with_body("float x = bad_distance(p);").find("recursion"), std::string::npos);
    EXPECT_NE(with_body("for (int i = 0; i < n; i++) { }").find("whole numbers"), std::string::npos);
    EXPECT_NE(with_body("#define X").find("preprocessor"), std::string::npos);
    EXPECT_NE(with_body("/* x */").find("//"), std::string::npos);
}

TEST(Dialect, ANodeMustSayWhatItsParametersAre)
{
    std::string text = torus;
    text.replace(text.find("// 1.0"), 3, "");
    EXPECT_NE(refusal(text, "nodes/primitive/torus.glsl"), "accepted");
    EXPECT_NE(refusal("// Torus\n").find("Title"), std::string::npos);
    EXPECT_NE(refusal("// Torus: x.\nfloat torus_distance(vec3 p)\n{\n return p.x;\n}\n", "nodes/primitive/torus.glsl")
                  .find("field:"),
              std::string::npos);
}

TEST(Dialect, HowManyCopiesDifferIsAnInt)
{
    std::string text =
        "// Bad: a test.\n// field: exact\n// copies: 2\nvec3 bad_point(vec3 p, int copy)\n{\n    return p;\n}\n"
        "int bad_copies()\n{\n    return 1;\n}\n"
        "float bad_distance(float acc, float d)\n{\n    return min(acc, d);\n}\n"
        "Box bad_bounds(Box child) { return child; }\n";
    EXPECT_EQ(refusal(text), "accepted");
    text.replace(text.find("int bad"), 3, "float");
    EXPECT_NE(refusal(text).find("how many of its `copies` differ"), std::string::npos);
}

TEST(Dialect, WhetherBShowsIsABool)
{
    std::string text =
        "// Bad: a test.\n// field: exact\nfloat bad_distance(float a, float b)\n{\n    return min(a, b);\n}\n"
        "float bad_blend(float a, float b)\n{\n    return b < a ? 1.0f : 0.0f;\n}\n"
        "bool bad_shows_b(float a, float b)\n{\n    return b < a;\n}\n"
        "Box bad_bounds(Box box_a, Box box_b) { return box_a; }\n";
    EXPECT_EQ(refusal(text), "accepted");
    text.replace(text.find("bool"), 4, "float");
    EXPECT_NE(refusal(text).find("returns a bool"), std::string::npos);
}

TEST(Dialect, ADefaultOutsideItsRangeIsRefused)
{
    std::string text = torus;
    text.replace(text.find("1.0 [0.01"), 3, "11.");
    EXPECT_NE(refusal(text, "nodes/primitive/torus.glsl").find("must lie between 0.01 and 10 m"), std::string::npos);
}

TEST(Dialect, ValuesAreReadAsArtistsWriteThem)
{
    Parameter number{.name = "x", .kind = ParameterKind::number};
    EXPECT_EQ(std::get<float>(*parse_value(number, "1.5")), 1.5f);
    EXPECT_FALSE(parse_value(number, "1.5x"));
    EXPECT_FALSE(parse_value(number, "nan"));
    EXPECT_FALSE(parse_value(number, "1e999"));
    Parameter vector{.name = "v", .kind = ParameterKind::vec3};
    EXPECT_EQ(std::get<glm::vec3>(*parse_value(vector, "1, 2,3")), glm::vec3(1, 2, 3));
    Parameter colour{.name = "c", .kind = ParameterKind::colour};
    EXPECT_EQ(std::get<glm::vec3>(*parse_value(colour, "#ffffff")), glm::vec3(1));
    EXPECT_NEAR(std::get<glm::vec3>(*parse_value(colour, "#808080")).x, 0.21586f, 1e-4f);
    Parameter list{.name = "l", .kind = ParameterKind::list};
    EXPECT_EQ(std::get<PointList>(*parse_value(list, "[(0, 1), (2, 3)]")).size(), 2u);
}

TEST(Dialect, TextsFormulasAndNumbersOfTheHeaderAreParameters)
{
    std::string text =
        "// Bad: a test.\n// text motto: \"a: b  c\"  What it says.\n// number a: 2.0 [0, 9] [1, 3] m  How much.\n"
        "float bad_value(\n    float result,  // formula \"sin(a)\"  What it computes.\n"
        "    float scale)  // 1.0 [0, 9]  A factor.\n{\n    return result * scale;\n}\n";
    NodeType type = declare(text, "nodes/value/bad.glsl");
    ASSERT_EQ(type.parameters.size(), 4u);
    EXPECT_EQ(type.parameters[0].kind, ParameterKind::text);
    EXPECT_EQ(std::get<std::string>(type.parameters[0].initial), "a: b  c");
    EXPECT_EQ(type.parameters[0].help, "What it says.");
    EXPECT_EQ(type.parameters[1].kind, ParameterKind::formula);
    EXPECT_EQ(std::get<std::string>(type.parameters[1].initial), "sin(a)");
    EXPECT_EQ(type.parameters[2].name, "scale");
    EXPECT_EQ(type.parameters[3].name, "a");
    EXPECT_EQ(type.parameters[3].soft_maximum, 3);
    EXPECT_EQ(type.parameters[3].unit, "m");
    EXPECT_EQ(type.inputs.size(), 2u) << "the numbers can be wired, the words cannot";
    EXPECT_EQ(type.function("value")->arguments[1].parameter, 2);
    EXPECT_EQ(type.help, "A test.");
}

TEST(Dialect, ASwitchOfTheHeaderMayHaveANodeFollowAnother)
{
    auto node = [](const std::string& header) {
        return "// Bad: a test.\n" + header +
               "float bad_value(\n    float x)  // 1.0  A factor.\n{\n    return x;\n}\n";
    };
    const std::string follows = "// follows: sun while led\n", path = "nodes/value/bad.glsl";
    NodeType type = declare(node(follows + "// switch led: true older false  Whether.\n"), path);
    ASSERT_EQ(type.parameters.size(), 2u);
    EXPECT_EQ(type.parameters[1].kind, ParameterKind::boolean);
    EXPECT_EQ(type.parameters[1].initial, Value(true));
    EXPECT_EQ(type.parameters[1].older, Value(false));
    EXPECT_EQ(type.parameters[0].older, std::nullopt);
    EXPECT_EQ(type.follows, "sun");
    EXPECT_EQ(type.inputs.size(), 1u) << "a switch has no socket";
    EXPECT_NE(refusal(node(follows), path).find("`led` is no switch"), std::string::npos);
    EXPECT_NE(refusal(node("// follows: sun\n"), path).find("TYPE while SWITCH"), std::string::npos);
    EXPECT_NE(refusal(node("// switch led: true older 7  Whether.\n"), path).find("older default"), std::string::npos);
}

TEST(Dialect, AnImageIsAPathWhoseFunctionReceivesAList)
{
    auto node = [](const std::string& arguments) {
        return "// Bad: a test.\n// field: exact\nfloat bad_distance(\n    vec2 p,\n    " + arguments +
               "{\n    return p.x;\n}\nBox bad_bounds() { return make_box(vec3(0.0f), vec3(1.0f)); }\n";
    };
    NodeType type = declare(node("List photo)  // image  The file.\n"), "nodes/shape2d/bad.glsl");
    ASSERT_EQ(type.parameters.size(), 1u);
    EXPECT_EQ(type.parameters[0].kind, ParameterKind::image);
    EXPECT_EQ(type.parameters[0].initial, Value(std::string()));
    EXPECT_EQ(type.parameters[0].help, "The file.");
    EXPECT_TRUE(type.inputs.empty());
    EXPECT_EQ(value_error(type.parameters[0], std::string("a/b.png")), "");
    EXPECT_NE(value_error(type.parameters[0], std::string("a\x01")), "");
    EXPECT_NE(value_error(type.parameters[0], 1.0f), "");
    EXPECT_NE(refusal(node("float photo)  // image  It.\n"), "nodes/shape2d/bad.glsl").find("is a List"),
              std::string::npos);
    EXPECT_NE(refusal(node("List a1,  // image  It.\n    List a2)  // image  It.\n"), "nodes/shape2d/bad.glsl")
                  .find("a node has one image"),
              std::string::npos);
}

TEST(Dialect, WordsStandInQuotes)
{
    auto with = [](const std::string& line, const std::string& comment) {
        return refusal(
            "// Bad: a test.\n" + line + "\nfloat bad_value(\n    float x)  // " + comment + "\n{\n    return x;\n}\n",
            "nodes/value/bad.glsl");
    };
    EXPECT_EQ(with("// text a: \"\"  Nothing.", "formula \"x\"  It."), "accepted");
    EXPECT_NE(with("// text a: word  It.", "1.0  It.").find("stands in quotes"), std::string::npos);
    EXPECT_NE(with("// text a: \"word\" It.", "1.0  It.").find("two spaces"), std::string::npos);
    EXPECT_NE(with("// text p: \"\"  It.", "1.0  It.").find("reserved"), std::string::npos);
    EXPECT_NE(with("// text x: \"\"  It.", "1.0  It.").find("twice"), std::string::npos);
    EXPECT_NE(with("// synonyms: y", "formula x  It.").find("stands in quotes"), std::string::npos);
    EXPECT_NE(with("// synonyms: y", "formula \"x +\"  It.").find("column 4: a number"), std::string::npos);
    EXPECT_NE(with("// synonyms: y", "formula \"x\" over a  It.").find("which is no vec3"), std::string::npos);
    EXPECT_NE(with("// synonyms: y", "formula \"x\" under a  It.").find("`over`"), std::string::npos);
}

TEST(Dialect, TextsAreUtf8WithoutControlCharacters)
{
    Parameter text{.name = "t", .kind = ParameterKind::text};
    EXPECT_EQ(value_error(text, *parse_value(text, "Gr\u00fc\u00dfe,\n\t\u03b1")), "");
    EXPECT_EQ(value_error(text, std::string(4096, 'a')), "");
    EXPECT_NE(value_error(text, std::string(4097, 'a')), "");
    EXPECT_NE(value_error(text, std::string("\xff")), "");
    EXPECT_NE(value_error(text, std::string("a\0b", 3)), "");
    EXPECT_NE(value_error(text, 1.0f), "");
}

TEST(Dialect, TwoFilesOfOneNameAreRefused)
{
    std::map<std::string, std::string> texts = embedded_texts();
    texts["nodes/other/sphere.glsl"] = texts.at("nodes/primitive/sphere.glsl");
    EXPECT_THROW(Library::from_texts(texts, embedded_texts()), DialectError);
}

}  // namespace
}  // namespace fieldwright::graph

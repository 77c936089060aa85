// The strict JSON reader: what it keeps, where it says things stand, and what it refuses.
#include "graph/json.h"

#include "graph/problem.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::graph {
namespace {

std::string refusal(std::string_view text)
{
    try {
        JsonTree tree(text, "t");
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.exit_code, 3);
        return failure.what();
    }
    return "accepted";
}

float number(std::string_view text)
{
    JsonTree tree(text, "t");
    return tree.number(tree.root());
}

TEST(json, keeps_order_places_and_paths)
{
    std::string text = "\xEF\xBB\xBF{\r\n  \"b\": [1, {\"x y\": \"\\u00e9\\n\"}],\r\n  \"a\": null }\r\n";
    JsonTree tree(text, "t");
    const JsonValue* b = tree.first_child(tree.root());
    EXPECT_EQ(b->key, "b");
    EXPECT_EQ(tree.next_sibling(*b)->key, "a");
    const JsonValue* object = tree.next_sibling(*tree.first_child(*b));
    EXPECT_EQ(tree.source(*object), "{\"x y\": \"\\u00e9\\n\"}");
    const JsonValue* string = tree.first_child(*object);
    EXPECT_EQ(string->string, "\xC3\xA9\n");
    EXPECT_EQ(tree.path(*string), "$.b[1][`x y`]");
    try {
        tree.fail(*string, "no.");
    } catch (const Failure& failure) {
        EXPECT_STREQ(failure.what(), "t:2:20: $.b[1][`x y`]: no.");
    }
}

TEST(json, numbers_read_back_exactly)
{
    for (float value : {0.1f, -0.0f, 1e-45f, 3.4028235e38f, 1.0f / 3, 16777216.0f}) {
        std::string text;
        append_json_number(text, value);
        EXPECT_EQ(number(text), value) << text;
        EXPECT_EQ(std::signbit(number(text)), std::signbit(value));
    }
    EXPECT_EQ(number("1e-400"), 0.0f);
    EXPECT_EQ(number("1e-60"), 0.0f);
    EXPECT_THROW(number("1e39"), Failure);
    EXPECT_THROW(number("-1e300"), Failure);
}

TEST(json, strings_read_back_exactly)
{
    std::string value = "a\"b\\c\n\t\x01/\xE2\x82\xAC", text;
    append_json_string(text, value);
    JsonTree tree(text, "t");
    EXPECT_EQ(tree.string(tree.root()), value);
}

TEST(json, refuses_in_one_sentence_with_the_place)
{
    EXPECT_EQ(refusal(""), "t:1:1: $: the text ends too early; the file is cut off");
    EXPECT_EQ(refusal("{\"a\": 1"), "t:1:8: $: the text ends too early; the file is cut off");
    EXPECT_EQ(refusal("{\"a\": 1,\n \"a\": 2}"), "t:2:2: $.a: is written twice in the same object; remove one of them");
    EXPECT_EQ(refusal("{\"a\": NaN}"), "t:1:7: $.a: unexpected `NaN`; numbers must be finite");
    EXPECT_EQ(refusal("{\"a\": -Infinity}"), "t:1:7: $.a: unexpected `-Infinity`; numbers must be finite");
    EXPECT_EQ(refusal("{\"a\": [1e999]}"), "t:1:8: $.a: holds a number that is too large; write a finite one");
    EXPECT_EQ(refusal("{\"a\": \"\xFF\"}"), "t:1:8: $.a: holds bytes that are not UTF-8; save the file as UTF-8");
    EXPECT_EQ(refusal("{} {}"), "t:1:4: $: more text follows the end of the scene; remove it");
    EXPECT_EQ(refusal(std::string_view("{}\0x", 4)), "t:1:3: $: more text follows the end of the scene; remove it");
    EXPECT_EQ(refusal("[1,,2]"), "t:1:4: $: unexpected `,`; the text is not JSON here");
    EXPECT_EQ(refusal("// note\n{}"), "t:1:1: $: unexpected `/`; the text is not JSON here");
    EXPECT_EQ(refusal("[01]"), "t:1:2: $: unexpected `01`; the text is not JSON here");
}

TEST(json, keeps_its_limits)
{
    EXPECT_NE(refusal(std::string(100'000, '[')).find("nested more than 32 deep"), std::string::npos);
    EXPECT_EQ(refusal(std::string(32, '[') + std::string(32, ']')), "accepted");
    EXPECT_NE(refusal("\"" + std::string(70'000, 'x') + "\"").find("more than 65536 bytes"), std::string::npos);
    std::string many = "[0";
    for (int i = 0; i < 1'000'001; ++i) many += ",0";
    EXPECT_NE(refusal(many + "]").find("limit of 1000000 values"), std::string::npos);
    EXPECT_NE(refusal(std::string((16u << 20) + 1, ' ')).find("larger than 16 MB"), std::string::npos);
}

TEST(json, names_must_be_utf8)
{
    EXPECT_TRUE(is_utf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"));
    for (const char* bad : {"\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\xC3"})
        EXPECT_FALSE(is_utf8(bad)) << bad;
}

}  // namespace
}  // namespace fieldwright::graph

// Typed formulas: what they compute, and what they are refused for.
#include "graph/formula.h"

#include "graph/library.h"
#include "tests/graph/small_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fieldwright::graph {
namespace {

constexpr std::string_view names[] = {"x", "y", "z", "time", "a"};

Formula parsed(std::string_view text)
{
    ParsedFormula result = parse_formula(text, names);
    if (auto* error = std::get_if<FormulaError>(&result)) ADD_FAILURE() << text << ": " << error->sentence();
    return std::holds_alternative<Formula>(result) ? std::get<Formula>(result) : Formula{{{}}};
}

std::string refusal(std::string_view text)
{
    ParsedFormula result = parse_formula(text, names);
    auto* error = std::get_if<FormulaError>(&result);
    return error ? error->sentence() : "accepted";
}

double number(std::string_view text, double x = 0, double y = 0, double z = 0)
{
    return evaluate(parsed(text), std::vector<double>{x, y, z, 0.5, 2});
}

TEST(Formula, computes_what_mathematics_says_at_thousands_of_points)
{
    using Function = double (*)(double x, double y, double z);
    const std::pair<const char*, Function> known[] = {
        {"x + y * z", [](double x, double y, double z) { return x + y * z; }},
        {"x - y - z", [](double x, double y, double z) { return x - y - z; }},
        {"x / y / z", [](double x, double y, double z) { return x / y / z; }},
        {"-x^2 + (-x)^2", [](double, double, double) { return 0.0; }},
        {"2^3^2 - 512", [](double, double, double) { return 0.0; }},
        {"x^7", [](double x, double, double) { return std::pow(x, 7); }},
        {"x^-3", [](double x, double, double) { return std::pow(x, -3); }},
        {"abs(x)^1.3", [](double x, double, double) { return std::pow(std::abs(x), 1.3); }},
        {"(y ^ 2) ^ (z / 4)", [](double, double y, double z) { return std::pow(y * y, z / 4); }},
        {"sin(x) * cos(y) + tan(z)",
         [](double x, double y, double z) { return std::sin(x) * std::cos(y) + std::tan(z); }},
        {"asin(x / 4) + acos(y / 4)", [](double x, double y, double) { return std::asin(x / 4) + std::acos(y / 4); }},
        {"atan(x) + atan2(y, z)", [](double x, double y, double z) { return std::atan(x) + std::atan2(y, z); }},
        {"sqrt(x^2 + y^2 + z^2)", [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }},
        {"length(x, y)", [](double x, double y, double) { return std::hypot(x, y); }},
        {"sqrt(abs(x))", [](double x, double, double) { return std::sqrt(std::abs(x)); }},
        {"min(x, y, z) + max(x, y)",
         [](double x, double y, double z) {
             return std::min({x, y, z}) + std::max(x, y);
         }},
        {"clamp(x, -1, 2)", [](double x, double, double) { return std::clamp(x, -1.0, 2.0); }},
        {"mix(x, y, 0.25)", [](double x, double y, double) { return 0.75 * x + 0.25 * y; }},
        {"floor(x) + fract(y)", [](double x, double y, double) { return std::floor(x) + y - std::floor(y); }},
        {"mod(x, 1.5)", [](double x, double, double) { return x - 1.5 * std::floor(x / 1.5); }},
        {"sign(x)", [](double x, double, double) { return x > 0 ? 1.0 : -1.0; }},
        {"exp(x) + log(abs(y))", [](double x, double y, double) { return std::exp(x) + std::log(std::abs(y)); }},
        {"step(0.5, x)", [](double x, double, double) { return x < 0.5 ? 0.0 : 1.0; }},
        {"smoothstep(-1, 2, x)",
         [](double x, double, double) {
             double t = std::clamp((x + 1) / 3, 0.0, 1.0);
             return t * t * (3 - 2 * t);
         }},
        {"x < y ? x : y <= z ? 2 : 3", [](double x, double y, double z) { return x < y    ? x
                                                                                 : y <= z ? 2
                                                                                          : 3; }},
        {"(x > y) + (x >= z) + (x == x) + (x != x)",
         [](double x, double y, double z) { return (x > y) + (x >= z) + 1.0; }},
        {"pi + tau + e", [](double, double, double) { return 3 * M_PI + M_E; }},
        {"Sin(X) * A", [](double x, double, double) { return 2 * std::sin(x); }},
        {"time * a + 1.5e2 - .5", [](double, double, double) { return 150.5; }},
    };
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-4, 4);
    for (const auto& [text, function] : known) {
        Formula formula = parsed(text);
        for (int i = 0; i < 2000; ++i) {
            double x = anywhere(random), y = anywhere(random), z = anywhere(random);
            double expected = function(x, y, z), found = evaluate(formula, std::vector<double>{x, y, z, 0.5, 2});
            ASSERT_NEAR(found, expected, 1e-6 * (1 + std::abs(expected)))
                << text << " at " << x << " " << y << " " << z;
        }
    }
}

TEST(Formula, gives_a_finite_number_where_mathematics_has_none)
{
    EXPECT_EQ(number("1 / x"), 0);
    EXPECT_EQ(number("sqrt(x)", -4), 0);
    EXPECT_EQ(number("x ^ 0.5", -4), 0);
    EXPECT_EQ(number("x ^ 0"), 1);
    EXPECT_EQ(number("x ^ -1"), 0);
    EXPECT_EQ(number("(-2) ^ (3 * a - 3)"), -8);
    EXPECT_EQ(number("mod(x, 0)", 5), 5);
    EXPECT_NEAR(number("log(x)", -1), -46, 0.1);
    EXPECT_NEAR(number("exp(1000)"), 1e12, 1e3);
    EXPECT_EQ(number("1e12 * 1e12"), 1e12);
    EXPECT_NEAR(number("asin(2)"), M_PI / 2, 1e-6);
    EXPECT_EQ(number("smoothstep(1, 1, x)", 3), 0);
}

TEST(Formula, errors_name_the_column_and_what_to_do)
{
    const std::pair<const char*, const char*> errors[] = {
        {"", "column 1: the formula is empty; write for example x + 1"},
        {"x + sin(y", "column 8: a bracket is not closed"},
        {"(x + (y)", "column 1: a bracket is not closed"},
        {"x)", "column 2: this bracket was never opened"},
        {"x +", "column 4: a number, a variable or a bracket is missing here"},
        {"x * / y", "column 5: a number, a variable or a bracket is missing here"},
        {"2x", "column 2: an operator is missing here; write for example 2 * x"},
        {"x(y)", "column 2: an operator is missing here; write x * ("},
        {"foo + 1", "column 1: `foo` is not known here; the variables are x, y, z, time, a"},
        {"x + sine(x)", "column 5: there is no function `sine`"},
        {"sin x", "column 5: the function `sin` needs brackets after it"},
        {"atan2(x)", "column 1: `atan2` takes 2 numbers, here is 1"},
        {"sin()", "column 1: `sin` takes 1 number, here are 0"},
        {"x^2 = 1", "column 5: two numbers are compared with ==; a surface is where the formula is 0, without = 0"},
        {"x ? 1", "column 3: a ? needs a : and what holds else"},
        {"1e13", "column 1: this number is beyond 1e12"},
        {"x $ y", "column 3: the character `$` is not part of a formula"},
        {"\xCE\xB1 + x", "column 1: the character `\xCE\xB1` is not part of a formula"},
        {"x + y \xC3\x97 z", "column 7: the character `\xC3\x97` is not part of a formula"},
        {"x, y", "column 2: a comma stands only between the numbers a function takes"},
    };
    for (const auto& [text, sentence] : errors) EXPECT_EQ(refusal(text), sentence) << text;
}

TEST(Formula, nesting_and_length_have_limits)
{
    auto nested = [](std::string open, std::string close, int depth) {
        std::string text = "x";
        for (int i = 0; i < depth; ++i) text = open + text + close;
        return refusal(text);
    };
    for (auto [open, close] : {std::pair("(", ")"), {"sin(", ")"}, {"-", ""}, {"x^", ""}, {"x ? 1 : ", ""}}) {
        EXPECT_EQ(nested(open, close, 60), "accepted") << open;
        EXPECT_NE(nested(open, close, 70).find("nested more than 64 deep"), std::string::npos) << open;
    }
    EXPECT_NE(nested("(", "", 4000).find("64 deep"), std::string::npos);
    std::string longest = "x";
    while (longest.size() + 2 <= 4096) longest += "+x";
    EXPECT_EQ(refusal(longest), "accepted");
    EXPECT_EQ(refusal(longest + "+x+x"), "column 4097: a formula has at most 4096 bytes; split it over several nodes");
}

TEST(Formula, any_bytes_are_taken_without_harm)
{
    std::mt19937 random(11);
    const std::string pieces[] = {"x", "sin(", ")",  "(",        "+",    "-", "*",  "/",    "^",
                                  "1", ".5",   "e",  "1e5",      "?",    ":", "<=", "=",    "min(",
                                  ",", " ",    "pi", "\xC3\x97", "\xff", "$", "!=", "mod(", "length("};
    auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
    int accepted = 0;
    for (int i = 0; i < 60000; ++i) {
        std::string text;
        for (std::size_t left = below(24); left > 0; --left)
            text += i % 3 ? pieces[below(std::size(pieces))] : std::string(1, static_cast<char>(below(256)));
        ParsedFormula result = parse_formula(text, names);
        if (auto* error = std::get_if<FormulaError>(&result)) {
            ASSERT_GE(error->column, 1);
            ASSERT_LE(error->column, static_cast<int>(text.size()) + 1) << text;
            continue;
        }
        ++accepted;
        ASSERT_TRUE(std::isfinite(evaluate(std::get<Formula>(result), std::vector<double>{0, -1.5, 1e6, 3, 0})))
            << text;
    }
    EXPECT_GT(accepted, 300);
}

TEST(Formula, a_number_changes_no_structure)
{
    auto structure = [](std::string_view text) {
        Formula formula = parsed(text);
        for (FormulaTerm& term : formula.terms) term.number = 0;
        return formula;
    };
    EXPECT_EQ(structure("2 * x + 0.5 * x + sin(3 * y)"), structure("4 * x + 4 * x + sin(0.25 * y)"));
    EXPECT_NE(structure("x^2"), structure("x^3")) << "a whole exponent is a product";
    EXPECT_EQ(structure("x^2.5"), structure("x^1.5"));
}

TEST(Formula, what_is_written_twice_is_computed_once)
{
    EXPECT_EQ(parsed("sin(x + y) * sin(x + y)").terms.size(), 5u);
    EXPECT_EQ(parsed("sqrt(x^2 + y^2) - 1").terms.size(), 5u) << "x, y, their length, 1, the difference";
}

TEST(Formula, knows_the_numbers_of_its_node)
{
    const NodeType& type = *small_library()->type("words");
    EXPECT_TRUE(std::holds_alternative<Formula>(parse_formula("a * scale + x + time", type)));
    EXPECT_TRUE(std::holds_alternative<FormulaError>(parse_formula("motto", type)));
}

}  // namespace
}  // namespace fieldwright::graph

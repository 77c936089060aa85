// How steep formulas are: never steeper than the bound, and not much less.
#include "graph/slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fieldwright::graph {
namespace {

constexpr std::string_view names[] = {"x", "y", "z", "time", "k"};

Formula parsed(std::string_view text)
{
    ParsedFormula result = parse_formula(text, names);
    if (auto* error = std::get_if<FormulaError>(&result)) ADD_FAILURE() << text << ": " << error->sentence();
    return std::get<Formula>(result);
}

SlopeBound bound(std::string_view text, double reach, Interval k = {0.5, 0.5})
{
    Interval side{-reach, reach};
    return slope_bound(parsed(text), std::vector<Interval>{side, side, side, {-10, 10}, k});
}

// By differences at random points, a quarter of them at corners.
double sampled(std::string_view text, double reach, Interval k = {0.5, 0.5}, int count = 20000)
{
    constexpr double step = 1e-5;
    Formula formula = parsed(text);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> inside(-reach + step, reach - step), moment(-10, 10), number(k.low, k.high);
    double steepest = 0;
    for (int i = 0; i < count; ++i) {
        std::vector<double> at = {inside(random), inside(random), inside(random), moment(random), number(random)};
        for (std::size_t axis = 0; axis < 3 && i % 4 == 0; ++axis) at[axis] = std::copysign(reach - step, at[axis]);
        double gradient[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<double> low = at, high = at;
            low[axis] -= step, high[axis] += step;
            gradient[axis] = (evaluate(formula, high) - evaluate(formula, low)) / (2 * step);
        }
        steepest = std::max(steepest, std::hypot(gradient[0], gradient[1], gradient[2]));
    }
    return steepest;
}

struct Case {
    const char* formula;
    double reach;
};

const Case usual[] = {
    {"x^4 - x^2 + y^4 - y^2 + z^4 - z^2 + k", 1.05},
    {"x^2 + y^2 + z^2 - 1", 1.2},
    {"sqrt(x^2 + y^2 + z^2) - 1", 1.2},
    {"(sqrt(x^2 + z^2) - 0.7)^2 + y^2 - 0.09", 1},
    {"(x^2 + 2.25 * z^2 + y^2 - 1)^3 - x^2 * y^3 - 0.1 * z^2 * y^3", 1.3},
    {"81*(x^3+y^3+z^3)-189*(x^2*y+x^2*z+y^2*x+y^2*z+z^2*x+z^2*y)+54*x*y*z+126*(x*y+x*z+y*z)-9*(x^2+y^2+z^2)-9*(x+y+z)+"
     "1",
     1},
    {"4*(2.618*x^2-y^2)*(2.618*y^2-z^2)*(2.618*z^2-x^2)-4.236*(x^2+y^2+z^2-1)^2", 1.2},
    {"2*y*(y^2-3*x^2)*(1-z^2)+(x^2+y^2)^2-(9*z^2-1)*(1-z^2)", 1.5},
    {"max(abs(x), abs(y), abs(z)) - 0.5", 1},
    {"length(x, y, z) - 0.7 + 0.1 * sin(6 * x)", 1},
    {"y - 0.3 * sin(8 * sqrt(x^2 + z^2)) * exp(-2 * (x^2 + z^2))", 1},
    {"y + 0.2 * atan(3 * x) + log(2 + z)", 1},
    {"abs(x)^2.5 + abs(y)^2.5 + abs(z)^2.5 - 1", 1.1},
    {"x^2 / (1.5 + y) + z", 1},
};

TEST(Slope, is_a_bound_and_tight_for_usual_surfaces)
{
    for (const Case& known : usual) {
        SlopeBound found = bound(known.formula, known.reach);
        double seen = sampled(known.formula, known.reach);
        EXPECT_TRUE(found.bounded) << known.formula;
        EXPECT_GE(found.slope, seen * (1 - 1e-6)) << known.formula;
        EXPECT_LE(found.slope, seen * 1.2) << known.formula;
    }
}

// Formulas of random operations: whenever there is a bound, it holds.
TEST(Slope, is_a_bound_for_random_formulas)
{
    std::mt19937 random(17);
    auto below = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
    auto formula = [&](auto& self, int depth) -> std::string {
        const char* leaves[] = {"x", "y", "z", "k", "time", "0.7", "2", "x", "y"};
        if (depth == 0) return leaves[below(9)];
        auto a = [&] { return self(self, depth - 1); };
        switch (below(16)) {
            case 0: return "(" + a() + " + " + a() + ")";
            case 1: return "(" + a() + " - " + a() + ")";
            case 2: return "(" + a() + " * " + a() + ")";
            case 3: return "(" + a() + " / " + a() + ")";
            case 4: return "sin(" + a() + ")";
            case 5: return "cos(" + a() + ")";
            case 6: return "sqrt(" + a() + ")";
            case 7: return "min(" + a() + ", " + a() + ")";
            case 8: return "max(" + a() + ", " + a() + ")";
            case 9: return "abs(" + a() + ")";
            case 10: return "atan2(" + a() + ", " + a() + ")";
            case 11: return "length(" + a() + ", " + a() + ")";
            case 12: return "(" + a() + ")^2";
            case 13: return "abs(" + a() + ")^1.5";
            case 14: return "exp(-abs(" + a() + "))";
            default: return "log(1 + abs(" + a() + "))";
        }
    };
    int bounded = 0;
    for (int i = 0; i < 500; ++i) {
        std::string text = formula(formula, 3);
        SlopeBound found = bound(text, 1, {-1, 2});
        if (!found.bounded) continue;
        ++bounded;
        double seen = sampled(text, 1, {-1, 2}, 1500);
        ASSERT_GE(found.slope * (1 + 1e-4) + 1e-4, seen) << text;
    }
    EXPECT_GT(bounded, 200);
}

TEST(Slope, of_what_does_not_move_is_nothing)
{
    EXPECT_EQ(bound("3", 1).slope, 0);
    EXPECT_EQ(bound("sin(time) * k", 1).slope, 0);
    EXPECT_EQ(bound("floor(k) + sign(time)", 1).slope, 0);
}

TEST(Slope, says_where_no_bound_exists)
{
    for (const char* text :
         {"sqrt(x) - y", "1 / x", "floor(3 * x) - y", "x < y", "atan2(z, x)", "log(x)", "x^0.5", "asin(x)"})
        EXPECT_FALSE(bound(text, 1).bounded) << text;
    for (const char* text : {"sqrt(x + 2) - y", "1 / (x + 2)", "floor(0.1 * k) * x", "atan2(z, x + 2)", "(x + 2)^0.5"})
        EXPECT_TRUE(bound(text, 1).bounded) << text;
    EXPECT_TRUE(bound("x > 0 ? x : -x", 1).chooses);
    EXPECT_FALSE(bound("k > 0 ? x : -x", 1).chooses);
}

TEST(Slope, covers_every_value_a_number_may_have)
{
    EXPECT_NEAR(bound("k * x", 1, {-3, 2}).slope, 3, 1e-6);
    EXPECT_NEAR(bound("sin(k * x)", 1, {-3, 2}).slope, 3, 1e-6);
}

TEST(SlopeMemo, gives_what_a_search_gives_for_each_formula_and_box)
{
    SlopeMemo memo;
    auto box = [](double reach) {
        Interval side{-reach, reach};
        return std::vector<Interval>{side, side, side, {-10, 10}, {0.5, 0.5}};
    };
    for (int round = 0; round < 2; ++round)
        for (const char* text : {"x^2 + y^2", "sin(3 * x) * k", "sqrt(x)"})
            for (double reach : {0.5, 2.0}) {
                SlopeBound expected = slope_bound(parsed(text), box(reach)),
                           kept = memo.bound(parsed(text), box(reach));
                EXPECT_EQ(kept.slope, expected.slope) << text << " " << reach;
                EXPECT_EQ(kept.bounded, expected.bounded) << text << " " << reach;
            }
}

TEST(SlopeMemo, forgets_the_oldest_of_many)
{
    SlopeMemo memo;
    Interval side{-1, 1};
    for (int k = 0; k < 200; ++k) {
        std::vector<Interval> variables = {side, side, side, {-10, 10}, {k + 1.0, k + 1.0}};
        EXPECT_NEAR(memo.bound(parsed("k * x"), variables).slope, k + 1.0, 0.1 * (k + 1));
    }
}

}  // namespace
}  // namespace fieldwright::graph

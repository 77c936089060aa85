// From the text of a formula to its operations, by recursive descent.
#include "graph/formula_terms.h"
#include "graph/json.h"
#include "graph/limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace fieldwright::graph {
namespace {

using Operation = FormulaOperation;
using Terms = FormulaTerms;
using Arguments = std::span<const int>;

int folded(Terms& terms, Operation operation, Arguments arguments)
{
    int result = arguments[0];
    for (int argument : arguments.subspan(1)) result = terms.apply(operation, result, argument);
    return result;
}

struct Function {
    std::string_view name;
    std::size_t fewest, most;  // arguments
    int (*make)(Terms& terms, Arguments arguments);
};

template <Operation operation>
int plain(Terms& terms, Arguments arguments)
{
    return arguments.size() == 1 ? terms.apply(operation, arguments[0])
                                 : terms.apply(operation, arguments[0], arguments[1]);
}

constexpr Function functions[] = {
    {"sin", 1, 1, plain<Operation::sin>},
    {"cos", 1, 1, plain<Operation::cos>},
    {"tan", 1, 1,
     [](Terms& t, Arguments a) { return t.divide(t.apply(Operation::sin, a[0]), t.apply(Operation::cos, a[0])); }},
    {"asin", 1, 1, [](Terms& t, Arguments a) { return t.inverse_sine(a[0]); }},
    {"acos", 1, 1,
     [](Terms& t, Arguments a) { return t.subtract(t.literal(0.5 * std::numbers::pi), t.inverse_sine(a[0])); }},
    {"atan", 1, 2,
     [](Terms& t, Arguments a) { return t.apply(Operation::atan2, a[0], a.size() > 1 ? a[1] : t.literal(1)); }},
    {"atan2", 2, 2, plain<Operation::atan2>},
    {"sqrt", 1, 1, [](Terms& t, Arguments a) { return t.root(a[0]); }},
    {"abs", 1, 1, plain<Operation::abs>},
    {"min", 2, 8, [](Terms& t, Arguments a) { return folded(t, Operation::min, a); }},
    {"max", 2, 8, [](Terms& t, Arguments a) { return folded(t, Operation::max, a); }},
    {"clamp", 3, 3, [](Terms& t, Arguments a) { return t.clamp(a[0], a[1], a[2]); }},
    {"mix", 3, 3, [](Terms& t, Arguments a) { return t.add(a[0], t.multiply(t.subtract(a[1], a[0]), a[2])); }},
    {"floor", 1, 1, plain<Operation::floor>},
    {"fract", 1, 1, [](Terms& t, Arguments a) { return t.fraction(a[0]); }},
    {"mod", 2, 2, [](Terms& t, Arguments a) { return t.remainder(a[0], a[1]); }},
    {"sign", 1, 1, plain<Operation::sign>},
    {"exp", 1, 1, plain<Operation::exp>},
    {"log", 1, 1, plain<Operation::log>},
    {"pow", 2, 2, [](Terms& t, Arguments a) { return t.power(a[0], a[1]); }},
    {"length", 2, 8, [](Terms& t, Arguments a) { return folded(t, Operation::length, a); }},
    {"step", 2, 2, plain<Operation::less_equal>},
    {"smoothstep", 3, 3, [](Terms& t, Arguments a) { return t.smooth_step(a[0], a[1], a[2]); }},
};

constexpr std::pair<std::string_view, double> constants[] = {
    {"pi", std::numbers::pi}, {"tau", 2 * std::numbers::pi}, {"e", std::numbers::e}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
public:
    Parser(std::string_view text, std::span<const std::string_view> names) : text_(text), names_(names) {}

    Formula parse()
    {
        if (text_.size() > text_limit)
            fail(text_limit, "a formula has at most 4096 bytes; split it over several nodes");
        skip_space();
        if (at_end()) fail(0, "the formula is empty; write for example x + 1");
        int result = choice();
        if (!at_end()) fail_at_rest();
        return terms_.finish(result);
    }

private:
    // One more level of what stands within each other. Lives for a call.
    class Level {
    public:
        explicit Level(Parser& parser) : depth_(parser.depth_)
        {
            if (++depth_ > formula_depth_limit)
                parser.fail(parser.at_, "the formula is nested more than 64 deep here; split it over several nodes");
        }
        ~Level() { --depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        int& depth_;
    };

    [[noreturn]] void fail(std::size_t byte, std::string what) const
    {
        auto before = text_.substr(0, byte);
        auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
        throw FormulaError{1 + static_cast<int>(std::count_if(before.begin(), before.end(), begins_letter)),
                           std::move(what)};
    }

    // Where an operator or the end was expected.
    [[noreturn]] void fail_at_rest() const
    {
        char c = text_[at_];
        if (c == ')') fail(at_, "this bracket was never opened");
        if (c == ',') fail(at_, "a comma stands only between the numbers a function takes");
        if (c == '=') fail(at_, "two numbers are compared with ==; a surface is where the formula is 0, without = 0");
        if (is_letter(c) || is_digit(c) || c == '(' || c == '.')
            fail(at_, "an operator is missing here; write for example 2 * x");
        fail_at_character();
    }

    [[noreturn]] void fail_at_character() const
    {
        std::size_t end = at_ + 1;
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0) == 0x80) ++end;
        std::string letter(text_.substr(at_, end - at_));
        bool printable = static_cast<unsigned char>(letter[0]) > ' ' && letter != "\x7f" && is_utf8(letter);
        fail(at_, "the character" + (printable ? " `" + letter + "`" : "") + " is not part of a formula");
    }

    bool at_end() const { return at_ >= text_.size(); }

    void skip_space()
    {
        while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
            ++at_;
    }

    bool take(std::string_view symbol)
    {
        if (!text_.substr(std::min(at_, text_.size())).starts_with(symbol)) return false;
        at_ += symbol.size();
        skip_space();
        return true;
    }

    // condition ? a : b
    int choice()
    {
        Level level(*this);
        int condition = comparison();
        std::size_t question = at_;
        if (!take("?")) return condition;
        int yes = choice();
        if (at_end()) fail(question, "a ? needs a : and what holds else");
        if (!take(":")) fail_at_rest();
        int no = choice();
        return terms_.apply(Operation::choose, condition, yes, no);
    }

    int comparison()
    {
        int a = sum();
        if (take("<=")) return terms_.apply(Operation::less_equal, a, sum());
        if (take(">=")) return terms_.apply(Operation::less_equal, sum(), a);
        if (take("==")) return terms_.apply(Operation::equal, a, sum());
        if (take("!=")) return terms_.subtract(terms_.literal(1), terms_.apply(Operation::equal, a, sum()));
        if (take("<")) return terms_.apply(Operation::less, a, sum());
        if (take(">")) return terms_.apply(Operation::less, sum(), a);
        return a;
    }

    int sum()
    {
        int result = product();
        while (true) {
            if (take("+")) result = terms_.add(result, product());
            else if (take("-")) result = terms_.subtract(result, product());
            else return result;
        }
    }

    int product()
    {
        int result = signed_power();
        while (true) {
            if (take("*")) result = terms_.multiply(result, signed_power());
            else if (take("/")) result = terms_.divide(result, signed_power());
            else return result;
        }
    }

    // A sign binds less than a power: -x^2 is -(x^2).
    int signed_power()
    {
        bool minus = take("-");
        if (minus || take("+")) {
            Level level(*this);
            int power = signed_power();
            return minus ? terms_.negate(power) : power;
        }
        int base = single();
        if (!take("^")) return base;
        Level level(*this);
        return terms_.power(base, signed_power());
    }

    int single()
    {
        if (at_end()) fail(at_, "a number, a variable or a bracket is missing here");
        std::size_t start = at_;
        char c = text_[at_];
        if (take("(")) {
            int inner = choice();
            close(start);
            return inner;
        }
        if (is_letter(c)) return word();
        if (is_digit(c) || c == '.') return number();
        if (c == ')' || c == ',' || std::string_view("*/^<>=!?:").find(c) != std::string_view::npos)
            fail(at_, "a number, a variable or a bracket is missing here");
        fail_at_character();
    }

    void close(std::size_t opened)
    {
        if (take(")")) return;
        if (at_end()) fail(opened, "a bracket is not closed");
        fail_at_rest();
    }

    int number()
    {
        double value = 0;
        auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error == std::errc::invalid_argument) fail(at_, "a number needs digits");
        if (error != std::errc() || std::abs(value) > 1e12) fail(at_, "this number is beyond 1e12");
        at_ = static_cast<std::size_t>(end - text_.data());
        skip_space();
        return terms_.literal(value);
    }

    // Capitals are small letters.
    int word()
    {
        std::size_t start = at_;
        while (!at_end() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        std::string name(text_.substr(start, at_ - start));
        std::transform(name.begin(), name.end(), name.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        skip_space();
        if (!at_end() && text_[at_] == '(') return call(start, name);
        if (auto found = std::find(names_.begin(), names_.end(), name); found != names_.end())
            return terms_.variable(static_cast<int>(found - names_.begin()));
        for (const auto& [constant, value] : constants)
            if (constant == name) return terms_.literal(value);
        for (const Function& function : functions)
            if (function.name == name) fail(at_, "the function `" + name + "` needs brackets after it");
        fail(start, "`" + shown(name) + "` is not known here; the variables are " + variable_list());
    }

    int call(std::size_t start, std::string_view name)
    {
        auto function = std::find_if(std::begin(functions), std::end(functions),
                                     [&](const Function& known) { return known.name == name; });
        if (function == std::end(functions)) fail_at_name(start, name);
        std::size_t opened = at_;
        take("(");
        std::vector<int> arguments;
        if (!at_end() && text_[at_] != ')') do
                arguments.push_back(choice());
            while (take(","));
        close(opened);
        if (arguments.size() < function->fewest || arguments.size() > function->most)
            fail(start, "`" + std::string(name) + "` takes " + count_words(*function) + ", here " +
                            (arguments.size() == 1 ? "is 1" : "are " + std::to_string(arguments.size())));
        return function->make(terms_, arguments);
    }

    // Letters before a bracket that are no function.
    [[noreturn]] void fail_at_name(std::size_t start, std::string_view name) const
    {
        bool number = std::find(names_.begin(), names_.end(), name) != names_.end() ||
                      std::any_of(std::begin(constants), std::end(constants),
                                  [&](const auto& constant) { return constant.first == name; });
        if (number) fail(at_, "an operator is missing here; write " + std::string(name) + " * (");
        fail(start, "there is no function `" + shown(name) + "`");
    }

    static std::string count_words(const Function& function)
    {
        std::string few = std::to_string(function.fewest), many = std::to_string(function.most);
        if (function.fewest == function.most) return few + (function.fewest == 1 ? " number" : " numbers");
        return few + (function.most - function.fewest == 1 ? " or " : " to ") + many + " numbers";
    }

    static std::string shown(std::string_view name)
    {
        return name.size() > 32 ? std::string(name.substr(0, 32)) + "..." : std::string(name);
    }

    std::string variable_list() const
    {
        std::string list;
        for (std::string_view name : names_) list += (list.empty() ? "" : ", ") + std::string(name);
        return list;
    }

    std::string_view text_;
    std::span<const std::string_view> names_;
    Terms terms_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

std::vector<std::string_view> formula_functions()
{
    std::vector<std::string_view> list;
    for (const Function& function : functions) list.push_back(function.name);
    return list;
}

ParsedFormula parse_formula(std::string_view text, std::span<const std::string_view> names)
{
    try {
        return Parser(text, names).parse();
    } catch (FormulaError& error) {
        return std::move(error);
    }
}

}  // namespace fieldwright::graph

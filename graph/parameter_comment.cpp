// The comment, from left to right: default, words to choose from, ranges, unit, help.
#include "graph/parameter_comment.h"

#include "graph/text_parts.h"

#include <cstdlib>

namespace fieldwright::graph {
namespace {

constexpr std::string_view formula_word = "formula ", image_word = "image  ";

class ParameterComment {
public:
    ParameterComment(const Argument& argument, const std::string& file) : argument_(argument), file_(file)
    {
        parameter_.name = argument.name;
        parameter_.type = argument.type;
    }

    Parameter read()
    {
        std::string_view comment = argument_.comment;
        if (argument_.type.base == BaseType::none) words(ParameterKind::text, comment);
        else if (argument_.type.name == "Material") material();
        else if (comment.starts_with(formula_word)) formula(trim(comment.substr(formula_word.size())));
        else if (comment.starts_with(image_word)) image(trim(comment.substr(image_word.size())));
        else number(comment);
        return std::move(parameter_);
    }

private:
    [[noreturn]] void fail(const std::string& rule) const { throw DialectError(file_, argument_.line, rule); }

    void material()
    {
        parameter_.kind = ParameterKind::material;
        parameter_.help = argument_.comment;
    }

    void formula(std::string_view comment)
    {
        if (argument_.type.base != BaseType::real)
            fail("what the formula `" + argument_.name + "` computes is a float");
        words(ParameterKind::formula, comment);
    }

    void image(std::string_view help)
    {
        if (argument_.type.base != BaseType::list) fail("what is baked from an image is a List");
        parameter_.kind = ParameterKind::image;
        parameter_.initial = std::string();
        parameter_.help = help;
    }

    // `"default"  help` of a text, `"default" over half_size  help` of a formula.
    void words(ParameterKind kind, std::string_view comment)
    {
        std::size_t end = comment.starts_with('"') ? comment.find('"', 1) : std::string_view::npos;
        std::size_t gap = end == std::string_view::npos ? end : comment.find("  ", end);
        if (gap == std::string_view::npos)
            fail("the default of `" + argument_.name + "` stands in quotes, two spaces before its help");
        parameter_.kind = kind;
        parameter_.initial = std::string(comment.substr(1, end - 1));
        parameter_.help = trim(comment.substr(gap));
        over(trim(comment.substr(end + 1, gap - end - 1)));
        refuse_bad_initial();
    }

    void over(std::string_view words)
    {
        if (words.empty()) return;
        if (!words.starts_with("over ") || parameter_.kind != ParameterKind::formula)
            fail("after the default of `" + argument_.name + "` stands nothing, or `over` and half a box's size");
        parameter_.over = trim(words.substr(5));
    }

    void number(std::string_view comment)
    {
        std::size_t gap = comment.find("  ");
        if (gap == std::string_view::npos)
            fail("the comment of `" + argument_.name + "` needs two spaces before its help");
        parameter_.help = trim(comment.substr(gap));
        std::string_view rest = trim(comment.substr(0, gap));
        std::string_view initial = take_initial(rest);
        rest.remove_prefix(initial.size());
        std::string_view older = take_older(rest);
        choices(rest);
        ranges(rest);
        parameter_.unit = trim(rest);
        kind(initial);
        std::optional<Value> value = parse_value(parameter_, initial);
        if (!value)
            fail("the default `" + std::string(initial) + "` of `" + argument_.name + "` does not fit its type");
        parameter_.initial = *value;
        refuse_bad_initial();
        if (older.empty()) return;
        parameter_.older = parse_value(parameter_, older);
        if (!parameter_.older || !value_error(parameter_, *parameter_.older).empty())
            fail("the older default `" + std::string(older) + "` of `" + argument_.name + "` does not fit");
    }

    // `older VALUE`, up to the next space.
    static std::string_view take_older(std::string_view& rest)
    {
        constexpr std::string_view word = "older ";
        rest = trim(rest);
        if (!rest.starts_with(word)) return {};
        rest.remove_prefix(word.size());
        std::string_view older = take_initial(rest);
        rest.remove_prefix(older.size());
        return older;
    }

    // The default: a bracketed group or everything up to the first space.
    static std::string_view take_initial(std::string_view text)
    {
        char open = text.empty() ? ' ' : text.front();
        char close = open == '(' ? ')' : open == '[' ? ']' : ' ';
        std::size_t end = text.find(close);
        if (end == std::string_view::npos) return text;
        return text.substr(0, close == ' ' ? end : end + 1);
    }

    void choices(std::string_view& rest)
    {
        rest = trim(rest);
        if (!rest.starts_with("{")) return;
        std::size_t end = rest.find('}');
        if (end == std::string_view::npos) return;
        parameter_.choices = split(rest.substr(1, end - 1), ',');
        rest.remove_prefix(end + 1);
    }

    void ranges(std::string_view& rest)
    {
        bool hard = true;
        for (rest = trim(rest); rest.starts_with("["); rest = trim(rest)) {
            std::size_t end = rest.find(']');
            std::vector<std::string> parts = split(rest.substr(1, end == std::string_view::npos ? 0 : end - 1), ',');
            if (parts.size() != 2) fail("a range reads [min, max]");
            double low = std::strtod(parts[0].c_str(), nullptr), high = std::strtod(parts[1].c_str(), nullptr);
            if (!(low <= high)) fail("a range reads [min, max], the smaller number first");
            if (hard) parameter_.minimum = low, parameter_.maximum = high;
            parameter_.soft_minimum = low, parameter_.soft_maximum = high;
            hard = false;
            rest.remove_prefix(end + 1);
        }
    }

    void kind(std::string_view initial)
    {
        bool degrees = parameter_.unit == "deg" || parameter_.unit.starts_with("deg/");
        switch (argument_.type.base) {
            case BaseType::real: parameter_.kind = degrees ? ParameterKind::angle : ParameterKind::number; return;
            case BaseType::integer:
                parameter_.kind = parameter_.choices.empty() ? ParameterKind::integer : ParameterKind::choice;
                return;
            case BaseType::boolean: parameter_.kind = ParameterKind::boolean; return;
            case BaseType::vec2: parameter_.kind = ParameterKind::vec2; return;
            case BaseType::vec3:
                parameter_.kind = initial.starts_with("#") ? ParameterKind::colour
                                  : degrees                ? ParameterKind::angles
                                                           : ParameterKind::vec3;
                return;
            case BaseType::list: parameter_.kind = ParameterKind::list; return;
            default: fail("a parameter cannot be of type " + argument_.type.name);
        }
    }

    void refuse_bad_initial() const
    {
        if (std::string error = value_error(parameter_, parameter_.initial); !error.empty())
            fail("the default of `" + argument_.name + "` " + error);
    }

    const Argument& argument_;
    const std::string& file_;
    Parameter parameter_;
};

}  // namespace

Parameter parameter_of(const Argument& argument, const std::string& file)
{
    return ParameterComment(argument, file).read();
}

}  // namespace fieldwright::graph

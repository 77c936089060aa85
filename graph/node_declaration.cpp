// The declaration of a node, from header lines, parameter comments and function names.
#include "graph/node_declaration.h"

#include "graph/drawing.h"
#include "graph/formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace fieldwright::graph {
namespace {

constexpr std::array<std::string_view, 18> reserved_arguments = {
    "p",  "d",         "a",     "b",     "c",     "acc",   "copy",   "cell", "time",
    "uv", "direction", "child", "box_a", "box_b", "box_c", "camera", "sky",  "steepest"};
constexpr std::array<std::string_view, 17> meaning_suffixes = {
    "distance", "point",     "point_a", "point_b", "point_c", "cell",     "blend", "blend_c", "shows_b",
    "bounds",   "lipschitz", "stretch", "value",   "light",   "material", "ray",   "sky"};

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string_view trim(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    while (true) {
        std::size_t end = text.find(separator);
        std::string_view part = trim(text.substr(0, end));
        if (!part.empty()) parts.emplace_back(part);
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

class Declaration {
public:
    explicit Declaration(SourceFile source) { type_.source = std::move(source); }

    NodeType declare()
    {
        names_from_path();
        header();
        for (const Function& function : type_.source.functions) function_name(function);
        for (const Argument& line : header_parameters_) header_parameter(line);
        std::size_t of_header = type_.parameters.size();
        for (const Function& function : type_.source.functions)
            for (const Argument& argument : function.arguments) argument_role(function, argument);
        numbers_of_the_header_last(of_header);
        for (Function& function : type_.source.functions)
            for (Argument& argument : function.arguments) resolve_argument(argument);
        int values = 0;
        for (Parameter& parameter : type_.parameters)
            if (parameter.kind != ParameterKind::material) parameter.value_index = values++;
        sockets();
        formulas();
        promises();
        return std::move(type_);
    }

private:
    [[noreturn]] void fail(int line, const std::string& rule) const
    {
        throw DialectError(type_.source.path, line, rule);
    }

    // nodes/<category>/<name>.glsl
    void names_from_path()
    {
        std::filesystem::path path = type_.source.path;
        type_.name = path.stem().string();
        type_.category = path.parent_path().filename().string();
        bool plain = std::all_of(type_.name.begin(), type_.name.end(),
                                 [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
        if (!plain || type_.name.empty() || type_.name.find("__") != std::string::npos)
            fail(1, "a node's file name is made of a-z, 0-9 and single _");
    }

    void header()
    {
        const std::string& first = type_.source.header.front();
        std::size_t colon = first.find(": ");
        if (colon == std::string::npos) fail(1, "the first line must read `// Title: what it is.`");
        type_.title = first.substr(0, colon);
        type_.help = trim(std::string_view(first).substr(colon + 2));
        type_.help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(type_.help[0])));
        for (std::size_t i = 1; i < type_.source.header.size(); ++i) header_line(static_cast<int>(i) + 1);
    }

    void header_line(int line)
    {
        std::string_view text = type_.source.header[static_cast<std::size_t>(line) - 1];
        std::size_t colon = text.find(": ");
        std::string_view key = text.substr(0, colon == std::string_view::npos ? 0 : colon);
        std::string_view value = colon == std::string_view::npos ? "" : trim(text.substr(colon + 2));
        if (key == "field") {
            field_quality(line, value);
        } else if (key == "synonyms") {
            type_.synonyms = split(value, ',');
        } else if (key == "copies") {
            type_.copies = std::atoi(std::string(value).c_str());
            if (type_.copies < 1 || type_.copies > 64) fail(line, "`copies` is a whole number from 1 to 64");
        } else if (key == "point") {
            if (value != "affine") fail(line, "`point` is `affine`");
            type_.affine = true;
        } else if (key == "inputs") {
            input_titles_ = split(value, ',');
        } else if (key == "combiner") {
            if (value != "hard" && value != "hard associative")
                fail(line, "`combiner` is `hard` or `hard associative`");
            type_.scaling = value == "hard" ? Scaling::hard : Scaling::hard_associative;
        } else if (is_parameter(key)) {
            Type type = key.starts_with("text ") ? Type{} : Type{BaseType::real, "float"};
            header_parameters_.push_back({type, std::string(key.substr(key.find(' ') + 1)), std::string(value), line});
        } else {
            type_.help += " " + std::string(trim(text));
        }
    }

    static bool is_parameter(std::string_view key)
    {
        return (key.starts_with("text ") || key.starts_with("number ")) && key.find(' ') == key.rfind(' ');
    }

    // A parameter that no function need receive.
    void header_parameter(const Argument& line)
    {
        bool word = !line.name.empty() &&
                    line.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
        if (!word) fail(line.line, "a parameter's name is made of a-z, 0-9 and _");
        if (is_reserved(line.name)) fail(line.line, "`" + line.name + "` is a reserved name");
        if (type_.parameter(line.name)) fail(line.line, "the parameter `" + line.name + "` is declared twice");
        if (line.type.base == BaseType::none) words(line, ParameterKind::text, line.comment);
        else parameter(line);
    }

    // The texts of the header come first among the parameters, its numbers last.
    void numbers_of_the_header_last(std::size_t of_header)
    {
        auto first = type_.parameters.begin(), last = first + static_cast<std::ptrdiff_t>(of_header);
        auto numbers = std::stable_partition(
            first, last, [](const Parameter& parameter) { return parameter.kind == ParameterKind::text; });
        std::rotate(numbers, last, type_.parameters.end());
    }

    // `"default"  help` of a text, `"default" over half_size  help` of a formula.
    void words(const Argument& argument, ParameterKind kind, std::string_view comment)
    {
        std::size_t end = comment.starts_with('"') ? comment.find('"', 1) : std::string_view::npos;
        std::size_t gap = end == std::string_view::npos ? end : comment.find("  ", end);
        if (gap == std::string_view::npos)
            fail(argument.line, "the default of `" + argument.name + "` stands in quotes, two spaces before its help");
        Parameter parameter;
        parameter.name = argument.name;
        parameter.kind = kind;
        parameter.type = argument.type;
        parameter.initial = std::string(comment.substr(1, end - 1));
        parameter.help = trim(comment.substr(gap));
        over(parameter, argument.line, trim(comment.substr(end + 1, gap - end - 1)));
        if (std::string error = value_error(parameter, parameter.initial); !error.empty())
            fail(argument.line, "the default of `" + argument.name + "` " + error);
        type_.parameters.push_back(std::move(parameter));
    }

    void over(Parameter& parameter, int line, std::string_view words) const
    {
        if (words.empty()) return;
        if (!words.starts_with("over ") || parameter.kind != ParameterKind::formula)
            fail(line, "after the default of `" + parameter.name + "` stands nothing, or `over` and half a box's size");
        parameter.over = trim(words.substr(5));
    }

    void default_formula(const Parameter& parameter) const
    {
        ParsedFormula parsed = parse_formula(std::get<std::string>(parameter.initial), type_);
        if (auto* error = std::get_if<FormulaError>(&parsed))
            fail(1, "the default of `" + parameter.name + "` cannot be read, " + error->sentence());
    }

    // A formula over a box knows how steep it is there.
    void formulas() const
    {
        int over = 0;
        for (const Parameter& parameter : type_.parameters) {
            if (parameter.kind == ParameterKind::formula) default_formula(parameter);
            if (parameter.over.empty()) continue;
            const Parameter* half_size = type_.parameter(parameter.over);
            if (++over > 1) fail(1, "one formula of a node may be over a box");
            if (!half_size || half_size->kind != ParameterKind::vec3)
                fail(1, "the formula `" + parameter.name + "` is over `" + parameter.over + "`, which is no vec3");
        }
        for (const Function& function : type_.source.functions)
            if (argument_named(&function, "steepest") && over == 0)
                fail(function.line, "`steepest` is the slope of a formula over a box; the node has none");
    }

    // Nodes of values have no field inputs, so these letters are theirs.
    bool is_reserved(std::string_view name) const
    {
        constexpr std::array<std::string_view, 4> letters = {"a", "b", "c", "d"};
        return contains(reserved_arguments, name) && !(type_.function("value") && contains(letters, name));
    }

    void field_quality(int line, std::string_view value)
    {
        has_quality_ = true;
        std::vector<std::string> parts = split(value, ';');
        if (parts.empty() || parts.size() > 2)
            fail(line, "`field` reads `exact`, `bound` or `approximate S`, then `; inside`");
        type_.quality_outside = quality(line, parts[0]);
        type_.quality_inside = parts.size() == 2 ? quality(line, parts[1]) : type_.quality_outside;
    }

    Quality quality(int line, std::string_view word)
    {
        if (word == "exact") return Quality::exact;
        if (word == "bound") return Quality::bound;
        if (word.starts_with("approximate")) {
            std::string step(trim(word.substr(11)));
            type_.approximate_step = step.empty() ? 1.0f : std::strtof(step.c_str(), nullptr);
            if (!(type_.approximate_step > 0 && type_.approximate_step <= 1))
                fail(line, "the step of `approximate S` lies above 0 and at most 1");
            return Quality::approximate;
        }
        fail(line, "a field is `exact`, `bound` or `approximate S`");
    }

    void function_name(const Function& function)
    {
        if (!function.name.starts_with(type_.name + "_"))
            fail(function.line, "the function `" + function.name + "` must begin with `" + type_.name + "_`");
    }

    void argument_role(const Function& function, const Argument& argument)
    {
        bool reserved = is_reserved(argument.name);
        bool declared = type_.parameter(argument.name) != nullptr;
        std::string_view suffix = std::string_view(function.name).substr(type_.name.size() + 1);
        bool helper = !contains(meaning_suffixes, suffix);
        if (!argument.comment.empty()) {
            if (reserved) fail(argument.line, "`" + argument.name + "` is a reserved name and takes no comment");
            if (declared) fail(argument.line, "the parameter `" + argument.name + "` is declared twice");
            parameter(argument);
        } else if (!reserved && !declared && !helper) {
            fail(argument.line,
                 "the parameter `" + argument.name + "` needs a comment `default [min, max] unit  help` on its line");
        } else if (declared && !helper && type_.parameter(argument.name)->type != argument.type) {
            fail(argument.line, "the parameter `" + argument.name + "` has another type where it is declared");
        }
    }

    // Reserved names and Role are in the same order, after Role::parameter.
    void resolve_argument(Argument& argument) const
    {
        for (std::size_t i = 0; i < type_.parameters.size(); ++i)
            if (type_.parameters[i].name == argument.name) {
                argument.parameter = static_cast<int>(i);
                return;
            }
        auto found = std::find(reserved_arguments.begin(), reserved_arguments.end(), argument.name);
        if (found != reserved_arguments.end())
            argument.role = static_cast<Role>(1 + std::distance(reserved_arguments.begin(), found));
    }

    void image(const Argument& argument, std::string_view help)
    {
        if (argument.type.base != BaseType::list) fail(argument.line, "what is baked from an image is a List");
        for (const Parameter& other : type_.parameters)
            if (other.kind == ParameterKind::image) fail(argument.line, "a node has one image");
        Parameter parameter;
        parameter.name = argument.name;
        parameter.kind = ParameterKind::image;
        parameter.type = argument.type;
        parameter.initial = std::string();
        parameter.help = help;
        type_.parameters.push_back(std::move(parameter));
    }

    // `default [min, max] [soft min, soft max] unit  help`; a material has help only.
    void parameter(const Argument& argument)
    {
        Parameter parameter;
        parameter.name = argument.name;
        parameter.type = argument.type;
        std::string_view comment = argument.comment;
        if (argument.type.name == "Material") {
            parameter.kind = ParameterKind::material;
            parameter.help = comment;
            type_.parameters.push_back(std::move(parameter));
            return;
        }
        constexpr std::string_view formula = "formula ";
        if (comment.starts_with(formula)) {
            if (argument.type.base != BaseType::real)
                fail(argument.line, "what the formula `" + argument.name + "` computes is a float");
            return words(argument, ParameterKind::formula, trim(comment.substr(formula.size())));
        }
        if (comment.starts_with("image  ")) return image(argument, trim(comment.substr(7)));
        std::size_t gap = comment.find("  ");
        if (gap == std::string_view::npos)
            fail(argument.line, "the comment of `" + argument.name + "` needs two spaces before its help");
        parameter.help = trim(comment.substr(gap));
        std::string_view rest = trim(comment.substr(0, gap));
        std::string_view initial = take_initial(rest);
        rest.remove_prefix(initial.size());
        choices(parameter, rest);
        ranges(argument, parameter, rest);
        parameter.unit = trim(rest);
        kind(argument, parameter, initial);
        std::optional<Value> value = parse_value(parameter, initial);
        if (!value)
            fail(argument.line,
                 "the default `" + std::string(initial) + "` of `" + argument.name + "` does not fit its type");
        parameter.initial = *value;
        if (std::string error = value_error(parameter, parameter.initial); !error.empty())
            fail(argument.line, "the default of `" + argument.name + "` " + error);
        type_.parameters.push_back(std::move(parameter));
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

    void choices(Parameter& parameter, std::string_view& rest) const
    {
        rest = trim(rest);
        if (!rest.starts_with("{")) return;
        std::size_t end = rest.find('}');
        if (end == std::string_view::npos) return;
        parameter.choices = split(rest.substr(1, end - 1), ',');
        rest.remove_prefix(end + 1);
    }

    void ranges(const Argument& argument, Parameter& parameter, std::string_view& rest) const
    {
        bool hard = true;
        for (rest = trim(rest); rest.starts_with("["); rest = trim(rest)) {
            std::size_t end = rest.find(']');
            std::vector<std::string> parts = split(rest.substr(1, end == std::string_view::npos ? 0 : end - 1), ',');
            if (parts.size() != 2) fail(argument.line, "a range reads [min, max]");
            double low = std::strtod(parts[0].c_str(), nullptr), high = std::strtod(parts[1].c_str(), nullptr);
            if (!(low <= high)) fail(argument.line, "a range reads [min, max], the smaller number first");
            if (hard) parameter.minimum = low, parameter.maximum = high;
            parameter.soft_minimum = low, parameter.soft_maximum = high;
            hard = false;
            rest.remove_prefix(end + 1);
        }
    }

    void kind(const Argument& argument, Parameter& parameter, std::string_view initial) const
    {
        bool degrees = parameter.unit == "deg" || parameter.unit.starts_with("deg/");
        switch (argument.type.base) {
            case BaseType::real: parameter.kind = degrees ? ParameterKind::angle : ParameterKind::number; return;
            case BaseType::integer:
                parameter.kind = parameter.choices.empty() ? ParameterKind::integer : ParameterKind::choice;
                return;
            case BaseType::boolean: parameter.kind = ParameterKind::boolean; return;
            case BaseType::vec2: parameter.kind = ParameterKind::vec2; return;
            case BaseType::vec3:
                parameter.kind = initial.starts_with("#") ? ParameterKind::colour
                                 : degrees                ? ParameterKind::angles
                                                          : ParameterKind::vec3;
                return;
            case BaseType::list: parameter.kind = ParameterKind::list; return;
            default: fail(argument.line, "a parameter cannot be of type " + argument.type.name);
        }
    }

    static SocketKind field_of(const Type& point_type)
    {
        return point_type.base == BaseType::vec2 ? SocketKind::field2d : SocketKind::field3d;
    }

    const Argument* argument_named(const Function* function, std::string_view name) const
    {
        if (!function) return nullptr;
        for (const Argument& argument : function->arguments)
            if (argument.name == name) return &argument;
        return nullptr;
    }

    void sockets()
    {
        const Function* distance = type_.function("distance");
        const Function* point = type_.function("point");
        if (distance || point) field_sockets(distance, point);
        else if (const Function* value = type_.function("value")) type_.output = value_kind(*value);
        else if (type_.function("material")) type_.output = SocketKind::material;
        else if (type_.function("light")) type_.output = SocketKind::light;
        else if (type_.function("ray")) type_.output = SocketKind::camera;
        else if (type_.function("sky")) type_.output = SocketKind::sky;
        else fail(1, "the file defines no function with a meaning, such as `" + type_.name + "_distance`");
        for (const Parameter& parameter : type_.parameters) parameter_socket(parameter);
    }

    void field_sockets(const Function* distance, const Function* point)
    {
        const Argument* at = argument_named(point, "p");
        for (const Function* function :
             {distance, type_.function("point_a"), type_.function("point_b"), type_.function("point_c")})
            if (!at) at = argument_named(function, "p");
        type_.output = at ? field_of(at->type) : SocketKind::field_any;
        auto inner = [&](const std::string& name) {
            const Function* own = type_.function("point_" + name);
            if (!own) own = point;
            return own ? field_of(own->result) : type_.output;
        };
        for (const char* name : {"d", "a", "b", "c"})
            if (argument_named(distance, name)) type_.inputs.push_back({name, inner(name)});
        if (point && type_.inputs.empty()) type_.inputs.push_back({"d", inner("d")});
        name_inputs();
        for (const char* name : {"camera", "sky"})
            if (argument_named(distance, name))
                type_.inputs.push_back({name, std::string_view(name) == "sky" ? SocketKind::sky : SocketKind::camera});
    }

    void name_inputs()
    {
        if (input_titles_.empty()) return;
        if (input_titles_.size() != type_.inputs.size()) fail(1, "`inputs` has a word for every field input");
        for (std::size_t i = 0; i < input_titles_.size(); ++i) type_.inputs[i].title = input_titles_[i];
    }

    SocketKind value_kind(const Function& value) const
    {
        switch (value.result.base) {
            case BaseType::real: return SocketKind::number;
            case BaseType::vec2: return SocketKind::vec2;
            case BaseType::vec3: return SocketKind::vec3;
            default: fail(value.line, "a value is a float, vec2 or vec3");
        }
    }

    void parameter_socket(const Parameter& parameter)
    {
        switch (parameter.kind) {
            case ParameterKind::number:
            case ParameterKind::angle: type_.inputs.push_back({parameter.name, SocketKind::number}); return;
            case ParameterKind::vec2: type_.inputs.push_back({parameter.name, SocketKind::vec2}); return;
            case ParameterKind::vec3:
            case ParameterKind::angles: type_.inputs.push_back({parameter.name, SocketKind::vec3}); return;
            case ParameterKind::colour: type_.inputs.push_back({parameter.name, SocketKind::colour}); return;
            case ParameterKind::material: type_.inputs.push_back({parameter.name, SocketKind::material}); return;
            default: return;
        }
    }

    // A drawing is rebuilt on a canvas of so many cells.
    void drawings() const
    {
        for (const Parameter& list : type_.parameters) {
            if (list.kind != ParameterKind::list || list.unit != drawing_unit) continue;
            const Parameter* side = type_.parameter(drawing_unit);
            if (!side || side->kind != ParameterKind::integer)
                fail(1, "a list in cells needs an int parameter `cells`, the side of its canvas");
        }
    }

    void promises() const
    {
        drawings();
        if (!type_.is_field()) return;
        if (!has_quality_) fail(1, "a field node needs a line `// field: exact`, `bound` or `approximate S`");
        if (!type_.function("bounds")) fail(1, "a field node defines `" + type_.name + "_bounds`");
        if (argument_named(type_.function("distance"), "b") && !type_.function("blend"))
            fail(1, "a combiner defines `" + type_.name + "_blend`: the share of b's material");
        if (argument_named(type_.function("distance"), "c") && !type_.function("blend_c"))
            fail(1, "a combiner of three defines `" + type_.name + "_blend_c`: the share of c's material");
        if (const Function* shows = type_.function("shows_b"); shows && shows->result.base != BaseType::boolean)
            fail(shows->line, "`" + shows->name + "` returns a bool: whether the share of b is at least a half");
        if (type_.copies > 1 &&
            (!argument_named(type_.function("point"), "copy") || !argument_named(type_.function("distance"), "acc")))
            fail(1, "a node with `copies` defines `_point(p, ..., copy)` and `_distance(acc, d)`");
        if (const Function* count = type_.function("copies");
            count && (count->result.base != BaseType::integer || type_.copies < 2))
            fail(count->line, "`" + count->name + "` returns an int: how many of its `copies` differ");
    }

    NodeType type_;
    std::vector<Argument> header_parameters_;  // declared by header lines; a text has no type
    bool has_quality_ = false;
    std::vector<std::string> input_titles_;
};

static_assert(static_cast<std::size_t>(Role::steepest) == reserved_arguments.size());

}  // namespace

NodeType declare_node(SourceFile source) { return Declaration(std::move(source)).declare(); }

}  // namespace fieldwright::graph

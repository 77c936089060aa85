// The declaration of a node, from header lines, parameter comments and function names.
#include "graph/node_declaration.h"

#include "graph/node_promises.h"
#include "graph/parameter_comment.h"
#include "graph/text_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldwright::graph {
namespace {

constexpr std::array<std::string_view, 20> reserved_arguments = {
    "p",         "d",     "a",     "b",     "c",     "acc",    "copy", "cell",     "time", "uv",
    "direction", "child", "box_a", "box_b", "box_c", "camera", "sky",  "steepest", "lens", "spread"};
constexpr std::array<std::string_view, 18> meaning_suffixes = {
    "distance", "least",  "point",     "point_a", "point_b", "point_c", "cell",     "blend", "blend_c",
    "shows_b",  "bounds", "lipschitz", "stretch", "value",   "light",   "material", "ray",   "sky"};

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
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
        check_follows();
        if (type_.is_field() && !has_quality_)
            fail(1, "a field node needs a line `// field: exact`, `bound` or `approximate S`");
        check_promises(type_);
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

    // After the first line with a key, what has none is the comment of the function below.
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
            inputs(line, value);
        } else if (key == "follows") {
            follows(line, value);
        } else if (key == "lipschitz") {
            type_.declared_lipschitz = std::strtof(std::string(value).c_str(), nullptr);
            if (!(type_.declared_lipschitz >= 1 && type_.declared_lipschitz <= 1000))
                fail(line, "`lipschitz` is a number from 1 to 1000");
        } else if (key == "combiner") {
            if (value != "hard" && value != "hard associative")
                fail(line, "`combiner` is `hard` or `hard associative`");
            type_.scaling = value == "hard" ? Scaling::hard : Scaling::hard_associative;
        } else if (is_parameter(key)) {
            Type type = key.starts_with("text ")     ? Type{}
                        : key.starts_with("switch ") ? Type{BaseType::boolean, "bool"}
                                                     : Type{BaseType::real, "float"};
            header_parameters_.push_back({type, std::string(key.substr(key.find(' ') + 1)), std::string(value), line});
        } else if (!keys_begun_) {
            type_.help += " " + std::string(trim(text));
            return;
        }
        keys_begun_ = true;
    }

    // Titles of the field inputs, or `up to N`.
    void inputs(int line, std::string_view value)
    {
        constexpr std::string_view up_to = "up to ";
        if (!value.starts_with(up_to)) {
            input_titles_ = split(value, ',');
            return;
        }
        type_.most_inputs = std::atoi(std::string(value.substr(up_to.size())).c_str());
        if (type_.most_inputs < 3 || type_.most_inputs > most_inputs_limit)
            fail(line, "`inputs: up to N` has a whole number from 3 to " + std::to_string(most_inputs_limit));
    }

    static bool is_parameter(std::string_view key)
    {
        bool kind = key.starts_with("text ") || key.starts_with("number ") || key.starts_with("switch ");
        return kind && key.find(' ') == key.rfind(' ');
    }

    void follows(int line, std::string_view value)
    {
        std::vector<std::string> words = split(value, ' ');
        if (words.size() != 3 || words[1] != "while") fail(line, "`follows` reads `TYPE while SWITCH`");
        type_.follows = words[0];
        type_.follows_while = words[2];
        follows_line_ = line;
    }

    void check_follows() const
    {
        if (type_.follows.empty()) return;
        const Parameter* parameter = type_.parameter(type_.follows_while);
        if (!parameter || parameter->kind != ParameterKind::boolean)
            fail(follows_line_, "`" + type_.follows_while + "` is no switch of this node");
    }

    // A parameter that no function need receive.
    void header_parameter(const Argument& line)
    {
        bool word = !line.name.empty() &&
                    line.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
        if (!word) fail(line.line, "a parameter's name is made of a-z, 0-9 and _");
        if (is_reserved(line.name)) fail(line.line, "`" + line.name + "` is a reserved name");
        if (type_.parameter(line.name)) fail(line.line, "the parameter `" + line.name + "` is declared twice");
        type_.parameters.push_back(parameter_of(line, type_.source.path));
    }

    // The texts of the header come first among the parameters, its numbers and switches last.
    void numbers_of_the_header_last(std::size_t of_header)
    {
        auto first = type_.parameters.begin(), last = first + static_cast<std::ptrdiff_t>(of_header);
        auto numbers = std::stable_partition(
            first, last, [](const Parameter& parameter) { return parameter.kind == ParameterKind::text; });
        std::rotate(numbers, last, type_.parameters.end());
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
            type_.parameters.push_back(parameter_of(argument, type_.source.path));
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

    static SocketKind field_of(const Type& point_type)
    {
        return point_type.base == BaseType::vec2 ? SocketKind::field2d : SocketKind::field3d;
    }

    void sockets()
    {
        const Function* distance = type_.function("distance");
        const Function* point = type_.function("point");
        if (distance || point) field_sockets(point);
        else if (const Function* value = type_.function("value")) type_.output = value_kind(*value);
        else if (type_.function("material")) type_.output = SocketKind::material;
        else if (type_.function("light")) type_.output = SocketKind::light;
        else if (type_.function("ray")) type_.output = SocketKind::camera;
        else if (type_.function("sky")) type_.output = SocketKind::sky;
        else fail(1, "the file defines no function with a meaning, such as `" + type_.name + "_distance`");
        for (const Parameter& parameter : type_.parameters) parameter_socket(parameter);
    }

    void field_sockets(const Function* point)
    {
        const Argument* at = nullptr;
        for (const char* suffix : {"point", "distance", "point_a", "point_b", "point_c"})
            if (!at) at = type_.argument(suffix, "p");
        type_.output = at ? field_of(at->type) : SocketKind::field_any;
        auto inner = [&](const std::string& name) {
            const Function* own = type_.function("point_" + name);
            if (!own) own = point;
            return own ? field_of(own->result) : type_.output;
        };
        for (const char* name : {"d", "a", "b", "c"})
            if (type_.argument("distance", name)) type_.inputs.push_back({name, inner(name)});
        if (point && type_.inputs.empty()) type_.inputs.push_back({"d", inner("d")});
        for (int n = 3; n <= type_.most_inputs; ++n) type_.inputs.push_back({"shape_" + std::to_string(n), inner("b")});
        name_inputs();
        for (const char* name : {"camera", "sky"})
            if (type_.argument("distance", name))
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

    NodeType type_;
    std::vector<Argument> header_parameters_;  // declared by header lines; a text has no type
    bool has_quality_ = false, keys_begun_ = false;
    int follows_line_ = 0;
    std::vector<std::string> input_titles_;
};

static_assert(static_cast<std::size_t>(Role::spread) == reserved_arguments.size());

}  // namespace

NodeType declare_node(SourceFile source) { return Declaration(std::move(source)).declare(); }

}  // namespace fieldwright::graph

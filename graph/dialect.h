// The dialect of node files and the shading library: GLSL that is also C++ over GLM. A small typed parser of its
// declarations (structs, constants, function signatures, parameter comments) and a lint of its rules.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::graph {

// Types of values. `structure` values are plain structs declared in shaders/render/types.glsl.
enum class BaseType { none, real, integer, boolean, vec2, vec3, vec4, mat2, mat3, list, structure };

struct Type {
    BaseType base = BaseType::none;
    std::string name;  // as written: "float", "vec3", "Material"
    bool operator==(const Type&) const = default;
};

struct StructDeclaration {
    std::string name;
    struct Member {
        Type type;
        std::string name;
    };
    std::vector<Member> members;
    std::string text;
    int line = 0;
};

// What an argument of a node's function receives: a parameter, or by its reserved name the point, an input's distance ...
enum class Role {
    parameter,
    p,
    d,
    a,
    b,
    c,
    acc,
    copy,
    cell,
    time,
    uv,
    direction,
    child,
    box_a,
    box_b,
    box_c,
    camera,
    sky,
    steepest,
    lens,
    spread
};

struct Argument {
    Type type;
    std::string name;
    std::string comment;  // the text after `//` on the same line; empty for reserved names and repeated parameters
    int line = 0;
    Role role = Role::parameter;  // of node functions; set with the node type
    int parameter = -1;           // index into NodeType::parameters when role is parameter
};

struct Function {
    Type result;
    std::string name;  // unique over the whole library
    std::vector<Argument> arguments;
    std::string text;         // the whole definition, verbatim
    int line = 0;             // of the definition in its file
    int loop_iterations = 0;  // loop iterations of one call, those of called functions included; saturates at 1e6
    // Of these, the ones of loops that leave off at the end of a list, and how often such a loop is run.
    int list_iterations = 0, list_loops = 0;
    int inlined_tokens = 0;  // of its body with those of called functions in their places; saturates at 1e9
    std::string file;        // for messages

    const Argument* argument(std::string_view wanted) const;  // null when absent
};

// One parsed file. Order of declaration is kept.
struct SourceFile {
    std::string path;
    std::string text;
    std::vector<std::string> header;  // leading `//` lines, without the slashes and one space
    std::vector<StructDeclaration> structs;
    std::vector<std::string> constants;  // `const float NAME = 1.0f;`, verbatim
    std::vector<Function> functions;
};

// A broken rule of the dialect: file, line and rule in one sentence (what() holds "file:line: sentence").
struct DialectError : std::runtime_error {
    DialectError(std::string file, int line, std::string rule, int column = 0);
    std::string file;
    int line;
    int column;  // from 1; 0 = the line as a whole
    std::string rule;
};

// Parses and lints one file. Throws DialectError at the first broken rule. `struct_names` are the types known from
// files parsed before.
SourceFile parse_source(std::string path, std::string text, const std::vector<std::string>& struct_names = {});

// Floats a value of this type takes in a parameter block or a row set; `structs` resolves structures.
// float/int/bool 1, vecN N, mat2 4, mat3 9, list 2 (first, count), structure = sum of its members.
int lane_count(const Type& type, const std::vector<StructDeclaration>& structs);

}  // namespace fieldwright::graph

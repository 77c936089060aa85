// The node library: every node type, read from one .glsl file each, and the shading library they stand on.
#pragma once

#include "graph/dialect.h"
#include "graph/own_type.h"
#include "graph/value.h"

#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>

namespace fieldwright::graph {

// What a socket carries. A field socket is 2D or 3D; `any` takes the dimension of what is wired to it.
enum class SocketKind { field2d, field3d, field_any, number, vec2, vec3, colour, material, camera, sky, light, none };

// A text is UTF-8 for whoever bakes it and no argument of a function. The function of a formula receives what it
// computes, a float; that of an image, a picture file's path, the list baked from it (graph/image_request.h).
enum class ParameterKind {
    number,
    integer,
    boolean,
    choice,
    vec2,
    vec3,
    angle,
    angles,
    colour,
    material,
    list,
    text,
    formula,
    image
};

// Declared once in a node file: by the comment of an argument, `default [min, max] unit  help` (after the default may
// stand `older VALUE`) or
// `formula "default" over half_size  help` or `image  help`, or by a header line, `text NAME: "default"  help` or
// `number NAME: default ...  help` or `switch NAME: default ...  help`.
struct Parameter {
    std::string name;
    ParameterKind kind = ParameterKind::number;
    Type type;
    Value initial;                         // as in documents: angles in degrees, colours linear
    std::optional<Value> older;            // what files from before this parameter mean, where that is not `initial`
    double minimum = -1e6, maximum = 1e6;  // hard, per component, inclusive
    double soft_minimum = -1e6, soft_maximum = 1e6;
    std::string unit;  // "m", "deg", "1/m", "s", "" ...
    std::string help;
    std::vector<std::string> choices;  // kind choice: the words; the function receives the index as int
    std::string over;      // kind formula: the vec3 parameter that is half the size of the box its point stays in
    int value_index = -1;  // into Node::parameters; -1 for materials, which have no value
};

struct Socket {
    std::string name;  // input: reserved argument name ("d", "a", "b", "camera", "sky"), parameter name, "shape_3" ...
    SocketKind kind = SocketKind::none;
    std::string title = {};  // of a field input that `// inputs: ...` names
};

inline constexpr int most_inputs_limit = 64;

enum class Quality { exact, bound, approximate };

// How a field node's result scales with its inputs: `hard` commutes with division by a positive constant, so a
// Lipschitz constant may be divided out below it; `hard associative` chains are also rebalanced.
enum class Scaling { none, hard, hard_associative };

// Where a node type comes from; later ones stand on earlier ones.
enum class Origin { program, user_folder, document, group };

struct NodeType {
    std::string name;      // file stem: the word in scene files
    std::string category;  // folder
    std::string title;     // "Torus"
    std::string help;      // "a ring around the y axis." made a sentence
    std::vector<std::string> synonyms;
    Quality quality_outside = Quality::exact, quality_inside = Quality::exact;
    float approximate_step = 1;  // S of `approximate S`: the field is divided by 1/S
    Scaling scaling = Scaling::none;
    int copies = 1;       // of a block (`// copies: N`)
    bool affine = false;  // `_point` is an affine map of p (`// point: affine`)
    int most_inputs =
        0;  // of a combiner of many (`// inputs: up to N`): how many fields `_distance(a, b)` folds; else 0
    float declared_lipschitz = 1;  // `// lipschitz: L`: of an own type, whose functions the CPU does not run
    std::string follows;           // a type, the first node of which gives its parameters of the same names ...
    std::string follows_while;     // ... while this switch is on
    std::vector<Parameter> parameters;
    std::vector<Socket> inputs;  // field inputs first, then one per wireable parameter
    SocketKind output = SocketKind::none;
    SourceFile source;
    bool compiled = false;  // the text equals the one built into this program, so the CPU can run it
    Origin origin = Origin::program;
    bool held_back = false;  // its code must not run, for the reason that the library gives: it counts as unconnected
    bool former = false;     // declared by an earlier text than the document's, which the library has left out

    const Function* function(std::string_view suffix) const;  // "distance", "point", ...; null when absent
    const Argument* argument(std::string_view suffix, std::string_view of) const;  // of that function, if it has it
    const Parameter* parameter(std::string_view name) const;
    const Socket* input(std::string_view name) const;
    bool is_field() const;
};

// Where a text is not a node, and why.
struct TextError {
    int line = 0, column = 0;  // from 1; 0 = as a whole
    std::string rule;
    bool waiting = false;  // nothing is wrong yet: it is being looked at
    bool operator==(const TextError&) const = default;
};
std::string sentence(const TextError& error);  // "line 3, column 14: the number 1.0 needs ..."

// What a library has beside the program's own types.
struct Additions {
    std::vector<NodeType> types;
    std::map<std::string, TextError> left_out;  // by name
};

// Immutable after loading; shared by documents, lowering and printers. Libraries that differ in additions share the rest.
class Library {
public:
    // The files built into the program.
    static std::shared_ptr<const Library> embedded();
    // A folder laid out as shaders/: nodes/<category>/<name>.glsl and render/*.glsl. Throws DialectError or Failure.
    static std::shared_ptr<const Library> load(const std::filesystem::path& folder);
    // From texts: path relative to shaders/ -> content. `builtin` marks nodes whose text is equal as compiled.
    static std::shared_ptr<const Library> from_texts(const std::map<std::string, std::string>& texts,
                                                     const std::map<std::string, std::string>& builtin);
    // This library with other additions of that origin and none of a later one. Their names must be free in it.
    std::shared_ptr<const Library> with(Origin origin, Additions additions, std::vector<OwnType> own_types = {}) const;
    // Without types of that origin and later ones, and without those that `dropped` picks.
    std::shared_ptr<const Library> without(Origin origin,
                                           const std::function<bool(const NodeType&)>& dropped = {}) const;
    const std::vector<OwnType>& own_types() const { return own_types_; }  // the document's, as given to `with`
    const TextError* left_out(std::string_view name) const;               // null unless a text of that name is broken
    std::vector<std::pair<std::string, TextError>> left_out_of(Origin origin) const;  // by name

    const NodeType* type(std::string_view name) const;     // null when unknown
    const Function& support(std::string_view name) const;  // of shaders/render; throws std::out_of_range
    const std::vector<const NodeType*>& types() const { return ordered_; }  // by category, then name
    const std::vector<StructDeclaration>& structs() const { return shading_->structs; }
    const std::vector<SourceFile>& render_files() const { return shading_->files; }  // dialect, in dependency order
    const std::string& text(std::string_view path) const;  // any file by path relative to shaders/
    std::vector<std::string> struct_names() const;
    bool has_support(std::string_view name) const { return shading_->support.contains(name); }
    int lanes(const Type& type) const { return lane_count(type, structs()); }

private:
    struct NameHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
    };
    template <typename T>
    using ByName = std::unordered_map<std::string, T, NameHash, std::equal_to<>>;

    struct Shading {
        std::vector<SourceFile> files;
        ByName<const Function*> support;  // of the files
        std::vector<StructDeclaration> structs;
        std::map<std::string, std::string> texts;
    };
    static std::shared_ptr<const Shading> shading(const std::map<std::string, std::string>& texts);
    void add(std::shared_ptr<const NodeType> type);
    void order();

    std::shared_ptr<const Shading> shading_;
    std::vector<std::shared_ptr<const NodeType>> types_;
    std::vector<const NodeType*> ordered_;  // derived, as by_name_
    ByName<const NodeType*> by_name_;
    std::map<std::string, std::pair<Origin, TextError>, std::less<>> left_out_;
    std::vector<OwnType> own_types_;
};

// The texts built into the program: path relative to shaders/ -> content. Generated at build time.
const std::map<std::string, std::string>& embedded_texts();

std::string_view socket_kind_name(SocketKind kind);
std::string_view parameter_kind_name(ParameterKind kind);
bool has_range(ParameterKind kind);  // whether its components are numbers between a minimum and a maximum
// Parses a value as written after `--set` and, but for texts in quotes, in a node file: `1.5`, `true`, `word`, `(1, 2, 3)`, `1,2,3`, `#rrggbb`,
// `[(0,0), (1,0)]`. Returns nullopt when the text is not of the parameter's kind.
std::optional<Value> parse_value(const Parameter& parameter, std::string_view text);
// Empty when `value` is of the parameter's kind, finite and in range; else what is wrong, as the end of a sentence.
std::string value_error(const Parameter& parameter, const Value& value);

}  // namespace fieldwright::graph

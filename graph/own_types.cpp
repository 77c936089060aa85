// Makes node types of texts that were not compiled into the program, and keeps them from each other's names.
#include "graph/own_types.h"

#include "graph/limits.h"
#include "graph/node_declaration.h"
#include "graph/own_type_rules.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace fieldwright::graph {
namespace {

// What the printed shader calls its own functions.
constexpr std::array<std::string_view, 4> printed_names = {"scene", "part", "update", "gl"};

bool is_plain(std::string_view name)
{
    auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && name.back() != '_' &&
           std::all_of(name.begin(), name.end(), plain) && name.find("__") == name.npos;
}

// n12 and the like name values in the printed shader.
bool is_printed(std::string_view name)
{
    bool number = name.size() > 1 && name.front() == 'n' && name[1] >= '0' && name[1] <= '9';
    return number || std::find(printed_names.begin(), printed_names.end(), name) != printed_names.end();
}

// Adds types one by one, each against what stands before it.
class Gathering {
public:
    explicit Gathering(const Library& base) : taken_(base) {}

    // What is wrong, if anything is.
    template <typename Declare>
    std::optional<TextError> add(const Declare& declare)
    {
        try {
            NodeType type = declare();
            check_own_rules(type, taken_);
            taken_.add(type);
            additions_.types.push_back(std::move(type));
            return std::nullopt;
        } catch (const DialectError& error) {
            return TextError{error.line, error.column, error.rule};
        }
    }

    template <typename Declare>
    void add(const std::string& name, const Declare& declare)
    {
        if (auto error = add(declare)) leave_out(name, std::move(*error));
    }

    void leave_out(const std::string& name, TextError error) { additions_.left_out.emplace(name, std::move(error)); }
    Additions finish() { return std::move(additions_); }

private:
    TakenNames taken_;
    Additions additions_;
};

[[noreturn]] void refuse_name(const std::string& path, const std::string& error)
{
    throw DialectError(path, 0, "the name of the node " + error);
}

// Of any name: whether it is free has been seen to.
NodeType declared(const OwnType& own, const std::string& path, const Library& library)
{
    if (own.text.size() > own_text_limit) throw DialectError(path, 0, "the text has more than 64 KB; shorten it");
    return declare_node(parse_source(path, own.text, library.struct_names()));
}

// Scenes keep their types whatever the user's folder holds by now.
std::shared_ptr<const Library> base_of(const Library& library, const std::vector<OwnType>& types)
{
    std::set<std::string_view> names;
    for (const OwnType& own : types) names.insert(own.name);
    return library.without(Origin::document, [&](const NodeType& type) {
        return type.origin == Origin::user_folder && names.contains(type.name);
    });
}

void gather(Gathering& gathering, const OwnType& own, const Library& base, const OwnTypeRules& rules)
{
    std::optional<TextError> refused = rules.refuse ? rules.refuse(own) : std::nullopt;
    auto declare_as = [&](const std::string& text) {
        return [&] {
            NodeType type = own_node_type({own.name, text}, base);
            type.held_back = refused.has_value();
            return type;
        };
    };
    auto former = rules.former.find(own.name);
    bool replaced = former != rules.former.end() && former->second != own.text;
    if (!refused || !replaced) {
        std::optional<TextError> broken = gathering.add(declare_as(own.text));
        if (!broken && !refused) return;
        if (!broken || !replaced) return gathering.leave_out(own.name, broken ? *broken : *refused);
        refused = broken;
    }
    gathering.leave_out(own.name, *refused);
    gathering.add([&] {
        NodeType type = own_node_type({own.name, former->second}, base);
        type.former = true;
        return type;
    });
}

}  // namespace

std::string own_name_error(const Library& library, std::string_view name)
{
    if (!is_plain(name)) return "is made of a-z, 0-9 and single _ between them, and begins with a letter";
    if (name.size() > 40) return "has at most 40 letters";
    if (is_printed(name)) return "is one that shaders use; choose another";
    const NodeType* other = library.type(name);
    if (!other || other->origin == Origin::document) return {};
    return other->origin == Origin::program ? "is that of a built-in node; choose another"
                                            : "is that of a node in your folder; choose another";
}

NodeType own_node_type(const OwnType& own, const Library& library)
{
    std::string path = "types/" + own.name + ".glsl";
    const NodeType* other = library.type(own.name);
    bool shadows = other && other->origin != Origin::program;
    if (std::string error = shadows ? "" : own_name_error(library, own.name); !error.empty()) refuse_name(path, error);
    NodeType type = declared(own, path, library);
    type.category = category_of_meaning(type);
    return type;
}

std::shared_ptr<const Library> with_own_types(const Library& library, const std::vector<OwnType>& types,
                                              const OwnTypeRules& rules)
{
    std::shared_ptr<const Library> base = base_of(library, types);
    if (types.empty()) return base;
    Gathering gathering(*base);
    for (const OwnType& own : types) gather(gathering, own, *base, rules);
    return base->with(Origin::document, gathering.finish(), types);
}

std::shared_ptr<const Library> library_for(const std::shared_ptr<const Library>& library,
                                           const std::vector<OwnType>& types)
{
    return library->own_types() == types ? library : with_own_types(*library, types);
}

std::shared_ptr<const Library> with_user_nodes(const Library& library, const std::map<std::string, std::string>& texts)
{
    std::shared_ptr<const Library> base = library.without(Origin::user_folder);
    if (texts.empty()) return base;
    Gathering gathering(*base);
    std::map<std::string, std::string> paths;  // by name
    for (const auto& [path, text] : texts) {
        std::string name = std::filesystem::path(path).stem().string();
        auto [place, is_new] = paths.emplace(name, path);
        gathering.add(is_new ? name : path, [&] {
            if (!is_new) refuse_name(path, "is taken by " + place->second + "; rename one of the files");
            if (std::string error = own_name_error(*base, name); !error.empty()) refuse_name(path, error);
            NodeType type = declared({name, text}, path, *base);
            std::string folder = std::filesystem::path(path).parent_path().filename().string();
            if (folder.empty() || folder == "output") type.category = category_of_meaning(type);
            return type;
        });
    }
    return base->with(Origin::user_folder, gathering.finish());
}

}  // namespace fieldwright::graph

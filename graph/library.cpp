// Makes node types from parsed files and loads the whole library.
#include "graph/library.h"

#include "graph/node_declaration.h"
#include "graph/problem.h"
#include "graph/shader_parts.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace fieldwright::graph {
namespace {

// The order in which the shading library's files build on each other; others follow by name.
constexpr std::array dialect_order = {"render/types.glsl",   "render/program.glsl", "render/march.glsl",
                                      "render/shading.glsl", "render/stereo.glsl",  "render/views.glsl"};

// gpu/ and export/ hold main functions: plain GLSL with outputs and uniforms, not the dialect.
bool is_dialect(const std::string& path) { return path.starts_with("render/"); }

std::vector<std::string> dialect_paths(const std::map<std::string, std::string>& texts)
{
    std::vector<std::string> paths;
    for (const char* path : dialect_order)
        if (texts.contains(path)) paths.emplace_back(path);
    for (const auto& [path, text] : texts)
        if (is_dialect(path) && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
    return paths;
}

std::string read_file(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    if (!stream) throw Failure(1, path.string() + ": cannot be read; check that the file exists and may be read");
    return text.str();
}

}  // namespace

std::shared_ptr<const Library> Library::embedded()
{
    static const std::shared_ptr<const Library> library = from_texts(embedded_texts(), embedded_texts());
    return library;
}

std::shared_ptr<const Library> Library::load(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> texts;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->is_regular_file() && it->path().extension() == ".glsl")
            texts[it->path().lexically_relative(folder).generic_string()] = read_file(it->path());
    if (error) throw Failure(1, folder.string() + ": " + error.message() + "; name a folder laid out as shaders/");
    if (!texts.contains("render/types.glsl"))
        throw Failure(1, folder.string() + ": holds no render/types.glsl; name a folder laid out as shaders/");
    return from_texts(texts, embedded_texts());
}

std::shared_ptr<const Library::Shading> Library::shading(const std::map<std::string, std::string>& texts)
{
    auto shading = std::make_shared<Shading>();
    shading->texts = texts;
    std::vector<std::string> struct_names;
    for (const std::string& path : dialect_paths(texts)) {
        shading->files.push_back(parse_source(path, with_all_parts(texts.at(path)), struct_names));
        for (const StructDeclaration& declared : shading->files.back().structs) {
            shading->structs.push_back(declared);
            struct_names.push_back(declared.name);
        }
    }
    for (const SourceFile& file : shading->files)
        for (const Function& function : file.functions) shading->support[function.name] = &function;
    return shading;
}

std::shared_ptr<const Library> Library::from_texts(const std::map<std::string, std::string>& texts,
                                                   const std::map<std::string, std::string>& builtin)
{
    auto library = std::make_shared<Library>();
    library->shading_ = shading(texts);
    std::vector<std::string> struct_names = library->struct_names();
    for (const auto& [path, text] : texts) {
        if (!path.starts_with("nodes/")) continue;
        auto type = std::make_shared<NodeType>(declare_node(parse_source(path, text, struct_names)));
        auto same = builtin.find(path);
        type->compiled = same != builtin.end() && same->second == text;
        if (const NodeType* other = library->type(type->name))
            throw DialectError(path, 1,
                               "a node named `" + type->name + "` exists already in " + other->source.path +
                                   "; rename one of the files");
        library->add(std::move(type));
    }
    library->order();
    return library;
}

void Library::add(std::shared_ptr<const NodeType> type)
{
    by_name_.emplace(type->name, type.get());
    ordered_.push_back(type.get());
    types_.push_back(std::move(type));
}

void Library::order()
{
    std::sort(ordered_.begin(), ordered_.end(), [](const NodeType* a, const NodeType* b) {
        return std::tie(a->category, a->name) < std::tie(b->category, b->name);
    });
}

std::shared_ptr<const Library> Library::without(Origin origin,
                                                const std::function<bool(const NodeType&)>& dropped) const
{
    auto library = std::make_shared<Library>();
    library->shading_ = shading_;
    for (const auto& type : types_)
        if (type->origin < origin && !(dropped && dropped(*type))) library->add(type);
    for (const auto& [name, place] : left_out_)
        if (place.first < origin) library->left_out_.emplace(name, place);
    library->order();
    return library;
}

std::shared_ptr<const Library> Library::with(Origin origin, Additions additions, std::vector<OwnType> own_types) const
{
    auto library = std::make_shared<Library>(*without(origin));
    library->own_types_ = origin > Origin::document ? own_types_ : std::move(own_types);
    for (NodeType& type : additions.types) {
        type.origin = origin;
        library->add(std::make_shared<NodeType>(std::move(type)));
    }
    for (auto& [name, error] : additions.left_out)
        library->left_out_.insert_or_assign(name, std::pair(origin, std::move(error)));
    library->order();
    return library;
}

std::vector<std::string> Library::struct_names() const
{
    std::vector<std::string> names;
    for (const StructDeclaration& declared : structs()) names.push_back(declared.name);
    return names;
}

const TextError* Library::left_out(std::string_view name) const
{
    auto found = left_out_.find(name);
    return found == left_out_.end() ? nullptr : &found->second.second;
}

std::vector<std::pair<std::string, TextError>> Library::left_out_of(Origin origin) const
{
    std::vector<std::pair<std::string, TextError>> found;
    for (const auto& [name, place] : left_out_)
        if (place.first == origin) found.emplace_back(name, place.second);
    return found;
}

std::string sentence(const TextError& error)
{
    if (!error.line) return error.rule;
    std::string place = "line " + std::to_string(error.line);
    if (error.column) place += ", column " + std::to_string(error.column);
    return place + ": " + error.rule;
}

const NodeType* Library::type(std::string_view name) const
{
    auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : found->second;
}

const Function& Library::support(std::string_view name) const
{
    auto found = shading_->support.find(name);
    if (found == shading_->support.end())
        throw std::out_of_range("the shading library has no function " + std::string(name));
    return *found->second;
}

const std::string& Library::text(std::string_view path) const { return shading_->texts.at(std::string(path)); }

const Argument* NodeType::argument(std::string_view suffix, std::string_view of) const
{
    const Function* found = function(suffix);
    return found ? found->argument(of) : nullptr;
}

const Function* NodeType::function(std::string_view suffix) const
{
    for (const Function& function : source.functions)
        if (function.name.size() == name.size() + 1 + suffix.size() && function.name.ends_with(suffix) &&
            function.name.starts_with(name) && function.name[name.size()] == '_')
            return &function;
    return nullptr;
}

const Parameter* NodeType::parameter(std::string_view parameter_name) const
{
    for (const Parameter& parameter : parameters)
        if (parameter.name == parameter_name) return &parameter;
    return nullptr;
}

const Socket* NodeType::input(std::string_view socket_name) const
{
    for (const Socket& socket : inputs)
        if (socket.name == socket_name) return &socket;
    return nullptr;
}

bool NodeType::is_field() const
{
    return output == SocketKind::field2d || output == SocketKind::field3d || output == SocketKind::field_any;
}

std::string_view socket_kind_name(SocketKind kind)
{
    switch (kind) {
        case SocketKind::field2d: return "2D field";
        case SocketKind::field3d: return "3D field";
        case SocketKind::field_any: return "field";
        case SocketKind::number: return "number";
        case SocketKind::vec2: return "vec2";
        case SocketKind::vec3: return "vec3";
        case SocketKind::colour: return "colour";
        case SocketKind::material: return "material";
        case SocketKind::camera: return "camera";
        case SocketKind::sky: return "sky";
        case SocketKind::light: return "light";
        case SocketKind::none: break;
    }
    return "nothing";
}

std::string_view parameter_kind_name(ParameterKind kind)
{
    switch (kind) {
        case ParameterKind::number: return "number";
        case ParameterKind::integer: return "integer";
        case ParameterKind::boolean: return "boolean";
        case ParameterKind::choice: return "choice";
        case ParameterKind::vec2: return "vec2";
        case ParameterKind::vec3: return "vec3";
        case ParameterKind::angle: return "angle";
        case ParameterKind::angles: return "angles";
        case ParameterKind::colour: return "colour";
        case ParameterKind::material: return "material";
        case ParameterKind::text: return "text";
        case ParameterKind::formula: return "formula";
        case ParameterKind::image: return "image";
        case ParameterKind::list: break;
    }
    return "list";
}

bool has_range(ParameterKind kind)
{
    switch (kind) {
        case ParameterKind::boolean:
        case ParameterKind::choice:
        case ParameterKind::material:
        case ParameterKind::text:
        case ParameterKind::formula:
        case ParameterKind::image: return false;
        default: return true;
    }
}

}  // namespace fieldwright::graph

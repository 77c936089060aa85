// Build step: writes every function of the dialect as C++ with a loop over rows of points, once per instruction set.
#include "field/single_arguments.h"
#include "graph/library.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <sstream>

namespace {

using namespace fieldwright::graph;
using fieldwright::field::is_single;

struct KernelSource {
    const Function* function;
    bool has_single = false;  // some argument may be a single value
    std::vector<bool> single;
};

bool kernelable(const Function& function)
{
    auto fits = [](const Type& type) {
        return type.base != BaseType::none && type.name != "Camera" && type.name != "Sky";
    };
    return fits(function.result) && function.result.base != BaseType::list &&
           std::all_of(function.arguments.begin(), function.arguments.end(),
                       [&](const Argument& a) { return fits(a.type); });
}

// An expression that builds a value of a type from lanes; `lane(k)` is the expression of lane k.
template <typename Lane>
std::string loaded(const Library& library, const Type& type, int& k, const Lane& lane)
{
    auto list = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + lane(k++);
        return text;
    };
    switch (type.base) {
        case BaseType::real: return lane(k++);
        case BaseType::integer: return "int(" + lane(k++) + ")";
        case BaseType::boolean: return "(" + lane(k++) + " > 0.5f)";
        case BaseType::vec2: return "vec2(" + list(2) + ")";
        case BaseType::vec3: return "vec3(" + list(3) + ")";
        case BaseType::vec4: return "vec4(" + list(4) + ")";
        case BaseType::mat2: return "mat2(" + list(4) + ")";
        case BaseType::mat3: return "mat3(" + list(9) + ")";
        default: break;
    }
    std::string text = type.name + "{";
    for (const StructDeclaration& declared : library.structs())
        if (declared.name == type.name)
            for (std::size_t i = 0; i < declared.members.size(); ++i)
                text += (i > 0 ? ", " : "") + loaded(library, declared.members[i].type, k, lane);
    return text + "}";
}

// Statements that store the parts of `value` to lanes of the result.
std::string stored(const Library& library, const Type& type, const std::string& value, int& k)
{
    auto store = [&](const std::string& part) {
        return "        r[" + std::to_string(k++) + " * row_width + i] = " + part + ";\n";
    };
    auto components = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += store(value + "." + "xyzw"[i]);
        return text;
    };
    auto columns = [&](int size) {
        std::string text;
        for (int c = 0; c < size; ++c)
            for (int row = 0; row < size; ++row) text += store(value + "[" + std::to_string(c) + "]." + "xyz"[row]);
        return text;
    };
    switch (type.base) {
        case BaseType::real: return store(value);
        case BaseType::integer: return store("float(" + value + ")");
        case BaseType::boolean: return store("(" + value + " ? 1.0f : 0.0f)");
        case BaseType::vec2: return components(2);
        case BaseType::vec3: return components(3);
        case BaseType::vec4: return components(4);
        case BaseType::mat2: return columns(2);
        case BaseType::mat3: return columns(3);
        default: break;
    }
    std::string text;
    for (const StructDeclaration& declared : library.structs())
        if (declared.name == type.name)
            for (const auto& member : declared.members)
                text += stored(library, member.type, value + "." + member.name, k);
    return text;
}

std::string list_declaration(int n, const std::string& count)
{
    std::string name = std::to_string(n), argument = "a" + name;
    return "    const List l" + name + "{list_data + int(" + argument + "[0]), " + count + "};\n";
}

// A loop that leaves off at the end of a list is vectorised when its end is known before it begins, and runs over the
// list itself: no index in it needs to be checked again.
std::string with_known_ends(std::string text)
{
    static const std::regex loop(
        R"(for \(int (\w+) = 0; \1 < (\d+); \1\+\+\) \{\s*if \(\1 >= (\w+)\.count\) \{\s*break;\s*\})");
    std::set<std::pair<std::string, std::string>> walks;  // list, index
    for (std::sregex_iterator match(text.begin(), text.end(), loop), end; match != end; ++match)
        walks.emplace((*match)[3], (*match)[1]);
    text =
        std::regex_replace(text, loop, "for (int $1 = 0, $1_end = $3.count < $2 ? $3.count : $2; $1 < $1_end; $1++) {");
    for (const auto& [list, index] : walks) {
        bool walks_otherwise = text.find("for (int " + index + " = 0; ") != std::string::npos;
        std::regex read("list_at\\(" + list + ", " + index + "\\)");
        if (!walks_otherwise) text = std::regex_replace(text, read, list + ".data[" + index + "]");
    }
    return text;
}

std::string length_read(int n) { return "int(a" + std::to_string(n) + "[1])"; }

// No loop around a loop of unknown length is vectorised: each of the usual lengths of a list has a loop of its own, in
// which the compiler unrolls the function's.
std::string by_list_length(int n, const std::string& loop)
{
    constexpr int usual_length = 8;
    std::string text = "    switch (" + length_read(n) + ") {\n";
    for (int length = 0; length <= usual_length; ++length)
        text += "    case " + std::to_string(length) + ": {\n" + list_declaration(n, std::to_string(length)) + loop +
                "    return;\n    }\n";
    return text + "    }\n" + list_declaration(n, length_read(n)) + loop;
}

std::string kernel(const Library& library, const KernelSource& source, bool uniform)
{
    const Function& function = *source.function;
    std::string text = "static void " + function.name + (uniform ? "_uniform" : "_varying") +
                       "(float* __restrict r, const float* const* a, const glm::vec4* list_data, int count)\n{\n    "
                       "(void)list_data;\n";
    std::string arguments;
    std::vector<int> lists;
    for (std::size_t n = 0; n < function.arguments.size(); ++n) {
        const Type& type = function.arguments[n].type;
        std::string name = "a" + std::to_string(n);
        text += "    const float* __restrict " + name + " = a[" + std::to_string(n) + "];\n";
        int k = 0;
        std::string argument;
        if (type.base == BaseType::list) {
            lists.push_back(static_cast<int>(n));
            argument = "l" + std::to_string(n);
        } else if (uniform && source.single[n]) {
            std::string value =
                loaded(library, type, k, [&](int lane) { return name + "[" + std::to_string(lane) + "]"; });
            text += "    const " + type.name + " s" + std::to_string(n) + " = " + value + ";\n";
            argument = "s" + std::to_string(n);
        } else {
            argument = loaded(library, type, k,
                              [&](int lane) { return name + "[" + std::to_string(lane) + " * row_width + i]"; });
        }
        arguments += (n > 0 ? ", " : "") + argument;
    }
    int k = 0;
    std::string loop = "#pragma GCC ivdep\n    for (int i = 0; i < count; i++) {\n        const " +
                       function.result.name + " v = " + function.name + "(" + arguments + ");\n" +
                       stored(library, function.result, "v", k) + "    }\n";
    if (lists.size() == 1 && function.loop_iterations > 0) return text + by_list_length(lists[0], loop) + "}\n\n";
    for (int n : lists) text += list_declaration(n, length_read(n));
    return text + loop + "}\n\n";
}

class Generator {
public:
    explicit Generator(const Library& library) : library_(library)
    {
        for (const SourceFile& file : library.render_files()) add_file(file);
        for (const NodeType* type : library.types()) add_file(type->source);
        std::sort(kernels_.begin(), kernels_.end(),
                  [](const auto& a, const auto& b) { return a.function->name < b.function->name; });
    }

    std::string text(const std::string& instruction_set) const
    {
        std::string text =
            "// Generated from the shader texts; do not edit.\n#include \"field/dialect.h\"\n#include "
            "\"field/kernel.h\"\n\n"
            "namespace fieldwright::field::" +
            instruction_set +
            " {\n\nFIELDWRIGHT_DIALECT_TYPES\n#include "
            "\"field/dialect_functions.inc\"\n\n" +
            source_;
        for (const KernelSource& source : kernels_) {
            if (source.has_single) text += kernel(library_, source, true);
            text += kernel(library_, source, false);
        }
        text += "static const KernelEntry entries[] = {\n";
        for (const KernelSource& source : kernels_) {
            const std::string& name = source.function->name;
            text += "    {\"" + name + "\", " + name + (source.has_single ? "_uniform, " : "_varying, ") + name +
                    "_varying},\n";
        }
        return text + "};\n\nextern const KernelTable table;\nconst KernelTable table = {\"" + instruction_set +
               "\", entries, entries + sizeof(entries) / sizeof(entries[0])};\n\n}\n";
    }

private:
    void add_file(const SourceFile& file)
    {
        source_ += "// " + file.path + "\n";
        for (const StructDeclaration& declared : file.structs) source_ += declared.text + "\n\n";
        for (const std::string& constant : file.constants) source_ += "static " + constant + "\n";
        for (const Function& function : file.functions) {
            source_ += "FIELDWRIGHT_INLINE " + with_known_ends(function.text) + "\n\n";
            if (kernelable(function)) add_kernel(function);
        }
    }

    void add_kernel(const Function& function)
    {
        KernelSource source{&function, false, {}};
        for (const Argument& argument : function.arguments) {
            source.single.push_back(is_single(function, argument));
            source.has_single = source.has_single || source.single.back();
        }
        kernels_.push_back(std::move(source));
    }

    const Library& library_;
    std::string source_;
    std::vector<KernelSource> kernels_;
};

void write_when_changed(const std::filesystem::path& path, const std::string& text)
{
    std::ifstream old(path, std::ios::binary);
    std::stringstream before;
    before << old.rdbuf();
    if (old && before.str() == text) return;
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

int main(int count, char** words)
{
    if (count != 3) {
        std::cerr << "usage: kernel_generator SHADERS OUTPUT\n";
        return 2;
    }
    try {
        auto library = Library::load(words[1]);
        Generator generator(*library);
        for (const char* instruction_set : {"base", "avx2", "avx512"})
            write_when_changed(std::filesystem::path(words[2]) / (std::string("kernels_") + instruction_set + ".cpp"),
                               generator.text(instruction_set));
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}

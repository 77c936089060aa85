#include "app/node_pages.h"

#include "app/starter_scene.h"
#include "graph/problem.h"
#include "graph/program.h"
#include "graph/scene_file.h"
#include "renderer/devices.h"
#include "renderer/picture.h"

#include <charconv>
#include <glm/gtc/color_space.hpp>
#include <system_error>

namespace fieldwright::app {
namespace {

using graph::NodeType;
using graph::Parameter;

constexpr int picture_width = 160, picture_height = 120;  // px
constexpr int picture_detail = 3;                         // samples along each side of a pixel

std::string number_text(float number)
{
    char digits[32];
    auto [end, error] = std::to_chars(digits, digits + sizeof digits, number == 0 ? 0.0f : number);
    return {digits, end};
}

std::string colour_text(const glm::vec3& linear)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string text = "#";
    glm::vec3 srgb = glm::clamp(glm::convertLinearToSRGB(linear), 0.0f, 1.0f) * 255.0f + 0.5f;
    for (int i = 0; i < 3; ++i) {
        int level = static_cast<int>(srgb[i]);
        text += digits[level / 16];
        text += digits[level % 16];
    }
    return text;
}

template <typename Vector>
std::string components_text(const Vector& vector, int count)
{
    std::string text = "(";
    for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + number_text(vector[i]);
    return text + ")";
}

std::string value_text(const Parameter& parameter)
{
    const graph::Value& value = parameter.initial;
    if (auto* flag = std::get_if<bool>(&value)) return *flag ? "on" : "off";
    if (auto* whole = std::get_if<int>(&value)) return std::to_string(*whole);
    if (auto* number = std::get_if<float>(&value)) return number_text(*number);
    if (auto* vector = std::get_if<glm::vec2>(&value)) return components_text(*vector, 2);
    if (auto* vector = std::get_if<glm::vec3>(&value))
        return parameter.kind == graph::ParameterKind::colour ? colour_text(*vector) : components_text(*vector, 3);
    if (auto* points = std::get_if<graph::PointList>(&value)) return std::to_string(points->size()) + " points";
    const auto& words = std::get<std::string>(value);
    return words.empty() ? "" : "`" + words + "`";
}

std::string range_text(const Parameter& parameter)
{
    if (!parameter.choices.empty()) {
        std::string words;
        for (const std::string& choice : parameter.choices) words += (words.empty() ? "" : ", ") + choice;
        return words;
    }
    if (!graph::has_range(parameter.kind)) return "";
    bool low = parameter.minimum > -1e6, high = parameter.maximum < 1e6;
    std::string minimum = number_text(static_cast<float>(parameter.minimum)),
                maximum = number_text(static_cast<float>(parameter.maximum));
    if (low && high) return minimum + " to " + maximum;
    if (low) return "from " + minimum;
    return high ? "up to " + maximum : "any";
}

std::string parameter_row(const Parameter& parameter)
{
    bool material = parameter.kind == graph::ParameterKind::material;
    return "| `" + parameter.name + "` | " + std::string(graph::parameter_kind_name(parameter.kind)) + " | " +
           (material ? "" : value_text(parameter)) + " | " + range_text(parameter) + " | " + parameter.unit + " | " +
           parameter.help + " |\n";
}

std::string quality_text(graph::Quality quality)
{
    switch (quality) {
        case graph::Quality::exact: return "the exact distance";
        case graph::Quality::bound: return "never more than the distance";
        case graph::Quality::approximate: break;
    }
    return "an estimate of the distance";
}

std::string field_text(const NodeType& type)
{
    std::string outside = quality_text(type.quality_outside), inside = quality_text(type.quality_inside);
    return outside == inside ? outside : outside + " outside, " + inside + " inside";
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

// Fields only: every number parameter is a socket too, and stands in the table.
std::string sockets_text(const NodeType& type)
{
    std::string kind = " (" + std::string(graph::socket_kind_name(type.output)) + ")";
    if (type.most_inputs > 0) return "`a`, `b`, `shape_3` to `shape_" + std::to_string(type.most_inputs) + "`" + kind;
    std::string text;
    for (const graph::Socket& socket : type.inputs)
        if (!type.parameter(socket.name))
            text += (text.empty() ? "`" : ", `") + socket.name + "` (" +
                    std::string(graph::socket_kind_name(socket.kind)) + ")";
    return text;
}

// The mean of the light of each pixel's samples.
renderer::Frame averaged(const renderer::Frame& fine)
{
    renderer::Frame frame(picture_width, picture_height);
    constexpr float share = 1.0f / (picture_detail * picture_detail);
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
            frame.colour[static_cast<std::size_t>(y / picture_detail * picture_width + x / picture_detail)] +=
                share * fine.colour[static_cast<std::size_t>(y * fine.width + x)];
    return frame;
}

renderer::Picture node_picture(const std::shared_ptr<const graph::Library>& library, const NodeType& type)
{
    StarterScene scene(library, type);
    scene.compose();
    graph::Program program = graph::lower(scene.document, library, {.ids = false});
    renderer::FrameRequest request{.width = picture_width * picture_detail, .height = picture_height * picture_detail};
    renderer::Frame frame = averaged(renderer::render_on_cpu(program, request));
    return renderer::picture(frame, renderer::View::beauty, program.march.step_limit);
}

}  // namespace

std::string node_page_stem(const NodeType& type) { return type.category + "/" + type.name; }

std::string node_page(const NodeType& type)
{
    std::string text = "# " + type.title + "\n\n![" + type.title + "](" + type.name + ".png)\n\n" + type.help + "\n\n";
    text += "- In scene files: `" + type.name + "`\n";
    if (type.is_field()) text += "- Its field gives " + field_text(type) + ".\n";
    if (std::string sockets = sockets_text(type); !sockets.empty()) text += "- Inputs: " + sockets + "\n";
    text += "- Output: " + std::string(graph::socket_kind_name(type.output)) + "\n";
    if (!type.synonyms.empty()) text += "- Also found as: " + joined(type.synonyms) + "\n";
    if (type.parameters.empty()) return text;
    text += "\n| parameter | kind | default | range | unit | meaning |\n|---|---|---|---|---|---|\n";
    for (const Parameter& parameter : type.parameters) text += parameter_row(parameter);
    return text;
}

std::string node_index(const graph::Library& library)
{
    std::string text = "# Node reference\n\n" + std::to_string(library.types().size()) +
                       " node types. Made by `./dev docs` from the files in `shaders/nodes`.\n";
    std::string category;
    for (const NodeType* type : library.types()) {
        if (type->category != category) text += "\n## " + type->category + "\n\n";
        category = type->category;
        std::string stem = node_page_stem(*type);
        text += "<a href=\"" + stem + ".md\"><img src=\"" + stem + ".png\" width=\"80\" title=\"" + type->title +
                "\" alt=\"" + type->title + "\"></a>\n";
    }
    return text;
}

void write_node_pages(const std::shared_ptr<const graph::Library>& library, const std::filesystem::path& folder)
{
    for (const NodeType* type : library->types()) {
        std::error_code error;
        std::filesystem::create_directories(folder / type->category, error);
        if (error)
            throw graph::Failure(5, "cannot make the folder " + (folder / type->category).string() + ": " +
                                        error.message() + "; choose another");
        std::filesystem::path stem = folder / node_page_stem(*type);
        graph::save_atomically(stem.string() + ".md", node_page(*type));
        renderer::write_png(stem.string() + ".png", node_picture(library, *type));
    }
    graph::save_atomically(folder / "README.md", node_index(*library));
}

}  // namespace fieldwright::app

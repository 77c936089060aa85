// A document as scene JSON: one value per line, so that a small edit is a small difference.
#include "graph/fragment.h"
#include "graph/json.h"
#include "graph/scene_file.h"
#include "graph/settings.h"

#include <cmath>
#include <utility>

namespace fieldwright::graph {
namespace {

class SceneWriter {
public:
    std::string write(const Document& document)
    {
        out_.reserve(512 + document.root.nodes.size() * 512);
        open("");
        text("format", "fieldwright");
        raw("version", std::to_string(document.version));
        raw("next_id", std::to_string(document.next_id));
        settings("march", document.march, march_table);
        settings("occlusion", document.occlusion, occlusion_table);
        // Scenes without are written as they were before there was any.
        if (document.fog != FogSettings{}) settings("fog", document.fog, fog_table);
        if (document.bounces != 0) raw("bounces", std::to_string(document.bounces));
        settings("picture", document.picture, picture_table);
        settings("animation", document.animation, animation_table);
        types(document.own_types);
        open("graphs");
        open("root");
        nodes(document.root.nodes);
        close();
        groups(document.groups);
        close();
        for (const auto& [key, json] : document.extras) raw(key, json);
        close();
        out_ += '\n';
        return std::move(out_);
    }

    std::string write(const std::vector<Node>& copied, const std::vector<OwnType>& own_types,
                      const std::vector<Group>& used)
    {
        open("");
        text("format", fragment_format);
        raw("version", std::to_string(fragment_version));
        types(own_types);
        if (!used.empty()) {
            open("groups");
            groups(used);
            close();
        }
        nodes(copied);
        close();
        out_ += '\n';
        return std::move(out_);
    }

private:
    void nodes(const std::vector<Node>& list)
    {
        open("nodes");
        for (const Node& node : list) write_node(node);
        close();
    }

    void groups(const std::vector<Group>& groups)
    {
        for (const Group& group : groups) {
            open(group.name);
            if (group.output) raw("output", std::to_string(group.output.number));
            exposed(group.exposed);
            nodes(group.graph.nodes);
            close();
        }
    }

    void exposed(const std::vector<Exposed>& list)
    {
        key("exposed");
        out_ += '[';
        ++depth_;
        empty_ = true;
        for (const Exposed& exposed : list) {
            if (!std::exchange(empty_, false)) out_ += ',';
            new_line();
            out_ += "{\"name\": ";
            append_json_string(out_, exposed.name);
            out_ += ", \"help\": ";
            append_json_string(out_, exposed.help);
            out_ += ", \"node\": " + std::to_string(exposed.node.number) + ", \"socket\": ";
            append_json_string(out_, exposed.socket);
            out_ += '}';
        }
        --depth_;
        if (!empty_) new_line();
        out_ += ']';
        empty_ = false;
    }

    void types(const std::vector<OwnType>& own_types)
    {
        if (own_types.empty()) return;
        open("types");
        for (const OwnType& type : own_types) text(type.name, type.text);
        close();
    }

    template <typename Settings>
    void settings(std::string_view name, const Settings& settings, const SettingTable<Settings>& table)
    {
        open(name);
        for (const auto& count : table.counts) raw(count.name, std::to_string(settings.*count.member));
        for (const auto& number : table.numbers) {
            key(number.name);
            append_json_number(out_, settings.*number.member);
        }
        for (const auto& choice : table.choices) text(choice.name, choice.words[choice.chosen(settings)]);
        for (const auto& colour : table.colours) {
            key(colour.name);
            vector(&(settings.*colour.member).x, 3);
        }
        close();
    }

    void write_node(const Node& node)
    {
        std::string id = std::to_string(node.id.number);
        if (!node.unknown_source.empty()) return raw(id, node.unknown_source);
        open(id);
        text("type", node.type);
        text("name", node.name);
        key("position");
        vector(&node.position.x, 2, false);
        raw("muted", node.muted ? "true" : "false");
        open("parameters");
        for (const auto& [name, value] : node.parameters) {
            key(name);
            std::visit([this](const auto& plain) { write_value(plain); }, value);
        }
        close();
        open("inputs");
        for (const auto& [socket, source] : node.inputs) raw(socket, std::to_string(source.number));
        close();
        close();
    }

    void write_value(bool value) { out_ += value ? "true" : "false"; }
    void write_value(int value) { out_ += std::to_string(value); }
    void write_value(float value) { append_json_number(out_, value); }
    void write_value(const glm::vec2& value) { vector(&value.x, 2); }
    void write_value(const glm::vec3& value) { vector(&value.x, 3); }
    void write_value(const std::string& value) { append_json_string(out_, value); }

    // Spare components at the end are left out while they are zero.
    void write_value(const PointList& points)
    {
        auto is_zero = [](float number) { return number == 0 && !std::signbit(number); };
        out_ += '[';
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i) out_ += ", ";
            int count = !is_zero(points[i].w) ? 4 : !is_zero(points[i].z) ? 3 : 2;
            vector(&points[i].x, count);
        }
        out_ += ']';
    }

    void vector(const float* numbers, int count, bool point = true)
    {
        out_ += '[';
        for (int i = 0; i < count; ++i) {
            if (i) out_ += ", ";
            append_json_number(out_, numbers[i], point);
        }
        out_ += ']';
    }

    void open(std::string_view name)
    {
        if (depth_ > 0) key(name);
        out_ += '{';
        ++depth_;
        empty_ = true;
    }

    void close()
    {
        --depth_;
        if (!empty_) new_line();
        out_ += '}';
        empty_ = false;
    }

    void key(std::string_view name)
    {
        if (!empty_) out_ += ',';
        new_line();
        append_json_string(out_, name);
        out_ += ": ";
        empty_ = false;
    }

    void text(std::string_view name, std::string_view value)
    {
        key(name);
        append_json_string(out_, value);
    }

    void raw(std::string_view name, std::string_view json)
    {
        key(name);
        out_ += json;
    }

    void new_line()
    {
        out_ += '\n';
        out_.append(2 * depth_, ' ');
    }

    std::string out_;
    std::size_t depth_ = 0;
    bool empty_ = true;  // nothing yet in the innermost object
};

}  // namespace

std::string write_scene(const Document& document, const Library&) { return SceneWriter().write(document); }

std::string write_fragment(const std::vector<Node>& nodes, const std::vector<OwnType>& own_types,
                           const std::vector<Group>& groups)
{
    return SceneWriter().write(nodes, own_types, groups);
}

}  // namespace fieldwright::graph

// Scene JSON to a document: every member checked where it stands, then the wires, then cycles.
#include "graph/edits.h"
#include "graph/fragment.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/scene_file.h"
#include "graph/settings.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace fieldwright::graph {
namespace {

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

constexpr std::string_view known_members[] = {"format", "version", "app", "next_id", "march", "occlusion", "graphs"};
constexpr std::string_view fragment_members[] = {"format", "version", "nodes"};

class SceneReader {
public:
    SceneReader(std::string_view text, const Library& library, std::string_view name)
        : json_(text, name), library_(library)
    {
    }

    Document read()
    {
        const JsonValue& scene = json_.root();
        if (scene.kind != JsonKind::object)
            json_.fail(scene, "must be an object; a scene begins with { \"format\": \"fieldwright\"");
        format(required(scene, "format", "\"format\": \"fieldwright\""));
        version(required(scene, "version", "\"version\": 1"));
        if (const JsonValue* march = json_.member(scene, "march")) read_march(json_.object(*march));
        if (const JsonValue* occlusion = json_.member(scene, "occlusion")) read_occlusion(json_.object(*occlusion));
        read_graphs(json_.object(required(scene, "graphs", "\"graphs\": {\"root\": {\"nodes\": {}}}")));
        next_id(json_.member(scene, "next_id"));
        read_wires();
        refuse_cycles();
        for (const JsonValue* member = json_.first_child(scene); member; member = json_.next_sibling(*member))
            if (!contains(known_members, member->key))
                document_.extras.emplace_back(member->key, json_.source(*member));
        return std::move(document_);
    }

    Fragment read_fragment()
    {
        const JsonValue& root = json_.object(json_.root());
        if (json_.string(required(root, "format", "the format of copied nodes")) != fragment_format)
            json_.fail(root, "is not made of copied nodes");
        if (json_.integer(required(root, "version", "\"version\": 1")) != fragment_version)
            json_.fail(root, "is of another version than this program reads, 1");
        for (const JsonValue* member = json_.first_child(root); member; member = json_.next_sibling(*member))
            if (!contains(fragment_members, member->key)) unknown_member(*member, "`format`, `version`, `nodes`");
        incoming_.emplace();
        read_nodes(json_.object(required(root, "nodes", "\"nodes\": {}")));
        document_.next_id = entries_.empty() ? 1 : entries_.back().id.number + 1;
        read_wires();
        refuse_cycles();
        drop_placeholders();
        return {std::move(document_.root.nodes), std::move(*incoming_)};
    }

private:
    // A node, and where it stands in the text.
    struct Entry {
        NodeId id;
        const JsonValue* value;
        const JsonValue* inputs = nullptr;  // of a known type
    };

    const JsonValue& required(const JsonValue& object, std::string_view key, const std::string& example) const
    {
        const JsonValue* value = json_.member(object, key);
        if (!value) json_.fail(object, "lacks its member `" + std::string(key) + "`; add " + example);
        return *value;
    }

    [[noreturn]] void unknown_member(const JsonValue& member, const std::string& known) const
    {
        std::string hint;
        if (document_.version > document_version)
            hint = "; the scene is of version " + std::to_string(document_.version) + ", this program reads version " +
                   std::to_string(document_version);
        json_.fail_at_key(member, "is not known here; the members are " + known + hint);
    }

    void format(const JsonValue& value) const
    {
        if (json_.string(value) != "fieldwright")
            json_.fail(value, "must be \"fieldwright\"; this is another kind of file");
    }

    void version(const JsonValue& value)
    {
        std::int64_t number = json_.integer(value);
        if (number < 1 || number > std::numeric_limits<int>::max())
            json_.fail(value, "must be 1 or the number of a newer version");
        document_.version = static_cast<int>(number);
    }

    int small_integer(const JsonValue& value) const
    {
        std::int64_t number = json_.integer(value);
        if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
            json_.fail(value, "is too large; write a whole number between -2^31 and 2^31 - 1");
        return static_cast<int>(number);
    }

    // Whether the member is one of the numbers, and then reads it.
    template <typename Settings, typename Numbers>
    bool read_number(const JsonValue& member, const Numbers& numbers, Settings& settings) const
    {
        for (const SettingNumber<Settings>& number : numbers) {
            if (member.key != number.name) continue;
            settings.*number.member = json_.number(member);
            return true;
        }
        return false;
    }

    void refuse_setting(const JsonValue& object, const std::optional<SettingError>& error) const
    {
        if (!error) return;
        const JsonValue* member = json_.member(object, error->name);
        if (member) json_.fail(*member, error->what);
        json_.fail(object, "`" + error->name + "` " + error->what);
    }

    void read_march(const JsonValue& object)
    {
        MarchSettings& march = document_.march;
        for (const JsonValue* member = json_.first_child(object); member; member = json_.next_sibling(*member)) {
            if (member->key == "step_limit") march.step_limit = small_integer(*member);
            else if (member->key == "out_of_steps") march.out_of_steps_hits = miss_or_hit(*member);
            else if (!read_number(*member, march_numbers, march))
                unknown_member(*member, "`step_limit`, `minimum_step`, `tolerance`, `near`, `far`, `out_of_steps`");
        }
        refuse_setting(object, setting_error(march));
    }

    bool miss_or_hit(const JsonValue& value) const
    {
        std::string_view word = json_.string(value);
        if (word != "miss" && word != "hit") json_.fail(value, "must be \"miss\" or \"hit\"");
        return word == "hit";
    }

    void read_occlusion(const JsonValue& object)
    {
        for (const JsonValue* member = json_.first_child(object); member; member = json_.next_sibling(*member))
            if (!read_number(*member, occlusion_numbers, document_.occlusion))
                unknown_member(*member, "`strength`, `radius`");
        refuse_setting(object, setting_error(document_.occlusion));
    }

    void read_graphs(const JsonValue& graphs)
    {
        const JsonValue& root = json_.object(required(graphs, "root", "\"root\": {\"nodes\": {}}"));
        for (const JsonValue* graph = json_.first_child(graphs); graph; graph = json_.next_sibling(*graph))
            if (graph != &root) unknown_member(*graph, "`root`");
        const JsonValue& nodes = json_.object(required(root, "nodes", "\"nodes\": {}"));
        for (const JsonValue* member = json_.first_child(root); member; member = json_.next_sibling(*member))
            if (member != &nodes) unknown_member(*member, "`nodes`");
        read_nodes(nodes);
    }

    void read_nodes(const JsonValue& nodes)
    {
        if (nodes.count > node_limit) json_.fail(nodes, "has more than 20000 nodes; split the scene");
        for (const JsonValue* node = json_.first_child(nodes); node; node = json_.next_sibling(*node))
            entries_.push_back({id_of(*node), &json_.object(*node)});
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
        document_.root.nodes.resize(entries_.size());
        for (std::size_t i = 0; i < entries_.size(); ++i) read_node(entries_[i], document_.root.nodes[i]);
    }

    NodeId id_of(const JsonValue& node) const
    {
        std::string_view key = node.key;
        std::int64_t number = 0;
        auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
        if (error != std::errc() || end != key.data() + key.size() || key.front() == '0' || number < 1 ||
            number >= id_limit)
            json_.fail_at_key(node, "is not an id; a node's key is a whole number from 1 up, without leading zeros");
        return {number};
    }

    std::string short_text(const JsonValue& value) const
    {
        std::string_view text = json_.string(value);
        if (text.size() > name_limit) json_.fail(value, "must have at most 256 bytes; shorten it");
        return std::string(text);
    }

    void read_node(Entry& entry, Node& node) const
    {
        node.id = entry.id;
        node.type = short_text(required(*entry.value, "type", "e.g. \"type\": \"sphere\""));
        const NodeType* type = library_.type(node.type);
        if (!type) return read_placeholder(entry, node);
        const JsonValue* parameters = nullptr;
        for (const JsonValue* member = json_.first_child(*entry.value); member; member = json_.next_sibling(*member)) {
            if (member->key == "type") continue;
            if (member->key == "name") node.name = short_text(*member);
            else if (member->key == "position") node.position = vector<2>(*member);
            else if (member->key == "muted") node.muted = json_.boolean(*member);
            else if (member->key == "parameters") parameters = &json_.object(*member);
            else if (member->key == "inputs") entry.inputs = &json_.object(*member);
            else unknown_member(*member, "`type`, `name`, `position`, `muted`, `parameters`, `inputs`");
        }
        read_parameters(*type, parameters, node);
    }

    // Only what can be shown of it; the text is the node.
    void read_placeholder(const Entry& entry, Node& node) const
    {
        const JsonValue& value = *entry.value;
        node.unknown_source = json_.source(value);
        const JsonValue* name = json_.member(value, "name");
        if (name && name->kind == JsonKind::string && name->string.size() <= name_limit) node.name = name->string;
        const JsonValue* muted = json_.member(value, "muted");
        if (muted && muted->kind == JsonKind::boolean) node.muted = muted->truth;
        const JsonValue* position = json_.member(value, "position");
        if (!position || position->kind != JsonKind::array || position->count != 2) return;
        const JsonValue* x = json_.first_child(*position);
        const JsonValue* y = json_.next_sibling(*x);
        if (x->kind == JsonKind::number && y->kind == JsonKind::number)
            node.position = {json_.number(*x), json_.number(*y)};
    }

    void read_parameters(const NodeType& type, const JsonValue* object, Node& node) const
    {
        node.parameters.reserve(type.parameters.size());
        for (const Parameter& parameter : type.parameters)
            if (parameter.kind != ParameterKind::material)
                node.parameters.emplace_back(parameter.name, parameter.initial);
        if (!object) return;
        for (const JsonValue* member = json_.first_child(*object); member; member = json_.next_sibling(*member)) {
            const Parameter* parameter = type.parameter(member->key);
            if (!parameter)
                json_.fail_at_key(
                    *member, "is not a parameter of `" + type.name + "`; its parameters are " + parameter_names(type));
            if (parameter->kind == ParameterKind::material)
                json_.fail_at_key(*member, "is a socket without a value; wire a material to it under `inputs`");
            Value value = value_of(*parameter, *member);
            if (std::string error = value_error(*parameter, value); !error.empty()) json_.fail(*member, error);
            auto place = std::find_if(node.parameters.begin(), node.parameters.end(),
                                      [&](const auto& known) { return known.first == parameter->name; });
            place->second = std::move(value);
        }
    }

    Value value_of(const Parameter& parameter, const JsonValue& value) const
    {
        switch (parameter.kind) {
            case ParameterKind::number:
            case ParameterKind::angle: return json_.number(value);
            case ParameterKind::integer: return small_integer(value);
            case ParameterKind::boolean: return json_.boolean(value);
            case ParameterKind::choice:
            case ParameterKind::text:
            case ParameterKind::formula:
            case ParameterKind::image: return std::string(json_.string(value));
            case ParameterKind::vec2: return vector<2>(value);
            case ParameterKind::vec3:
            case ParameterKind::angles:
            case ParameterKind::colour: return vector<3>(value);
            case ParameterKind::list: return points(value);
            case ParameterKind::material: break;
        }
        return {};
    }

    template <int size>
    glm::vec<size, float> vector(const JsonValue& value) const
    {
        if (value.kind != JsonKind::array || value.count != size)
            json_.fail(value, size == 2 ? "must be two numbers; write e.g. [0.0, 0.0]"
                                        : "must be three numbers; write e.g. [0.0, 0.0, 0.0]");
        glm::vec<size, float> result(0.0f);
        int i = 0;
        for (const JsonValue* part = json_.first_child(value); part; part = json_.next_sibling(*part))
            result[i++] = json_.number(*part);
        return result;
    }

    PointList points(const JsonValue& value) const
    {
        PointList list;
        list.reserve(json_.array(value).count);
        for (const JsonValue* point = json_.first_child(value); point; point = json_.next_sibling(*point)) {
            if (point->kind != JsonKind::array || point->count < 2 || point->count > 4)
                json_.fail(*point, "must be a point of two to four numbers; write e.g. [0.0, 1.0]");
            glm::vec4& target = list.emplace_back(0.0f);
            int i = 0;
            for (const JsonValue* part = json_.first_child(*point); part; part = json_.next_sibling(*part))
                target[i++] = json_.number(*part);
        }
        return list;
    }

    void next_id(const JsonValue* value)
    {
        std::int64_t largest = entries_.empty() ? 0 : entries_.back().id.number;
        document_.next_id = value ? json_.integer(*value) : largest + 1;
        if (value && document_.next_id < 1) json_.fail(*value, "must be 1 or more");
        if (document_.next_id <= largest)
            json_.fail(*value, "must be larger than every id; the largest is " + std::to_string(largest));
    }

    void read_wires()
    {
        WireRules rules(document_.root, library_, Wording::file);
        std::size_t wires = 0;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            Node& node = document_.root.nodes[i];
            if (!node.unknown_source.empty() && !incoming_) placeholder_wires(*entries_[i].value, node);
            else if (entries_[i].inputs) node_wires(*entries_[i].inputs, node, rules);
            wires += node.inputs.size();
            if (wires > wire_limit)
                json_.fail(*entries_[i].value, "is beyond the limit of 65536 wires; split the scene");
            std::sort(node.inputs.begin(), node.inputs.end());
        }
    }

    void node_wires(const JsonValue& inputs, Node& node, WireRules& rules)
    {
        for (const JsonValue* input = json_.first_child(inputs); input; input = json_.next_sibling(*input)) {
            NodeId source{json_.integer(*input)};
            bool outside = !document_.root.find(source);
            if (outside && !incoming_)
                json_.fail(*input, "must be the id of a node; there is no node " + std::to_string(source.number));
            Refusal refusal = outside ? kind_error({}, {&node, library_.type(node.type)}, input->key, Wording::file)
                                      : rules.add(source, node.id, input->key);
            if (refusal) json_.fail(*input, *refusal);
            if (outside) incoming_->push_back({source, node.id, std::string(input->key)});
            else node.inputs.emplace_back(input->key, source);
        }
    }

    // Wires that can be read are known, for cycles and look-ups; the rest stays text.
    void placeholder_wires(const JsonValue& value, Node& node) const
    {
        const JsonValue* inputs = json_.member(value, "inputs");
        if (!inputs || inputs->kind != JsonKind::object) return;
        for (const JsonValue* input = json_.first_child(*inputs); input; input = json_.next_sibling(*input)) {
            std::string_view text = json_.source(*input);
            NodeId source;
            auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), source.number);
            if (error != std::errc() || end != text.data() + text.size()) continue;
            if (source.number >= document_.next_id)
                json_.fail(*input, "must be the id of a node; there is no node " + std::to_string(source.number));
            if (document_.root.find(source)) node.inputs.emplace_back(input->key, source);
        }
    }

    void refuse_cycles() const
    {
        std::vector<NodeId> cycle = find_cycle(document_.root);
        if (cycle.empty()) return;
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), cycle.front(),
                                      [](const Entry& a, NodeId id) { return a.id < id; });
        json_.fail(*json_.member(*entry->value, "inputs"),
                   "is part of a cycle, " + cycle_text(cycle) + "; remove one of its wires");
    }

    // Their text names ids that mean nothing elsewhere.
    void drop_placeholders()
    {
        std::set<NodeId> placeholders;
        for (const Node& node : document_.root.nodes)
            if (!node.unknown_source.empty()) placeholders.insert(node.id);
        remove_nodes(document_, placeholders);
    }

    JsonTree json_;
    const Library& library_;
    Document document_;
    std::vector<Entry> entries_;                 // sorted by id, as the document's nodes
    std::optional<std::vector<Wire>> incoming_;  // of a fragment: wires whose source is not in it
};

}  // namespace

Document read_scene(std::string_view text, const Library& library, std::string_view name)
{
    return SceneReader(text, library, name).read();
}

Fragment read_fragment(std::string_view text, const Library& library, std::string_view name)
{
    return SceneReader(text, library, name).read_fragment();
}

}  // namespace fieldwright::graph

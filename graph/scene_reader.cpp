// Scene JSON to a document: every member checked where it stands, then the wires, then cycles.
#include "graph/edits.h"
#include "graph/fragment.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/own_types.h"
#include "graph/scene_file.h"
#include "graph/settings.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

namespace fieldwright::graph {
namespace {

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

constexpr std::string_view known_members[] = {"format", "version",   "app",   "next_id",
                                              "march",  "occlusion", "types", "graphs"};
constexpr std::string_view exposed_members[] = {"name", "help", "node", "socket"};
constexpr std::string_view fragment_members[] = {"format", "version", "types", "groups", "nodes"};

bool is_of_group(const NodeType* type) { return type->origin == Origin::group; }

class SceneReader {
public:
    SceneReader(std::string_view text, const Library& library, std::string_view name)
        : json_(text, name), plain_(library), library_(&library)
    {
        // The groups of another document are none of this one.
        if (std::any_of(library.types().begin(), library.types().end(), is_of_group)) know_types();
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
        read_types(json_.member(scene, "types"));
        list_graphs(json_.object(required(scene, "graphs", "\"graphs\": {\"root\": {\"nodes\": {}}}")));
        next_id(json_.member(scene, "next_id"));
        read_parts();
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
            if (!contains(fragment_members, member->key))
                unknown_member(*member, "`format`, `version`, `types`, `groups`, `nodes`");
        read_types(json_.member(root, "types"));
        if (const JsonValue* groups = json_.member(root, "groups")) list_groups(json_.object(*groups), nullptr);
        list_nodes(required(root, "nodes", "\"nodes\": {}"), root_);
        next_id(nullptr);
        incoming_.emplace();
        read_parts();
        drop_placeholders();
        return {std::move(document_.root.nodes), std::move(*incoming_), std::move(document_.own_types),
                std::move(document_.groups)};
    }

    Value read_value(const Parameter& parameter) const
    {
        Value value = value_of(parameter, json_.root());
        if (std::string error = value_error(parameter, value); !error.empty()) json_.fail(json_.root(), error);
        return value;
    }

private:
    // A node, and where it stands in the text.
    struct Entry {
        NodeId id;
        const JsonValue* value;
        const JsonValue* inputs = nullptr;  // of a known type
    };

    // A graph, and where it stands.
    struct Part {
        const JsonValue* value = nullptr;  // of a group
        std::vector<Entry> entries;        // sorted by id, as the graph's nodes
        enum class Mark { fresh, open, done } mark = Mark::fresh;
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

    // The nodes are read under the library that knows them.
    void read_types(const JsonValue* types)
    {
        if (types) {
            if (json_.object(*types).count > own_type_limit) json_.fail(*types, "has more than 256 types; remove some");
            for (const JsonValue* type = json_.first_child(*types); type; type = json_.next_sibling(*type))
                document_.own_types.push_back(own_type(*type));
        }
        std::sort(document_.own_types.begin(), document_.own_types.end(),
                  [](const OwnType& a, const OwnType& b) { return a.name < b.name; });
        if (document_.own_types == library_->own_types()) return;
        own_library_ = with_own_types(*library_, document_.own_types);
        library_ = own_library_.get();
    }

    // A name that is taken here stays in the document, and its nodes say so.
    OwnType own_type(const JsonValue& type) const
    {
        if (type.key.empty() || type.key.size() > name_limit)
            json_.fail_at_key(type, "is not the name of a type; it has 1 to 256 bytes");
        return {std::string(type.key), std::string(json_.string(type))};
    }

    void list_graphs(const JsonValue& graphs)
    {
        const JsonValue& root = json_.object(required(graphs, "root", "\"root\": {\"nodes\": {}}"));
        const JsonValue& nodes = json_.object(required(root, "nodes", "\"nodes\": {}"));
        for (const JsonValue* member = json_.first_child(root); member; member = json_.next_sibling(*member))
            if (member != &nodes) unknown_member(*member, "`nodes`");
        list_groups(graphs, &root);
        list_nodes(nodes, root_);
    }

    void list_groups(const JsonValue& graphs, const JsonValue* root)
    {
        for (const JsonValue* member = json_.first_child(graphs); member; member = json_.next_sibling(*member)) {
            if (member == root) continue;
            if (Refusal refusal = group_name_error(member->key))
                json_.fail_at_key(*member, "names a group: " + *refusal);
            if (parts_.size() >= group_limit) json_.fail(graphs, "has more than 1000 groups; split the scene");
            Part& part = parts_[std::string(member->key)];
            part.value = &json_.object(*member);
            list_nodes(required(*member, "nodes", "\"nodes\": {}"), part);
        }
        for (const auto& [name, part] : parts_) document_.groups.emplace_back().name = name;
    }

    void list_nodes(const JsonValue& nodes, Part& part)
    {
        node_count_ += json_.object(nodes).count;
        if (node_count_ > node_limit) json_.fail(nodes, "has more than 20000 nodes; split the scene");
        for (const JsonValue* node = json_.first_child(nodes); node; node = json_.next_sibling(*node))
            part.entries.push_back({id_of(*node), &json_.object(*node)});
        std::sort(part.entries.begin(), part.entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
        if (parts_.empty()) return;
        for (const Entry& entry : part.entries)
            if (!ids_.insert(entry.id).second)
                json_.fail_at_key(*entry.value, "is the id of a node in another graph too");
    }

    // Groups before the graphs that use them.
    void read_parts()
    {
        for (auto& [name, part] : parts_) read_group(name, part, 1);
        if (!parts_.empty()) know_types();
        read_graph(root_, document_.root);
    }

    void read_group(const std::string& name, Part& part, std::size_t depth)
    {
        if (part.mark == Part::Mark::done) return;
        if (part.mark == Part::Mark::open) json_.fail_at_key(*part.value, "is a group that contains itself");
        if (depth > group_depth_limit)
            json_.fail_at_key(*part.value, "is a group more than 32 groups deep; ungroup some");
        part.mark = Part::Mark::open;
        bool uses_groups = false;
        for (const Entry& entry : part.entries) {
            const JsonValue* type = json_.member(*entry.value, "type");
            if (!type || type->kind != JsonKind::string || !type->string.starts_with(group_prefix)) continue;
            auto inner = parts_.find(std::string(type->string.substr(group_prefix.size())));
            if (inner == parts_.end()) continue;
            read_group(inner->first, inner->second, depth + 1);
            uses_groups = true;
        }
        if (uses_groups) know_types();
        Group& group = *find_group(document_, name);
        read_graph(part, group.graph);
        read_interface(*part.value, group);
        types_.push_back(group_type(group, *library_));
        part.mark = Part::Mark::done;
    }

    // Of the groups read so far.
    void know_types()
    {
        known_ = (own_library_ ? *own_library_ : plain_).with(Origin::group, {types_, {}});
        library_ = known_.get();
    }

    void read_interface(const JsonValue& value, Group& group) const
    {
        for (const JsonValue* member = json_.first_child(value); member; member = json_.next_sibling(*member)) {
            if (member->key == "nodes") continue;
            if (member->key == "output") group.output = {json_.integer(*member)};
            else if (member->key == "exposed") read_exposed(json_.array(*member), group);
            else unknown_member(*member, "`output`, `exposed`, `nodes`");
            if (member->key != "output") continue;
            if (Refusal refusal = group_output_error(group.output, group.graph, *library_))
                json_.fail(*member, *refusal);
        }
    }

    void read_exposed(const JsonValue& list, Group& group) const
    {
        if (list.count > exposed_limit) json_.fail(list, "has more than 256 entries");
        for (const JsonValue* value = json_.first_child(list); value; value = json_.next_sibling(*value)) {
            Exposed exposed = exposed_of(json_.object(*value));
            if (Refusal refusal = exposed_name_error(exposed.name)) json_.fail(*value, *refusal);
            if (free_exposed_name(group, exposed.name) != exposed.name)
                json_.fail(*value, "has the name of another entry, " + in_quotes(exposed.name));
            if (Refusal refusal = exposed_error(exposed, group.graph, *library_)) json_.fail(*value, *refusal);
            group.exposed.push_back(std::move(exposed));
        }
    }

    Exposed exposed_of(const JsonValue& object) const
    {
        Exposed exposed;
        exposed.name = json_.string(required(object, "name", "\"name\": \"radius\""));
        exposed.node = {json_.integer(required(object, "node", "the id of an inner node"))};
        exposed.socket = json_.string(required(object, "socket", "the parameter or input that it drives"));
        if (const JsonValue* help = json_.member(object, "help")) exposed.help = short_text(*help);
        for (const JsonValue* member = json_.first_child(object); member; member = json_.next_sibling(*member))
            if (!contains(exposed_members, member->key)) unknown_member(*member, "`name`, `help`, `node`, `socket`");
        return exposed;
    }

    void read_graph(Part& part, Graph& graph)
    {
        graph.nodes.resize(part.entries.size());
        for (std::size_t i = 0; i < part.entries.size(); ++i) read_node(part.entries[i], graph.nodes[i]);
        read_wires(part, graph);
        refuse_cycles(part, graph);
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
        const NodeType* type = library_->type(node.type);
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
        std::int64_t largest = root_.entries.empty() ? 0 : root_.entries.back().id.number;
        for (const auto& [name, part] : parts_)
            if (!part.entries.empty()) largest = std::max(largest, part.entries.back().id.number);
        document_.next_id = value ? json_.integer(*value) : largest + 1;
        if (value && document_.next_id < 1) json_.fail(*value, "must be 1 or more");
        if (document_.next_id <= largest)
            json_.fail(*value, "must be larger than every id; the largest is " + std::to_string(largest));
    }

    void read_wires(const Part& part, Graph& graph)
    {
        WireRules rules(graph, *library_, Wording::file);
        bool may_come_from_outside = incoming_ && &part == &root_;
        for (std::size_t i = 0; i < part.entries.size(); ++i) {
            Node& node = graph.nodes[i];
            if (!node.unknown_source.empty() && !may_come_from_outside)
                placeholder_wires(*part.entries[i].value, node, graph);
            else if (part.entries[i].inputs) node_wires(*part.entries[i].inputs, node, graph, rules);
            wire_count_ += node.inputs.size();
            if (wire_count_ > wire_limit)
                json_.fail(*part.entries[i].value, "is beyond the limit of 65536 wires; split the scene");
            std::sort(node.inputs.begin(), node.inputs.end());
        }
    }

    void node_wires(const JsonValue& inputs, Node& node, const Graph& graph, WireRules& rules)
    {
        bool may_come_from_outside = incoming_ && &graph == &document_.root;
        for (const JsonValue* input = json_.first_child(inputs); input; input = json_.next_sibling(*input)) {
            NodeId source{json_.integer(*input)};
            bool outside = !graph.find(source);
            if (outside && !may_come_from_outside)
                json_.fail(*input, "must be the id of a node; there is no node " + std::to_string(source.number));
            Refusal refusal = outside ? kind_error({}, {&node, library_->type(node.type)}, input->key, Wording::file)
                                      : rules.add(source, node.id, input->key);
            if (refusal) json_.fail(*input, *refusal);
            if (outside) incoming_->push_back({source, node.id, std::string(input->key)});
            else node.inputs.emplace_back(input->key, source);
        }
    }

    // Wires that can be read are known, for cycles and look-ups; the rest stays text.
    void placeholder_wires(const JsonValue& value, Node& node, const Graph& graph) const
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
            if (graph.find(source)) node.inputs.emplace_back(input->key, source);
        }
    }

    void refuse_cycles(const Part& part, const Graph& graph) const
    {
        std::vector<NodeId> cycle = find_cycle(graph);
        if (cycle.empty()) return;
        auto entry = std::lower_bound(part.entries.begin(), part.entries.end(), cycle.front(),
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
    const Library& plain_;
    std::shared_ptr<const Library> own_library_;  // of the types that the text brings, when it does
    std::shared_ptr<const Library> known_;        // with the groups read so far
    const Library* library_;                      // the latest of these
    Document document_;
    Part root_;
    std::map<std::string, Part> parts_;  // groups
    std::vector<NodeType> types_;        // of groups read so far
    std::set<NodeId> ids_;               // when there are groups
    std::size_t node_count_ = 0, wire_count_ = 0;
    std::optional<std::vector<Wire>> incoming_;  // of a fragment: wires whose source is not in it
};

}  // namespace

Document read_scene(std::string_view text, const Library& library, std::string_view name)
{
    return SceneReader(text, library, name).read();
}

Value read_value(std::string_view json, const Parameter& parameter)
{
    return SceneReader(json, *Library::embedded(), "value").read_value(parameter);
}

Fragment read_fragment(std::string_view text, const Library& library, std::string_view name)
{
    return SceneReader(text, library, name).read_fragment();
}

}  // namespace fieldwright::graph

// Scene JSON to a document: every member checked where it stands, then the wires, then cycles.
#include "graph/edits.h"
#include "graph/fragment.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/interface_reader.h"
#include "graph/limits.h"
#include "graph/node_reader.h"
#include "graph/own_types.h"
#include "graph/scene_file.h"
#include "graph/settings_reader.h"
#include "graph/value_reader.h"
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

constexpr std::string_view known_members[] = {"format", "version", "app", "next_id", "types", "graphs"};
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
        format(json_.required(scene, "format", "\"format\": \"fieldwright\""));
        version(json_.required(scene, "version", "\"version\": 1"));
        read_types(json_.member(scene, "types"));
        list_graphs(json_.object(json_.required(scene, "graphs", "\"graphs\": {\"root\": {\"nodes\": {}}}")));
        next_id(json_.member(scene, "next_id"));
        read_parts();
        for (const JsonValue* member = json_.first_child(scene); member; member = json_.next_sibling(*member))
            if (!contains(known_members, member->key) && !read_setting(json_, *member, document_))
                document_.extras.emplace_back(member->key, json_.source(*member));
        return std::move(document_);
    }

    Fragment read_fragment()
    {
        const JsonValue& root = json_.object(json_.root());
        if (json_.string(json_.required(root, "format", "the format of copied nodes")) != fragment_format)
            json_.fail(root, "is not made of copied nodes");
        if (json_.integer(json_.required(root, "version", "\"version\": 1")) != fragment_version)
            json_.fail(root, "is of another version than this program reads, 1");
        for (const JsonValue* member = json_.first_child(root); member; member = json_.next_sibling(*member))
            if (!contains(fragment_members, member->key))
                json_.unknown_member(*member, "`format`, `version`, `types`, `groups`, `nodes`");
        read_types(json_.member(root, "types"));
        if (const JsonValue* groups = json_.member(root, "groups")) list_groups(json_.object(*groups), nullptr);
        list_nodes(json_.required(root, "nodes", "\"nodes\": {}"), root_);
        next_id(nullptr);
        incoming_.emplace();
        read_parts();
        drop_placeholders();
        return {std::move(document_.root.nodes), std::move(*incoming_), std::move(document_.own_types),
                std::move(document_.groups)};
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
        json_.set_version(document_.version);
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
        const JsonValue& root = json_.object(json_.required(graphs, "root", "\"root\": {\"nodes\": {}}"));
        const JsonValue& nodes = json_.object(json_.required(root, "nodes", "\"nodes\": {}"));
        for (const JsonValue* member = json_.first_child(root); member; member = json_.next_sibling(*member))
            if (member != &nodes) json_.unknown_member(*member, "`nodes`");
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
            list_nodes(json_.required(*member, "nodes", "\"nodes\": {}"), part);
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
        read_interface(json_, *part.value, *library_, group);
        types_.push_back(group_type(group, *library_));
        part.mark = Part::Mark::done;
    }

    // Of the groups read so far.
    void know_types()
    {
        known_ = (own_library_ ? *own_library_ : plain_).with(Origin::group, {types_, {}});
        library_ = known_.get();
    }

    void read_graph(Part& part, Graph& graph)
    {
        graph.nodes.resize(part.entries.size());
        for (std::size_t i = 0; i < part.entries.size(); ++i) {
            Entry& entry = part.entries[i];
            graph.nodes[i].id = entry.id;
            entry.inputs = read_node(json_, *entry.value, *library_, graph.nodes[i]);
        }
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

    SceneJson json_;
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
    SceneJson tree(json, "value");
    return read_value(tree, tree.root(), parameter);
}

Fragment read_fragment(std::string_view text, const Library& library, std::string_view name)
{
    return SceneReader(text, library, name).read_fragment();
}

}  // namespace fieldwright::graph

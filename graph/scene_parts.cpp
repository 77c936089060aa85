// Edits of a solid's place, its material and the scene's camera.
#include "graph/scene_parts.h"

#include "graph/draft.h"
#include "graph/groups.h"
#include "graph/known_types.h"
#include "graph/wire_rules.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

std::string no_node(NodeId id) { return "there is no node " + std::to_string(id.number); }

// Wires the material to the last paint on the field's own way, which overrules those before it, or to a new one.
void paint(Draft& draft, NodeId material, NodeId field)
{
    if (draft.refused()) return;
    NodeId painter;
    for (NodeId id : own_way(draft.document(), draft.library(), field))
        if (draft.node(id).type == known_types::paint && !draft.node(id).muted) painter = id;
    if (!painter) {
        Placed added = insert_after(draft.document(), draft.library(), known_types::paint, field);
        draft.refuse(added.refusal);
        painter = added.node;
    }
    if (draft.refused()) return;
    for (const Socket& socket : draft.library().type(known_types::paint)->inputs)
        if (socket.kind == SocketKind::material) return draft.wire(material, painter, socket.name);
}

Refusal not_a_field(const Document& document, const Library& library, NodeId id)
{
    const Node* node = document.root.find(id);
    if (!node) return no_node(id);
    const NodeType* type = library.type(node->type);
    if (!type || !type->is_field() || is_output(*type))
        return titled(node_title(*node, type)) + " is not a shape; select one";
    return std::nullopt;
}

// Sets a parameter and takes away the wire that would overrule it.
void fix(Draft& draft, NodeId node, std::string_view parameter, Value value)
{
    draft.set(node, parameter, std::move(value));
    draft.wire({}, node, parameter);
}

// Removes a camera that nothing reads any more.
void drop_unread(Draft& draft, NodeId camera)
{
    if (!camera || draft.refused() || !draft.node(camera).unknown_source.empty()) return;
    if (Readers(draft.document().root).of(camera).empty()) draft.refuse(remove_node(draft.document(), camera));
}

NodeId camera_of(const Library& library, const Node& output)
{
    for (const Socket& socket : library.type(output.type)->inputs)
        if (socket.kind == SocketKind::camera) return output.input(socket.name);
    return {};
}

// The scene's camera, replaced when it is not of the type; `replaced` is the one before.
NodeId camera_of_type(Draft& draft, std::string_view type, NodeId& replaced)
{
    const Node* output = shown_output(draft.document(), draft.library());
    NodeId camera = output ? camera_of(draft.library(), *output) : NodeId{};
    if (camera && draft.node(camera).type == type) return camera;
    glm::vec2 position(0);
    if (output) position = output->position + glm::vec2(-column_px, 0.5f * column_px);
    if (camera) position = draft.node(camera).position;
    replaced = camera;
    Placed added = add_to_output(draft.document(), draft.library(), type, position);
    draft.refuse(added.refusal);
    return added.node;
}

bool makes_field(const Node& node, const Library& library)
{
    const NodeType* type = library.type(node.type);
    return type && type->is_field() && !is_output(*type);
}

// Whether an unmuted shape is under a node; muted ones pass on their first input.
bool makes_something(const Document& document, const Library& library, NodeId start)
{
    std::set<NodeId> seen;
    for (std::vector<NodeId> stack = {start}; !stack.empty();) {
        const Node* node = document.root.find(stack.back());
        stack.pop_back();
        if (!node || !makes_field(*node, library) || !seen.insert(node->id).second) continue;
        std::vector<std::string> inputs = field_inputs(*library.type(node->type));
        if (inputs.empty() && !node->muted) return true;
        if (node->muted) inputs.resize(std::min<std::size_t>(inputs.size(), 1));
        for (const std::string& input : inputs) stack.push_back(node->input(input));
    }
    return false;
}

std::size_t count_upstream(const Graph& graph, NodeId start)
{
    std::set<NodeId> seen;
    for (std::vector<NodeId> stack = {start}; !stack.empty();) {
        NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        for (const auto& [socket, source] : graph.find(id)->inputs) stack.push_back(source);
    }
    return seen.size();
}

// Of the fields that nothing reads, the one made of most, and of equals the newest.
NodeId largest_unread(const Document& document, const Library& library)
{
    Readers readers(document.root);
    NodeId largest;
    std::size_t most = 0;
    for (const Node& node : document.root.nodes) {
        if (!makes_field(node, library) || !readers.of(node.id).empty()) continue;
        std::size_t count = count_upstream(document.root, node.id);
        if (count >= most) largest = node.id, most = count;
    }
    return largest;
}

// A camera and a sky that nothing reads are what a new output would use.
void wire_unread(Draft& draft, NodeId output)
{
    const Document& document = draft.document();
    Readers readers(document.root);
    for (const Socket& socket : draft.library().type(draft.node(output).type)->inputs)
        for (const Node& node : document.root.nodes) {
            const NodeType* type = draft.library().type(node.type);
            bool fits = type && !carries_field(socket.kind) && type->output == socket.kind;
            if (fits && readers.of(node.id).empty()) draft.wire(node.id, output, socket.name);
        }
}

}  // namespace

Shown shown_by_output(const Document& document, const Library& library)
{
    const std::vector<Node>& nodes = document.root.nodes;
    if (std::none_of(nodes.begin(), nodes.end(), [&](const Node& node) { return makes_field(node, library); }))
        return Shown::no_shape;
    const Node* output = shown_output(document, library);
    if (!output) return Shown::no_output;
    NodeId shown = output->input(field_inputs(*library.type(output->type)).front());
    if (!shown) return Shown::nothing_wired;
    return makes_something(document, library, shown) ? Shown::something : Shown::nothing_made;
}

Placed show_shape(Document& document, const Library& library)
{
    NodeId shape = largest_unread(document, library);
    if (!shape) return {{}, "there is no shape that nothing reads yet; add one"};
    Draft draft(document, library);
    if (field_dimension(document, library, shape) == 2) shape = draft.append(shape, known_types::extrude);
    const Node* output = shown_output(draft.document(), library);
    NodeId shows = output ? output->id : NodeId{};
    if (!output && !draft.refused()) {
        shows = draft.add(known_types::output, draft.node(shape).position + glm::vec2(column_px, 0));
        if (shows) wire_unread(draft, shows);
    }
    if (shows) draft.wire(shape, shows, field_inputs(*library.type(draft.node(shows).type)).front());
    return draft.finish(shows);
}

NodeId nearest_translate(const Document& document, const Library& library, NodeId id)
{
    for (NodeId passed : own_way(document, library, id)) {
        const Node& node = *document.root.find(passed);
        if (node.type == known_types::translate && !node.muted && !node.input(known_types::translate_offset))
            return passed;
    }
    return {};
}

Placed insert_translate(Document& document, const Library& library, NodeId id)
{
    if (Refusal refusal = not_a_field(document, library, id)) return {{}, refusal};
    WireRules rules(document.root, library);
    rules.add_all();
    NodeId solid;
    for (NodeId passed : own_way(document, library, id))
        if (!solid && rules.dimension(passed) != 2) solid = passed;
    if (!solid)
        return {{},
                titled(title_of(*document.root.find(id), library)) +
                    " is flat where it is combined with others; move it there by “Translate 2D”"};
    Draft draft(document, library);
    Placed added = insert_after(draft.document(), library, known_types::translate, solid);
    draft.refuse(added.refusal);
    draft.set(added.node, known_types::translate_offset, glm::vec3(0));
    return draft.finish(added.node);
}

Placed add_material(Document& document, const Library& library, std::string_view type_name, NodeId field)
{
    if (Refusal refusal = not_a_field(document, library, field)) return {{}, refusal};
    const NodeType* type = library.type(type_name);
    if (type && type->output != SocketKind::material) return {{}, titled(type->title) + " is not a material"};
    Draft draft(document, library);
    NodeId material = draft.add(type_name, document.root.find(field)->position + glm::vec2(0, column_px));
    paint(draft, material, field);
    return draft.finish(material);
}

Refusal assign_material(Document& document, const Library& library, NodeId material, NodeId field)
{
    if (!document.root.find(material)) return no_node(material);
    if (Refusal refusal = not_a_field(document, library, field)) return refusal;
    Draft draft(document, library);
    paint(draft, material, field);
    return draft.finish(material).refusal;
}

Placed set_scene_camera_from_view(Document& document, const Library& library, const SceneView& view)
{
    AtRest scene(document);
    std::string_view type = view.height ? known_types::orthographic : known_types::perspective;
    Draft draft(document, library);
    NodeId replaced, camera = camera_of_type(draft, type, replaced);
    fix(draft, camera, known_types::camera_position, view.position);
    fix(draft, camera, known_types::camera_target, view.target);
    if (view.height) fix(draft, camera, known_types::view_height, *view.height);
    else fix(draft, camera, known_types::field_of_view, view.field_of_view_deg);
    if (!draft.refused()) draft.refuse(set_muted(draft.document(), camera, false));
    draft.make_wires();
    drop_unread(draft, replaced);
    return draft.finish(camera);
}

}  // namespace fieldwright::graph

// Edits of a solid's place, its material and the scene's camera.
#include "graph/scene_parts.h"

#include "graph/draft.h"
#include "graph/known_types.h"
#include "graph/wire_rules.h"

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
    if (!type || !type->is_field() || is_output(*type)) return described(*node) + " is not a field; select one";
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

}  // namespace

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
                described(*document.root.find(id)) +
                    " is flat where it is combined with others; move it there by a "
                    "2D translate"};
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
    if (type && type->output != SocketKind::material) return {{}, "`" + type->name + "` is not a material"};
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

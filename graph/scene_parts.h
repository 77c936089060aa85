// Edits that panels and viewport make on parts of a scene: a solid's place, its material, the scene's camera. Each is
// one step for undo and changes nothing when it refuses.
#pragma once

#include "graph/compose.h"

namespace fieldwright::graph {

// The translate node that moves this node's surface and nothing else, muted or driven ones apart; NodeId{} when none.
NodeId nearest_translate(const Document& document, const Library& library, NodeId node);
// A translate by zero right after the node, or of flat shapes after what makes them solid.
Placed insert_translate(Document& document, const Library& library, NodeId node);

// A new material for what `field` shows: wired to the paint node on its way to the output, or to a new one after it.
Placed add_material(Document& document, const Library& library, std::string_view type, NodeId field);
// The same with a material that exists.
Refusal assign_material(Document& document, const Library& library, NodeId material, NodeId field);

// What the output shows; when it is nothing, why.
enum class Shown { something, no_shape, no_output, nothing_wired, nothing_made };
Shown shown_by_output(const Document& document, const Library& library);
// The output, made when there is none, shows from now on the shape that is made of most and that nothing reads; a flat one
// is extruded. A new output also takes a camera and a sky that nothing reads. Returns the output.
Placed show_shape(Document& document, const Library& library);

struct SceneView {
    glm::vec3 position, target;    // world, m
    float field_of_view_deg = 45;  // vertical; of a perspective view
    std::optional<float> height;   // m; an orthographic view
};
// Makes the scene's camera see the view. A camera of the other kind, or none, is replaced by a new node; one that
// nothing else reads goes. Wires that drove its place are removed. Returns the camera.
Placed set_scene_camera_from_view(Document& document, const Library& library, const SceneView& view);

}  // namespace fieldwright::graph

// A small complete scene around one node of any type, with default children: what a test of all types walks over.
#pragma once

#include "tests/support/random.h"

namespace fieldwright::tests {

class Starter {
public:
    // With a random source, the parameters of the subject and its children are random.
    explicit Starter(const graph::NodeType& type, std::shared_ptr<const graph::Library> library,
                     Random* random = nullptr)
        : scene(std::move(library)), random_(random)
    {
        bool is_output = type.category == "output";
        subject = is_output ? scene.show(child(3)) : add(type.name);
        NodeId field = is_output ? child(3) : child_for(type.output);
        scene.show(field);
        if (!is_output) fill_inputs(subject);
        if (type.output == graph::SocketKind::camera) scene.wire(subject, scene.show(field), "camera");
        if (type.output == graph::SocketKind::sky) scene.wire(subject, scene.show(field), "sky");
        if (type.output != graph::SocketKind::light) scene.node("sun");
    }

    Scene scene;
    NodeId subject;

private:
    using Kind = graph::SocketKind;

    NodeId add(std::string_view type)
    {
        NodeId id = scene.node(type);
        if (random_) set_random_parameters(*random_, scene, id);
        return id;
    }

    // Children alternate, so that a combiner has two different sides.
    NodeId child(int dimension)
    {
        bool first = count_++ % 2 == 0;
        if (dimension == 2) return add(first ? "rectangle" : "circle");
        return add(first ? "box" : "capsule");
    }

    void fill_inputs(NodeId id)
    {
        for (const graph::Socket& socket : scene.type(id).inputs)
            if (is_field(socket.kind)) scene.wire(child(socket.kind == Kind::field2d ? 2 : 3), id, socket.name);
    }

    // The field to show: the subject, or one that uses it.
    NodeId child_for(Kind output)
    {
        if (output == Kind::field2d) return scene.node("extrude", {{"d", subject}});
        if (is_field(output)) return subject;
        NodeId field = child(3);
        if (output == Kind::material || output == Kind::number || output == Kind::vec2 || output == Kind::vec3 ||
            output == Kind::colour)
            return user_of(output, field);
        return field;
    }

    // The first field type with a socket for the subject; else one whose material has it. Combiners may leave nothing.
    NodeId user_of(Kind output, NodeId shown)
    {
        for (const graph::NodeType* type : scene.library->types()) {
            if (!gives_space(*type) && type->output != Kind::material) continue;
            if (type->category == "combine") continue;
            for (const graph::Socket& socket : type->inputs) {
                if (socket.kind != output) continue;
                NodeId user = scene.node(type->name, {{socket.name, subject}});
                if (type->output == Kind::material) return user_of_material(user, shown);
                if (scene.type(user).input("d")) scene.wire(shown, user, "d");
                else fill_inputs(user);
                return user;
            }
        }
        return shown;
    }

    NodeId user_of_material(NodeId material, NodeId shown)
    {
        NodeId paint = scene.node("paint", {{"d", shown}});
        for (const graph::Socket& socket : scene.type(paint).inputs)
            if (socket.kind == Kind::material) scene.wire(material, paint, socket.name);
        return paint;
    }

    static bool gives_space(const graph::NodeType& type)
    {
        return type.category != "output" && (type.output == Kind::field3d || type.output == Kind::field_any) &&
               std::none_of(type.inputs.begin(), type.inputs.end(),
                            [](const graph::Socket& socket) { return socket.kind == Kind::field2d; });
    }

    Random* random_;
    int count_ = 0;
};

}  // namespace fieldwright::tests

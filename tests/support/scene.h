// Builds documents in a few words: nodes with default parameters, then what is wired and set.
#pragma once

#include "graph/edits.h"
#include "graph/program.h"

#include <initializer_list>
#include <stdexcept>

namespace fieldwright::tests {

using graph::NodeId;

class Scene {
public:
    // A socket's source or a parameter's value.
    using Setting = std::pair<std::string_view, std::variant<NodeId, graph::Value>>;

    explicit Scene(std::shared_ptr<const graph::Library> from = graph::Library::embedded()) : library(std::move(from))
    {
    }

    NodeId node(std::string_view type, std::initializer_list<Setting> settings = {})
    {
        NodeId id = graph::add_node(document, *library, type);
        if (!id) throw std::runtime_error("no node type " + std::string(type));
        for (const auto& [name, setting] : settings) {
            if (const NodeId* source = std::get_if<NodeId>(&setting)) wire(*source, id, name);
            else set(id, name, std::get<graph::Value>(setting));
        }
        return id;
    }

    void wire(NodeId source, NodeId target, std::string_view socket)
    {
        require(graph::connect(document, *library, source, target, socket));
    }

    void set(NodeId id, std::string_view name, graph::Value value)
    {
        require(graph::set_parameter(document, *library, id, name, std::move(value)));
    }

    // The output node; the first one is reused.
    NodeId show(NodeId field)
    {
        if (!output_) output_ = node("output");
        wire(field, output_, "d");
        return output_;
    }

    graph::Program program(const graph::LowerOptions& options = {}) const
    {
        return graph::lower(document, library, options);
    }

    const graph::NodeType& type(NodeId id) const { return *library->type(document.root.find(id)->type); }

    std::shared_ptr<const graph::Library> library;
    graph::Document document;

private:
    static void require(const graph::Refusal& refusal)
    {
        if (refusal) throw std::runtime_error(*refusal);
    }

    NodeId output_;
};

inline bool is_field(graph::SocketKind kind)
{
    return kind == graph::SocketKind::field2d || kind == graph::SocketKind::field3d ||
           kind == graph::SocketKind::field_any;
}

}  // namespace fieldwright::tests

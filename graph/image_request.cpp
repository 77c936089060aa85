// Requests from nodes.
#include "graph/image_request.h"

#include "graph/expansion.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

template <typename T>
void take(const Node& node, std::string_view name, T& into)
{
    const Value* value = node.parameter(name);
    if (const T* held = value ? std::get_if<T>(value) : nullptr) into = *held;
}

}  // namespace

const BakedImage* baked_image(const BakedImages& images, const ImageRequest& request)
{
    auto found = images.find(request);
    return found == images.end() ? nullptr : found->second.get();
}

const Parameter* image_parameter(const NodeType& type)
{
    auto found = std::find_if(type.parameters.begin(), type.parameters.end(),
                              [](const Parameter& parameter) { return parameter.kind == ParameterKind::image; });
    return found == type.parameters.end() ? nullptr : &*found;
}

std::optional<ImageRequest> image_request(const Node& node, const NodeType& type)
{
    const Parameter* parameter = image_parameter(type);
    if (!parameter) return std::nullopt;
    ImageRequest request;
    take(node, parameter->name, request.path);
    if (request.path.empty()) return std::nullopt;
    if (type.output == SocketKind::sky) request.part = panorama;
    take(node, "part", request.part);
    take(node, "level", request.level);
    take(node, "detail", request.detail);
    return request;
}

std::vector<ImageRequest> image_requests(const Document& document, const Library& library)
{
    std::vector<ImageRequest> requests;
    auto ask = [&](const Graph& graph) {
        for (const Node& node : graph.nodes)
            if (const NodeType* type = library.type(node.type))
                if (auto request = image_request(node, *type)) requests.push_back(std::move(*request));
    };
    for_each_graph(document, ask);
    if (!document.groups.empty()) ask(expanded(document, library).document.root);
    std::sort(requests.begin(), requests.end());
    requests.erase(std::unique(requests.begin(), requests.end()), requests.end());
    return requests;
}

}  // namespace fieldwright::graph

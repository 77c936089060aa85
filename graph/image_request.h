// Picture files that nodes draw from: what is to be made of one, and what was.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <map>
#include <memory>
#include <optional>

namespace fieldwright::graph {

inline constexpr int image_detail_limit = 500;

// What a node asks to be made of its picture: its image parameter's path, and its parameters of these names.
struct ImageRequest {
    std::string path;           // relative to the scene's folder, or absolute
    std::string part = "dark";  // "dark", "bright", "opaque" or "transparent": which pixels are inside
    int level = 50;             // %: the brightness, or opacity, at the edge
    int detail = 256;           // samples along the longer side
    auto operator<=>(const ImageRequest&) const = default;
};

// Signed distances to the part's edge, or why there are none. As a list: (columns, rows, Lipschitz constant of the
// samples' bilinear interpolation, spacing of the samples in heights of the picture), (centre and half size of the
// part's box, in samples from the first one), then the samples row by row from below, four to an entry, in spacings.
struct BakedImage {
    PointList distances;
    std::string sentence;
};

// By request: nodes that ask alike share one.
using BakedImages = std::map<ImageRequest, std::shared_ptr<const BakedImage>>;

// Null when it is not among them.
const BakedImage* baked_image(const BakedImages& images, const ImageRequest& request);

const Parameter* image_parameter(const NodeType& type);  // null when it has none
// Nothing when the type draws no picture or no file is chosen.
std::optional<ImageRequest> image_request(const Node& node, const NodeType& type);
std::vector<ImageRequest> image_requests(const Document& document, const Library& library);  // sorted, each once

}  // namespace fieldwright::graph

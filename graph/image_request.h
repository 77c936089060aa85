// Picture files that nodes draw from: what is to be made of one, and what was.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <map>
#include <memory>
#include <optional>

namespace fieldwright::graph {

inline constexpr int image_detail_limit = 500;
inline constexpr std::string_view panorama = "panorama";

// What a node asks to be made of its picture: its image parameter's path, and its parameters of these names. Skies ask
// for the panorama.
struct ImageRequest {
    std::string path;           // relative to the scene's folder, or absolute
    std::string part = "dark";  // "dark", "bright", "opaque" or "transparent": which pixels are inside; or `panorama`
    int level = 50;             // %: the brightness, or opacity, at the edge
    int detail = 256;           // samples along the longer side; of a panorama, at most
    auto operator<=>(const ImageRequest&) const = default;
};

// What was made, as a list, or why there is nothing. Of a part, signed distances to its edge: (columns, rows, Lipschitz
// constant of the samples' bilinear interpolation, spacing of the samples in heights of the picture), (centre and half
// size of the part's box, in samples from the first one), then the samples row by row from below, four to an entry, in
// spacings. Of a panorama, two maps of radiance, equirectangular, linear Rec.709: (columns, rows of the first, columns,
// rows of the second), then the picture, then what a matt surface gathers around each direction (its irradiance over pi),
// both row by row from the top, the middle of a row at -z and +x to its right, a colour to an entry.
struct BakedImage {
    PointList list;
    std::string sentence;
};

// By request: nodes that ask alike share one.
using BakedImages = std::map<ImageRequest, std::shared_ptr<const BakedImage>>;

// Null when it is not among them.
const BakedImage* baked_image(const BakedImages& images, const ImageRequest& request);

const Parameter* image_parameter(const NodeType& type);  // null when it has none
// Nothing when the type draws no picture or no file is chosen.
std::optional<ImageRequest> image_request(const Node& node, const NodeType& type);
// Of a document at rest, those of groups as their nodes set them included. Sorted, each once.
std::vector<ImageRequest> image_requests(const Document& document, const Library& library);

}  // namespace fieldwright::graph

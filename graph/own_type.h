// A node type that belongs to a document: its name and the text of its node file. A plain value.
#pragma once

#include <string>

namespace fieldwright::graph {

struct OwnType {
    std::string name;  // the word in scene files, and what its functions' names begin with
    std::string text;  // as a file of shaders/nodes; may be broken, then its nodes count as unconnected
    bool operator==(const OwnType&) const = default;
};

}  // namespace fieldwright::graph

// What holds for node texts of users beyond the dialect: they are linked into shaders beside all others, and nobody
// compiled them as C++ before.
#pragma once

#include "graph/library.h"

#include <set>

namespace fieldwright::graph {

// Names of functions and constants, which are unique over a shader.
class TakenNames {
public:
    explicit TakenNames(const Library& library);
    void add(const NodeType& type);
    bool function(std::string_view name) const { return functions_.contains(name); }
    bool constant(std::string_view name) const { return constants_.contains(name); }

private:
    void add(const SourceFile& file);
    std::set<std::string, std::less<>> functions_, constants_;
};

// Throws DialectError: what each function returns and receives, names, loops and size.
void check_own_rules(const NodeType& type, const TakenNames& taken);
// The folder of shaders/nodes where such a node would lie.
std::string category_of_meaning(const NodeType& type);

}  // namespace fieldwright::graph

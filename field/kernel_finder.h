// The kernels of a program's functions.
#pragma once

#include "field/kernel.h"
#include "graph/program.h"

#include <unordered_map>

namespace fieldwright::field {

// Looks each function up once. Table and program must outlive it.
class KernelFinder {
public:
    KernelFinder(const KernelTable& table, const graph::Program& program) : table_(table), program_(program) {}

    // node: that which needs the function. Throws graph::Failure{1} naming it when the function is not compiled into
    // this program.
    const KernelEntry& operator()(const graph::Function& function, graph::NodeId node);
    const KernelEntry& operator()(const graph::Instruction& call) { return (*this)(*call.function, call.node); }

private:
    const KernelTable& table_;
    const graph::Program& program_;
    std::unordered_map<const graph::Function*, const KernelEntry*> found_;
};

}  // namespace fieldwright::field

// A kernel is found by its function's name, if the function is the one that it was made of.
#include "field/kernel_finder.h"

namespace fieldwright::field {
namespace {

using graph::Program;

// Kernels are made of the texts built in: a function of the same name in an edited file is another one.
bool is_built_in(const Program& program, const graph::Function& function)
{
    auto built_in = graph::embedded_texts().find(function.file);
    return built_in != graph::embedded_texts().end() && built_in->second == program.library->text(function.file);
}

const KernelEntry& kernel_of(const KernelTable& table, const Program& program, const graph::Function& function,
                             graph::NodeId node)
{
    const KernelEntry* kernel = find_kernel(table, function.name);
    if (!kernel || !is_built_in(program, function))
        throw graph::Failure(1, "node " + std::to_string(node.number) + " (" + function.name +
                                    ") is not compiled into this program; render it with --device gpu or rebuild");
    return *kernel;
}

}  // namespace

const KernelEntry& KernelFinder::operator()(const graph::Function& function, graph::NodeId node)
{
    auto [found, added] = found_.try_emplace(&function, nullptr);
    if (added) found->second = &kernel_of(table_, program_, function, node);
    return *found->second;
}

}  // namespace fieldwright::field

// The choice of an instruction set at run time.
#include "field/kernel.h"

#include "graph/problem.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace fieldwright::field {

namespace base {
extern const KernelTable table;
}
#ifdef FIELDWRIGHT_X86
namespace avx2 {
extern const KernelTable table;
}
namespace avx512 {
extern const KernelTable table;
}
#endif

namespace {

std::vector<const KernelTable*> runnable()
{
    std::vector<const KernelTable*> tables;
#ifdef FIELDWRIGHT_X86
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl"))
        tables.push_back(&avx512::table);
    if (__builtin_cpu_supports("avx2")) tables.push_back(&avx2::table);
#endif
    tables.push_back(&base::table);
    return tables;
}

const KernelTable& chosen()
{
    static const std::vector<const KernelTable*> tables = runnable();
    const char* wanted = std::getenv("FIELDWRIGHT_ISA");
    if (!wanted || !*wanted) return *tables.front();
    for (const KernelTable* table : tables)
        if (table->instruction_set == wanted) return *table;
    throw graph::Failure(
        2, "FIELDWRIGHT_ISA=" + std::string(wanted) + ": this processor does not run it; unset the variable");
}

}  // namespace

const KernelTable& kernels()
{
    static const KernelTable& table = chosen();
    return table;
}

const KernelTable* const* runnable_kernels(int& count)
{
    static const std::vector<const KernelTable*> tables = runnable();
    count = static_cast<int>(tables.size());
    return tables.data();
}

const KernelEntry* find_kernel(const KernelTable& table, std::string_view function)
{
    const KernelEntry* found =
        std::lower_bound(table.begin, table.end, function,
                         [](const KernelEntry& entry, std::string_view name) { return entry.function < name; });
    return found != table.end && found->function == function ? found : nullptr;
}

}  // namespace fieldwright::field

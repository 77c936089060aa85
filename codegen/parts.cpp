// A level is cut where few values are alive.
#include "codegen/parts.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fieldwright::codegen {
namespace {

using graph::Instruction;
using graph::Program;
using graph::ValueId;

// Items per part: about 32 primitives with their moves and combiners (compilers slow down beyond).
constexpr std::size_t smallest_part = 64;

template <typename Visit>
void for_each_use(const Program& program, const Item& item, const Visit& visit)
{
    for (std::int32_t i = item.instruction; i < item.end; ++i) {
        const Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        for (ValueId argument : arguments_of(program, instruction)) visit(argument);
        for (const graph::Carried& pair : carried_of(program, instruction)) visit(pair.next);
    }
}

template <typename Visit>
void for_each_definition(const Program& program, const Item& item, const Visit& visit)
{
    for (std::int32_t i = item.instruction; i < item.end; ++i) {
        const Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        if (!instruction.is_block()) visit(instruction.result);
        else visit(instruction.copy);
        for (const graph::Carried& pair : carried_of(program, instruction)) visit(pair.accumulator);
    }
}

// Where, 64 to 128 items on, the fewest values defined since `first` are read later; the latest such place.
std::size_t best_cut(const Program& program, const std::vector<Item>& items, std::size_t first,
                     const std::vector<std::uint32_t>& last_use)
{
    std::size_t last = first + largest_part;
    if (last >= items.size()) return items.size();
    std::array<int, largest_part + 2> change{};  // of the number of values alive, by items after first
    for (std::size_t i = first; i < last; ++i)
        for_each_definition(program, items[i], [&](ValueId id) {
            std::size_t end = last_use[static_cast<std::size_t>(id)];
            if (end <= i) return;
            ++change[i + 1 - first];
            if (end < last) --change[end + 1 - first];
        });
    int alive = 0, fewest = std::numeric_limits<int>::max();
    std::size_t best = last;
    for (std::size_t cut = 1; cut <= largest_part; ++cut) {
        alive += change[cut];
        if (cut >= smallest_part && alive <= fewest) fewest = alive, best = first + cut;
    }
    return best;
}

}  // namespace

std::vector<Item> items_of(const Program& program, std::int32_t first, std::int32_t last)
{
    std::vector<Item> result;
    for (std::int32_t i = first; i < last;) {
        const Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        std::int32_t end = instruction.is_block() ? instruction.body_end : i + 1;
        result.push_back({i, end});
        i = end;
    }
    return result;
}

std::vector<Part> parts_of(const Program& program, const std::vector<Item>& items, std::span<const ValueId> results)
{
    constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> defined(program.values.size(), never), last_use(program.values.size(), 0);
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        for_each_definition(program, items[i], [&](ValueId id) { defined[static_cast<std::size_t>(id)] = i; });
        for_each_use(program, items[i], [&](ValueId id) { last_use[static_cast<std::size_t>(id)] = i; });
    }
    for (ValueId id : results) last_use[static_cast<std::size_t>(id)] = never;

    std::vector<Part> result;
    for (std::size_t first = 0; first < items.size();) {
        std::size_t best = best_cut(program, items, first, last_use);
        Part part{first, best, {}, {}};
        for (std::size_t i = first; i < best; ++i) {
            for_each_use(program, items[i], [&](ValueId id) {
                bool outside =
                    program.values[static_cast<std::size_t>(id)].rate == graph::Rate::point &&
                    (defined[static_cast<std::size_t>(id)] == never || defined[static_cast<std::size_t>(id)] < first);
                if (outside && std::find(part.inputs.begin(), part.inputs.end(), id) == part.inputs.end())
                    part.inputs.push_back(id);
            });
            for_each_definition(program, items[i], [&](ValueId id) {
                if (last_use[static_cast<std::size_t>(id)] >= best) part.outputs.push_back(id);
            });
        }
        first = best;
        result.push_back(std::move(part));
    }
    return result;
}

}  // namespace fieldwright::codegen

// Finds the guards in unions, gathers what only they need, and puts it behind their rivals.
#include "field/steps.h"

#include "field/program_values.h"
#include "graph/known_types.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <unordered_map>

namespace fieldwright::field {
namespace {

using graph::Instruction;
using graph::Program;
using graph::ValueId;

constexpr std::string_view distance_suffix = "_distance";
constexpr std::size_t least_worthwhile = 4;  // calls; fewer take no longer than looking whether they are needed

class Planner {
public:
    Planner(const Program& program, const graph::Entry& entry) : program_(program), uses_(program.values.size(), 0)
    {
        Items items = listed(entry.first, entry.last);
        for (const Item& item : items) for_each_use(item, [&](ValueId id) { ++uses_[index(id)]; });
        for (ValueId result : entry.results) ++uses_[index(result)];
        guard(items);
        write(items);
    }

    Plan plan() && { return std::move(plan_); }

private:
    struct Item;
    using Items = std::vector<Item>;
    struct Item {
        const Instruction* instruction = nullptr;  // a call or a block; null: a guarded part
        int guard = -1;
        Items body;  // of a block or a guarded part
    };
    struct Part {
        std::size_t guard;               // where in the items
        std::vector<std::size_t> slice;  // what only it needs, in order
        Guard meaning;
    };
    using Producers = std::unordered_map<ValueId, std::size_t>;

    Items listed(std::int32_t first, std::int32_t last) const
    {
        Items items;
        for (std::int32_t i = first; i < last; ++i) {
            const Instruction& instruction = program_.instructions[index(i)];
            items.push_back({&instruction});
            if (!instruction.is_block()) continue;
            items.back().body = listed(i + 1, instruction.body_end);
            i = instruction.body_end - 1;
        }
        return items;
    }

    // A block's use of its own accumulators is nobody else's.
    template <typename Visit>
    void for_each_use(const Item& item, const Visit& visit) const
    {
        if (!item.instruction || !item.instruction->is_block()) {
            if (item.instruction)
                for (ValueId id : arguments_of(program_, *item.instruction)) visit(id);
            for (const Item& inner : item.body) for_each_use(inner, visit);
            return;
        }
        std::span<const graph::Carried> carried = carried_of(program_, *item.instruction);
        auto visit_outer = [&](ValueId id) {
            auto is_own = [&](const graph::Carried& pair) { return pair.accumulator == id; };
            if (std::none_of(carried.begin(), carried.end(), is_own)) visit(id);
        };
        for (const graph::Carried& pair : carried) visit_outer(pair.initial), visit_outer(pair.next);
        for (const Item& inner : item.body) for_each_use(inner, std::function<void(ValueId)>(visit_outer));
    }

    std::vector<ValueId> results_of(const Item& item) const
    {
        if (!item.instruction) return {plan_.guards[index(item.guard)].guarded};
        if (!item.instruction->is_block()) return {item.instruction->result};
        std::vector<ValueId> results;
        for (const graph::Carried& pair : carried_of(program_, *item.instruction)) results.push_back(pair.accumulator);
        return results;
    }

    static bool is_call_of(const Item& item, std::string_view node_type)
    {
        if (!item.instruction || item.instruction->is_block()) return false;
        std::string_view name = item.instruction->function->name;
        return name.size() == node_type.size() + distance_suffix.size() && name.starts_with(node_type) &&
               name.ends_with(distance_suffix);
    }

    static bool is_union(const Item& item) { return is_call_of(item, graph::known_types::union_of_two); }

    const graph::Function* least_of(const Item& item) const
    {
        if (!item.instruction || item.instruction->is_block()) return nullptr;
        std::string_view name = item.instruction->function->name;
        if (!name.ends_with(distance_suffix)) return nullptr;
        name.remove_suffix(distance_suffix.size());
        const graph::NodeType* type = program_.library->type(name);
        return type ? type->function("least") : nullptr;
    }

    // Those of blocks first; then union by union.
    void guard(Items& items)
    {
        for (Item& item : items) guard(item.body);
        if (std::none_of(items.begin(), items.end(), [&](const Item& item) { return least_of(item) != nullptr; }))
            return;
        std::vector<ValueId> roots;
        for (const Item& item : items)
            if (is_union(item)) roots.push_back(item.instruction->result);
        for (const Item& item : items) {
            if (!is_union(item)) continue;
            for (ValueId id : arguments_of(program_, *item.instruction))
                if (uses_[index(id)] == 1) std::erase(roots, id);
        }
        for (ValueId root : roots) guard_union(items, root);
    }

    // A union of unions is one of many: each of its guards has as rivals what stands without one, and those before it.
    void guard_union(Items& items, ValueId root)
    {
        Producers producers;
        for (std::size_t i = 0; i < items.size(); ++i)
            for (ValueId result : results_of(items[i])) producers[result] = i;
        auto found = producers.find(root);
        if (found == producers.end()) return;  // inside a guarded part by now, where its rivals are as well

        std::vector<std::size_t> unions = {found->second};
        std::vector<Part> parts;
        std::vector<ValueId> rivals;
        for (std::size_t next = 0; next < unions.size(); ++next)
            for (ValueId leaf : arguments_of(program_, *items[unions[next]].instruction)) {
                auto producer = producers.find(leaf);
                bool alone = producer != producers.end() && uses_[index(leaf)] == 1;
                if (alone && is_union(items[producer->second])) unions.push_back(producer->second);
                else if (auto part = alone ? guarded_part(items, producer->second, producers) : std::nullopt)
                    parts.push_back(std::move(*part));
                else if (program_.values[index(leaf)].rate == graph::Rate::point) rivals.push_back(leaf);
            }
        if (rivals.empty() && !parts.empty()) {
            rivals.push_back(parts.front().meaning.call->result);
            parts.erase(parts.begin());
        }
        if (!parts.empty()) items = reordered(std::move(items), std::move(unions), std::move(parts), std::move(rivals));
    }

    std::optional<Part> guarded_part(const Items& items, std::size_t at, const Producers& producers) const
    {
        const graph::Function* least = least_of(items[at]);
        if (!least) return std::nullopt;
        ValueId guarded = argument_named(program_, *items[at].instruction, "a");
        if (guarded == graph::no_value || !producers.contains(guarded) || uses_[index(guarded)] != 1)
            return std::nullopt;
        Part part{at, slice(items, at, guarded), {items[at].instruction, least, guarded, {}}};
        std::size_t calls = 0;
        for (std::size_t i : part.slice) calls += items[i].body.empty() ? 1 : least_worthwhile;
        if (calls < least_worthwhile) return std::nullopt;
        return part;
    }

    // What is used for `result` and for nothing else.
    std::vector<std::size_t> slice(const Items& items, std::size_t end, ValueId result) const
    {
        std::vector<std::size_t> members;
        std::unordered_map<ValueId, int> used = {{result, 1}};
        for (std::size_t i = end; i-- > 0;) {
            int all = 0, inside = 0;
            for (ValueId id : results_of(items[i])) all += uses_[index(id)], inside += used.contains(id) ? used[id] : 0;
            if (inside == 0 || inside < all) continue;
            members.push_back(i);
            for_each_use(items[i], [&](ValueId id) { ++used[id]; });
        }
        std::reverse(members.begin(), members.end());
        return members;
    }

    Items reordered(Items items, std::vector<std::size_t> unions, std::vector<Part> parts, std::vector<ValueId> rivals)
    {
        std::vector<bool> moved(items.size(), false);
        for (std::size_t at : unions) moved[at] = true;
        for (const Part& part : parts) {
            moved[part.guard] = true;
            for (std::size_t at : part.slice) moved[at] = true;
        }
        std::size_t root = unions.front();
        Items order;
        for (std::size_t i = 0; i < root; ++i)
            if (!moved[i]) order.push_back(std::move(items[i]));
        for (Part& part : parts) {
            part.meaning.rivals = rivals;
            rivals.push_back(part.meaning.call->result);
            Item guarded{nullptr, static_cast<int>(plan_.guards.size())};
            for (std::size_t at : part.slice) guarded.body.push_back(std::move(items[at]));
            plan_.guards.push_back(std::move(part.meaning));
            order.push_back(std::move(guarded));
            order.push_back(std::move(items[part.guard]));
        }
        std::sort(unions.begin(), unions.end());
        for (std::size_t at : unions) order.push_back(std::move(items[at]));
        std::move(items.begin() + static_cast<std::ptrdiff_t>(root) + 1, items.end(), std::back_inserter(order));
        return order;
    }

    void write(const Items& items)
    {
        using Kind = Step::Kind;
        for (const Item& item : items) {
            bool part = !item.instruction, block = !part && item.instruction->is_block();
            if (!part && !block) {
                plan_.steps.push_back({Kind::call, item.instruction});
                continue;
            }
            plan_.steps.push_back({part ? Kind::begin_guard : Kind::begin_block, item.instruction, item.guard});
            write(item.body);
            plan_.steps.push_back({part ? Kind::end_guard : Kind::end_block, item.instruction, item.guard});
        }
    }

    const Program& program_;
    std::vector<int> uses_;  // by value, in this entry
    Plan plan_;
};

}  // namespace

Plan plan_of(const Program& program, const graph::Entry& entry) { return Planner(program, entry).plan(); }

ValueId argument_named(const Program& program, const Instruction& call, std::string_view name)
{
    const std::vector<graph::Argument>& arguments = call.function->arguments;
    for (std::size_t k = 0; k < arguments.size(); ++k)
        if (arguments[k].name == name) return arguments_of(program, call)[k];
    return graph::no_value;
}

}  // namespace fieldwright::field

// Branch and bound: the cell that may be steepest is halved, until what it may be is near what was found.
#include "graph/slope.h"

#include "graph/cell_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace fieldwright::graph {
namespace {

constexpr std::size_t memo_limit = 32;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Cell {
    std::array<Interval, 3> box;
    double steepest;  // no steeper in it
    int depth = 0;    // halvings
    bool operator<(const Cell& other) const { return steepest < other.steepest; }
};

class Search {
public:
    Search(const Formula& formula, std::span<const Interval> variables)
        : cell_slope_(formula), variables_(variables.begin(), variables.end())
    {
        for (int axis = formula_x; axis <= formula_z; ++axis)
            if (formula.uses(axis)) axes_.push_back(static_cast<std::size_t>(axis));
    }

    SlopeBound run()
    {
        add({variables_[formula_x], variables_[formula_y], variables_[formula_z]}, 0);
        for (int cells = 0; cells < most_cells && !cells_.empty(); ++cells) {
            Cell cell = cells_.top();
            if (cell.steepest <= tolerance * found_) break;
            cells_.pop();
            if (std::isinf(cell.steepest) &&
                (axes_.empty() || cell.depth >= deepest_endless * static_cast<int>(axes_.size())))
                bounded_ = false;
            else look_at(cell.box), split(cell);
        }
        double slope = cells_.empty() ? found_ : std::max(found_, cells_.top().steepest);
        if (std::isinf(slope)) bounded_ = false, slope = found_;
        return {slope * rounding, bounded_, cell_slope_.chose()};
    }

private:
    static constexpr int most_cells = 1000;    // halved
    static constexpr int deepest_endless = 3;  // halvings of an axis until a cell without a bound is given up
    static constexpr double tolerance = 1.1;
    static constexpr double rounding = 1 + 1e-9;  // of the arithmetic here, which does not round outwards

    double steepest(const std::array<Interval, 3>& box)
    {
        std::copy(box.begin(), box.end(), variables_.begin());
        return cell_slope_.steepest(variables_);
    }

    // The middle, and the corner farthest out, where polynomials are steep, are as steep as they are.
    void look_at(const std::array<Interval, 3>& box)
    {
        std::array<Interval, 3> middle, corner;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double centre = 0.5 * (box[axis].low + box[axis].high);
            double far_end = centre < 0 ? box[axis].low : box[axis].high;
            middle[axis] = {centre, centre};
            corner[axis] = {far_end, far_end};
        }
        for (const auto& point : {middle, corner})
            if (double here = steepest(point); std::isfinite(here)) found_ = std::max(found_, here);
    }

    void add(const std::array<Interval, 3>& box, int depth)
    {
        double steep = steepest(box);
        if (std::isnan(steep)) steep = infinite;
        cells_.push({box, steep, depth});
    }

    void split(const Cell& cell)
    {
        if (axes_.empty()) return;
        std::size_t axis = axes_[static_cast<std::size_t>(cell.depth) % axes_.size()];
        double middle = 0.5 * (cell.box[axis].low + cell.box[axis].high);
        for (Interval half : {Interval{cell.box[axis].low, middle}, Interval{middle, cell.box[axis].high}}) {
            std::array<Interval, 3> box = cell.box;
            box[axis] = half;
            add(box, cell.depth + 1);
        }
    }

    CellSlope cell_slope_;
    std::vector<Interval> variables_;
    std::vector<std::size_t> axes_;  // that the formula uses
    std::priority_queue<Cell> cells_;
    double found_ = 0;  // somewhere it is as steep
    bool bounded_ = true;
};

}  // namespace

SlopeBound slope_bound(const Formula& formula, std::span<const Interval> variables)
{
    return Search(formula, variables).run();
}

SlopeBound SlopeMemo::bound(const Formula& formula, std::span<const Interval> variables)
{
    for (const Entry& entry : entries_)
        if (entry.formula == formula && std::ranges::equal(entry.variables, variables)) return entry.bound;
    if (entries_.size() >= memo_limit) entries_.pop_front();
    entries_.push_back({formula, {variables.begin(), variables.end()}, slope_bound(formula, variables)});
    return entries_.back().bound;
}

}  // namespace fieldwright::graph

// Splitting of drawings into rectangles.
#include "graph/drawing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace fieldwright::graph {
namespace {

// Whole cells, or steps of a grid of any spacing: [x0, x1) x [y0, y1).
struct Span {
    int x0, y0, x1, y1;
};

using Spans = std::vector<Span>;

// Two that make one: equal across, and touching.
bool merge(Span& a, const Span& b)
{
    bool beside = a.y0 == b.y0 && a.y1 == b.y1 && (a.x1 == b.x0 || b.x1 == a.x0);
    bool above = a.x0 == b.x0 && a.x1 == b.x1 && (a.y1 == b.y0 || b.y1 == a.y0);
    if (!beside && !above) return false;
    a = {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
    return true;
}

// Until no two make one.
Spans merged(Spans spans)
{
    for (std::size_t i = 0; i < spans.size(); ++i)
        for (std::size_t j = 0; j < spans.size(); ++j) {
            if (i == j || !merge(spans[i], spans[j])) continue;
            spans.erase(spans.begin() + static_cast<std::ptrdiff_t>(j));
            if (j < i) --i;
            j = static_cast<std::size_t>(-1);
        }
    return spans;
}

template <typename Filled>
void split(const Filled& filled, int x, int y, int size, int side, Spans& into)
{
    if (x >= side || y >= side) return;
    bool some = false, all = x + size <= side && y + size <= side;
    for (int row = y; row < std::min(y + size, side); ++row)
        for (int column = x; column < std::min(x + size, side); ++column)
            (filled(column, row) ? some : all) = filled(column, row);
    if (!some) return;
    if (all) return into.push_back({x, y, x + size, y + size});
    int half = size / 2;
    for (int quarter = 0; quarter < 4; ++quarter)
        split(filled, x + quarter % 2 * half, y + quarter / 2 * half, half, side, into);
}

template <typename Filled>
Spans quadtree(const Filled& filled, int side)
{
    Spans squares;
    split(filled, 0, 0, static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))), side, squares);
    return merged(std::move(squares));
}

// Runs of filled cells in every row; equal runs of neighbouring rows are one.
template <typename Filled>
Spans rows(const Filled& filled, int width, int height)
{
    Spans done, open;
    for (int y = 0; y < height; ++y) {
        Spans now;
        for (int x = 0; x < width; ++x) {
            if (!filled(x, y)) continue;
            if (x > 0 && filled(x - 1, y)) now.back().x1 = x + 1;
            else now.push_back({x, y, x + 1, y + 1});
        }
        for (Span& run : now)
            for (Span& below : open)
                if (below.x0 == run.x0 && below.x1 == run.x1) run.y0 = std::exchange(below.y0, -1);
        for (const Span& ended : open)
            if (ended.y0 >= 0) done.push_back(ended);
        open = std::move(now);
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
}

template <typename Filled>
Spans columns(const Filled& filled, int width, int height)
{
    Spans spans = rows([&](int x, int y) { return filled(y, x); }, height, width);
    for (Span& span : spans) span = {span.y0, span.x0, span.y1, span.x1};
    return spans;
}

Spans fewer(Spans a, Spans b) { return b.size() < a.size() ? b : a; }

// The grid on which the borders of rectangles lie, and which of its fields they cover.
class Grid {
public:
    explicit Grid(const PointList& rectangles)
    {
        for (const glm::vec4& r : rectangles) {
            for (float sign : {-1.0f, 1.0f}) x_.push_back(r.x + sign * r.z), y_.push_back(r.y + sign * r.w);
        }
        for (auto* lines : {&x_, &y_}) {
            std::sort(lines->begin(), lines->end());
            lines->erase(std::unique(lines->begin(), lines->end()), lines->end());
            lines->insert(lines->begin(), lines->front() - 1);  // the gap around all is one cell wide
            lines->push_back(lines->back() + 1);
        }
        covered_.assign(static_cast<std::size_t>(width() * height()), 0);
        for (const glm::vec4& r : rectangles) cover(r);
    }

    int width() const { return static_cast<int>(x_.size()) - 1; }
    int height() const { return static_cast<int>(y_.size()) - 1; }
    bool gap(int x, int y) const { return !covered_[static_cast<std::size_t>(y * width() + x)]; }

    glm::vec4 rectangle(const Span& span) const
    {
        auto at = [](const std::vector<float>& lines, int i) { return lines[static_cast<std::size_t>(i)]; };
        float x0 = at(x_, span.x0), x1 = at(x_, span.x1), y0 = at(y_, span.y0), y1 = at(y_, span.y1);
        return {0.5f * (x0 + x1), 0.5f * (y0 + y1), 0.5f * (x1 - x0), 0.5f * (y1 - y0)};
    }

private:
    static int line(const std::vector<float>& lines, float at)
    {
        return static_cast<int>(std::lower_bound(lines.begin(), lines.end(), at) - lines.begin());
    }

    void cover(const glm::vec4& r)
    {
        int x0 = line(x_, r.x - r.z), x1 = line(x_, r.x + r.z);
        for (int y = line(y_, r.y - r.w); y < line(y_, r.y + r.w); ++y)
            std::fill(covered_.begin() + y * width() + x0, covered_.begin() + y * width() + x1, std::uint8_t(1));
    }

    std::vector<float> x_, y_;
    std::vector<std::uint8_t> covered_;  // row by row
};

// Borders that are meant to be the same are, however the numbers were rounded.
glm::vec4 on_grid(const glm::vec4& r)
{
    constexpr float steps = 1024;  // per cell
    auto border = [](float at) { return std::round(at * steps) / steps; };
    float x0 = border(r.x - std::abs(r.z)), x1 = border(r.x + std::abs(r.z));
    float y0 = border(r.y - std::abs(r.w)), y1 = border(r.y + std::abs(r.w));
    return {0.5f * (x0 + x1), 0.5f * (y0 + y1), 0.5f * (x1 - x0), 0.5f * (y1 - y0)};
}

}  // namespace

Drawing::Drawing(int side)
    : side_(std::clamp(side, 1, drawing_side_limit)), cells_(static_cast<std::size_t>(side_ * side_), 0)
{
}

Drawing::Drawing(const PointList& rectangles, int side) : Drawing(side)
{
    auto first = [&](float low) { return static_cast<int>(std::clamp(std::ceil(low - 0.5f), 0.0f, float(side_))); };
    for (const glm::vec4& r : rectangles) {
        float half_width = std::abs(r.z), half_height = std::abs(r.w);
        for (int y = first(r.y - half_height); y < first(r.y + half_height); ++y)
            for (int x = first(r.x - half_width); x < first(r.x + half_width); ++x) fill(x, y, true);
    }
}

void Drawing::fill(int x, int y, bool on)
{
    if (contains(x, y)) cells_[index(x, y)] = on;
}

int Drawing::count() const { return static_cast<int>(std::count(cells_.begin(), cells_.end(), 1)); }

PointList Drawing::rectangles() const
{
    auto is_filled = [&](int x, int y) { return filled(x, y); };
    Spans spans =
        fewer(quadtree(is_filled, side_), fewer(rows(is_filled, side_, side_), columns(is_filled, side_, side_)));
    PointList result;
    for (const Span& s : spans)
        result.emplace_back(0.5f * static_cast<float>(s.x0 + s.x1), 0.5f * static_cast<float>(s.y0 + s.y1),
                            0.5f * static_cast<float>(s.x1 - s.x0), 0.5f * static_cast<float>(s.y1 - s.y0));
    return result;
}

PointList with_gaps(const PointList& rectangles)
{
    PointList all;
    for (const glm::vec4& r : rectangles)
        if (all.size() < drawing_rectangle_limit) all.push_back(on_grid(r));
    if (all.empty()) return all;
    Grid grid(all);
    auto gap = [&](int x, int y) { return grid.gap(x, y); };
    Spans gaps = fewer(rows(gap, grid.width(), grid.height()), columns(gap, grid.width(), grid.height()));
    if (all.size() + gaps.size() > drawing_rectangle_limit) return all;
    for (const Span& span : gaps) {
        all.push_back(grid.rectangle(span));
        all.back().z = -all.back().z;
    }
    return all;
}

}  // namespace fieldwright::graph

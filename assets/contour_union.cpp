// Sides are cut where they meet, kept where only one of their two sides is covered, and joined to contours again.
#include "assets/contour_union.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fieldwright::assets {
namespace {

using glm::dvec2;

constexpr double grid = 1.0 / 131072;
constexpr double touching = 0.75 * grid;  // nearer is on the line
constexpr double aside = 4 * grid;        // where the two sides of a piece are looked at

struct Side {
    dvec2 from, to;
};

struct Before {
    bool operator()(dvec2 a, dvec2 b) const { return a.x < b.x || (a.x == b.x && a.y < b.y); }
    bool operator()(const Side& a, const Side& b) const
    {
        return a.from != b.from ? (*this)(a.from, b.from) : (*this)(a.to, b.to);
    }
};

dvec2 snapped(dvec2 p) { return glm::round(p / grid) * grid; }

double cross(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

std::vector<Side> sides_of(const std::vector<Contour>& contours)
{
    std::vector<Side> sides;
    for (const Contour& contour : contours)
        for (std::size_t i = 0; i < contour.size(); ++i) {
            Side side{snapped(contour[i]), snapped(contour[(i + 1) % contour.size()])};
            if (side.from != side.to) sides.push_back(side);
        }
    return sides;
}

bool near_each_other(const Side& a, const Side& b)
{
    dvec2 low = glm::max(glm::min(a.from, a.to), glm::min(b.from, b.to));
    dvec2 high = glm::min(glm::max(a.from, a.to), glm::max(b.from, b.to));
    return low.x <= high.x + touching && low.y <= high.y + touching;
}

bool lies_on(dvec2 p, const Side& side)
{
    dvec2 along = side.to - side.from;
    double share = std::clamp(glm::dot(p - side.from, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(p, side.from + share * along) < touching;
}

// Adds to each side the points at which the other cuts it.
void cut(const Side& a, const Side& b, Contour& of_a, Contour& of_b)
{
    if (!near_each_other(a, b)) return;
    bool meet = false;
    for (dvec2 p : {b.from, b.to})
        if (lies_on(p, a)) of_a.push_back(p), meet = true;
    for (dvec2 p : {a.from, a.to})
        if (lies_on(p, b)) of_b.push_back(p), meet = true;
    dvec2 u = a.to - a.from, v = b.to - b.from;
    double turn = cross(u, v);
    if (meet || std::abs(turn) < 1e-14) return;
    double s = cross(b.from - a.from, v) / turn, t = cross(b.from - a.from, u) / turn;
    if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return;
    dvec2 p = snapped(a.from + s * u);
    of_a.push_back(p);
    of_b.push_back(p);
}

// All sides cut at every point where they meet, and how often more often each is run from `from` to `to` than back.
std::map<Side, int, Before> pieces_of(const std::vector<Side>& sides)
{
    std::vector<Contour> cuts(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j) cut(sides[i], sides[j], cuts[i], cuts[j]);
    std::map<Side, int, Before> pieces;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        Contour& points = cuts[i];
        points.push_back(sides[i].from);
        points.push_back(sides[i].to);
        dvec2 along = sides[i].to - sides[i].from;
        std::sort(points.begin(), points.end(),
                  [&](dvec2 a, dvec2 b) { return glm::dot(a, along) < glm::dot(b, along); });
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            if (points[k] == points[k + 1]) continue;
            Side piece{points[k], points[k + 1]};
            bool backwards = Before()(piece.to, piece.from);
            if (backwards) std::swap(piece.from, piece.to);
            pieces[piece] += backwards ? -1 : 1;
        }
    }
    return pieces;
}

// How often the sides wind around a point, anticlockwise counted up.
int winding(const std::map<Side, int, Before>& pieces, dvec2 p)
{
    int sum = 0;
    for (const auto& [piece, count] : pieces) {
        if ((piece.from.y > p.y) == (piece.to.y > p.y)) continue;
        bool upwards = piece.to.y > piece.from.y;
        double side = cross(piece.to - piece.from, p - piece.from);
        if (upwards ? side > 0 : side < 0) sum += upwards ? count : -count;
    }
    return sum;
}

// The pieces with something covered on one side only, turned so that it is the left one; by where they begin.
std::multimap<dvec2, dvec2, Before> borders(const std::map<Side, int, Before>& pieces)
{
    std::multimap<dvec2, dvec2, Before> found;
    for (const auto& [piece, count] : pieces) {
        if (count == 0) continue;
        dvec2 along = glm::normalize(piece.to - piece.from), left(-along.y, along.x);
        int on_left = winding(pieces, 0.5 * (piece.from + piece.to) + aside * left);
        int on_right = on_left - count;
        if ((on_left == 0) == (on_right == 0)) continue;
        if (on_left != 0) found.emplace(piece.from, piece.to);
        else found.emplace(piece.to, piece.from);
    }
    return found;
}

// Without corners in the middle of a straight line.
Contour straightened(const Contour& contour)
{
    Contour result;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        dvec2 before = result.empty() ? contour.back() : result.back(), after = contour[(i + 1) % contour.size()];
        bool turns = !lies_on(contour[i], {before, after});
        if (before == after || turns) result.push_back(contour[i]);
    }
    return result;
}

}  // namespace

std::vector<Contour> contour_union(const std::vector<Contour>& contours)
{
    auto open = borders(pieces_of(sides_of(contours)));
    std::vector<Contour> result;
    while (!open.empty()) {
        Contour contour;
        for (auto side = open.begin(); side != open.end(); side = open.find(contour.back())) {
            if (contour.empty()) contour.push_back(side->first);
            dvec2 next = side->second;
            open.erase(side);
            if (next == contour.front()) break;
            contour.push_back(next);
        }
        contour = straightened(contour);
        if (contour.size() > 2) result.push_back(std::move(contour));
    }
    return result;
}

}  // namespace fieldwright::assets

// Writing turned into few enough sides.
#include "assets/outlines.h"

#include "assets/font_file.h"
#include "assets/typesetting.h"
#include "graph/contours.h"
#include "graph/problem.h"

namespace fieldwright::assets {
namespace {

constexpr double tolerances[] = {0.001, 0.002, 0.004, 0.006, 0.01};  // em
constexpr std::size_t side_limit_before_union = 8192;  // beyond it nothing fits, and the union would take seconds

std::size_t side_count(const std::vector<Contour>& contours)
{
    std::size_t count = 0;
    for (const Contour& contour : contours) count += contour.size();
    return count;
}

graph::PointList in_one_list(const std::vector<Contour>& contours)
{
    graph::PointList points;
    for (const Contour& contour : contours)
        for (std::size_t i = 0; i < contour.size(); ++i)
            points.emplace_back(glm::vec2(contour[i]), i == 0 ? 1.0f : 0.0f, 0.0f);
    return points;
}

Outlines written_with(Typesetter& typesetter, const Writing& writing)
{
    std::size_t sides = 0;
    for (double tolerance : tolerances) {
        std::vector<Contour> contours = typesetter.set(writing, tolerance);
        sides = side_count(contours);
        if (sides > side_limit_before_union) continue;
        contours = contour_union(contours);
        sides = side_count(contours);
        if (sides <= graph::contour_side_limit) return {in_one_list(contours), tolerance, {}};
    }
    return {{},
            0,
            "the text takes " + std::to_string(sides) + " sides and at most " +
                std::to_string(graph::contour_side_limit) +
                " fit, so the saved outlines are shown; write less, or use several text nodes"};
}

}  // namespace

Outlines outlines_of(const Writing& writing, std::span<const unsigned char> built_in_font)
{
    FontFile file;
    if (!writing.font.empty()) file = find_font(writing.font);
    auto missing = [&](const std::string& reason) {
        return Outlines{{},
                        0,
                        "the font `" + writing.font + "` " + reason +
                            "; the saved outlines are shown: choose another font to edit the text"};
    };
    if (!file.error.empty()) return missing(file.error);
    try {
        Typesetter typesetter(writing.font.empty() ? built_in_font : std::span<const unsigned char>(file.bytes),
                              file.face);
        return written_with(typesetter, writing);
    } catch (const graph::Failure& failure) {
        return missing(failure.what());
    }
}

}  // namespace fieldwright::assets

// Samples fields on both machines: points, distances, slopes, and where they must agree.
#pragma once

#include "field/evaluator.h"
#include "renderer/devices.h"
#include "tests/support/random.h"

namespace fieldwright::tests {

// A program with its block at one moment.
struct Field {
    explicit Field(graph::Program from, float at = 0.6f)
        : program(std::move(from)), block(field::evaluate_frame(program, at)), time(at)
    {
    }

    std::vector<float> at(std::span<const glm::vec3> points) const { return field::distances(program, block, points); }
    float lipschitz() const
    {
        return program.lipschitz == graph::no_value ? 1.0f : std::max(1.0f, lane(program.lipschitz, 0));
    }
    float lane(graph::ValueId value, int lane) const
    {
        return block[static_cast<std::size_t>(program.values[static_cast<std::size_t>(value)].slot + lane)];
    }

    graph::Program program;
    std::vector<float> block;
    float time;
};

// Points near and far, on symmetry planes, and on borders of cells.
inline std::vector<glm::vec3> sample_points(Random& random, std::size_t count)
{
    std::vector<glm::vec3> points;
    while (points.size() < count) {
        glm::vec3 p = random.in_cube(random.chance(0.5f) ? 1.5f : 4.0f);
        if (random.chance(0.15f)) p[random.below(3)] = random.between(-1e-3f, 1e-3f);
        if (random.chance(0.15f))
            p[random.below(3)] = 0.5f * static_cast<float>(random.below(9) - 4) + random.between(-1e-3f, 1e-3f);
        points.push_back(p);
    }
    return points;
}

// Whether the text of the program's functions takes inverse sines, which Mesa approximates.
inline bool uses_inverse_sine(const graph::Program& program)
{
    for (const graph::Instruction& instruction : program.instructions) {
        if (!instruction.function) continue;
        const std::string& text = instruction.function->text;
        if (text.find("asin(") != std::string::npos || text.find("acos(") != std::string::npos) return true;
    }
    return false;
}

// The largest change over 1e-4 in six directions: where it is a jump, machines may stand on different sides.
inline std::vector<float> steepness(const Field& field, std::span<const glm::vec3> points)
{
    constexpr float step = 1e-4f;
    std::vector<float> centre = field.at(points), steepest(points.size(), 0);
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-step, step}) {
            std::vector<glm::vec3> moved(points.begin(), points.end());
            for (glm::vec3& p : moved) p[axis] += side;
            std::vector<float> there = field.at(moved);
            for (std::size_t i = 0; i < points.size(); ++i)
                steepest[i] = std::max(steepest[i], std::abs(there[i] - centre[i]) / step);
        }
    return steepest;
}

struct Agreement {
    std::size_t compared = 0, differing = 0;
    std::string worst;  // the worst difference in words
};

// GPU against CPU distances by the rule of the design (section 6).
inline Agreement compare_machines(const Field& field, std::span<const glm::vec3> points, std::span<const float> gpu)
{
    std::vector<float> cpu = field.at(points), steep = steepness(field, points);
    float base = (uses_inverse_sine(field.program) ? 5e-4f : 1e-5f) * field.lipschitz();
    Agreement agreement;
    float worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        float tolerance = base * (1 + glm::length(points[i]));
        if (steep[i] > 2.0f + tolerance / 1e-4f) continue;
        ++agreement.compared;
        float difference = std::abs(cpu[i] - gpu[i]);
        if (std::isfinite(cpu[i]) && difference <= tolerance) continue;
        ++agreement.differing;
        if (!(difference <= worst)) {
            worst = difference;
            const glm::vec3& p = points[i];
            agreement.worst = "at (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
                              "): cpu " + std::to_string(cpu[i]) + ", gpu " + std::to_string(gpu[i]) + ", allowed " +
                              std::to_string(tolerance);
        }
    }
    return agreement;
}

}  // namespace fieldwright::tests

// Every operation of formulas gives the same numbers on both machines.
#include "tests/support/fields.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

const char* const formulas[] = {
    "x * y - z / (2 + x * x) + sin(3 * x) * cos(2 * y + 1) + 1 / (0.1 + abs(z))",
    "asin(x / 2) + acos(y / 3) + atan(z) + atan2(y, x) + tan(z / 2)",
    "sqrt(x^2 + z^2) - abs(y) + sqrt(abs(z)) + min(x, y, z) * max(x, 0.5) + clamp(z, -0.5, 0.25)",
    "mix(x, y, 0.3) + floor(2 * z) + fract(y) + mod(x, 0.7) + sign(y)",
    "exp(z) - log(2.5 + y) + abs(x)^1.7 + x^5 / 10 - 2^y + (z + 3)^-2",
    "(x < y ? x : y >= z ? smoothstep(-1, 1, z) : step(0, x)) + (x != y) - -x",
};

TEST(Formulas, gpu_and_cpu_compute_the_same)
{
    renderer::GpuDevice gpu;
    Random random(8);
    std::vector<glm::vec3> points = sample_points(random, 3000);
    for (const char* formula : formulas) {
        Scene scene;
        NodeId expression = scene.node("expression", {{"formula", std::string(formula)}});
        NodeId plane = scene.node("plane", {{"height", expression}});
        scene.show(plane);
        Field field(scene.program({.root = plane}));
        std::vector<float> on_cpu = field.at(points), on_gpu = gpu.distances(field.program, field.time, points);
        int apart = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            apart += std::abs(on_cpu[i] - on_gpu[i]) <= 2e-5f * (1 + std::abs(on_cpu[i])) ? 0 : 1;
        // At a jump, the machines may stand on different sides.
        EXPECT_LE(apart, 6) << formula;
    }
}

}  // namespace
}  // namespace fieldwright::tests

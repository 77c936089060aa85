// One row of distances through the combiner's kernel.
#include "app/blend_curve.h"

#include "field/evaluator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fieldwright::app {
namespace {

using graph::Argument;
using graph::Instruction;
using Row = std::array<float, field::row_width>;

constexpr int samples = 129;
constexpr float shown = 1.6f;  // half the axis, in sizes of the blend

const graph::Parameter* smoothness_of(const graph::NodeType& type)
{
    const graph::Parameter* smoothness = type.parameter("smoothness");
    bool combines = type.category == "combine" && type.input("a") && type.input("b") && type.function("distance");
    return combines && type.compiled ? smoothness : nullptr;
}

const Instruction* call_of(const graph::Program& program, const graph::Function* function, graph::NodeId node)
{
    for (std::int32_t i = program.distance.first; i < program.distance.last; ++i) {
        const Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        if (instruction.function == function && instruction.node == node) return &instruction;
    }
    return nullptr;
}

// The combiner with its parameters, and rows for its distances.
class Combiner {
public:
    Combiner(const graph::Program& program, const Instruction& call, std::span<const float> block)
        : call_(call), kernel_(field::find_kernel(field::kernels(), call.function->name)->varying)
    {
        for (std::size_t i = 0; i < call.function->arguments.size(); ++i) {
            graph::ValueId value = arguments_of(program, call)[i];
            const graph::ProgramValue& known = program.values[static_cast<std::size_t>(value)];
            rows_.emplace_back();
            if (call.function->arguments[i].role != graph::Role::parameter) continue;
            varies_ = varies_ || known.rate == graph::Rate::point || known.lanes != 1;
            if (!varies_) rows_.back().fill(block[static_cast<std::size_t>(known.slot)]);
        }
    }

    bool varies() const { return varies_; }

    float parameter(std::string_view name) const
    {
        const auto& arguments = call_.function->arguments;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            if (arguments[i].name == name) return rows_[i][0];
        return 0;
    }

    Row of(const Row& a, const Row& b)
    {
        std::vector<const float*> pointers;
        const auto& arguments = call_.function->arguments;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            pointers.push_back(arguments[i].role == graph::Role::a   ? a.data()
                               : arguments[i].role == graph::Role::b ? b.data()
                                                                     : rows_[i].data());
        Row result{};
        kernel_(result.data(), pointers.data(), nullptr, samples);
        return result;
    }

private:
    const Instruction& call_;
    field::Kernel kernel_;
    std::vector<Row> rows_;  // by argument
    bool varies_ = false;
};

// By how much the row turns anywhere.
float bend(const Row& row)
{
    float most = 0;
    for (std::size_t i = 1; i + 1 < samples; ++i) most = std::max(most, std::abs(row[i - 1] - 2 * row[i] + row[i + 1]));
    return most;
}

}  // namespace

std::optional<ui::BlendCurve> blend_curve(const graph::Program& program, const graph::NodeType& type,
                                          graph::NodeId node, float time_s)
{
    const Instruction* call = smoothness_of(type) ? call_of(program, type.function("distance"), node) : nullptr;
    if (!call) return std::nullopt;
    Combiner combiner(program, *call, field::evaluate_frame(program, time_s));
    if (combiner.varies()) return std::nullopt;
    ui::BlendCurve curve{.size = combiner.parameter("smoothness")};
    float reach = shown * std::max(curve.size, 0.01f), step = 2 * reach / (samples - 1);
    Row half{}, other{};
    for (std::size_t i = 0; i < samples; ++i) {
        half[i] = 0.5f * (static_cast<float>(i) * step - reach);
        other[i] = -half[i];
    }
    Row result = combiner.of(half, other), of_sum = combiner.of(half, half);
    curve.of_sum = bend(result) < 0.1f * bend(of_sum);
    if (curve.of_sum) result = of_sum;
    for (std::size_t i = 0; i < samples; ++i) {
        std::size_t before = i > 0 ? i - 1 : i, after = std::min<std::size_t>(i + 1, samples - 1);
        float run = static_cast<float>(after - before) * 0.5f * step;  // of a
        curve.across.push_back(2 * half[i]);
        curve.a.push_back(half[i]);
        curve.b.push_back(other[i]);
        curve.result.push_back(result[i]);
        curve.slope.push_back((result[after] - result[before]) / run);
    }
    return curve;
}

}  // namespace fieldwright::app

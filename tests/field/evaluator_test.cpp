// The evaluator: every instruction set, blocks, frame values and the reuse of rows.
#include "field/evaluator.h"
#include "graph/edits.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstring>
#include <map>
#include <random>

namespace fieldwright::field {
namespace {

using graph::Document;
using graph::Library;
using graph::NodeId;

class Scene {
public:
    NodeId add(std::string_view type) { return graph::add_node(document, *library, type); }

    NodeId add(std::string_view type, std::initializer_list<std::pair<const char*, NodeId>> inputs)
    {
        NodeId node = add(type);
        for (const auto& [socket, source] : inputs) {
            graph::Refusal refusal = graph::connect(document, *library, source, node, socket);
            EXPECT_FALSE(refusal) << *refusal;
        }
        return node;
    }

    void set(NodeId node, const char* name, graph::Value value)
    {
        graph::Refusal refusal = graph::set_parameter(document, *library, node, name, std::move(value));
        EXPECT_FALSE(refusal) << *refusal;
    }

    std::vector<float> distances_at(const std::vector<glm::vec3>& points, float time = 0,
                                    const KernelTable& table = kernels())
    {
        graph::Program program = graph::lower(document, library);
        for (const graph::Problem& problem : program.problems) ADD_FAILURE() << problem.sentence;
        return distances(program, evaluate_frame(program, time), points, table);
    }

    std::shared_ptr<const Library> library = Library::embedded();
    Document document;
};

std::vector<glm::vec3> scattered_points(std::size_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-4, 4);
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points) point = {coordinate(random), coordinate(random), coordinate(random)};
    return points;
}

// Wires a field into what makes it the output's, whatever its inputs and dimension.
void show(Scene& scene, const graph::NodeType& type)
{
    NodeId shown = scene.add(type.name);
    for (const graph::Socket& socket : type.inputs) {
        bool flat = socket.kind == graph::SocketKind::field2d;
        if (!flat && socket.kind != graph::SocketKind::field3d && socket.kind != graph::SocketKind::field_any) continue;
        NodeId source = scene.add(flat ? "rectangle" : "box");
        EXPECT_FALSE(graph::connect(scene.document, *scene.library, source, shown, socket.name));
    }
    scene.add("output", {{"d", shown}});
}

TEST(Evaluator, EveryInstructionSetGivesTheSameBytes)
{
    int count = 0;
    const KernelTable* const* tables = runnable_kernels(count);
    std::vector<glm::vec3> points = scattered_points(4096);
    for (const graph::NodeType* type : Library::embedded()->types()) {
        if (!type->is_field() || type->category == "output") continue;
        Scene scene;
        show(scene, *type);
        std::vector<float> widest = scene.distances_at(points, 0, *tables[0]);
        for (int i = 1; i < count; ++i) {
            std::vector<float> narrower = scene.distances_at(points, 0, *tables[i]);
            EXPECT_EQ(std::memcmp(narrower.data(), widest.data(), widest.size() * sizeof(float)), 0)
                << type->name << ", " << tables[i]->instruction_set;
        }
    }
}

TEST(Evaluator, ABlockFoldsTheNearestCopy)
{
    Scene scene;
    NodeId sphere = scene.add("sphere");
    scene.set(sphere, "radius", 0.5f);
    NodeId repeat = scene.add("repeat", {{"d", sphere}});
    scene.set(repeat, "spacing", glm::vec3(2, 2, 2));
    scene.add("output", {{"d", repeat}});
    std::vector<glm::vec3> points = scattered_points(1000);
    std::vector<float> measured = scene.distances_at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        glm::vec3 nearest = points[i] - 2.0f * glm::floor(points[i] / 2.0f + 0.5f);
        EXPECT_NEAR(measured[i], glm::length(nearest) - 0.5f, 1e-5f);
    }
}

TEST(Evaluator, FrameValuesFollowTime)
{
    Scene scene;
    NodeId time = scene.add("time");
    NodeId sphere = scene.add("sphere", {{"radius", time}});
    scene.add("output", {{"d", sphere}});
    EXPECT_FLOAT_EQ(scene.distances_at({{5, 0, 0}}, 2)[0], 3);
    EXPECT_FLOAT_EQ(scene.distances_at({{5, 0, 0}}, 4)[0], 1);
}

// A wide tree whose branches stay alive while others run: any row reused too early changes the minimum.
TEST(Evaluator, RowsAreReusedOnlyWhenTheirValueIsDead)
{
    Scene scene;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-3, 3);
    std::vector<glm::vec3> centres;
    std::vector<NodeId> roots;
    for (int i = 0; i < 60; ++i) {
        centres.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        NodeId moved = scene.add("translate", {{"d", scene.add("sphere")}});
        scene.set(moved, "offset", centres.back());
        roots.push_back(moved);
    }
    while (roots.size() > 1) {
        NodeId joined = scene.add("smooth_union", {{"a", roots[0]}, {"b", roots.back()}});
        scene.set(joined, "smoothness", 0.0f);
        roots.erase(roots.begin());
        roots.back() = joined;
    }
    scene.add("output", {{"d", roots[0]}});
    std::vector<glm::vec3> points = scattered_points(777);
    std::vector<float> measured = scene.distances_at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        float nearest = 1e9f;
        for (glm::vec3 centre : centres) nearest = std::min(nearest, glm::length(points[i] - centre) - 1);
        EXPECT_NEAR(measured[i], nearest, 2e-5f);
    }
}

// The distance entry call by call: every value has rows of its own and every kernel takes rows.
class PlainEvaluation {
public:
    PlainEvaluation(const graph::Program& program, const std::vector<float>& block) : program_(program), block_(block)
    {
    }

    std::vector<float> distances(const std::vector<glm::vec3>& points)
    {
        std::vector<float>& p = rows(program_.distance.inputs[0]);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int lane = 0; lane < 3; ++lane) p[static_cast<std::size_t>(lane * row_width) + i] = points[i][lane];
        run(program_.distance.first, program_.distance.last);
        std::vector<float> result = rows(program_.distance.results[0]);
        result.resize(points.size());
        return result;
    }

private:
    std::vector<float>& rows(graph::ValueId id)
    {
        const graph::ProgramValue& value = program_.values[static_cast<std::size_t>(id)];
        auto [found, added] = rows_.try_emplace(id, static_cast<std::size_t>(value.lanes * row_width));
        if (added && value.rate != graph::Rate::point)
            for (int lane = 0; lane < value.lanes; ++lane)
                std::fill_n(found->second.begin() + lane * row_width, row_width,
                            block_[static_cast<std::size_t>(value.slot + lane)]);
        return found->second;
    }

    void run(std::int32_t first, std::int32_t last)
    {
        for (std::int32_t i = first; i < last; ++i) {
            const graph::Instruction& instruction = program_.instructions[static_cast<std::size_t>(i)];
            if (!instruction.is_block()) {
                call(instruction);
                continue;
            }
            repeat(i, instruction);
            i = instruction.body_end - 1;
        }
    }

    void repeat(std::int32_t at, const graph::Instruction& block)
    {
        auto carried = [&](int k) { return program_.carried[static_cast<std::size_t>(block.first_carried + k)]; };
        for (int k = 0; k < block.carried_count; ++k) rows(carried(k).accumulator) = rows(carried(k).initial);
        for (int copy = 0; copy < block.copies; ++copy) {
            std::fill(rows(block.copy).begin(), rows(block.copy).end(), static_cast<float>(copy));
            run(at + 1, block.body_end);
            for (int k = 0; k < block.carried_count; ++k) rows(carried(k).accumulator) = rows(carried(k).next);
        }
    }

    void call(const graph::Instruction& instruction)
    {
        std::vector<const float*> arguments;
        for (int k = 0; k < instruction.argument_count; ++k) {
            graph::ValueId id = program_.arguments[static_cast<std::size_t>(instruction.first_argument + k)];
            const graph::ProgramValue& value = program_.values[static_cast<std::size_t>(id)];
            bool list = value.type->base == graph::BaseType::list;
            arguments.push_back(list ? block_.data() + value.slot : rows(id).data());
        }
        const KernelEntry* kernel = find_kernel(kernels(), instruction.function->name);
        kernel->varying(rows(instruction.result).data(), arguments.data(), program_.list_data.data(), row_width);
    }

    const graph::Program& program_;
    const std::vector<float>& block_;
    std::map<graph::ValueId, std::vector<float>> rows_;
};

void expect_as_plainly_evaluated(const graph::Program& program)
{
    std::vector<glm::vec3> points = scattered_points(row_width);
    std::vector<float> block = evaluate_frame(program, 0.7f);
    std::vector<float> plain = PlainEvaluation(program, block).distances(points);
    EXPECT_EQ(distances(program, block, points), plain);
}

// (x, y) -> (y, x y), three times from (1, 2): a value that is carried to another is read before it changes.
TEST(Evaluator, CarriedValuesChangeTogether)
{
    using graph::Rate;
    graph::Type real{graph::BaseType::real, "float"}, integer{graph::BaseType::integer, "int"};
    graph::Program program;
    program.library = Library::embedded();
    program.block = {1, 2, 0, 0};
    auto add_value = [&](const graph::Type& type, Rate rate, int slot = -1) {
        program.values.push_back({.type = &type, .rate = rate, .slot = slot});
        return static_cast<graph::ValueId>(program.values.size() - 1);
    };
    graph::ValueId one = add_value(real, Rate::constant, 0), two = add_value(real, Rate::constant, 1);
    graph::ValueId x = add_value(real, Rate::point), y = add_value(real, Rate::point);
    graph::ValueId copy = add_value(integer, Rate::point), product = add_value(real, Rate::point);
    program.arguments = {x, y};
    program.carried = {{x, one, y}, {y, two, product}};
    program.instructions = {
        {.body_end = 2, .copies = 3, .copy = copy, .carried_count = 2},
        {.function = &program.library->support("multiply_lipschitz"), .argument_count = 2, .result = product}};
    graph::Entry entry{0, 2, {}, {x, y}};
    Evaluator evaluator(program, entry);
    Evaluator::Workspace workspace(evaluator);
    evaluator.evaluate(workspace, program.block, 5);
    EXPECT_EQ(workspace.result(0)[4], 4);
    EXPECT_EQ(workspace.result(1)[4], 8);
}

// Grows a document by nodes of any type, their inputs wired at random where the rules allow it.
Scene random_scene(unsigned seed)
{
    std::mt19937 random(seed);
    auto below = [&](std::size_t count) { return random() % count; };
    Scene scene;
    std::vector<NodeId> nodes;
    NodeId last_field;
    for (int i = 0; i < 40; ++i) {
        const graph::NodeType& type = *scene.library->types()[below(scene.library->types().size())];
        if (type.category == "output") continue;
        NodeId node = scene.add(type.name);
        for (const graph::Socket& socket : type.inputs) {
            bool field = socket.name == "d" || socket.name == "a" || socket.name == "b" || socket.name == "c";
            for (int attempt = 0; attempt < (field ? 20 : 1) && !nodes.empty(); ++attempt)
                if (!graph::connect(scene.document, *scene.library, nodes[below(nodes.size())], node, socket.name))
                    break;
        }
        if (type.is_field()) last_field = node;
        nodes.push_back(node);
    }
    scene.add("output", {{"d", last_field}});
    return scene;
}

TEST(Evaluator, RowsGiveWhatPlainEvaluationGives)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Scene scene = random_scene(seed);
        expect_as_plainly_evaluated(graph::lower(scene.document, scene.library));
    }
}

TEST(Evaluator, ManyBlocksInsideABlockCountTheirOwnCopies)
{
    Scene scene;
    NodeId joined = scene.add("sphere");
    for (int i = 0; i < 70; ++i) {
        NodeId around = scene.add("polar_repeat", {{"d", scene.add("sphere")}});
        joined = scene.add("union", {{"a", joined}, {"b", around}});
    }
    scene.add("output", {{"d", scene.add("repeat", {{"d", joined}})}});
    expect_as_plainly_evaluated(graph::lower(scene.document, scene.library));
}

// Of copies to either side along an axis that has no others, one is enough.
TEST(Evaluator, CopiesThatRepeatOthersAreLeftOut)
{
    Scene scene;
    NodeId repeat = scene.add("repeat", {{"d", scene.add("box")}});
    scene.set(repeat, "spacing", glm::vec3(2, 0, 3));
    NodeId limited = scene.add("repeat_limited", {{"d", scene.add("box")}});
    scene.set(limited, "count", glm::vec3(1, 1, 4));
    scene.add("output", {{"d", scene.add("union", {{"a", repeat}, {"b", limited}})}});
    graph::Program program = graph::lower(scene.document, scene.library);
    std::vector<float> block = evaluate_frame(program, 0), needed;
    for (int i = program.distance.first; i < program.distance.last; ++i) {
        const graph::Instruction& instruction = program.instructions[static_cast<std::size_t>(i)];
        if (!instruction.is_block()) continue;
        ASSERT_NE(instruction.needed, graph::no_value);
        int slot = program.values[static_cast<std::size_t>(instruction.needed)].slot;
        needed.push_back(block[static_cast<std::size_t>(slot)]);
    }
    EXPECT_EQ(needed, (std::vector<float>{4, 2}));
    expect_as_plainly_evaluated(program);
}

TEST(Evaluator, CopiesThatVaryFromPointToPointAreAllNeeded)
{
    Scene scene;
    NodeId repeat = scene.add("repeat", {{"d", scene.add("sphere")}, {"spacing", scene.add("position")}});
    scene.add("output", {{"d", repeat}});
    graph::Program program = graph::lower(scene.document, scene.library);
    for (const graph::Instruction& instruction : program.instructions) EXPECT_EQ(instruction.needed, graph::no_value);
    expect_as_plainly_evaluated(program);
}

// Turned by an angle in proportion to its height, (1, y, 0) shows the cosine in x and the sine in -z.
TEST(Evaluator, SinesAndCosinesAreExactUpToTenThousand)
{
    int count = 0;
    const KernelTable* const* tables = runnable_kernels(count);
    std::mt19937 random(11);
    std::vector<float> p(3 * row_width, 0), turned(3 * row_width);
    const float turn = 1;
    const float* arguments[] = {p.data(), &turn};
    for (float reach : {1.0f, 10.0f, 1e4f})
        for (int table = 0; table < count; ++table) {
            std::uniform_real_distribution<float> angle(-reach, reach);
            for (int i = 0; i < row_width; ++i) {
                p[static_cast<std::size_t>(i)] = 1;
                p[static_cast<std::size_t>(row_width + i)] = angle(random);
            }
            find_kernel(*tables[table], "twist_point")->uniform(turned.data(), arguments, nullptr, row_width);
            for (std::size_t i = 0; i < row_width; ++i) {
                double exact = p[row_width + i];
                EXPECT_NEAR(turned[i], std::cos(exact), 2e-7) << exact;
                EXPECT_NEAR(turned[2 * row_width + i], -std::sin(exact), 2e-7) << exact;
            }
        }
}

// Lists of few points have loops of their own.
TEST(Evaluator, APolylineOfAnyLengthIsTheNearestOfItsSegments)
{
    std::vector<glm::vec3> points = scattered_points(500);
    for (int length : {1, 2, 3, 7, 8, 9, 20}) {
        SCOPED_TRACE(length);
        graph::PointList corners;
        for (int i = 0; i < length; ++i) {
            auto angle = static_cast<float>(i);
            corners.emplace_back(0.1f * angle * std::cos(angle), 0.1f * angle * std::sin(angle), 0, 0);
        }
        Scene scene;
        NodeId line = scene.add("polyline");
        scene.set(line, "points", corners);
        scene.set(line, "thickness", 0.2f);
        scene.add("output", {{"d", line}});
        std::vector<float> measured = scene.distances_at(points);
        for (std::size_t k = 0; k < points.size(); ++k) {
            glm::vec2 p(points[k]);
            float nearest = glm::length(p - glm::vec2(corners[0]));
            for (std::size_t i = 1; i < corners.size(); ++i) {
                glm::vec2 start(corners[i - 1]), along = glm::vec2(corners[i]) - start;
                float share = glm::clamp(glm::dot(p - start, along) / glm::dot(along, along), 0.0f, 1.0f);
                nearest = std::min(nearest, glm::length(p - start - share * along));
            }
            EXPECT_NEAR(measured[k], nearest - 0.1f, 1e-5f);
        }
    }
}

TEST(Evaluator, AnEditedNodeIsNotRunAsTheOneBuiltIn)
{
    std::map<std::string, std::string> texts = graph::embedded_texts();
    texts["nodes/primitive/sphere.glsl"] += "\n// edited\n";
    Scene scene;
    scene.library = Library::from_texts(texts, graph::embedded_texts());
    NodeId sphere = scene.add("sphere");
    scene.add("output", {{"d", sphere}});
    graph::Program program = graph::lower(scene.document, scene.library);
    try {
        distances(program, evaluate_frame(program, 0), {{glm::vec3(1)}});
        ADD_FAILURE() << "evaluated";
    } catch (const graph::Failure& failure) {
        EXPECT_EQ(failure.exit_code, 1);
        EXPECT_NE(std::string(failure.what()).find("node " + std::to_string(sphere.number)), std::string::npos);
    }
}

}  // namespace
}  // namespace fieldwright::field

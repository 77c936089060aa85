// Walks over every node type of the library and holds it to what its file says.
#include "codegen/glsl.h"
#include "tests/support/fields.h"
#include "tests/support/glslang.h"
#include "tests/support/starter.h"

#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace fieldwright::tests {
namespace {

using graph::NodeType;
using graph::Parameter;
using graph::ParameterKind;

std::shared_ptr<const graph::Library> library() { return graph::Library::embedded(); }

std::vector<const NodeType*> field_types()
{
    std::vector<const NodeType*> types;
    for (const NodeType* type : library()->types())
        if (type->is_field()) types.push_back(type);
    return types;
}

// The subject's own field, with its bounds.
Field own_field(const Starter& starter)
{
    return Field(starter.scene.program({.bounds = true, .root = starter.subject}));
}

// Default parameters first, then random ones.
Starter variant(const NodeType& type, int number)
{
    Random random(static_cast<std::uint64_t>(number) * 977);
    return Starter(type, library(), number == 0 ? nullptr : &random);
}

bool is_sentence(const std::string& text)
{
    return text.size() > 3 && text.back() == '.' && !std::islower(static_cast<unsigned char>(text.front()));
}

TEST(LibraryWalk, has_what_an_artist_reaches_for_in_every_category)
{
    const std::map<std::string, int> wanted = {{"primitive", 50}, {"shape2d", 36}, {"convert", 8}, {"combine", 24},
                                               {"domain", 28},    {"modify", 12},  {"value", 26},  {"material", 9},
                                               {"light", 2},      {"camera", 2},   {"sky", 1},     {"output", 1}};
    std::map<std::string, int> found;
    for (const NodeType* type : library()->types()) ++found[type->category];
    for (const auto& [category, count] : wanted) EXPECT_GE(found[category], count) << category;
    EXPECT_EQ(found.size(), wanted.size());
}

TEST(LibraryWalk, documents_every_type_and_parameter)
{
    for (const NodeType* type : library()->types()) {
        SCOPED_TRACE(type->name);
        EXPECT_FALSE(type->title.empty());
        EXPECT_TRUE(is_sentence(type->help)) << type->help;
        EXPECT_FALSE(type->synonyms.empty());
        for (const Parameter& parameter : type->parameters) {
            SCOPED_TRACE(parameter.name);
            EXPECT_TRUE(is_sentence(parameter.help)) << parameter.help;
            bool choice = parameter.kind == ParameterKind::choice;
            EXPECT_GE(parameter.choices.size(), choice ? 2u : 0u);
        }
    }
}

// Two nodes that say the same of themselves cannot be told apart in a search.
TEST(LibraryWalk, describes_every_type_in_its_own_words)
{
    std::map<std::string, std::string> said;
    for (const NodeType* type : library()->types()) {
        auto [other, is_new] = said.emplace(type->help, type->name);
        EXPECT_TRUE(is_new) << type->name << " and " << other->second << ": " << type->help;
        std::set<std::string> words(type->synonyms.begin(), type->synonyms.end());
        EXPECT_EQ(words.size(), type->synonyms.size()) << type->name << " names a synonym twice";
        EXPECT_FALSE(words.contains(type->name)) << type->name << " is its own synonym";
        EXPECT_EQ(type->help.find('`'), std::string::npos) << type->name << " speaks of its code: " << type->help;
    }
}

// Words that only lengths have in their names.
TEST(LibraryWalk, says_the_unit_of_every_length)
{
    const std::set<std::string> lengths = {"radius", "height",  "width",      "thickness", "size",
                                           "offset", "spacing", "smoothness", "distance"};
    for (const NodeType* type : field_types())
        for (const Parameter& parameter : type->parameters)
            EXPECT_TRUE(!lengths.contains(parameter.name) || parameter.unit == "m")
                << type->name << "." << parameter.name;
}

TEST(LibraryWalk, compiles_every_function_for_every_instruction_set)
{
    int count = 0;
    const field::KernelTable* const* tables = field::runnable_kernels(count);
    ASSERT_GE(count, 1);
    for (const NodeType* type : library()->types()) {
        EXPECT_TRUE(type->compiled) << type->name;
        for (const char* suffix :
             {"distance", "point", "point_a", "point_b", "point_c", "cell", "blend", "blend_c", "shows_b", "bounds",
              "lipschitz", "stretch", "value", "material", "light", "ray", "sky"}) {
            const graph::Function* function = type->function(suffix);
            if (!function || (type->category == "output" && std::string_view(suffix) == "distance")) continue;
            for (int i = 0; i < count; ++i)
                EXPECT_NE(field::find_kernel(*tables[i], function->name), nullptr)
                    << function->name << " " << tables[i]->instruction_set;
        }
    }
}

// A row for every argument that `_blend` and `_shows_b` may take, on a coarse grid now and then: ties count.
std::map<std::string, std::vector<float>> combiner_rows(const NodeType& type, Random& random)
{
    std::map<std::string, std::vector<float>> rows;
    auto fill = [&](const std::string& name, const auto& number) {
        for (int i = 0; i < field::row_width; ++i) rows[name].push_back(number());
    };
    for (const char* side : {"a", "b"})
        fill(side, [&] {
            return random.chance(0.5f) ? random.between(-1, 1) : 0.25f * static_cast<float>(random.below(9) - 4);
        });
    for (const Parameter& parameter : type.parameters)
        fill(parameter.name, [&] {
            if (parameter.kind == ParameterKind::choice)
                return static_cast<float>(random.below(static_cast<int>(parameter.choices.size())));
            if (const int* whole = std::get_if<int>(&parameter.initial)) return static_cast<float>(*whole);
            return random_component(random, parameter, std::get<float>(parameter.initial));
        });
    return rows;
}

std::vector<float> called(const graph::Function& function, const std::map<std::string, std::vector<float>>& rows)
{
    std::vector<const float*> arguments;
    for (const graph::Argument& argument : function.arguments) arguments.push_back(rows.at(argument.name).data());
    std::vector<float> result(field::row_width);
    field::find_kernel(field::kernels(), function.name)
        ->varying(result.data(), arguments.data(), nullptr, field::row_width);
    return result;
}

TEST(LibraryWalk, shows_the_id_of_b_where_at_least_half_of_its_material_shows)
{
    int walked = 0;
    for (const NodeType* type : library()->types()) {
        const graph::Function *shows = type->function("shows_b"), *blend = type->function("blend");
        if (!shows) continue;
        ASSERT_TRUE(blend) << type->name;
        ++walked;
        for (std::uint64_t round = 0; round < 40; ++round) {
            Random random(round);
            auto rows = combiner_rows(*type, random);
            std::vector<float> weights = called(*blend, rows), flags = called(*shows, rows);
            for (std::size_t i = 0; i < weights.size(); ++i)
                ASSERT_EQ(flags[i] > 0.5f, weights[i] >= 0.5f)
                    << type->name << " a " << rows.at("a")[i] << " b " << rows.at("b")[i] << " blend " << weights[i];
        }
    }
    EXPECT_GE(walked, 6);
}

TEST(LibraryWalk, every_type_draws_alike_on_both_devices)
{
    renderer::GpuDevice gpu;
    renderer::FrameRequest request{.width = 32, .height = 32, .time = 0.6f};
    for (const NodeType* type : library()->types()) {
        graph::Program program = Starter(*type, library()).scene.program();
        for (const graph::Problem& problem : program.problems)
            EXPECT_EQ(problem.severity, graph::Problem::Severity::note) << type->name << ": " << problem.sentence;
        renderer::Frame on_gpu = gpu.render(program, request), on_cpu = renderer::render_on_cpu(program, request);
        int apart = 0;
        for (std::size_t i = 0; i < on_gpu.colour.size(); ++i)
            apart += glm::length(on_gpu.colour[i] - on_cpu.colour[i]) <= 0.02f ? 0 : 1;
        EXPECT_LE(apart, 5) << type->name;
        EXPECT_GT(std::count_if(on_cpu.node_id.begin(), on_cpu.node_id.end(), [](int id) { return id > 0; }), 0)
            << type->name;
    }
}

TEST(LibraryWalk, gpu_and_cpu_agree_at_4096_points)
{
    renderer::GpuDevice gpu;
    for (const NodeType* type : field_types())
        for (int number = 0; number < 2; ++number) {
            Field field = own_field(variant(*type, number));
            Random random(11);
            std::vector<glm::vec3> points = sample_points(random, 4096);
            Agreement agreement = compare_machines(field, points, gpu.distances(field.program, field.time, points));
            EXPECT_EQ(agreement.differing, 0u) << type->name << " " << number << " " << agreement.worst;
            EXPECT_GE(agreement.compared, 3500u) << type->name << " " << number;
        }
}

TEST(LibraryWalk, instruction_sets_agree_to_the_bit)
{
    int count = 0;
    const field::KernelTable* const* tables = field::runnable_kernels(count);
    for (const NodeType* type : field_types()) {
        Field field = own_field(variant(*type, 1));
        Random random(12);
        std::vector<glm::vec3> points = sample_points(random, 1000);
        std::vector<float> widest = field::distances(field.program, field.block, points, *tables[0]);
        for (int i = 1; i < count; ++i)
            EXPECT_EQ(widest, field::distances(field.program, field.block, points, *tables[i]))
                << type->name << " " << tables[i]->instruction_set;
    }
}

// Pairs of points 1e-3 to 1e-1 apart and the steepest change between them, beyond what single precision blurs.
struct Slope {
    float steepest = 0;
    std::string where;
};

Slope steepest_slope(const Field& field, bool outside_only, Random& random)
{
    constexpr std::size_t pairs = 6000;
    std::vector<glm::vec3> from = sample_points(random, pairs), to;
    for (const glm::vec3& p : from) to.push_back(p + random.direction() * std::pow(10.0f, random.between(-3, -1)));
    std::vector<float> there = field.at(from), here = field.at(to);
    Slope slope;
    for (std::size_t i = 0; i < pairs; ++i) {
        if (outside_only && (there[i] < 0 || here[i] < 0)) continue;
        float apart = glm::distance(from[i], to[i]);
        float blur = 4e-6f * (1 + glm::length(from[i]) + std::abs(there[i]));
        float steep = (std::abs(there[i] - here[i]) - blur) / apart;
        if (steep <= slope.steepest) continue;
        const glm::vec3 &p = from[i], &q = to[i];
        slope.steepest = steep;
        slope.where = "from (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ") " +
                      std::to_string(there[i]) + " to (" + std::to_string(q.x) + ", " + std::to_string(q.y) + ", " +
                      std::to_string(q.z) + ") " + std::to_string(here[i]);
    }
    return slope;
}

TEST(LibraryWalk, no_field_is_steeper_than_its_file_says)
{
    for (const NodeType* type : field_types())
        for (int number = 0; number < 25; ++number) {
            if (type->quality_outside == graph::Quality::approximate) continue;  // marched finely instead, below
            Starter starter = variant(*type, number);
            Random random(static_cast<std::uint64_t>(number) + 5);
            bool outside_only = type->quality_inside == graph::Quality::approximate;
            Slope slope = steepest_slope(own_field(starter), outside_only, random);
            EXPECT_LE(slope.steepest, 1.0001f) << type->name << " variant " << number << " " << slope.where;
        }
}

// How far rays from all sides get before the field is below the tolerance, in steps of that share of the distance;
// infinite for those that pass.
std::vector<float> marched(const Field& field, const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& along,
                           float share)
{
    constexpr float tolerance = 1e-3f, end = 8;
    std::vector<float> t(from.size(), 0), reached(from.size(), std::numeric_limits<float>::infinity());
    std::vector<std::size_t> going(from.size());
    std::iota(going.begin(), going.end(), std::size_t{0});
    for (int step = 0; step < 20000 && !going.empty(); ++step) {
        std::vector<glm::vec3> points;
        for (std::size_t ray : going) points.push_back(from[ray] + t[ray] * along[ray]);
        std::vector<float> distances = field.at(points);
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < going.size(); ++i) {
            std::size_t ray = going[i];
            if (distances[i] < tolerance) reached[ray] = t[ray];
            else if ((t[ray] += share * distances[i]) < end) left.push_back(ray);
        }
        going = left;
    }
    return reached;
}

TEST(LibraryWalk, rays_stop_at_approximate_fields_where_sixteenths_of_their_steps_do)
{
    int walked = 0;
    for (const NodeType* type : field_types()) {
        if (type->quality_outside != graph::Quality::approximate) continue;
        ++walked;
        for (int number = 0; number < 3; ++number) {
            Field field = own_field(variant(*type, number));
            Random random(static_cast<std::uint64_t>(number) + 31);
            std::vector<glm::vec3> from, along;
            for (int ray = 0; ray < 500; ++ray) {
                from.push_back(4.0f * random.direction());
                along.push_back(glm::normalize(random.in_cube(0.6f) - from.back()));
            }
            std::vector<float> reached = marched(field, from, along, 1),
                               finely = marched(field, from, along, 1 / 16.0f);
            int apart = 0, hits = 0;
            for (std::size_t ray = 0; ray < from.size(); ++ray) {
                bool both_pass = std::isinf(reached[ray]) && std::isinf(finely[ray]);
                apart += both_pass || std::abs(reached[ray] - finely[ray]) < 0.02f ? 0 : 1;
                hits += std::isinf(finely[ray]) ? 0 : 1;
            }
            EXPECT_LE(apart, 10) << type->name << " variant " << number << ", " << hits << " rays stop";
            EXPECT_GT(hits, number == 0 ? 100 : 0) << type->name << " variant " << number;
        }
    }
    EXPECT_GE(walked, 3);
}

TEST(LibraryWalk, bounds_contain_the_surface)
{
    for (const NodeType* type : field_types())
        for (int number = 0; number < 25; ++number) {
            Field field = own_field(variant(*type, number));
            ASSERT_NE(field.program.bounds, graph::no_value) << type->name;
            glm::vec3 centre, half;
            for (int axis = 0; axis < 3; ++axis) {
                centre[axis] = field.lane(field.program.bounds, axis);
                half[axis] = field.lane(field.program.bounds, 3 + axis);
            }
            Random random(static_cast<std::uint64_t>(number) + 77);
            std::vector<glm::vec3> outside;
            bool plane = type->output == graph::SocketKind::field2d;
            for (int i = 0; i < 4000; ++i) {
                glm::vec3 p = centre + (glm::min(half, glm::vec3(4)) + 0.5f) * random.in_cube(1);
                if (plane) p.z = 0;
                glm::vec3 beyond = glm::abs(p - centre) - half;
                if (std::max(beyond.x, std::max(beyond.y, beyond.z)) > 1e-3f) outside.push_back(p);
            }
            std::vector<float> distances = field.at(outside);
            for (std::size_t i = 0; i < outside.size(); ++i)
                ASSERT_GT(distances[i], 0)
                    << type->name << " variant " << number << " at " << outside[i].x << " " << outside[i].y << " "
                    << outside[i].z << " box " << centre.x << " " << centre.y << " " << centre.z << " half " << half.x
                    << " " << half.y << " " << half.z;
        }
}

}  // namespace
}  // namespace fieldwright::tests

// The generated shader against one of the same scene as written by hand: seconds until it is ready, seconds per frame.
// Twice: both with node ids, and both without.
#include "codegen/glsl.h"
#include "codegen/scene_printer.h"
#include "field/evaluator.h"
#include "renderer/gl_handles.h"
#include "renderer/headless_context.h"
#include "tests/bench/csg_scene.h"
#include "tests/bench/timing.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fieldwright::bench {
namespace {

constexpr int width = 512, height = 288;  // px
constexpr int attachments = 3;
constexpr int primitives = 100;

std::string number(float value)
{
    std::string text;
    codegen::append_float(text, value);
    text.pop_back();  // the suffix: nobody writes it by hand
    return text;
}

std::string vector(glm::vec3 v) { return "vec3(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")"; }

std::string shape_text(const Placed& placed)
{
    std::string at = "p - " + vector(placed.centre) + ", ";
    switch (placed.shape) {
        case Shape::sphere: return "sdSphere(" + at + number(placed.half_size.x) + ")";
        case Shape::rounded_box:
            return "sdRoundBox(" + at + vector(placed.half_size) + ", " + number(placed.rounding) + ")";
        case Shape::cylinder: break;
    }
    return "sdCappedCylinder(" + at + number(placed.half_size.x) + ", " + number(placed.half_size.y) + ")";
}

std::string combination_text(const Combination& combination, const std::string& a, const std::string& b)
{
    switch (combination.combiner) {
        case Combiner::unite: return "opUnion(" + a + ", " + b + ")";
        case Combiner::smooth_unite:
            return "opSmoothUnion(" + a + ", " + b + ", " + number(combination.smoothness) + ")";
        case Combiner::subtract: break;
    }
    return "opSubtraction(" + a + ", " + b + ")";
}

// Appends the lines that compute an operand; the name of its distance.
std::string write_operand(std::string& lines, const CsgScene& scene, int operand)
{
    auto shapes = static_cast<int>(scene.shapes.size());
    std::string name = "d" + std::to_string(operand), value;
    if (operand < shapes) {
        std::string id = std::to_string(shape_node_id(operand)) + ".0";
        value = "SHAPE(" + shape_text(scene.shapes[static_cast<std::size_t>(operand)]) + ", " + id + ")";
    } else {
        const Combination& combination = scene.combinations[static_cast<std::size_t>(operand - shapes)];
        std::string a = write_operand(lines, scene, combination.a);
        value = combination_text(combination, a, write_operand(lines, scene, combination.b));
    }
    lines += "    Found " + name + " = " + value + ";\n";
    return name;
}

std::string map_text(const CsgScene& scene)
{
    std::string lines;
    std::string root =
        write_operand(lines, scene, static_cast<int>(scene.shapes.size() + scene.combinations.size()) - 1);
    return "Found map(vec3 p)\n{\n" + lines + "    return " + root + ";\n}\n";
}

template <typename T>
T setting(const graph::Document& document, std::string_view type, std::string_view name)
{
    for (const graph::Node& node : document.root.nodes)
        if (node.type == type) return std::get<T>(*node.parameter(name));
    throw graph::Failure(1, "the benchmark's scene has no " + std::string(type));
}

std::string surroundings_text(const graph::Document& document)
{
    auto colour = [&](const char* type, const char* name) { return setting<glm::vec3>(document, type, name); };
    auto angle_rad = [&](const char* type, const char* name) {
        return glm::radians(setting<float>(document, type, name));
    };
    auto constant = [](const char* name, glm::vec3 v) {
        return std::string("const vec3 ") + name + " = " + vector(v) + ";\n";
    };
    float elevation = angle_rad("sun", "elevation"), azimuth = angle_rad("sun", "azimuth");
    glm::vec3 sun(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                  std::cos(elevation) * std::cos(azimuth));
    float strength = setting<float>(document, "gradient", "strength");
    return constant("EYE", colour("perspective", "position")) + constant("TARGET", colour("perspective", "target")) +
           "const float SLOPE = " + number(std::tan(0.5f * angle_rad("perspective", "field_of_view"))) + ";\n" +
           constant("SUN", sun) +
           constant("SUN_COLOUR", colour("sun", "colour") * setting<float>(document, "sun", "intensity")) +
           constant("ZENITH", strength * colour("gradient", "zenith")) +
           constant("HORIZON", strength * colour("gradient", "horizon")) +
           constant("GROUND", strength * colour("gradient", "ground"));
}

std::string hand_written_shader(const CsgScene& scene, const graph::Document& document, bool with_ids)
{
    std::ifstream file(FIELDWRIGHT_SOURCE_DIR "/tests/bench/shadertoy_style.glsl");
    std::string text(std::istreambuf_iterator<char>(file), {});
    std::string_view mark = "// SCENE\n";
    std::size_t place = text.find(mark);
    if (place == std::string::npos)
        throw graph::Failure(1, "tests/bench/shadertoy_style.glsl is missing or has no SCENE line");
    text.replace(place, mark.size(), surroundings_text(document) + "\n" + map_text(scene));
    return std::string("#version 330\n#define WITH_IDS ") + (with_ids ? "1\n" : "0\n") + text;
}

// Both shaders are drawn in the same way, whole, into the same target.
class Canvas {
public:
    Canvas() : target_(width, height, attachments)
    {
        glBindVertexArray(vertices_.name());
        glEnable(GL_SCISSOR_TEST);
        target_.bind();
    }

    // What a shader does not declare, it does not need.
    void set_uniforms(const renderer::Shader& shader, const graph::Program& program) const
    {
        shader.use();
        glUniform2f(shader.uniform("resolution"), width, height);
        shader.set("march.step_limit", program.march.step_limit);
        shader.set("march.minimum_step", program.march.minimum_step);
        shader.set("march.tolerance", program.march.tolerance);
        shader.set("march.near_limit", program.march.near);
        shader.set("march.far_limit", program.march.far);
        shader.set("march.out_of_steps_hits", program.march.out_of_steps_hits ? 1 : 0);
        shader.set("march.step_scale", graph::step_scale(program.march));
        shader.set("march.normal_step", program.march.normal_step);
        shader.set("march.occlusion_samples", program.occlusion.samples);
        shader.set("march.occlusion_strength", program.occlusion.strength);
        shader.set("march.occlusion_radius", program.occlusion.radius);
        shader.set("step_budget", program.step_budget);
        shader.set("ray_count", 2);
        shader.set("convergence", 5.0f);
    }

    void draw(int columns, int rows) const
    {
        glScissor(0, 0, columns, rows);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glFinish();
    }

    // From text to the first pixel: software GL compiles at the first draw.
    double ready_seconds(const std::string& text, const graph::Program& program) const
    {
        return measured([&] {
            renderer::Shader shader(text);
            set_uniforms(shader, program);
            draw(1, 1);
        });
    }

    double frame_seconds(const renderer::Shader& shader) const
    {
        shader.use();
        return measured([&] { draw(width, height); });
    }

    std::vector<glm::vec4> texels(const renderer::Shader& shader, int attachment) const
    {
        shader.use();
        draw(width, height);
        std::vector<glm::vec4> result(static_cast<std::size_t>(width) * height);
        target_.read(attachment, &result[0].x);
        return result;
    }

    bool software() const { return renderer_name().find("llvmpipe") != std::string_view::npos; }
    std::string_view renderer_name() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

private:
    // Software GL works on this process's threads, so their time is taken: the clock on the wall counts others' work.
    template <typename Work>
    double measured(const Work& work) const
    {
        return software() ? processor_seconds_of(CLOCK_PROCESS_CPUTIME_ID, work) : seconds_of(work);
    }

    renderer::HeadlessContext context_;
    renderer::VertexArray vertices_;
    renderer::FloatTarget target_;
};

float srgb_byte(float linear)
{
    float c = std::clamp(linear, 0.0f, 1.0f);
    return 255.0f * (c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f);
}

// Share of pixels that are at most 2/255 apart, as shown on a screen.
double equal_share(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b)
{
    std::size_t equal = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        float apart = 0;
        for (int channel = 0; channel < 3; ++channel)
            apart = std::max(apart, std::abs(srgb_byte(a[i][channel]) - srgb_byte(b[i][channel])));
        equal += apart <= 2.0f;
    }
    return static_cast<double>(equal) / static_cast<double>(a.size());
}

// Share of pixels whose node ids are equal: the generated shader's stand in y, the other's in w.
double equal_ids(const std::vector<glm::vec4>& generated, const std::vector<glm::vec4>& hand)
{
    std::size_t equal = 0;
    for (std::size_t i = 0; i < hand.size(); ++i) equal += generated[i].y == hand[i].w;
    return static_cast<double>(equal) / static_cast<double>(hand.size());
}

// A black picture equals every other black one.
bool shows_something(const std::vector<glm::vec4>& colours)
{
    auto same = std::count(colours.begin(), colours.end(), colours[0]);
    return same < static_cast<std::ptrdiff_t>(colours.size() / 2);
}

void compare_pictures(const Canvas& canvas, const renderer::Shader& generated, const renderer::Shader& hand,
                      bool with_ids)
{
    std::vector<glm::vec4> ours = canvas.texels(generated, 0), theirs = canvas.texels(hand, 0);
    double colours = equal_share(ours, theirs);
    std::printf("equal within 2/255: %.3f %% of pixels", 100 * colours);
    demand(shows_something(ours) && colours >= 0.999, "pictures of the generated and the hand-written shader");
    if (with_ids) {
        double ids = equal_ids(canvas.texels(generated, 1), theirs);
        std::printf("; equal node ids: %.3f %%", 100 * ids);
        demand(ids >= 0.999, "node ids of the generated and the hand-written shader");
    }
    std::printf("\n");
}

void print_ratio(const char* what, const std::pair<Times, Times>& times, double limit)
{
    const auto& [ours, theirs] = times;
    double ratio = ours.minimum / theirs.minimum, median_ratio = ours.median / theirs.median;
    std::printf(
        "  %-6s generated %7.1f ms (median %7.1f)   by hand %7.1f ms (median %7.1f)   %.2fx, median %.2fx (<= %.1fx): "
        "%s\n",
        what, 1e3 * ours.minimum, 1e3 * ours.median, 1e3 * theirs.minimum, 1e3 * theirs.median, ratio, median_ratio,
        limit, verdict(std::max(ratio, median_ratio) <= limit));
}

struct Rivals {
    const char* title;
    graph::Program program;
    std::string generated, by_hand;
    bool with_ids;
};

Rivals rivals(const char* title, const CsgScene& scene, bool with_ids)
{
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    graph::Document document = csg_document(scene, library);
    graph::LowerOptions options;
    options.ids = with_ids;
    graph::Program program = graph::lower(document, library, options);
    demand(program.problems.empty(), "the scene lowers without problems");
    std::vector<float> block = field::evaluate_frame(program, 0);
    std::string generated = codegen::print_fragment_shader(program, block, codegen::Placement::literals);
    return {title, std::move(program), std::move(generated), hand_written_shader(scene, document, with_ids), with_ids};
}

void compare(const Canvas& canvas, const Rivals& rivals)
{
    std::printf("%s: ", rivals.title);
    const graph::Program& program = rivals.program;
    renderer::Shader generated(rivals.generated), hand(rivals.by_hand);
    canvas.set_uniforms(generated, program);
    canvas.set_uniforms(hand, program);
    compare_pictures(canvas, generated, hand, rivals.with_ids);
    print_ratio("ready",
                interleaved([&] { return canvas.ready_seconds(rivals.generated, program); },
                            [&] { return canvas.ready_seconds(rivals.by_hand, program); }),
                0.6);
    print_ratio(
        "frame",
        interleaved([&] { return canvas.frame_seconds(generated); }, [&] { return canvas.frame_seconds(hand); }), 1.1);
}

void run()
{
    CsgScene scene = csg_scene(primitives);
    Canvas canvas;
    std::printf("csg(%d), %dx%d, %s\n", primitives, width, height, canvas.renderer_name().data());
    compare(canvas, rivals("colour and node ids", scene, true));
    compare(canvas, rivals("colour without ids", scene, false));
}

}  // namespace
}  // namespace fieldwright::bench

int main() { return fieldwright::bench::run_benchmark(fieldwright::bench::run); }

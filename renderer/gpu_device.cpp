// Draws a program's fragment shader in strips and reads the buffers back.
#include "renderer/devices.h"

#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "renderer/gl_handles.h"
#include "renderer/headless_context.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace fieldwright::renderer {
namespace {

constexpr double strip_seconds = 0.015;  // aimed at; a longer draw makes other programs on the GPU stutter
constexpr int smallest_strip = 4;        // px; software GL shades 4x4 pixels at once
constexpr int points_across = 256;       // distances per row of the target, and rows per draw
constexpr int list_unit = 0, points_unit = 1;

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool is_software(const std::string& name)
{
    for (const char* known : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (name.find(known) != std::string::npos) return true;
    return false;
}

// Shader that was linked last, and from what; linking again needs another text.
struct CachedShader {
    std::string text;
    std::optional<Shader> shader;

    // Whether it was linked anew.
    bool update(std::string new_text)
    {
        if (shader && text == new_text) return false;
        shader.reset();
        shader.emplace(new_text);
        text = std::move(new_text);
        return true;
    }
};

void draw_rows(int width, int first, int count)
{
    glScissor(0, first, width, count);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

void draw_in_strips(int width, int height, const Progress& progress)
{
    int rows = 16;
    for (int y = 0; y < height;) {
        int count = std::min(rows, height - y);
        auto start = std::chrono::steady_clock::now();
        draw_rows(width, y, count);
        double growth = std::clamp(strip_seconds / std::max(seconds_since(start), 1e-5), 0.25, 4.0);
        rows = std::clamp(static_cast<int>(rows * growth), smallest_strip, height + smallest_strip);
        y += count;
        if (progress) progress(static_cast<float>(y) / static_cast<float>(height));
    }
}

void set_march(const Shader& shader, const graph::Program& program)
{
    shader.set("march.step_limit", program.march.step_limit);
    shader.set("march.minimum_step", program.march.minimum_step);
    shader.set("march.tolerance", program.march.tolerance);
    shader.set("march.near_limit", program.march.near);
    shader.set("march.far_limit", program.march.far);
    shader.set("march.out_of_steps_hits", program.march.out_of_steps_hits ? 1 : 0);
    shader.set("march.occlusion_strength", program.occlusion.strength);
    shader.set("march.occlusion_radius", program.occlusion.radius);
    shader.set("step_budget", program.step_budget);
    shader.set("ray_count", 1 + shadow_count(program));
}

void set_view(const Shader& shader, const FrameRequest& request)
{
    glUniform2f(shader.uniform("resolution"), static_cast<float>(request.width), static_cast<float>(request.height));
    shader.set("eye", eye_side(request.eye));
    shader.set("interaxial", request.interaxial);
    shader.set("convergence", request.convergence);
}

// A driver that reset the GPU leaves pixels that mean nothing.
void require_context()
{
    bool can_tell = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness") ||
                    epoxy_has_gl_extension("GL_ARB_robustness");
    if ((can_tell && glGetGraphicsResetStatus() != GL_NO_ERROR) || glGetError() == GL_OUT_OF_MEMORY)
        throw graph::Failure(
            1, "the GPU gave up while drawing this scene; use a simpler scene, a smaller --size or --device cpu");
}

// Reads one attachment; visit(pixel of the frame, vec4). GL rows are bottom-up, the frame's top-down.
template <typename Visit>
void read_flipped(const FloatTarget& target, int attachment, std::vector<glm::vec4>& scratch, Visit visit)
{
    auto width = static_cast<std::size_t>(target.width()), height = static_cast<std::size_t>(target.height());
    scratch.resize(width * height);
    target.read(attachment, &scratch[0].x);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) visit(y * width + x, scratch[(height - 1 - y) * width + x]);
}

Frame read_frame(const FloatTarget& target)
{
    Frame frame(target.width(), target.height());
    std::vector<glm::vec4> scratch;
    read_flipped(target, 0, scratch, [&](std::size_t i, const glm::vec4& texel) {
        frame.colour[i] = glm::vec3(texel);
        frame.exhausted[i] = texel.w > 0.5f;
    });
    read_flipped(target, 1, scratch, [&](std::size_t i, const glm::vec4& texel) {
        frame.depth[i] = texel.x < 0 ? std::numeric_limits<float>::infinity() : texel.x;
        frame.node_id[i] = static_cast<int>(texel.y);
        frame.material_id[i] = static_cast<int>(texel.z);
        frame.steps[i] = static_cast<int>(texel.w);
    });
    read_flipped(target, 2, scratch,
                 [&](std::size_t i, const glm::vec4& texel) { frame.normal[i] = glm::vec3(texel); });
    return frame;
}

}  // namespace

struct GpuDevice::State {
    HeadlessContext context;  // first: the objects below die while it lives
    std::string name;
    VertexArray vertices;
    Buffer block;
    FloatTexture lists, points;
    CachedShader picture, distances;
    std::optional<FloatTarget> target;
    int links = 0;

    State();
    codegen::Placement placement(std::span<const float> values) const;
    void upload(const Shader& shader, const graph::Program& program, std::span<const float> values);
    void size_target(int width, int height);
};

GpuDevice::State::State()
{
    if (epoxy_gl_version() < 33) throw graph::Failure(4, "the graphics driver offers no OpenGL 3.3; use --device cpu");
    name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    glBindVertexArray(vertices.name());
    glEnable(GL_SCISSOR_TEST);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
}

// A buffer keeps the text while values change, but software GL reads literals several times faster.
codegen::Placement GpuDevice::State::placement(std::span<const float> values) const
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &limit);
    bool fits = values.size_bytes() <= static_cast<std::size_t>(limit);
    return is_software(name) || !fits ? codegen::Placement::literals : codegen::Placement::buffer;
}

void GpuDevice::State::upload(const Shader& shader, const graph::Program& program, std::span<const float> values)
{
    shader.use();
    if (GLuint index = glGetUniformBlockIndex(shader.name(), "Parameters"); index != GL_INVALID_INDEX) {
        glBindBuffer(GL_UNIFORM_BUFFER, block.name());
        glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_DYNAMIC_DRAW);
        glUniformBlockBinding(shader.name(), index, 0);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.name());
    }
    const glm::vec4 none(0);
    bool empty = program.list_data.empty();
    lists.bind(list_unit);
    lists.upload(empty ? &none.x : &program.list_data[0].x, empty ? 1 : program.list_data.size());
    shader.set("list_texture", list_unit);
}

void GpuDevice::State::size_target(int width, int height)
{
    if (!target || target->width() != width || target->height() != height) {
        target.reset();
        target.emplace(width, height, 3);
    }
    target->bind();
}

GpuDevice::GpuDevice() : state_(std::make_unique<State>()) {}
GpuDevice::GpuDevice(GpuDevice&&) noexcept = default;

GpuDevice::~GpuDevice()
{
    if (!state_) return;
    try {
        state_->context.make_current();
    } catch (const graph::Failure&) {  // the driver is gone, and its objects with it
    }
}

std::string GpuDevice::renderer_name() const { return state_->name; }
bool GpuDevice::software() const { return is_software(state_->name); }
int GpuDevice::links() const { return state_->links; }

Frame GpuDevice::render(const graph::Program& program, const FrameRequest& request, const Progress& progress)
{
    state_->context.make_current();
    std::vector<float> values = field::evaluate_frame(program, request.time);
    bool linked = state_->picture.update(codegen::print_fragment_shader(program, values, state_->placement(values)));
    state_->links += linked ? 1 : 0;
    const Shader& shader = *state_->picture.shader;
    state_->upload(shader, program, values);
    set_march(shader, program);
    set_view(shader, request);
    state_->size_target(request.width, request.height);
    if (linked) draw_rows(1, 0, 1);  // drivers finish compiling at the first draw, which must not size the strips
    draw_in_strips(request.width, request.height, progress);
    Frame frame = read_frame(*state_->target);
    require_context();
    return frame;
}

std::vector<float> GpuDevice::distances(const graph::Program& program, float time, const std::vector<glm::vec3>& points)
{
    state_->context.make_current();
    std::vector<float> values = field::evaluate_frame(program, time);
    state_->links +=
        state_->distances.update(codegen::print_distance_shader(program, values, state_->placement(values)));
    const Shader& shader = *state_->distances.shader;
    state_->upload(shader, program, values);
    shader.set("points", points_unit);
    shader.set("points_per_row", points_across);
    state_->size_target(points_across, points_across);

    constexpr std::size_t batch = points_across * points_across;
    std::vector<glm::vec4> texels(batch);
    std::vector<float> result;
    for (std::size_t first = 0; first < points.size(); first += batch) {
        std::size_t count = std::min(batch, points.size() - first);
        for (std::size_t i = 0; i < count; ++i) texels[i] = glm::vec4(points[first + i], 0);
        state_->points.bind(points_unit);  // uploading binds to the active unit: make it this one
        state_->points.upload(&texels[0].x, batch);
        draw_rows(points_across, 0, static_cast<int>((count + points_across - 1) / points_across));
        std::vector<glm::vec4> drawn(batch);
        state_->target->read(0, &drawn[0].x);
        for (std::size_t i = 0; i < count; ++i) result.push_back(drawn[i].x);
    }
    require_context();
    return result;
}

double GpuDevice::ready_seconds(const std::string& fragment_shader)
{
    constexpr int size = 64;
    state_->context.make_current();
    state_->size_target(size, size);
    auto start = std::chrono::steady_clock::now();
    Shader shader(fragment_shader);
    shader.use();
    glUniform2f(shader.uniform("resolution"), size, size);
    draw_rows(1, 0, 1);
    glm::vec4 pixel;
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &pixel.x);
    return seconds_since(start);
}

}  // namespace fieldwright::renderer

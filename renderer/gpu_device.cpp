// Draws a program's fragment shader in strips and reads the buffers back.
#include "renderer/devices.h"

#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "renderer/gl_handles.h"
#include "renderer/headless_context.h"
#include "renderer/slice_tile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <list>
#include <optional>

namespace fieldwright::renderer {
namespace {

constexpr double strip_seconds = 0.015;  // aimed at; a longer draw makes other programs on the GPU stutter
constexpr int smallest_strip = 4;        // px; software GL shades 4x4 pixels at once
constexpr int points_across = 256;       // distances per row of the target, and rows per draw
constexpr int slice_band = 128;          // px
constexpr int list_unit = 0, points_unit = 1;
constexpr int plain_attachments = 3, layer_attachments = 8;  // outputs of shaders/gpu/main.glsl

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

// The shaders used last and their texts, the newest first: undo and redo of an edit link nothing.
class ShaderCache {
public:
    // Null when the text is not linked.
    const Shader* find(const std::string& text) const
    {
        auto known = at(text);
        return known == linked_.end() ? nullptr : &known->second;
    }

    const Shader& use(const std::string& text)
    {
        auto known = at(text);
        if (known == linked_.end()) {
            linked_.emplace_front(text, Shader(text));
            ++links_;
        } else {
            linked_.splice(linked_.begin(), linked_, known);
        }
        if (linked_.size() > capacity) linked_.pop_back();
        return linked_.front().second;
    }

    int links() const { return links_; }

private:
    static constexpr std::size_t capacity = 8;
    using Linked = std::list<std::pair<std::string, Shader>>;

    Linked::const_iterator at(const std::string& text) const
    {
        return std::find_if(linked_.begin(), linked_.end(), [&](const auto& entry) { return entry.first == text; });
    }

    Linked linked_;
    int links_ = 0;
};

void draw_rows(int width, int first, int count)
{
    glScissor(0, first, width, count);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

// From the top; `drawn` hears of each strip, and false from it stops the drawing.
template <typename Drawn>
bool draw_in_strips(int width, int height, const Drawn& drawn)
{
    int rows = 16;
    for (int y = 0; y < height;) {
        int count = std::min(rows, height - y);
        auto start = std::chrono::steady_clock::now();
        draw_rows(width, height - y - count, count);
        double growth = std::clamp(strip_seconds / std::max(seconds_since(start), 1e-5), 0.25, 4.0);
        rows = std::clamp(static_cast<int>(rows * growth), smallest_strip, height + smallest_strip);
        if (!drawn(Area{0, y, width, count})) return false;
        y += count;
    }
    return true;
}

void set_march(const Shader& shader, const graph::Program& program)
{
    shader.set("march.step_limit", program.march.step_limit);
    shader.set("march.minimum_step", program.march.minimum_step);
    shader.set("march.tolerance", program.march.tolerance);
    shader.set("march.near_limit", program.march.near);
    shader.set("march.far_limit", program.march.far);
    shader.set("march.out_of_steps_hits", program.march.out_of_steps_hits ? 1 : 0);
    shader.set("march.step_scale", graph::step_scale(program.march));
    shader.set("march.constant_step", program.march.constant_step);
    shader.set("march.normal_step", program.march.normal_step);
    shader.set("march.occlusion_samples", program.occlusion.samples);
    shader.set("march.occlusion_strength", program.occlusion.strength);
    shader.set("march.occlusion_radius", program.occlusion.radius);
    shader.set("step_budget", program.step_budget);
    shader.set("ray_count", 1 + graph::shadow_count(program));
    shader.set("fog.colour", program.fog.colour);
    shader.set("fog.density", program.fog.density);
    shader.set("fog.start", program.fog.start);
    shader.set("fog.height_falloff", program.fog.height_falloff);
}

void set_view(const Shader& shader, const FrameRequest& request)
{
    // A lattice is a smaller picture, whose pixels' middles lie elsewhere.
    const DrawnPixels drawn = drawn_pixels(request);
    int below = request.height - 1 - (drawn.y + drawn.step * (drawn.height - 1));
    auto step = static_cast<float>(drawn.step);
    auto shifted = [&](float offset, int first) {
        return (offset + (static_cast<float>(first % drawn.step) + 0.5f - 0.5f * step)) / step;
    };
    glUniform2f(shader.uniform("resolution"), static_cast<float>(request.width) / step,
                static_cast<float>(request.height) / step);
    glUniform2f(shader.uniform("first_pixel"), static_cast<float>(drawn.x / drawn.step),
                static_cast<float>(below / drawn.step));
    glUniform2f(shader.uniform("offset"), shifted(request.offset.x, drawn.x), shifted(request.offset.y, below));
    glUniform2f(shader.uniform("lens"), request.lens.x, request.lens.y);
    shader.set("eye", eye_side(request.eye));
    shader.set("interaxial", request.interaxial);
    shader.set("convergence", request.convergence);
    shader.set("toe_in", request.toe_in ? 1.0f : 0.0f);
    shader.set("sky", request.sky ? 1.0f : 0.0f);
    shader.set("pixel_size", 2.0f / static_cast<float>(request.height));
    shader.set("has_view", request.camera ? 1 : 0);
    if (!request.camera) return;
    Viewpoint view = viewpoint_of(*request.camera);
    shader.set("view.position", view.position);
    shader.set("view.forward", view.forward);
    shader.set("view.right", view.right);
    shader.set("view.upward", view.upward);
    shader.set("view.slope", view.slope);
    shader.set("view.half_height", view.half_height);
}

// A driver that reset the GPU leaves pixels that mean nothing.
void require_context()
{
    bool can_tell = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness") ||
                    epoxy_has_gl_extension("GL_ARB_robustness");
    if ((can_tell && glGetGraphicsResetStatus() != GL_NO_ERROR) || glGetError() == GL_OUT_OF_MEMORY)
        throw ContextLost(
            1, "the GPU gave up while drawing this scene; use a simpler scene, a smaller --size or --device cpu");
}

// Reads a strip of one attachment; visit(pixel of the frame, vec4). GL rows are bottom-up, the frame's top-down.
template <typename Visit>
void read_flipped(const FloatTarget& target, int attachment, int frame_height, const Area& strip,
                  std::vector<glm::vec4>& scratch, Visit visit)
{
    auto width = static_cast<std::size_t>(strip.width), rows = static_cast<std::size_t>(strip.height);
    auto first = static_cast<std::size_t>(strip.y) * width;
    scratch.resize(width * rows);
    target.read(attachment, {0, frame_height - strip.y - strip.height, strip.width, strip.height}, &scratch[0].x);
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < width; ++x) visit(first + y * width + x, scratch[(rows - 1 - y) * width + x]);
}

// The inverse of shaders/gpu/main.glsl's.
glm::vec3 from_octahedral(float x, float y)
{
    float z = 1.0f - std::abs(x) - std::abs(y);
    float fold = std::max(-z, 0.0f);
    return glm::normalize(glm::vec3(x - std::copysign(fold, x), y - std::copysign(fold, y), z));
}

// The buffers of shaders/gpu/main.glsl with layers.
void read_layers(Frame& frame, const FloatTarget& target, const Area& strip)
{
    Layers& layers = *frame.layers;
    std::vector<glm::vec4> scratch;
    auto read = [&](int attachment, const auto& visit) {
        read_flipped(target, attachment, frame.height, strip, scratch, visit);
    };
    auto read_split = [&](int attachment, std::vector<glm::vec3>& first, const auto& last) {
        read(attachment, [&](std::size_t i, const glm::vec4& texel) {
            first[i] = glm::vec3(texel);
            last(i) = static_cast<std::remove_reference_t<decltype(last(i))>>(texel.w);
        });
    };
    read(0, [&](std::size_t i, const glm::vec4& texel) {
        frame.depth[i] = texel.x < 0 ? std::numeric_limits<float>::infinity() : texel.x;
        frame.node_id[i] = static_cast<int>(texel.y);
        frame.material_id[i] = static_cast<int>(texel.z);
        frame.exhausted[i] = texel.w < 0;
        frame.steps[i] = static_cast<int>(texel.w < 0 ? -1 - texel.w : texel.w);
    });
    read(1, [&](std::size_t i, const glm::vec4& texel) {
        frame.normal[i] = std::isinf(frame.depth[i]) ? glm::vec3(0) : from_octahedral(texel.x, texel.y);
        float evaluations = std::floor(texel.z);
        frame.evaluations += static_cast<std::int64_t>(evaluations);
        if (!frame.covered.empty()) frame.covered[i] = 2.0f * (texel.z - evaluations);
        layers.minimum_cone_ratio[i] = texel.w;
    });
    read(2, [&](std::size_t i, const glm::vec4& texel) {
        layers.position[i] = glm::vec3(texel);
        float shadow = std::floor(texel.w / 4096.0f);
        layers.shadow[i] = shadow / 4095.0f;
        layers.occlusion[i] = (texel.w - 4096.0f * shadow) / 4095.0f;
    });
    read_split(3, layers.albedo, [&](std::size_t i) -> float& { return layers.gradient_length[i]; });
    read_split(4, layers.ambient, [&](std::size_t i) -> int& { return layers.shadow_steps[i]; });
    read_split(5, layers.diffuse, [&](std::size_t i) -> float& { return layers.emission[i].r; });
    read_split(6, layers.specular, [&](std::size_t i) -> float& { return layers.emission[i].g; });
    read_split(7, layers.reflection, [&](std::size_t i) -> float& { return layers.emission[i].b; });
    for (std::size_t i = static_cast<std::size_t>(strip.y) * static_cast<std::size_t>(strip.width), n = 0;
         n < static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height); ++n, ++i)
        frame.colour[i] = layers.colour(i);
}

void read_strip(Frame& frame, const FloatTarget& target, const Area& strip)
{
    if (frame.layers) return read_layers(frame, target, strip);
    std::vector<glm::vec4> scratch;
    read_flipped(target, 0, frame.height, strip, scratch, [&](std::size_t i, const glm::vec4& texel) {
        frame.colour[i] = glm::vec3(texel);
        frame.exhausted[i] = texel.w > 0.5f;
    });
    read_flipped(target, 1, frame.height, strip, scratch, [&](std::size_t i, const glm::vec4& texel) {
        frame.depth[i] = texel.x < 0 ? std::numeric_limits<float>::infinity() : texel.x;
        frame.node_id[i] = static_cast<int>(texel.y);
        frame.material_id[i] = static_cast<int>(texel.z);
        frame.steps[i] = static_cast<int>(texel.w);
    });
    read_flipped(target, 2, frame.height, strip, scratch, [&](std::size_t i, const glm::vec4& texel) {
        frame.normal[i] = glm::vec3(texel);
        float evaluations = std::floor(texel.w);
        frame.evaluations += static_cast<std::int64_t>(evaluations);
        if (!frame.covered.empty()) frame.covered[i] = 2.0f * (texel.w - evaluations);
    });
}

}  // namespace

struct GpuDevice::State {
    HeadlessContext context;  // first: the objects below die while it lives
    std::string name;
    VertexArray vertices;
    Buffer block;
    FloatTexture lists, points;
    ShaderCache shaders;
    std::optional<FloatTarget> plain_target, layer_target;

    State();
    codegen::Placement placement(std::span<const float> values) const;
    void upload(const Shader& shader, const graph::Program& program, std::span<const float> values);
    FloatTarget& bound_target(int width, int height, bool layers = false);  // of at least that size
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

FloatTarget& GpuDevice::State::bound_target(int width, int height, bool layers)
{
    std::optional<FloatTarget>& target = layers ? layer_target : plain_target;
    if (!target || target->width() < width || target->height() < height) {
        target.reset();
        target.emplace(width, height, layers ? layer_attachments : plain_attachments);
    }
    target->bind();
    glViewport(0, 0, width, height);
    return *target;
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
int GpuDevice::links() const { return state_->shaders.links(); }

std::string GpuDevice::shader_text(const graph::Program& program, const FrameRequest& request) const
{
    std::vector<float> values = field::evaluate_frame(program, request.time);
    return codegen::print_fragment_shader(program, values, state_->placement(values), request.layers, request.counts);
}

bool GpuDevice::linked(const std::string& text) const { return state_->shaders.find(text) != nullptr; }

void GpuDevice::link(const std::string& text, bool layers)
{
    state_->context.make_current();
    if (linked(text)) return;
    const Shader& shader = state_->shaders.use(text);
    shader.use();
    state_->bound_target(1, 1, layers);
    draw_rows(1, 0, 1);
    require_context();
}

// A band at a time, so that a newer request is heard.
bool GpuDevice::draw_slice(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch)
{
    auto distances_at = [&](std::span<const glm::vec3> points) {
        return distances(program, request.time, {points.begin(), points.end()});
    };
    for (int y = 0; y < request.height; y += slice_band) {
        if (watch.stops()) return false;
        Area band{0, y, request.width, std::min(slice_band, request.height - y)};
        draw_slice_area(frame, request, band, distances_at);
        if (watch.part_drawn) watch.part_drawn(frame, band);
    }
    return true;
}

bool GpuDevice::draw(Frame& frame, const graph::Program& program, const FrameRequest& request, const Watch& watch)
{
    frame.evaluations = 0;
    frame.covered.resize(program.march.coverage && !request.slice ? frame.colour.size() : 0);
    if (request.slice) return draw_slice(frame, program, request, watch);
    state_->context.make_current();
    std::vector<float> values = field::evaluate_frame(program, request.time);
    std::string text =
        codegen::print_fragment_shader(program, values, state_->placement(values), request.layers, request.counts);
    bool linked_before = linked(text);
    const Shader& shader = state_->shaders.use(text);
    state_->upload(shader, program, values);
    set_march(shader, program);
    set_view(shader, request);
    FloatTarget& target = state_->bound_target(frame.width, frame.height, request.layers);
    if (!linked_before) draw_rows(1, 0, 1);  // or compiling would size the strips
    return draw_in_strips(frame.width, frame.height, [&](const Area& strip) {
        read_strip(frame, target, strip);
        require_context();
        if (watch.part_drawn) watch.part_drawn(frame, strip);
        if (watch.progress)
            watch.progress(static_cast<float>(strip.y + strip.height) / static_cast<float>(frame.height));
        return !watch.stops();
    });
}

Frame GpuDevice::render(const graph::Program& program, const FrameRequest& request, const Progress& progress)
{
    const DrawnPixels drawn = drawn_pixels(request);
    Frame frame(drawn.width, drawn.height, request.layers);
    draw(frame, program, request, {.progress = progress});
    return frame;
}

std::vector<float> GpuDevice::distances(const graph::Program& program, float time, const std::vector<glm::vec3>& points)
{
    state_->context.make_current();
    std::vector<float> values = field::evaluate_frame(program, time);
    const Shader& shader =
        state_->shaders.use(codegen::print_distance_shader(program, values, state_->placement(values)));
    state_->upload(shader, program, values);
    shader.set("points", points_unit);
    shader.set("points_per_row", points_across);
    FloatTarget& target = state_->bound_target(points_across, points_across);

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
        target.read(0, {0, 0, points_across, points_across}, &drawn[0].x);
        for (std::size_t i = 0; i < count; ++i) result.push_back(drawn[i].x);
    }
    require_context();
    return result;
}

double GpuDevice::ready_seconds(const std::string& fragment_shader)
{
    constexpr int size = 64;
    state_->context.make_current();
    state_->bound_target(size, size);
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

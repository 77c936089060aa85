// `render`: a scene to a PNG, on the GPU or the CPU.
#include "app/commands.h"
#include "app/progress_line.h"
#include "app/scene_arguments.h"
#include "renderer/devices.h"
#include "renderer/picture.h"

#include <charconv>
#include <iostream>

namespace fieldwright::app {
namespace {

constexpr int side_limit_px = 16384;
constexpr std::int64_t area_limit_px = 64'000'000;

struct RenderArguments {
    SceneArguments scene;
    std::filesystem::path output;
    std::string size = "960x540", device = "auto", view = "beauty", stereo = "off";
    float interaxial = 0.065f, convergence = 5.0f;  // m
    bool quiet = false;
};

std::optional<std::pair<int, int>> parse_size(const std::string& text)
{
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    auto [cross, bad_width] = std::from_chars(text.data(), end, width);
    if (bad_width != std::errc() || cross == end || *cross != 'x') return std::nullopt;
    auto [stop, bad_height] = std::from_chars(cross + 1, end, height);
    if (bad_height != std::errc() || stop != end || width < 1 || height < 1) return std::nullopt;
    return std::pair(width, height);
}

std::string size_error(const std::string& text)
{
    auto size = parse_size(text);
    if (!size) return "`" + text + "` is not a size; write WIDTHxHEIGHT in pixels, such as 960x540";
    if (std::max(size->first, size->second) > side_limit_px || std::int64_t{size->first} * size->second > area_limit_px)
        return "a picture has at most 16384 pixels a side and 64 million in all";
    return {};
}

std::string png_error(const std::string& text)
{
    std::string extension = std::filesystem::path(text).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == ".png" ? "" : "pictures are written as .png only; rename `" + text + "`";
}

// The device that `--device` means for this program; none = the CPU. `auto` must not depend on timing.
std::optional<renderer::GpuDevice> choose_gpu(const std::string& device, const graph::Program& program)
{
    bool by_cpu = renderer::runs_on_cpu(program);
    if (device == "cpu" && !by_cpu && !program.gpu_only)
        throw graph::Failure(
            1,
            "the shading of --shaders (render/*.glsl) is not the one compiled into this program, so only "
            "a GPU can draw with it; use --device gpu, or build the program with these shaders");
    if (device == "cpu") return std::nullopt;
    if (device == "gpu" || !by_cpu) return renderer::GpuDevice();
    try {
        renderer::GpuDevice gpu;
        if (!gpu.software()) return gpu;
    } catch (const graph::Failure& failure) {
        if (failure.exit_code != 4) throw;  // no GL: the CPU draws
    }
    return std::nullopt;
}

class Drawing {
public:
    Drawing(const RenderArguments& arguments, const graph::Program& program)
        : arguments_(arguments), program_(program), gpu_(choose_gpu(arguments.device, program)), line_(!arguments.quiet)
    {
        std::tie(request_.width, request_.height) = *parse_size(arguments.size);
        request_.time = arguments.scene.time;
        request_.interaxial = arguments.interaxial;
        request_.convergence = arguments.convergence;
    }

    renderer::Picture draw()
    {
        renderer::View view = *renderer::view_from_name(arguments_.view);
        renderer::Stereo stereo = *renderer::stereo_from_name(arguments_.stereo);
        int step_limit = program_.march.step_limit;
        if (stereo == renderer::Stereo::off)
            return renderer::picture(frame(renderer::Eye::centre, 0, 1), view, step_limit);
        renderer::Frame left = frame(renderer::Eye::left, 0, 0.5f);
        renderer::Frame right = frame(renderer::Eye::right, 0.5f, 0.5f);
        return renderer::anaglyph(left, right, view, step_limit, stereo);
    }

    void finish()
    {
        line_.finish(arguments_.output.string() + "  " + std::to_string(request_.width) + "x" +
                     std::to_string(request_.height) + " on " + (gpu_ ? gpu_->renderer_name() : "the CPU"));
    }

private:
    renderer::Frame frame(renderer::Eye eye, float start, float share)
    {
        renderer::FrameRequest request = request_;
        request.eye = eye;
        auto progress = [&](float fraction) { line_.show(start + share * fraction); };
        return gpu_ ? gpu_->render(program_, request, progress) : renderer::render_on_cpu(program_, request, progress);
    }

    const RenderArguments& arguments_;
    const graph::Program& program_;
    std::optional<renderer::GpuDevice> gpu_;
    renderer::FrameRequest request_;
    ProgressLine line_;
};

int render(const RenderArguments& arguments, const Session& session)
{
    require_place(arguments.output);
    auto [document, library] = open_document(arguments.scene, session.library());
    require_allowed_code(arguments.scene, document);
    graph::LowerOptions options;
    options.ids = renderer::view_from_name(arguments.view) == renderer::View::id;
    graph::Program program = lower_scene(arguments.scene, document, library, options);
    report_problems(program, document);
    Drawing drawing(arguments, program);
    renderer::write_png(arguments.output, drawing.draw());
    drawing.finish();
    return 0;
}

}  // namespace

void add_render(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App& command = *parser.add_subcommand("render", "Draw a scene to a PNG");
    add_scene(command, arguments->scene);
    command.add_option("-o,--output", arguments->output, "The picture (*.png)")->required()->check(png_error);
    command.add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->check(size_error)->capture_default_str();
    command.add_option("--device", arguments->device, "auto draws on a hardware GPU, else on the CPU")
        ->check(CLI::IsMember({"gpu", "cpu", "auto"}))
        ->capture_default_str();
    command.add_option("--view", arguments->view, "What the pixels show")
        ->check(CLI::IsMember(renderer::view_names()))
        ->capture_default_str();
    command.add_option("--stereo", arguments->stereo, "Red-cyan anaglyph of two off-axis eyes")
        ->check(CLI::IsMember(renderer::stereo_names()))
        ->capture_default_str();
    command.add_option("--interaxial", arguments->interaxial, "Distance between the eyes in metres")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command.add_option("--convergence", arguments->convergence, "Distance in metres that appears on the screen")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
    add_time(command, arguments->scene);
    add_changes(command, arguments->scene);
    add_allow_code(command, arguments->scene);
    command.add_flag("-q,--quiet", arguments->quiet, "No progress on stderr");
    command.callback(
        [arguments, &session] { session.action = [arguments, &session] { return render(*arguments, session); }; });
}

}  // namespace fieldwright::app

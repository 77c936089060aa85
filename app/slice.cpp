// `slice`: the field on a plane, as a picture.
#include "app/commands.h"
#include "app/render_arguments.h"
#include "graph/slice_plane.h"
#include "renderer/devices.h"
#include "renderer/picture.h"

#include <iostream>

namespace fieldwright::app {
namespace {

struct SliceArguments {
    SceneArguments scene;
    std::filesystem::path output;
    std::string size = "960x540", plane = "xy", style = "sign", colour_map = "viridis";
    float offset = 0, height = 4, gamma = 2.2f, spacing = 0;
    std::vector<float> centre = {0, 0};
    bool quiet = false;
};

std::string output_error(const std::string& text)
{
    auto format = renderer::picture_format(text);
    bool of_light = format == renderer::PictureFormat::hdr || format == renderer::PictureFormat::exr;
    return format && !of_light ? "" : "slices are written as .png or .jpg; rename `" + text + "`";
}

renderer::FrameRequest request_of(const SliceArguments& arguments)
{
    renderer::FrameRequest request{.time = arguments.scene.time};
    std::tie(request.width, request.height) = parsed_size(arguments.size);
    const graph::SlicePlane& plane = *graph::find_slice_plane(arguments.plane);
    renderer::Slice slice = renderer::slice_of(plane, arguments.offset);
    slice.centre += arguments.centre[0] * plane.right + arguments.centre[1] * plane.up;
    slice.height = arguments.height;
    slice.style = *renderer::slice_style_from_name(arguments.style);
    slice.gamma = arguments.gamma;
    slice.spacing = arguments.spacing > 0 ? arguments.spacing : graph::line_spacing(arguments.height);
    slice.colour_map = *renderer::colour_map_from_name(arguments.colour_map);
    request.slice = slice;
    return request;
}

int slice(const SliceArguments& arguments, const Session& session)
{
    require_place(arguments.output);
    auto [document, library] = open_document(arguments.scene, session.library());
    require_allowed_code(arguments.scene, document);
    graph::Program program = lower_scene(arguments.scene, document, library, {.ids = false});
    report_problems(program, document);
    renderer::FrameRequest request = request_of(arguments);
    renderer::Frame frame =
        program.gpu_only ? renderer::GpuDevice().render(program, request) : renderer::render_on_cpu(program, request);
    int step_limit = program.march.step_limit;
    renderer::write_picture(arguments.output, renderer::picture(frame, renderer::View::slice, step_limit), {});
    if (!arguments.quiet) std::cerr << arguments.output.string() << "  " << arguments.size << "\n";
    return 0;
}

void add_plane(CLI::App& command, SliceArguments& arguments)
{
    std::vector<std::string> planes;
    for (const graph::SlicePlane& plane : graph::slice_planes) planes.emplace_back(plane.name);
    command.add_option("--plane", arguments.plane, "The two axes that span it")
        ->check(CLI::IsMember(planes))
        ->capture_default_str();
    command.add_option("--offset", arguments.offset, "Metres along the third axis")
        ->check(CLI::Range(-1e6, 1e6))
        ->capture_default_str();
    command.add_option("--centre", arguments.centre, "Middle of the picture: metres to the right and up")
        ->expected(2)
        ->check(CLI::Range(-1e6, 1e6))
        ->capture_default_str();
    command.add_option("--height", arguments.height, "Metres that the picture is high")
        ->check(CLI::Range(1e-3, 1e6))
        ->capture_default_str();
}

void add_style(CLI::App& command, SliceArguments& arguments)
{
    command.add_option("--style", arguments.style, "What is shown of the distances")
        ->check(CLI::IsMember(renderer::slice_style_names()))
        ->capture_default_str();
    command.add_option("--gamma", arguments.gamma, "Of grey: larger shows small distances brighter")
        ->check(CLI::Range(0.1, 10.0))
        ->capture_default_str();
    command.add_option("--spacing", arguments.spacing, "Metres between lines of equal distance; 0 fits the height")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command.add_option("--colour-map", arguments.colour_map, "Colours of the gradient's error")
        ->check(CLI::IsMember(renderer::colour_map_names()))
        ->capture_default_str();
}

}  // namespace

void add_slice(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<SliceArguments>();
    CLI::App& command = *parser.add_subcommand("slice", "Draw the field on a plane");
    add_scene(command, arguments->scene);
    command.add_option("-o,--output", arguments->output, "The picture: .png or .jpg")->required()->check(output_error);
    command.add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->check(size_error)->capture_default_str();
    add_plane(command, *arguments);
    add_style(command, *arguments);
    add_time(command, arguments->scene);
    add_changes(command, arguments->scene);
    add_allow_code(command, arguments->scene);
    command.add_flag("-q,--quiet", arguments->quiet, "Nothing on stderr");
    command.callback(
        [arguments, &session] { session.action = [arguments, &session] { return slice(*arguments, session); }; });
}

}  // namespace fieldwright::app

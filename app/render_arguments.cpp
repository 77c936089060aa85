// The options of `render`: their words, their checks, and what does not go together.
#include "app/render_arguments.h"

#include "app/frame_numbers.h"
#include "graph/edits.h"
#include "graph/settings.h"

#include <algorithm>
#include <charconv>

namespace fieldwright::app {
namespace {

constexpr int side_limit_px = 16384;
constexpr std::int64_t area_limit_px = 64'000'000;
constexpr int grid_limit = 64, enlargement_limit = 16;

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

std::string output_error(const std::string& text)
{
    if (renderer::picture_format(text)) return {};
    return "pictures are written as .png, .jpg, .hdr or .exr; rename `" + text + "`";
}

std::string frames_error(const std::string& text)
{
    if (frames_from_text(text)) return {};
    return "`" + text + "` are not frames; write such as 1-10,20,30-40x2, at most a million";
}

template <typename Names>
std::vector<std::string> as_strings(const Names& names)
{
    return {names.begin(), names.end()};
}

template <typename Kind, typename Names>
Kind by_name(const Names& names, const std::string& name)
{
    return static_cast<Kind>(std::find(names.begin(), names.end(), name) - names.begin());
}

// "sky", "transparent", or a colour as parameters read it.
void set_backdrop(graph::PictureSettings& picture, const std::string& text)
{
    if (text == "sky" || text == "transparent") {
        picture.backdrop = by_name<graph::Backdrop>(graph::backdrop_names, text);
        return;
    }
    graph::Parameter colour;
    colour.kind = graph::ParameterKind::colour;
    std::optional<graph::Value> value = graph::parse_value(colour, text);
    if (!value)
        throw graph::Failure(2, "--backdrop: `" + text + "` is neither sky, transparent nor a colour such as #204060");
    picture.backdrop = graph::Backdrop::colour;
    picture.backdrop_colour = std::get<glm::vec3>(*value);
}

void add_picture(CLI::App& command, RenderArguments& arguments)
{
    command
        .add_option("-o,--output", arguments.output,
                    "The picture: .png, .jpg, .hdr or .exr; of --frames, # become the frame's number: out.####.png")
        ->required()
        ->check(output_error);
    command.add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels")->check(size_error)->capture_default_str();
    command.add_option("--tile", arguments.tile,
                       "Draw a part only: X,Y,WIDTH,HEIGHT in pixels from the top left, or N/M, the Nth of M bands");
    command
        .add_option("--enlarge", arguments.enlarge,
                    "N: every pixel becomes N x N of the file, to see it; .png and .jpg only")
        ->check(CLI::Range(1, enlargement_limit));
    command.add_option("--device", arguments.device, "auto draws on a hardware GPU, else on the CPU")
        ->check(CLI::IsMember({"gpu", "cpu", "auto"}))
        ->capture_default_str();
    command.add_flag("--sheet", arguments.sheet, "Every view in one labelled picture, each of --size");
}

void add_light(CLI::App& command, RenderArguments& arguments)
{
    command.add_option("--samples", arguments.samples, "Samples of a pixel; the scene's own when left out")
        ->check(CLI::Range(1, graph::samples_maximum));
    command.add_option("--grid", arguments.grid, "N x N samples of a pixel on a regular grid instead of --samples")
        ->check(CLI::Range(1, grid_limit));
    command
        .add_option("--anti-aliasing", arguments.anti_aliasing,
                    "coverage: where an edge passes through a pixel, both sides share each of its samples; none")
        ->check(CLI::IsMember(as_strings(graph::anti_aliasing_names)));
    command.add_option("--shutter", arguments.shutter, "Seconds that a picture is exposed, for motion blur")
        ->check(CLI::Range(0.0, 100.0));
    command.add_option("--exposure", arguments.exposure, "Stops, each of which doubles the light; .png and .jpg only")
        ->check(CLI::Range(-20.0, 20.0));
    command.add_option("--tone-map", arguments.tone_map, "How bright light is compressed; .png and .jpg only")
        ->check(CLI::IsMember(as_strings(graph::tone_map_names)));
    command.add_option("--backdrop", arguments.backdrop,
                       "What shows where nothing is: sky, transparent (.png and .exr), or a colour such as #204060");
}

void add_sequence(CLI::App& command, RenderArguments& arguments)
{
    command
        .add_option("--frames", arguments.frames,
                    "Frames of an animation: 1-10,20,30-40x2; frame n shows the moment (n - 1) / --fps")
        ->check(frames_error);
    command.add_option("--fps", arguments.frames_per_second, "Frames per second; the scene's own when left out")
        ->check(CLI::Range(0.1, 1000.0));
    command.add_flag("--skip-existing", arguments.skip_existing, "Leave pictures alone that are there already");
    command.add_flag("--keep-going", arguments.keep_going, "Go on with the next frame when one fails, and exit with 7");
    command.add_flag("--json", arguments.json, "A line of JSON on stdout for every picture written");
    command.add_flag("--keep-scene", arguments.keep_scene, "Keep the scene's JSON in the file (.png and .exr)");
}

}  // namespace

std::string size_error(const std::string& text)
{
    auto size = parse_size(text);
    if (!size) return "`" + text + "` is not a size; write WIDTHxHEIGHT in pixels, such as 960x540";
    if (std::max(size->first, size->second) > side_limit_px || std::int64_t{size->first} * size->second > area_limit_px)
        return "a picture has at most 16384 pixels a side and 64 million in all";
    return {};
}

std::pair<int, int> parsed_size(const std::string& text) { return *parse_size(text); }

void add_render_options(CLI::App& command, RenderArguments& arguments)
{
    add_scene(command, arguments.scene);
    add_picture(command, arguments);
    add_display(command, arguments.display);
    add_light(command, arguments);
    add_sequence(command, arguments);
    add_time(command, arguments.scene);
    add_changes(command, arguments.scene);
    add_allow_code(command, arguments.scene);
    command.add_flag("-q,--quiet", arguments.quiet, "No progress on stderr");
}

void require_sense(const RenderArguments& arguments)
{
    using renderer::PictureFormat;
    auto refuse = [](const std::string& sentence) { throw graph::Failure(2, sentence); };
    PictureFormat format = arguments.format();
    bool of_light = format == PictureFormat::hdr || format == PictureFormat::exr;
    if (of_light && (arguments.display.view != "beauty" || arguments.sheet))
        refuse("--view and --sheet are for .png and .jpg; .exr holds every buffer as a layer, .hdr the light");
    if (of_light && (!arguments.tone_map.empty() || arguments.exposure))
        refuse("--tone-map and --exposure are for .png and .jpg; .hdr and .exr hold the light itself");
    if (of_light && arguments.enlarge > 1) refuse("--enlarge is for .png and .jpg, to be looked at");
    if (format == PictureFormat::hdr && arguments.has_stereo()) refuse("--stereo needs .png, .jpg or .exr");
    if (arguments.sheet && arguments.has_stereo()) refuse("--sheet shows one eye; leave --stereo out");
    if (arguments.sheet && !arguments.tile.empty()) refuse("--sheet shows whole pictures; leave --tile out");
    bool mixes_eyes = renderer::mode_of(*renderer::stereo_from_name(arguments.display.stereo)).layout ==
                      renderer::StereoLayout::mixed;
    if (arguments.display.split > 0 && (of_light || !mixes_eyes))
        refuse("--split compares anaglyphs: choose one by --stereo, such as dubois, for .png or .jpg");
    if (arguments.display.split > 0 && !arguments.tile.empty())
        refuse("--split divides whole pictures; leave --tile out");
    if (arguments.grid > 0 && arguments.samples)
        refuse("--grid and --samples both say how many samples; leave one out");
    bool named_alike = !has_number_place(arguments.output.filename().string());
    if (!arguments.frames.empty() && named_alike && frames_from_text(arguments.frames)->size() > 1)
        refuse("the frames would overwrite each other; give --output a place for their numbers, such as out.####.png");
    auto [width, height] = parsed_size(arguments.size);
    if (!arguments.tile.empty() && !tile_from_text(arguments.tile, width, height))
        refuse("--tile: `" + arguments.tile + "` is no part of a picture of " + arguments.size +
               "; write X,Y,WIDTH,HEIGHT or N/M");
}

void change_settings(graph::Document& document, const RenderArguments& arguments)
{
    graph::PictureSettings& picture = document.picture;
    picture.samples = arguments.samples.value_or(picture.samples);
    picture.shutter = arguments.shutter.value_or(picture.shutter);
    picture.exposure = arguments.exposure.value_or(picture.exposure);
    if (!arguments.tone_map.empty())
        picture.tone_map = by_name<graph::ToneMap>(graph::tone_map_names, arguments.tone_map);
    if (!arguments.backdrop.empty()) set_backdrop(picture, arguments.backdrop);
    if (!arguments.anti_aliasing.empty())
        document.march.coverage = by_name<bool>(graph::anti_aliasing_names, arguments.anti_aliasing);
    document.animation.frames_per_second = arguments.frames_per_second.value_or(document.animation.frames_per_second);
    auto format = arguments.format();
    bool has_alpha = format == renderer::PictureFormat::png || format == renderer::PictureFormat::exr;
    if (picture.backdrop == graph::Backdrop::transparent && (!has_alpha || arguments.has_stereo()) &&
        !arguments.backdrop.empty())
        throw graph::Failure(2, "--backdrop transparent needs .png without --stereo, or .exr");
}

}  // namespace fieldwright::app

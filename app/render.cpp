// `render`: a scene to a picture, or to one for every frame of an animation.
#include "app/commands.h"
#include "app/frame_numbers.h"
#include "app/picture_maker.h"
#include "graph/json.h"
#include "graph/settings.h"

#include <chrono>
#include <cmath>
#include <iostream>

namespace fieldwright::app {
namespace {

constexpr int partly_failed = 7;

struct Shot {
    std::filesystem::path path;
    float time = 0;            // s
    std::optional<int> frame;  // of an animation
};

std::vector<Shot> shots_of(const RenderArguments& arguments, const graph::AnimationSettings& animation)
{
    if (arguments.frames.empty()) return {{arguments.output, arguments.scene.time, std::nullopt}};
    std::vector<Shot> shots;
    const std::vector<int> frames = *frames_from_text(arguments.frames);
    for (int frame : frames) {
        std::filesystem::path path = arguments.output;
        path.replace_filename(numbered(arguments.output.filename().string(), frame));
        shots.push_back({path, graph::time_of_frame(animation, frame), frame});
    }
    return shots;
}

// One line, flushed: who reads it may wait for it.
void print_json(const Shot& shot, const PictureMaker& maker, double ms)
{
    std::string line = "{";
    if (shot.frame) line += "\"frame\": " + std::to_string(*shot.frame) + ", ";
    line += "\"path\": ";
    graph::append_json_string(line, shot.path.string());
    line += ", \"ms\": " + std::to_string(std::lround(ms)) + ", \"samples\": " + std::to_string(maker.samples()) +
            ", \"device\": ";
    graph::append_json_string(line, maker.device_name());
    std::cout << line << "}" << std::endl;
}

void make(const Shot& shot, const RenderArguments& arguments, PictureMaker& maker)
{
    auto start = std::chrono::steady_clock::now();
    maker.make(shot.path, shot.time);
    std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    if (arguments.json) print_json(shot, maker, taken.count());
}

// How many of them failed; the first failure ends it, unless they are to be passed over.
int make_all(const std::vector<Shot>& shots, const RenderArguments& arguments, PictureMaker& maker)
{
    int failed = 0;
    for (const Shot& shot : shots) {
        std::error_code error;
        if (arguments.skip_existing && std::filesystem::exists(shot.path, error)) continue;
        try {
            make(shot, arguments, maker);
        } catch (const graph::Failure& failure) {
            std::string where = shot.frame ? "frame " + std::to_string(*shot.frame) + ": " : "";
            if (!arguments.keep_going) throw graph::Failure(failure.exit_code, where + failure.what());
            std::cerr << "fieldwright: " << where << failure.what() << "\n";
            ++failed;
        }
    }
    return failed;
}

std::string summary(const std::vector<Shot>& shots, const RenderArguments& arguments)
{
    std::string pictures = shots.size() == 1 ? shots[0].path.string()
                                             : std::to_string(shots.size()) + " frames as " + arguments.output.string();
    return pictures + "  " + arguments.size;
}

int render(const RenderArguments& arguments, const Session& session)
{
    require_sense(arguments);
    require_place(arguments.output);
    auto [document, library] = open_document(arguments.scene, session.library());
    change_settings(document, arguments);
    require_allowed_code(arguments.scene, document);
    graph::LowerOptions options;
    options.ids = arguments.sheet || arguments.format() == renderer::PictureFormat::exr ||
                  arguments.display.view == "id" || arguments.display.view == "material";
    graph::Program program = lower_scene(arguments.scene, document, library, options);
    report_problems(program, document);
    std::vector<Shot> shots = shots_of(arguments, document.animation);
    PictureMaker maker(arguments, document, program, shots.size());
    int failed = make_all(shots, arguments, maker);
    maker.finish(summary(shots, arguments));
    return failed > 0 ? partly_failed : 0;
}

}  // namespace

void add_render(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App& command = *parser.add_subcommand("render", "Draw a scene to a picture, or an animation to a sequence");
    add_render_options(command, *arguments);
    command.callback(
        [arguments, &session] { session.action = [arguments, &session] { return render(*arguments, session); }; });
}

}  // namespace fieldwright::app

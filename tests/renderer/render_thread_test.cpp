// The render thread without a window: what it shows, what it drops, and that it rests.
#include "renderer/render_thread.h"
#include "renderer/low_priority.h"

#include "renderer/devices.h"
#include "renderer/gpu_worker.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <thread>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using namespace std::chrono_literals;
using glm::vec3;
using Clock = std::chrono::steady_clock;
using ProgramPointer = std::shared_ptr<const graph::Program>;

// A row of balls melted into each other under a sun; more of them are slower.
Scene balls(int count, float radius = 0.4f)
{
    Scene s;
    NodeId all;
    for (int i = 0; i < count; ++i) {
        NodeId ball = s.node("sphere", {{"radius", radius}});
        vec3 offset(0.7f * static_cast<float>(i % 8) - 2.5f, 0.7f * static_cast<float>(i / 8 % 8) - 2.0f,
                    -0.7f * static_cast<float>(i / 64));
        NodeId moved = s.node("translate", {{"d", ball}, {"offset", offset}});
        all = i == 0 ? moved : s.node("smooth_union", {{"a", all}, {"b", moved}});
    }
    s.show(all);
    s.node("sun");
    return s;
}

ProgramPointer program_of(const Scene& scene) { return std::make_shared<const graph::Program>(scene.program()); }

PictureRequest request_of(ProgramPointer program, int width, int height)
{
    PictureRequest request{.program = std::move(program)};
    request.frame.width = width;
    request.frame.height = height;
    return request;
}

// Numbers requests, and collects results.
class Desk {
public:
    explicit Desk(Device device) : thread(RenderOptions{.device = device}) {}

    std::uint64_t ask(PictureRequest request, bool interacting = false)
    {
        request.interacting = interacting;
        request.generation = ++generation_;
        thread.request(std::move(request));
        return generation_;
    }

    std::optional<RenderResult> next(Clock::duration patience = 240s)
    {
        for (auto until = Clock::now() + patience; Clock::now() < until; std::this_thread::sleep_for(1ms))
            if (std::optional<RenderResult> result = thread.poll()) return result;
        return std::nullopt;
    }

    template <typename Kind>
    std::optional<Kind> next_of(Clock::duration patience = 240s)
    {
        for (auto until = Clock::now() + patience; Clock::now() < until;) {
            std::optional<RenderResult> result = next(until - Clock::now());
            if (result && std::holds_alternative<Kind>(*result)) return std::get<Kind>(std::move(*result));
        }
        return std::nullopt;
    }

    std::optional<DrawnPicture> final_picture(std::uint64_t generation)
    {
        for (;;) {
            std::optional<DrawnPicture> drawn = next_of<DrawnPicture>();
            if (!drawn || (drawn->final && drawn->generation == generation)) return drawn;
        }
    }

    bool rests(Clock::duration patience = 240s)
    {
        auto until = Clock::now() + patience;
        while (thread.status().busy && Clock::now() < until) std::this_thread::sleep_for(1ms);
        return !thread.status().busy;
    }

    RenderThread thread;

private:
    std::uint64_t generation_ = 0;
};

double processor_seconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string word_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::string text;
    std::getline(file, text);
    return text;
}

TEST(RenderThread, shows_a_coarse_picture_then_the_one_of_the_cpu)
{
    PictureRequest request = request_of(program_of(balls(60)), 640, 360);
    Desk desk(Device::cpu);
    std::uint64_t generation = desk.ask(request);
    std::optional<DrawnPicture> first = desk.next_of<DrawnPicture>();
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->final);
    EXPECT_GT(first->divisor, 1);
    EXPECT_EQ(first->picture->width, divided(request.frame, first->divisor).width);
    EXPECT_EQ(first->frame->width, first->picture->width);
    std::optional<DrawnPicture> last = desk.final_picture(generation);
    ASSERT_TRUE(last);
    Frame frame = render_on_cpu(*request.program, request.frame);
    EXPECT_EQ(last->picture->rgb, picture(frame, View::beauty, request.program->march.step_limit).rgb);
    EXPECT_EQ(last->frame->node_id, frame.node_id);
    EXPECT_EQ(last->device, Device::cpu);
    StepStatistics steps = step_statistics(frame);
    EXPECT_EQ(last->steps.mean, steps.mean);
    EXPECT_EQ(last->steps.largest, *std::max_element(frame.steps.begin(), frame.steps.end()));
    EXPECT_EQ(desk.thread.status().links, 0);
}

TEST(RenderThread, shows_every_view_and_anaglyphs_as_the_command_line_does)
{
    PictureRequest request = request_of(program_of(balls(3)), 160, 90);
    Frame centre = render_on_cpu(*request.program, request.frame);
    request.frame.eye = Eye::left;
    Frame left = render_on_cpu(*request.program, request.frame);
    request.frame.eye = Eye::right;
    Frame right = render_on_cpu(*request.program, request.frame);
    request.frame.eye = Eye::centre;
    Desk desk(Device::cpu);
    auto expect_shown = [&](const Display& display) {
        request.display = display;
        bool flat = display.stereo == Stereo::off;
        std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request));
        ASSERT_TRUE(drawn);
        EXPECT_EQ(drawn->picture->rgb, picture(flat ? centre : left, right, display, 256).rgb)
            << kind_of(display.view).name << " " << mode_of(display.stereo).name;
        EXPECT_EQ(drawn->right_frame == nullptr, flat);
        EXPECT_EQ(drawn->fighting_share.has_value(), mode_of(display.stereo).layout == StereoLayout::mixed);
    };
    for (std::size_t i = 0; i < view_names().size(); ++i)
        if (!views()[i].layers) expect_shown({.view = static_cast<View>(i)});
    for (std::size_t i = 0; i < stereo_modes().size(); ++i) expect_shown({.stereo = static_cast<Stereo>(i)});
    expect_shown({.stereo = Stereo::dubois, .swap_eyes = true, .split = 0.3f, .rivalry = true});
}

TEST(RenderThread, draws_slices_on_the_cpu_and_goes_back_to_rays)
{
    PictureRequest request = request_of(program_of(balls(3)), 160, 90);
    Desk desk(Device::automatic);
    ASSERT_TRUE(desk.final_picture(desk.ask(request)));
    request.frame.slice = Slice{};
    request.display.view = View::slice;
    std::optional<DrawnPicture> slice = desk.final_picture(desk.ask(request));
    ASSERT_TRUE(slice);
    EXPECT_TRUE(slice->of_slice);
    EXPECT_EQ(slice->device, Device::cpu);
    EXPECT_EQ(slice->picture->rgb, picture(render_on_cpu(*request.program, request.frame), View::slice, 256).rgb);
    request.frame.slice.reset();
    request.display.view = View::beauty;
    EXPECT_FALSE(desk.final_picture(desk.ask(request))->of_slice);
}

TEST(RenderThread, counts_what_a_picture_takes)
{
    PictureRequest request = request_of(program_of(balls(3)), 160, 90);
    Desk desk(Device::cpu);
    std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request));
    ASSERT_TRUE(drawn);
    std::vector<int> steps = render_on_cpu(*request.program, request.frame).steps;
    std::sort(steps.begin(), steps.end());
    EXPECT_EQ(drawn->steps.p99,
              steps[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(steps.size()))) - 1]);
    EXPECT_GE(drawn->steps.evaluations, std::accumulate(steps.begin(), steps.end(), std::int64_t{0}))
        << "the eyes' steps, and normals and shadows besides";
}

TEST(RenderThread, lets_the_newest_request_win)
{
    PictureRequest slow = request_of(program_of(balls(200)), 1920, 1080),
                   quick = request_of(program_of(balls(1)), 64, 36);
    Desk desk(Device::cpu);
    desk.ask(slow);
    ASSERT_TRUE(desk.next_of<DrawnPicture>());
    auto start = Clock::now();
    std::uint64_t newest = desk.ask(quick);
    std::optional<DrawnPicture> drawn = desk.final_picture(newest);
    ASSERT_TRUE(drawn);
    EXPECT_LT(Clock::now() - start, 2s);
    EXPECT_EQ(drawn->picture->width, 64);
    EXPECT_FALSE(desk.next(100ms)) << "something came after the newest final picture";
}

TEST(RenderThread, grows_a_slow_picture_before_the_eyes)
{
    Desk desk(Device::cpu);
    desk.ask(request_of(program_of(balls(200)), 1280, 720));
    int growing = 0;
    for (std::optional<DrawnPicture> drawn; (drawn = desk.next_of<DrawnPicture>()) && !drawn->final;)
        growing += drawn->picture->width > drawn->frame->width ? 1 : 0;
    EXPECT_GE(growing, 1);
}

TEST(RenderThread, links_nothing_while_a_hand_moves_something)
{
    Desk desk(Device::automatic);
    desk.ask(request_of(program_of(balls(8, 0.4f)), 320, 180));
    ASSERT_TRUE(desk.next_of<DrawnPicture>());
    desk.rests();
    int links = desk.thread.status().links, pictures = 0;
    for (int i = 0; i < 30; ++i) {
        float amount = 0.01f * static_cast<float>(i);
        PictureRequest request = request_of(program_of(balls(8, 0.3f + amount)), 320, 180);
        request.frame.camera = ViewCamera{.position = {4 + amount, 3, 6}};
        desk.ask(request, true);
        while (desk.next_of<DrawnPicture>(16ms)) ++pictures;
    }
    EXPECT_GE(pictures, 5);
    EXPECT_EQ(desk.thread.status().links, links);
}

TEST(RenderThread, on_the_gpu_shows_the_picture_of_the_gpu)
{
    PictureRequest request = request_of(program_of(balls(8)), 320, 180);
    request.frame.camera = ViewCamera{.position = {1, 2, 7}};
    Desk desk(Device::gpu);
    std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request));
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->device, Device::gpu);
    GpuDevice gpu;
    EXPECT_EQ(drawn->picture->rgb, picture(gpu.render(*request.program, request.frame), View::beauty, 256).rgb);
    request.frame.camera->position.x = 2;
    EXPECT_TRUE(desk.final_picture(desk.ask(request)));
    EXPECT_EQ(desk.thread.status().links, 1);
}

// A node that no kernel was compiled for, so that only the GPU can draw it.
Scene edited_sphere(const std::string& statement)
{
    std::map<std::string, std::string> texts = graph::embedded_texts();
    std::string& text = texts.at("nodes/primitive/sphere.glsl");
    text.replace(text.find("return length(p)"), 6, statement + " return");
    Scene s(graph::Library::from_texts(texts, graph::embedded_texts()));
    s.show(s.node("sphere"));
    s.node("sun");
    return s;
}

TEST(RenderThread, draws_what_only_the_gpu_can)
{
    ProgramPointer program = program_of(edited_sphere("p.x = p.x * 1.5f;"));
    ASSERT_TRUE(program->gpu_only);
    Desk desk(Device::automatic);
    std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request_of(program, 64, 36)));
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->device, Device::gpu);
}

TEST(RenderThread, says_that_there_is_no_gpu_for_what_only_the_gpu_can_draw)
{
    Desk desk(Device::cpu);
    desk.ask(request_of(program_of(edited_sphere("p.x = p.x * 1.5f;")), 64, 36));
    std::optional<Failed> failed = desk.next_of<Failed>();
    ASSERT_TRUE(failed);
    EXPECT_NE(failed->sentence.find("GPU"), std::string::npos);
    EXPECT_TRUE(desk.final_picture(desk.ask(request_of(program_of(balls(1)), 64, 36))));
}

TEST(RenderThread, reports_a_broken_shader_for_each_request_and_lives)
{
    ProgramPointer broken = program_of(edited_sphere("p.x = nothing_like_this;"));
    Desk desk(Device::automatic);
    std::uint64_t generation = desk.ask(request_of(broken, 64, 36));
    std::optional<CompileFailed> failed = desk.next_of<CompileFailed>();
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->generation, generation);
    EXPECT_NE(failed->log.find("nothing_like_this"), std::string::npos) << failed->log;
    EXPECT_NE(failed->log.find("nodes/primitive/sphere.glsl:"), std::string::npos) << failed->log;
    generation = desk.ask(request_of(broken, 65, 36));
    failed = desk.next_of<CompileFailed>();
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->generation, generation);
    EXPECT_TRUE(desk.final_picture(desk.ask(request_of(program_of(balls(1)), 64, 36))));
}

TEST(RenderThread, ends_at_once_in_the_midst_of_a_picture)
{
    for (Device device : {Device::cpu, Device::automatic}) {
        auto desk = std::make_unique<Desk>(device);
        desk->ask(request_of(program_of(balls(200)), 1920, 1080));
        ASSERT_TRUE(desk->next_of<DrawnPicture>());
        std::this_thread::sleep_for(50ms);
        auto start = Clock::now();
        desk.reset();
        EXPECT_LT(Clock::now() - start, 1s);
    }
}

TEST(RenderThread, lets_its_owner_wait_for_a_picture_but_not_for_long)
{
    Desk desk(Device::cpu);
    std::uint64_t generation = desk.ask(request_of(program_of(balls(8)), 320, 180));
    auto start = Clock::now();
    desk.thread.wait(generation, 60);
    EXPECT_LT(Clock::now() - start, 30s);
    std::optional<RenderResult> result = desk.thread.poll();
    ASSERT_TRUE(result && std::holds_alternative<DrawnPicture>(*result));
    EXPECT_EQ(std::get<DrawnPicture>(*result).generation, generation);
    desk.rests();
    desk.thread.poll();
    start = Clock::now();
    desk.thread.wait(generation + 1, 0.02);
    EXPECT_GE(Clock::now() - start, 20ms);
}

TEST(RenderThread, rests_when_the_picture_is_there)
{
    Desk desk(Device::automatic);
    ASSERT_TRUE(desk.final_picture(desk.ask(request_of(program_of(balls(8)), 320, 180))));
    ASSERT_TRUE(desk.rests());
    std::this_thread::sleep_for(50ms);
    double before = processor_seconds();
    std::this_thread::sleep_for(300ms);
    EXPECT_LT(processor_seconds() - before, 0.010);
    EXPECT_FALSE(desk.thread.poll() && desk.thread.poll()) << "pictures go on";
}

TEST(RenderThread, adds_samples_to_a_finished_picture_and_then_rests)
{
    for (Device device : {Device::cpu, Device::gpu}) {
        PictureRequest request = request_of(program_of(balls(8)), 320, 180);
        request.exposure.samples = 12;
        Desk desk(device);
        desk.ask(request);
        std::optional<DrawnPicture> drawn = desk.next_of<DrawnPicture>();
        int least = 0;
        for (; drawn && drawn->samples < 12; drawn = desk.next_of<DrawnPicture>()) {
            EXPECT_GE(drawn->samples, least);
            EXPECT_TRUE(drawn->samples == 1 || drawn->final);
            least = drawn->samples;
        }
        ASSERT_TRUE(drawn);
        GpuDevice gpu;
        auto draw = [&](int sample) {
            FrameRequest frame = sample_of(request.frame, request.exposure, sample);
            return device == Device::gpu ? gpu.render(*request.program, frame) : render_on_cpu(*request.program, frame);
        };
        Accumulator sums;
        for (int i = 0; i < 12; ++i) sums.add(draw(i), request.exposure);
        Frame mean = draw(0);
        sums.resolve(mean, request.exposure);
        EXPECT_EQ(drawn->frame->colour, mean.colour);
        EXPECT_EQ(drawn->frame->depth, mean.depth) << "other buffers are those of the first sample";
        EXPECT_EQ(drawn->picture->rgb, picture(mean, View::beauty, 256).rgb);
        ASSERT_TRUE(desk.rests());
        double before = processor_seconds();
        std::this_thread::sleep_for(300ms);
        EXPECT_LT(processor_seconds() - before, 0.010);
        EXPECT_FALSE(desk.next(50ms)) << "pictures go on";
    }
}

TEST(RenderThread, adds_samples_to_views_of_light_and_none_to_data)
{
    PictureRequest request = request_of(program_of(balls(1)), 32, 18);
    request.exposure.samples = 12;
    for (std::string name : {"beauty", "glow", "ambient", "diffuse", "specular", "reflection", "emission"}) {
        request.display.view = *view_from_name(name);
        EXPECT_EQ(wanted_samples(request), 12) << name;
    }
    for (std::string name : {"steps", "normal", "depth", "id", "albedo", "shadow", "slice"}) {
        request.display.view = *view_from_name(name);
        EXPECT_EQ(wanted_samples(request), 1) << name;
    }
}

TEST(RenderThread, adds_no_samples_while_a_hand_moves_and_goes_on_where_it_was)
{
    PictureRequest request = request_of(program_of(balls(8)), 320, 180);
    request.exposure.samples = 3;
    Desk desk(Device::cpu);
    desk.ask(request);
    ASSERT_TRUE(desk.rests());
    request.exposure.samples = 6;
    desk.ask(request, true);
    ASSERT_TRUE(desk.rests());
    std::optional<DrawnPicture> held;
    while (std::optional<DrawnPicture> drawn = desk.next_of<DrawnPicture>(50ms)) held = drawn;
    ASSERT_TRUE(held);
    EXPECT_EQ(held->samples, 3);
    std::uint64_t generation = desk.ask(request);
    ASSERT_TRUE(desk.rests());
    while (std::optional<DrawnPicture> drawn = desk.next_of<DrawnPicture>(50ms)) held = drawn;
    EXPECT_EQ(held->samples, 6);
    EXPECT_EQ(held->generation, generation);
}

TEST(RenderThread, shows_another_look_of_the_samples_that_are_there)
{
    PictureRequest request = request_of(program_of(balls(8)), 320, 180);
    request.exposure.samples = 4;
    Desk desk(Device::cpu);
    desk.ask(request);
    ASSERT_TRUE(desk.rests());
    std::optional<DrawnPicture> first, second;
    while (std::optional<DrawnPicture> drawn = desk.next_of<DrawnPicture>(50ms)) first = drawn;
    request.display.look = {graph::ToneMap::agx, 1};
    desk.ask(request);
    ASSERT_TRUE(desk.rests());
    while (std::optional<DrawnPicture> drawn = desk.next_of<DrawnPicture>(50ms)) second = drawn;
    ASSERT_TRUE(first && second);
    EXPECT_EQ(second->samples, 4);
    EXPECT_EQ(second->frame, first->frame) << "it was drawn again";
    EXPECT_EQ(second->picture->rgb, picture(*first->frame, View::beauty, 256, request.display.look).rgb);
}

TEST(RenderThread, answers_the_same_request_with_the_same_picture)
{
    PictureRequest request = request_of(program_of(balls(8)), 320, 180);
    Desk desk(Device::cpu);
    std::optional<DrawnPicture> first = desk.final_picture(desk.ask(request));
    std::uint64_t generation = desk.ask(request);
    std::optional<DrawnPicture> second = desk.final_picture(generation);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->picture, second->picture) << "it was drawn again";
}

TEST(RenderThread, finishes_what_is_asked_for_again_and_again)
{
    PictureRequest request = request_of(program_of(balls(60)), 640, 360);
    Desk desk(Device::cpu);
    std::uint64_t generation = desk.ask(request);
    ASSERT_TRUE(desk.next_of<DrawnPicture>());
    std::optional<DrawnPicture> drawn;
    for (auto until = Clock::now() + 240s; Clock::now() < until && !(drawn && drawn->final);) {
        generation = desk.ask(request);
        if (std::optional<DrawnPicture> next = desk.next_of<DrawnPicture>(5ms)) drawn = std::move(next);
    }
    ASSERT_TRUE(drawn);
    EXPECT_TRUE(drawn->final);
    EXPECT_EQ(drawn->generation, generation);
}

TEST(RenderThread, calls_when_there_is_something_to_poll)
{
    std::atomic<int> calls = 0;
    RenderThread thread({.device = Device::cpu, .on_ready = [&] { ++calls; }});
    thread.request(request_of(program_of(balls(1)), 64, 36));
    for (auto until = Clock::now() + 10s; calls == 0 && Clock::now() < until;) std::this_thread::sleep_for(1ms);
    EXPECT_GT(calls, 0);
    EXPECT_TRUE(thread.poll());
}

TEST(RenderThread, gives_way_to_the_windows_thread)
{
    if (getpriority(PRIO_PROCESS, static_cast<id_t>(getpid())) >= 10) GTEST_SKIP() << "all threads are as low here";
    Desk desk(Device::automatic);
    ASSERT_TRUE(desk.final_picture(desk.ask(request_of(program_of(balls(60)), 320, 180))));
    std::set<std::string> seen;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string name = word_of(task.path() / "comm");
        if (!name.starts_with("render ")) continue;
        seen.insert(name);
        int thread = std::stoi(task.path().filename());
        bool compiles = name == "render gpu";
        EXPECT_EQ(getpriority(PRIO_PROCESS, static_cast<id_t>(thread)), compiles ? 19 : 10) << name;
    }
    EXPECT_TRUE(seen.contains("render cpu") && seen.contains("render gpu"));
}

// What the driver would throw in the midst of drawing comes from the callback of the GPU's thread.
TEST(RenderThread, bears_one_loss_of_the_gpu_and_goes_on_without_it_after_two)
{
    std::atomic<bool> loses = true;
    RenderThread thread({.device = Device::automatic, .on_ready = [&] {
                             if (loses.exchange(false)) throw ContextLost(1, "lost");
                         }});
    int losses = 0, failures = 0;
    bool gives_up = false;
    DrawnPicture newest;
    auto poll_until = [&](auto reached) {
        for (auto until = Clock::now() + 240s; !reached() && Clock::now() < until; std::this_thread::sleep_for(1ms))
            while (std::optional<RenderResult> result = thread.poll()) {
                if (auto* drawn = std::get_if<DrawnPicture>(&*result)) newest = *drawn;
                if (auto* lost = std::get_if<Lost>(&*result)) ++losses, gives_up = lost->gives_up;
                failures += std::holds_alternative<Failed>(*result) ? 1 : 0;
            }
        return reached();
    };
    PictureRequest gpu_only = request_of(program_of(edited_sphere("p.x = p.x * 1.5f;")), 640, 360);
    gpu_only.generation = 1;
    thread.request(gpu_only);
    EXPECT_TRUE(poll_until([&] { return losses == 1 && newest.final; }));
    EXPECT_FALSE(gives_up);
    EXPECT_EQ(newest.device, Device::gpu);

    gpu_only.frame.time = 1;
    gpu_only.generation = 2;
    std::this_thread::sleep_for(200ms);  // the call that tells of the first loss must not be taken for the second
    loses = true;
    thread.request(gpu_only);
    EXPECT_TRUE(poll_until([&] { return losses == 2; }));
    EXPECT_TRUE(gives_up);

    gpu_only.frame.time = 2;
    thread.request(gpu_only);
    EXPECT_TRUE(poll_until([&] { return failures > 0; })) << "nobody can draw this one any more";
    PictureRequest for_both = request_of(program_of(balls(2)), 64, 36);
    for_both.generation = 3;
    thread.request(for_both);
    EXPECT_TRUE(poll_until([&] { return newest.generation == 3 && newest.final; }));
    EXPECT_EQ(newest.device, Device::cpu);
    EXPECT_FALSE(thread.status().no_gpu.empty());
}

TEST(RenderThread, draws_an_edited_shading_library_on_the_gpu)
{
    std::map<std::string, std::string> texts = graph::embedded_texts();
    texts.at("render/shading.glsl") += "\n";
    Scene s(graph::Library::from_texts(texts, graph::embedded_texts()));
    s.show(s.node("sphere"));
    ASSERT_FALSE(s.program().gpu_only);
    Desk desk(Device::automatic);
    std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request_of(program_of(s), 64, 36)));
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->device, Device::gpu);
}

TEST(RenderThread, takes_the_gpu_where_it_is_faster_and_says_so)
{
    PictureRequest request = request_of(program_of(balls(2)), 2560, 1440);
    Desk desk(Device::automatic);
    ASSERT_TRUE(desk.final_picture(desk.ask(request)));
    ASSERT_TRUE(desk.rests());
    RenderStatus status = desk.thread.status();
    ASSERT_FALSE(status.gpu.empty());
    EXPECT_GT(status.cpu_ns_per_pixel, 0);
    if (status.links == 0) GTEST_SKIP() << "the CPU is fast enough here";
    EXPECT_GT(status.gpu_ns_per_pixel, 0);
    request.frame.camera = ViewCamera{};
    std::optional<DrawnPicture> drawn = desk.final_picture(desk.ask(request));
    ASSERT_TRUE(drawn);
    bool gpu_is_faster = status.gpu_ns_per_pixel < 0.5 * status.cpu_ns_per_pixel;
    EXPECT_TRUE(!gpu_is_faster || drawn->device == Device::gpu);
    EXPECT_EQ(desk.thread.status().links, status.links);
}

TEST(LossRecord, bears_one_loss_in_two_minutes)
{
    LossRecord record;
    LossRecord::Clock::time_point start{};
    EXPECT_FALSE(record.too_many(start));
    EXPECT_FALSE(record.too_many(start + 3min));
    EXPECT_TRUE(record.too_many(start + 4min));
}

TEST(Passes, go_from_what_is_affordable_to_the_full_picture)
{
    PictureRequest request = request_of(nullptr, 1280, 720);
    auto divisors = [&](double ns_per_pixel, std::optional<int> shown) {
        std::vector<int> list;
        for (const PassPlan& plan : passes(request, 1e-9 * ns_per_pixel, 0.05, shown)) list.push_back(plan.divisor);
        return list;
    };
    EXPECT_EQ(divisors(40, {}), (std::vector{1}));
    EXPECT_EQ(divisors(150, {}), (std::vector{2, 1}));
    EXPECT_EQ(divisors(2000, {}), (std::vector{8, 2, 1}));
    EXPECT_EQ(divisors(2000, 8), (std::vector{2, 1}));
    EXPECT_EQ(divisors(2000, 1), (std::vector<int>{}));
    request.display.stereo = Stereo::dubois;
    EXPECT_EQ(divisors(2000, {}), (std::vector{12, 2, 1}));
    request.interacting = true;
    EXPECT_EQ(divisors(1e6, {}), (std::vector{16}));
}

TEST(Resized, keeps_a_ramp_a_ramp)
{
    Picture ramp{2, 1, {0, 0, 0, 200, 100, 50}};
    Picture wide = resized(ramp, 4, 3);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(wide.rgb[3 * (4 * row + x)], (std::array{0, 50, 150, 200})[x]);
    EXPECT_EQ(resized(ramp, 2, 1).rgb, ramp.rgb);
}

}  // namespace
}  // namespace fieldwright::tests

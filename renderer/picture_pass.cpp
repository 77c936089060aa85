// Draws the eyes of a request, encodes part by part, and shows what is there now and then.
#include "renderer/picture_pass.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>

namespace fieldwright::renderer {
namespace {

constexpr auto show_interval = std::chrono::milliseconds(150);
constexpr double slice_share = 1.0 / 20;  // of the time of a ray that a distance slice takes for a pixel
constexpr double worth_a_half = 0.4;      // s; a full picture that takes less needs no half one before it

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

// Where a sample of the smaller picture lies, by pixel of the larger one: index of the first of two, and the second's share.
struct Sample {
    int first, second;
    float share;
};

std::vector<Sample> samples(int from, int to)
{
    std::vector<Sample> result;
    for (int i = 0; i < to; ++i) {
        float x = (static_cast<float>(i) + 0.5f) * static_cast<float>(from) / static_cast<float>(to) - 0.5f;
        float inside = std::clamp(x, 0.0f, static_cast<float>(from - 1));
        int first = static_cast<int>(inside);
        result.push_back({first, std::min(first + 1, from - 1), inside - static_cast<float>(first)});
    }
    return result;
}

void resize_row(unsigned char* to, const Picture& from, const Sample& row, const std::vector<Sample>& columns)
{
    const unsigned char* upper =
        &from.rgb[static_cast<std::size_t>(row.first) * static_cast<std::size_t>(from.width) * 3];
    const unsigned char* lower =
        &from.rgb[static_cast<std::size_t>(row.second) * static_cast<std::size_t>(from.width) * 3];
    for (const Sample& column : columns) {
        for (int k = 0; k < 3; ++k) {
            auto across = [&](const unsigned char* line) {
                auto a = static_cast<float>(line[3 * column.first + k]),
                     b = static_cast<float>(line[3 * column.second + k]);
                return a + column.share * (b - a);
            };
            float top = across(upper);
            *to++ = static_cast<unsigned char>(top + row.share * (across(lower) - top) + 0.5f);
        }
    }
}

// The least number of steps that the share of the pixels does not exceed.
int percentile(const std::vector<std::size_t>& pixels_by_steps, std::size_t pixels, double share)
{
    auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(pixels)));
    std::size_t seen = 0;
    for (std::size_t steps = 0; steps < pixels_by_steps.size(); ++steps)
        if ((seen += pixels_by_steps[steps]) >= wanted) return static_cast<int>(steps);
    return 0;
}

std::optional<double> fights(const Frame& frame, const Display& display)
{
    if (mode_of(display.stereo).layout != StereoLayout::mixed) return std::nullopt;
    return fighting_share(frame, display.stereo, display.stereo_space);
}

}  // namespace

Picture resized(const Picture& picture, int width, int height)
{
    Picture result{width, height,
                   std::vector<unsigned char>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    const std::vector<Sample> rows = samples(picture.height, height), columns = samples(picture.width, width);
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t y) {
        resize_row(&result.rgb[y * static_cast<std::size_t>(width) * 3], picture, rows[y], columns);
    });
    return result;
}

StepStatistics step_statistics(const Frame& frame)
{
    StepStatistics statistics;
    auto pixels = static_cast<double>(std::max<std::size_t>(frame.steps.size(), 1));
    std::int64_t sum = 0, exhausted = 0;
    std::vector<std::size_t> pixels_by_steps;
    for (int steps : frame.steps) {
        sum += steps;
        auto index = static_cast<std::size_t>(std::max(steps, 0));
        if (index >= pixels_by_steps.size()) pixels_by_steps.resize(index + 1);
        ++pixels_by_steps[index];
    }
    statistics.largest = std::max(static_cast<int>(pixels_by_steps.size()) - 1, 0);
    statistics.p99 = percentile(pixels_by_steps, frame.steps.size(), 0.99);
    statistics.evaluations = frame.evaluations;
    for (unsigned char flag : frame.exhausted) exhausted += flag;
    statistics.mean = static_cast<double>(sum) / pixels;
    statistics.exhausted = static_cast<double>(exhausted) / pixels;
    return statistics;
}

std::vector<PassPlan> passes(const PictureRequest& request, double seconds_per_pixel, double seconds,
                             std::optional<int> shown_divisor)
{
    if (request.frame.slice) seconds_per_pixel *= slice_share;
    double per_pixel = is_stereo(request) ? 2 * seconds_per_pixel : seconds_per_pixel;
    int coarse = affordable_divisor(request.frame, per_pixel, seconds);
    double full_seconds = per_pixel * static_cast<double>(pixel_count(request.frame));
    std::vector<PassPlan> all = {{coarse, true}};
    if (!request.interacting && coarse > 2 && full_seconds > worth_a_half) all.push_back({2, false});
    if (!request.interacting && coarse > 1) all.push_back({1, false});
    std::erase_if(all, [&](const PassPlan& plan) { return shown_divisor && plan.divisor >= *shown_divisor; });
    return all;
}

std::optional<int> show_again(RenderDesk& desk, Device device, const Job& job)
{
    const PictureRequest& request = *job.request;
    RenderDesk::Shown shown = desk.shown();
    if (!shown.request || !same_frames(*shown.request, request)) return std::nullopt;
    if (!same_content(*shown.request, request)) {
        const Frame& left = *shown.picture.frame;
        const Frame& right = shown.picture.right_frame ? *shown.picture.right_frame : left;
        shown.picture.fighting_share = fights(left, request.display);
        shown.picture.picture =
            std::make_shared<const Picture>(picture(left, right, request.display, request.program->march.step_limit));
    }
    int divisor = shown.picture.divisor;
    desk.deliver(device, job, std::move(shown.picture), true);
    return divisor;
}

std::shared_ptr<Frame> FramePool::take(const FrameRequest& request)
{
    auto is_free = [](const std::shared_ptr<Frame>& frame) { return frame.use_count() == 1; };
    auto fits = [&](const std::shared_ptr<Frame>& frame) {
        return is_free(frame) && frame->width == request.width && frame->height == request.height &&
               frame->layers.has_value() == request.layers;
    };
    auto found = std::find_if(frames_.begin(), frames_.end(), fits);
    std::atomic_thread_fence(std::memory_order_acquire);  // after the reads of those who let go of it
    if (found != frames_.end()) return *found;
    auto oldest = std::find_if(frames_.begin(), frames_.end(), is_free);
    if (frames_.size() >= capacity && oldest != frames_.end()) frames_.erase(oldest);
    frames_.push_back(std::make_shared<Frame>(request.width, request.height, request.layers));
    return frames_.back();
}

PicturePass::PicturePass(RenderDesk& desk, FramePool& frames, Device device, const Job& job, PassPlan plan)
    : desk_(desk),
      frames_(frames),
      device_(device),
      job_(job),
      plan_(plan),
      request_(divided(job.request->frame, plan.divisor)),
      encoder_(job.request->display, job.request->program->march.step_limit),
      left_(frames.take(request_)),
      base_(desk.shown()),
      last_shown_(Clock::now())
{
    request_.sky = shows_sky(job.request->exposure);
    if (base_.request && !same_content(*base_.request, *job.request)) base_ = {};
    glm::ivec2 size = encoder_.size_px({request_.width, request_.height});
    picture_ = std::make_shared<Picture>(base_.request ? resized(*base_.picture.picture, size.x, size.y)
                                                       : blank_picture(size));
}

bool PicturePass::stops() const
{
    if (plan_.coarse) return desk_.stops_coarse(device_, job_);
    desk_.wait_for_window();
    return desk_.stops_fine(device_, job_);
}

std::optional<double> PicturePass::draw(const DrawFrame& draw_frame)
{
    auto start = Clock::now();
    if (!draw_eyes(draw_frame)) return std::nullopt;
    double seconds = seconds_between(start, Clock::now());
    desk_.deliver(device_, job_, finished(seconds), true);
    return seconds;
}

// Parts are encoded as the last eye's come in.
bool PicturePass::draw_eyes(const DrawFrame& draw_frame)
{
    const graph::Program& program = *job_.request->program;
    Watch watch{.cancelled = [this] { return stops(); }};
    const Exposure& exposure = job_.request->exposure;
    const Area whole = drawn_area(request_);
    left_->alpha.clear();
    if (is_stereo(*job_.request)) {
        request_.eye = Eye::left;
        if (!draw_frame(*left_, program, request_, watch)) return false;
        lay_backdrop(*left_, whole, exposure, whole);
        request_.eye = Eye::right;
        right_ = frames_.take(request_);
        right_->alpha.clear();
    }
    watch.part_drawn = [&](const Frame&, const Area& area) {
        lay_backdrop(right_ ? *right_ : *left_, area, exposure, whole);
        encode(area);
        if (base_.request) show_growing();
    };
    return draw_frame(right_ ? *right_ : *left_, program, request_, watch);
}

void PicturePass::encode(const Area& area)
{
    std::shared_lock lock(picture_mutex_);
    encoder_.encode(*picture_, area, *left_, right_ ? *right_ : *left_);
}

// Who comes too often or while parts are encoded leaves it to the next.
void PicturePass::show_growing()
{
    Clock::time_point last = last_shown_, now = Clock::now();
    if (now - last < show_interval) return;
    std::unique_lock lock(picture_mutex_, std::try_to_lock);
    if (!lock || !last_shown_.compare_exchange_strong(last, now)) return;
    auto copy = std::make_shared<const Picture>(*picture_);
    lock.unlock();
    DrawnPicture growing = base_.picture;
    growing.picture = std::move(copy);
    growing.final = false;
    growing.device = device_;
    desk_.deliver(device_, job_, std::move(growing), false);
}

DrawnPicture PicturePass::finished(double seconds) const
{
    DrawnPicture drawn;
    drawn.picture = picture_;
    drawn.frame = left_;
    drawn.right_frame = right_;
    drawn.device = device_;
    drawn.divisor = plan_.divisor;
    drawn.final = plan_.divisor == 1;
    drawn.ms = 1e3 * seconds;
    drawn.of_slice = request_.slice.has_value();
    drawn.steps = step_statistics(*left_);
    if (right_) drawn.steps.evaluations += right_->evaluations;
    drawn.fighting_share = fights(*left_, job_.request->display);
    return drawn;
}

}  // namespace fieldwright::renderer

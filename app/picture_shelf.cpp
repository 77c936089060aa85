// Reading, baking and keeping, on the caller's thread or one of its own.
#include "app/picture_shelf.h"

#include "assets/panorama_bake.h"
#include "graph/problem.h"
#include "renderer/low_priority.h"

#include <algorithm>
#include <chrono>

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t images_kept = 32;
constexpr auto look_again = std::chrono::seconds(1);  // at the files

std::string subject_of(const fs::path& file) { return "the picture " + file.filename().string(); }

std::shared_ptr<const graph::BakedImage> none_because(std::string sentence)
{
    return std::make_shared<const graph::BakedImage>(graph::BakedImage{{}, std::move(sentence)});
}

bool is_panorama(const graph::ImageRequest& request) { return request.part == graph::panorama; }

// A few pixels of a drawing for each sample of its edge, one for each of a panorama's light.
assets::PictureQuestion question_of(const graph::ImageRequest& request)
{
    if (is_panorama(request)) return {assets::PixelScale::light, request.detail};
    return {assets::PixelScale::shown, assets::pixels_wanted(request.detail)};
}

}  // namespace

fs::path picture_path(const graph::ImageRequest& request, const fs::path& folder)
{
    return (folder / fs::path(request.path)).lexically_normal();
}

const assets::PictureAnswer& ImageMaker::read(const fs::path& file, const assets::PictureQuestion& question,
                                              const std::optional<FileStamp>& stamp, const std::stop_token& stop)
{
    auto known = std::find_if(read_.begin(), read_.end(), [&](const Read& read) {
        return read.file == file && read.question == question && read.stamp == stamp && read.answer;
    });
    if (known != read_.end()) {
        read_.splice(read_.begin(), read_, known);
        return read_.front().answer;
    }
    assets::PictureAnswer answer =
        assets::read_picture(worker_, assets::picture_bytes(file), subject_of(file), question, stop);
    read_.push_front({file, question, stamp, std::move(answer)});
    if (read_.size() > files_kept) read_.pop_back();
    return read_.front().answer;
}

std::shared_ptr<const graph::BakedImage> ImageMaker::make(const fs::path& file, const graph::ImageRequest& request,
                                                          const std::optional<FileStamp>& stamp,
                                                          const std::stop_token& stop)
{
    try {
        const assets::PictureAnswer& answer = read(file, question_of(request), stamp, stop);
        if (!answer) return none_because(answer.sentence + "; choose another file");
        if (is_panorama(request)) return std::make_shared<const graph::BakedImage>(assets::panorama(answer.pixels));
        return std::make_shared<const graph::BakedImage>(assets::baked(answer.pixels, request, subject_of(file)));
    } catch (const graph::Failure& failure) {
        return none_because(subject_of(file) + " " + failure.what() + "; choose another file");
    } catch (const std::bad_alloc&) {
        return none_because(subject_of(file) + " needs more memory than there is; choose a smaller one");
    }
}

graph::BakedImages images_of(const graph::Document& document, const graph::Library& library, const fs::path& folder)
{
    graph::BakedImages images;
    ImageMaker maker;
    for (const graph::ImageRequest& request : graph::image_requests(document, library)) {
        fs::path file = picture_path(request, folder);
        images[request] = maker.make(file, request, file_stamp(file));
    }
    return images;
}

PictureShelf::PictureShelf(std::function<void()> on_ready, assets::Worker worker)
    : on_ready_(std::move(on_ready)),
      maker_(std::move(worker)),
      thread_([this](const std::stop_token& stop) { work(stop); })
{
}

PictureShelf::~PictureShelf() = default;  // the thread first: it is the last member

graph::BakedImages PictureShelf::images(const std::vector<graph::ImageRequest>& requests, const fs::path& folder)
{
    graph::BakedImages images;
    std::lock_guard lock(mutex_);
    wanted_.clear();
    news_ = false;
    for (const graph::ImageRequest& request : requests) {
        wanted_.push_back({picture_path(request, folder), request});
        auto found = made_.find(wanted_.back());
        if (auto image = found == made_.end() ? stand_in(wanted_.back()) : found->second.image) images[request] = image;
    }
    asked_.notify_one();
    return images;
}

bool PictureShelf::has_news() const
{
    std::lock_guard lock(mutex_);
    return news_;
}

bool PictureShelf::busy() const
{
    std::lock_guard lock(mutex_);
    return next_missing().has_value();
}

std::shared_ptr<const graph::BakedImage> PictureShelf::stand_in(const Wanted& wanted) const
{
    const Made* newest = nullptr;
    for (const auto& [made_for, made] : made_)
        if (made_for.file == wanted.file && is_panorama(made_for.request) == is_panorama(wanted.request) &&
            made.image->sentence.empty() && (!newest || made.turn > newest->turn))
            newest = &made;
    return newest ? newest->image : nullptr;
}

std::optional<PictureShelf::Wanted> PictureShelf::next_missing() const
{
    auto missing = std::find_if(wanted_.begin(), wanted_.end(), [&](const Wanted& w) { return !made_.contains(w); });
    return missing == wanted_.end() ? std::nullopt : std::optional(*missing);
}

void PictureShelf::work(const std::stop_token& stop)
{
    renderer::lower_priority("pictures", renderer::Priority::picture);
    while (!stop.stop_requested()) {
        std::optional<Wanted> wanted;
        {
            std::unique_lock lock(mutex_);
            asked_.wait_for(lock, stop, look_again, [&] { return next_missing().has_value(); });
            wanted = next_missing();
        }
        if (stop.stop_requested()) return;
        if (!wanted) {
            look_for_changes();
            continue;
        }
        // Stamped before it is read: what is written in between counts as changed.
        std::optional<FileStamp> stamp = file_stamp(wanted->file);
        std::shared_ptr<const graph::BakedImage> image = maker_.make(wanted->file, wanted->request, stamp, stop);
        if (stop.stop_requested()) return;
        {
            std::lock_guard lock(mutex_);
            made_[*wanted] = {image, stamp, ++turn_};
            forget_the_oldest();
            news_ = true;
        }
        on_ready_();
    }
}

std::vector<std::pair<PictureShelf::Wanted, std::optional<FileStamp>>> PictureShelf::shown() const
{
    std::lock_guard lock(mutex_);
    std::vector<std::pair<Wanted, std::optional<FileStamp>>> result;
    for (const Wanted& wanted : wanted_)
        if (auto found = made_.find(wanted); found != made_.end()) result.emplace_back(wanted, found->second.stamp);
    return result;
}

// What was made of a file that is another now is made again.
void PictureShelf::look_for_changes()
{
    for (const auto& [wanted, stamp] : shown()) {
        if (file_stamp(wanted.file) == stamp) continue;
        std::lock_guard lock(mutex_);
        std::erase_if(made_, [&, &file = wanted.file](const auto& entry) { return entry.first.file == file; });
    }
}

void PictureShelf::forget_the_oldest()
{
    while (made_.size() > images_kept) {
        auto oldest = made_.end();
        for (auto at = made_.begin(); at != made_.end(); ++at) {
            bool in_use = std::find(wanted_.begin(), wanted_.end(), at->first) != wanted_.end();
            if (!in_use && (oldest == made_.end() || at->second.turn < oldest->second.turn)) oldest = at;
        }
        if (oldest == made_.end()) return;
        made_.erase(oldest);
    }
}

}  // namespace fieldwright::app

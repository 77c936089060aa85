// The pictures that a scene draws from: files read by workers, made into what nodes ask for, and kept.
#pragma once

#include "app/file_stamp.h"
#include "assets/image_bake.h"
#include "graph/image_request.h"

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <thread>

namespace fieldwright::app {

// The file that a request means: a relative path is one from the scene's folder.
std::filesystem::path picture_path(const graph::ImageRequest& request, const std::filesystem::path& folder);

// Makes images one at a time; keeps the pixels of the last files, so that another level costs no reading.
class ImageMaker {
public:
    explicit ImageMaker(assets::Worker worker = assets::Worker()) : worker_(std::move(worker)) {}
    // The stamp is the file's; pixels kept of another state of it are not used.
    std::shared_ptr<const graph::BakedImage> make(const std::filesystem::path& file, const graph::ImageRequest& request,
                                                  const std::optional<FileStamp>& stamp,
                                                  const std::stop_token& stop = {});

private:
    struct Read {
        std::filesystem::path file;
        assets::PictureQuestion question;
        std::optional<FileStamp> stamp;
        assets::PictureAnswer answer;
    };
    const assets::PictureAnswer& read(const std::filesystem::path& file, const assets::PictureQuestion& question,
                                      const std::optional<FileStamp>& stamp, const std::stop_token& stop);

    static constexpr std::size_t files_kept = 4;
    assets::Worker worker_;
    std::list<Read> read_;  // the last first
};

// All that a document asks for, made here and now: for the command line. `folder` is the scene's.
graph::BakedImages images_of(const graph::Document& document, const graph::Library& library,
                             const std::filesystem::path& folder);

// For the window: hands out what is there and makes the rest on a thread of its own. Files that change are read again.
class PictureShelf {
public:
    // `on_ready` is called on that thread whenever something new is there.
    explicit PictureShelf(std::function<void()> on_ready, assets::Worker worker = assets::Worker());
    ~PictureShelf();
    PictureShelf(const PictureShelf&) = delete;
    PictureShelf& operator=(const PictureShelf&) = delete;

    // What is there of the requests; the rest is begun. Until it is there, what was last made of the same file stands
    // for it, so that a level being dragged never leaves a hole.
    graph::BakedImages images(const std::vector<graph::ImageRequest>& requests, const std::filesystem::path& folder);
    // Whether something came since `images` was last asked.
    bool has_news() const;
    bool busy() const;  // something asked for is not there yet

private:
    struct Wanted {
        std::filesystem::path file;
        graph::ImageRequest request;
        auto operator<=>(const Wanted&) const = default;
    };
    struct Made {
        std::shared_ptr<const graph::BakedImage> image;
        std::optional<FileStamp> stamp;
        std::uint64_t turn = 0;  // when it was made
    };

    void work(const std::stop_token& stop);
    std::optional<Wanted> next_missing() const;
    std::vector<std::pair<Wanted, std::optional<FileStamp>>> shown() const;
    void look_for_changes();
    std::shared_ptr<const graph::BakedImage> stand_in(const Wanted& wanted) const;
    void forget_the_oldest();

    std::function<void()> on_ready_;
    mutable std::mutex mutex_;
    std::condition_variable_any asked_;
    std::vector<Wanted> wanted_;  // by the last call of images
    std::map<Wanted, Made> made_;
    std::uint64_t turn_ = 0;
    bool news_ = false;
    ImageMaker maker_;  // of the thread
    std::jthread thread_;
};

}  // namespace fieldwright::app

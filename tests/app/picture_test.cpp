// Scenes with pictures: files read beside the window, problems said, paths kept.
#include "app/picture_paths.h"
#include "app/picture_shelf.h"
#include "app/session.h"
#include "graph/scene_file.h"
#include "tests/app/program.h"
#include "tests/support/scene.h"

#include <OpenImageIO/imageio.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

namespace fieldwright::tests {
namespace {

namespace fs = std::filesystem;

// The tests' program is no worker; the finished one is.
const assets::Worker worker{FIELDWRIGHT_BINARY};

class Pictures : public InFolder {
protected:
    // A black disc on white.
    std::string picture(const std::string& name, int side = 64, float radius = 20)
    {
        std::vector<float> grey;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                glm::vec2 off = glm::vec2(x, y) + 0.5f - 0.5f * static_cast<float>(side);
                grey.push_back(std::clamp(0.5f + glm::length(off) - radius, 0.0f, 1.0f));
            }
        auto output = OIIO::ImageOutput::create("png");
        OIIO::ImageSpec spec(side, side, 1, OIIO::TypeDesc::UINT8);
        EXPECT_TRUE(output->open(path(name), spec) && output->write_image(OIIO::TypeDesc::FLOAT, grey.data()) &&
                    output->close());
        return path(name);
    }

    // A box, and beside it an extruded image.
    std::string scene(const std::string& name, const std::string& picture_path, int detail = 64)
    {
        Scene made;
        NodeId image = made.node("image", {{"picture", picture_path}, {"detail", detail}});
        NodeId extruded = made.node("extrude", {{"d", image}});
        NodeId moved = made.node("translate", {{"d", extruded}, {"offset", glm::vec3(3, 0, 0)}});
        made.show(made.node("union", {{"a", made.node("box")}, {"b", moved}}));
        graph::save_scene(path(name), made.document, *made.library);
        return path(name);
    }

    static std::string distance(const std::string& scene, const std::string& point)
    {
        Outcome outcome = run_program("eval " + scene, point + "\n");
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return outcome.output;
    }
};

TEST_F(Pictures, are_found_from_the_scenes_folder_and_drawn)
{
    picture("disc.png");
    std::string file = scene("a.scene.json", "disc.png");
    EXPECT_EQ(run_program("check " + file).code, 0);
    EXPECT_LT(std::stof(distance(file, "3 0 0")), -0.15f);
    EXPECT_GT(std::stof(distance(file, "3.6 0.6 0")), 0.2f);  // a corner of the picture, far from the disc
}

TEST_F(Pictures, that_cannot_be_used_are_one_sentence_and_the_rest_is_drawn)
{
    std::ofstream(path("words.png")) << "no picture";
    picture("cut.png");
    fs::resize_file(path("cut.png"), 60);
    for (const auto& [name, words] : {std::pair("none.png", "the picture none.png is not there; choose another file"),
                                      std::pair("words.png",
                                                "the picture words.png is not a PNG, JPEG, HDR, EXR or "
                                                "TIFF file; choose another file"),
                                      std::pair("cut.png", "the picture cut.png is damaged")}) {
        std::string file = scene("a.scene.json", name);
        Outcome outcome = run_program("check " + file);
        EXPECT_EQ(outcome.code, 3) << name;
        EXPECT_NE(outcome.output.find(words), std::string::npos) << outcome.output;
    }
    EXPECT_NEAR(std::stof(distance(path("a.scene.json"), "0 1.5 0")), 1, 0.01f);
}

TEST_F(Pictures, fit_an_export_when_their_detail_is_low)
{
    picture("disc.png", 300, 100);
    std::string large = scene("large.scene.json", "disc.png", 256), small = scene("small.scene.json", "disc.png", 64);
    Outcome refused = run_program("export " + large + " --target glsl -o " + path("large.glsl"));
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.errors.find("lower the detail of its pictures"), std::string::npos) << refused.errors;
    EXPECT_EQ(run_program("export " + small + " --target glsl -o " + path("small.glsl")).code, 0);
}

TEST_F(Pictures, come_from_one_reading_whatever_is_asked_of_them)
{
    fs::path file = picture("disc.png");
    app::ImageMaker maker(worker);
    auto stamp = app::file_stamp(file);
    auto fifty = maker.make(file, {.path = "disc.png", .detail = 64}, stamp);
    auto start = std::chrono::steady_clock::now();
    auto forty = maker.make(file, {.path = "disc.png", .level = 40, .detail = 64}, stamp);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(100));
    EXPECT_EQ(fifty->sentence + forty->sentence, "");
    EXPECT_NE(fifty->list, forty->list);
}

// The window's shelf, and waiting for it.
class ShelfTest : public Pictures {
protected:
    ShelfTest() : shelf([this] { ++news; }, worker) {}

    graph::BakedImages settled(const graph::ImageRequest& request)
    {
        shelf.images({request}, folder_);
        auto start = std::chrono::steady_clock::now();
        while (shelf.busy() && std::chrono::steady_clock::now() - start < std::chrono::seconds(20))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return shelf.images({request}, folder_);
    }

    std::atomic<int> news = 0;
    app::PictureShelf shelf;
};

TEST_F(ShelfTest, hands_out_at_once_what_it_has_and_tells_of_the_rest)
{
    picture("disc.png");
    graph::ImageRequest request{.path = "disc.png", .detail = 64};
    EXPECT_TRUE(shelf.images({request}, folder_).empty());
    EXPECT_TRUE(shelf.busy());
    graph::BakedImages images = settled(request);
    ASSERT_EQ(images.size(), 1u);
    EXPECT_EQ(images[request]->sentence, "");
    EXPECT_GE(news, 1);
    // While another level is being made, the last one stands for it.
    graph::ImageRequest other = request;
    other.level = 30;
    EXPECT_EQ(shelf.images({other}, folder_)[other], images[request]);
    EXPECT_NE(settled(other)[other], images[request]);
}

TEST_F(ShelfTest, reads_a_file_again_that_changed_or_came)
{
    graph::ImageRequest request{.path = "disc.png", .detail = 64};
    EXPECT_EQ(settled(request)[request]->sentence, "the picture disc.png is not there; choose another file");
    picture("disc.png");
    auto start = std::chrono::steady_clock::now();
    while (!shelf.has_news() && std::chrono::steady_clock::now() - start < std::chrono::seconds(20))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(shelf.images({request}, folder_)[request]->sentence, "");
}

TEST_F(Pictures, are_named_from_the_folder_of_the_scene)
{
    EXPECT_EQ(app::stored_picture_path("/home/a/b/x.png", "/home/a/b"), "x.png");
    EXPECT_EQ(app::stored_picture_path("/home/a/pictures/x.png", "/home/a/b"), "../pictures/x.png");
    EXPECT_EQ(app::stored_picture_path("/media/disk/x.png", "/home/a/b"), "/media/disk/x.png");
    EXPECT_EQ(app::stored_picture_path("/home/a/x.png", ""), "/home/a/x.png");
    EXPECT_TRUE(app::is_picture_name("a/B.JPG"));
    EXPECT_FALSE(app::is_picture_name("a/b.scene.json"));
}

TEST_F(Pictures, are_found_again_when_the_scene_is_saved_elsewhere)
{
    picture("disc.png");
    fs::create_directories(path("other"));
    app::EditSession session(graph::Library::embedded());
    session.open(scene("a.scene.json", "disc.png"));
    session.save_as(path("other/b.scene.json"));
    EXPECT_FALSE(session.dirty());
    graph::BakedImages images = [&] {
        app::ImageMaker maker(worker);
        graph::BakedImages all;
        for (const graph::ImageRequest& request : graph::image_requests(session.document(), *session.library())) {
            EXPECT_EQ(request.path, "../disc.png");
            fs::path file = app::picture_path(request, session.folder());
            all[request] = maker.make(file, request, app::file_stamp(file));
        }
        return all;
    }();
    ASSERT_EQ(images.size(), 1u);
    EXPECT_EQ(images.begin()->second->sentence, "");
}

}  // namespace
}  // namespace fieldwright::tests

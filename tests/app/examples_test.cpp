// The examples that are built into the program.
#include "app/examples.h"

#include "graph/edits.h"
#include "graph/scene_file.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

namespace fieldwright::app {
namespace {

TEST(Examples, all_of_them_are_offered_with_words)
{
    EXPECT_EQ(examples().size(), example_files().size());
    EXPECT_GE(examples().size(), 3u);
    for (const Example& example : examples()) {
        EXPECT_FALSE(example.title.empty());
        EXPECT_TRUE(example.sentence.ends_with('.')) << example.sentence;
    }
}

TEST(Examples, are_the_scenes_of_their_files)
{
    std::shared_ptr<const graph::Library> library = graph::Library::embedded();
    for (const ExampleFile& file : example_files()) {
        std::string path = std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples/" + std::string(file.name) + ".scene.json";
        EXPECT_EQ(example_scene(file, *library), graph::open_scene(path, *library)) << file.name;
    }
}

TEST(Examples, have_pictures_of_the_shape_that_the_canvas_gives_them)
{
    for (const ExampleFile& file : example_files()) {
        int width = 0, height = 0, channels = 0;
        ASSERT_TRUE(stbi_info_from_memory(file.picture.data(), static_cast<int>(file.picture.size()), &width, &height,
                                          &channels))
            << file.name;
        EXPECT_EQ(width * 9, height * 16) << file.name;
    }
}

}  // namespace
}  // namespace fieldwright::app

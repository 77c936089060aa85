// Frames and pictures as files: what other programs find in them, and that the same pixels are the same bytes.
#include "renderer/picture_file.h"

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace fieldwright::tests {
namespace {

using namespace renderer;
using glm::vec3;

class PictureFiles : public testing::Test {
protected:
    PictureFiles() : folder_(std::filesystem::temp_directory_path() / ("picture_files_" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~PictureFiles() override { std::filesystem::remove_all(folder_); }

    std::string path(const char* name) const { return (folder_ / name).string(); }

    std::string bytes(const char* name) const
    {
        std::ifstream stream(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::filesystem::path folder_;
};

Frame some_frame(bool with_layers)
{
    Frame frame(5, 3, with_layers);
    for (std::size_t i = 0; i < frame.colour.size(); ++i) {
        auto x = static_cast<float>(i);
        frame.colour[i] = vec3(0.25f * x, 0.5f, 4.0f);
        if (i % 2 == 0) frame.depth[i] = 1.1f * x;
        frame.normal[i] = vec3(0, 1, 0);
        frame.node_id[i] = 100'003;
        frame.steps[i] = 7;
        if (with_layers) frame.layers->position[i] = vec3(x, 1.1f, -3);
    }
    return frame;
}

FileNotes notes_of(const Frame& frame)
{
    FileNotes notes;
    notes.width = 20, notes.height = 10;
    notes.part = {4, 6, frame.width, frame.height};
    notes.samples = 16;
    return notes;
}

struct Channel {
    OIIO::TypeDesc type;
    std::vector<float> values;
};

Channel channel(const std::string& path, const std::string& name)
{
    auto input = OIIO::ImageInput::open(path);
    EXPECT_TRUE(input) << OIIO::geterror();
    const OIIO::ImageSpec& spec = input->spec();
    auto found = std::find(spec.channelnames.begin(), spec.channelnames.end(), name);
    EXPECT_NE(found, spec.channelnames.end()) << name;
    if (found == spec.channelnames.end()) return {};
    int index = static_cast<int>(found - spec.channelnames.begin());
    Channel read{spec.channelformat(index), std::vector<float>(spec.image_pixels())};
    EXPECT_TRUE(input->read_image(0, 0, index, index + 1, OIIO::TypeDesc::FLOAT, read.values.data()));
    return read;
}

TEST_F(PictureFiles, of_openexr_hold_every_buffer_as_a_layer)
{
    Frame frame = some_frame(true);
    const Frame* eyes[] = {&frame};
    write_exr(path("a.exr"), eyes, notes_of(frame));
    for (const char* name : {"R", "G", "B", "A", "N.X", "N.Y", "N.Z", "albedo.R", "ambient.G", "diffuse.B",
                             "specular.R", "reflection.R", "emission.R", "shadow.Y", "occlusion.Y"})
        EXPECT_EQ(channel(path("a.exr"), name).type, OIIO::TypeDesc::HALF) << name;
    for (const char* name : {"Z", "P.X", "P.Y", "P.Z", "id.Y", "material.Y", "steps.Y", "gradient.Y", "cone.Y"})
        EXPECT_EQ(channel(path("a.exr"), name).type, OIIO::TypeDesc::FLOAT) << name;
    EXPECT_EQ(channel(path("a.exr"), "R").values[14], 3.5f);
    EXPECT_EQ(channel(path("a.exr"), "A").values[0], 1.0f);
    EXPECT_EQ(channel(path("a.exr"), "Z").values, frame.depth) << "inf where nothing was hit";
    EXPECT_EQ(channel(path("a.exr"), "id.Y").values[3], 100'003.0f);
    EXPECT_EQ(channel(path("a.exr"), "P.Y").values[3], 1.1f) << "float, not half";
}

TEST_F(PictureFiles, of_openexr_say_where_their_part_lies)
{
    Frame frame = some_frame(false);
    const Frame* eyes[] = {&frame};
    write_exr(path("a.exr"), eyes, notes_of(frame));
    auto input = OIIO::ImageInput::open(path("a.exr"));
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.x, 4);
    EXPECT_EQ(spec.y, 6);
    EXPECT_EQ(spec.full_width, 20);
    EXPECT_EQ(spec.full_height, 10);
    EXPECT_EQ(spec.get_int_attribute("fieldwright/samples"), 16);
    EXPECT_EQ(spec.get_string_attribute("compression"), "zip");
}

TEST_F(PictureFiles, of_openexr_hold_two_eyes_as_parts)
{
    Frame left = some_frame(false), right = some_frame(false);
    right.colour[0] = vec3(2);
    const Frame* eyes[] = {&left, &right};
    write_exr(path("a.exr"), eyes, notes_of(left));
    auto input = OIIO::ImageInput::open(path("a.exr"));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().get_string_attribute("view"), "left");
    ASSERT_TRUE(input->seek_subimage(1, 0));
    EXPECT_EQ(input->spec().get_string_attribute("view"), "right");
    std::vector<float> red(15);
    ASSERT_TRUE(input->read_image(1, 0, 0, 1, OIIO::TypeDesc::FLOAT, red.data()));
    EXPECT_EQ(red[0], 2.0f);
}

TEST_F(PictureFiles, of_the_same_pixels_have_the_same_bytes)
{
    Frame frame = some_frame(true);
    Picture picture = renderer::picture(frame, View::beauty, 256);
    const Frame* eyes[] = {&frame};
    auto write = [&](const std::string& name) {
        write_exr(path((name + ".exr").c_str()), eyes, notes_of(frame));
        write_hdr(path((name + ".hdr").c_str()), frame);
        for (const char* end : {".png", ".jpg"}) write_picture(path((name + end).c_str()), picture, notes_of(frame));
    };
    write("a");
    sleep(1);  // dates have seconds
    write("b");
    for (const char* end : {".exr", ".hdr", ".png", ".jpg"}) {
        std::string a = std::string("a") + end, b = std::string("b") + end;
        EXPECT_FALSE(bytes(a.c_str()).empty());
        EXPECT_TRUE(bytes(a.c_str()) == bytes(b.c_str())) << end;
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 8) << "nothing else is left";
}

TEST_F(PictureFiles, of_radiance_hold_the_light_itself)
{
    Frame frame = some_frame(false);
    write_hdr(path("a.hdr"), frame);
    EXPECT_NEAR(channel(path("a.hdr"), "R").values[14], 3.5f, 0.02f);
    EXPECT_NEAR(channel(path("a.hdr"), "B").values[14], 4.0f, 0.03f);
}

TEST_F(PictureFiles, of_png_hold_alpha_and_the_scene)
{
    Picture picture{2, 1, {200, 100, 50, 0, 0, 0}};
    picture.alpha = {128, 0};
    FileNotes notes;
    notes.scene = "{\"format\": \"fieldwright\", \"name\": \"\xc3\xa4\"}";
    write_picture(path("a.png"), picture, notes);
    auto input = OIIO::ImageInput::open(path("a.png"));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().get_string_attribute("fieldwright:graph"), notes.scene);
    EXPECT_EQ(channel(path("a.png"), "A").values, (std::vector<float>{128.0f / 255, 0}));
    std::string raw = bytes("a.png");
    EXPECT_NE(raw.find("fieldwright:graph"), std::string::npos);
}

TEST(PictureFormats, are_known_by_the_end_of_the_name)
{
    EXPECT_EQ(picture_format("a/b.PNG"), PictureFormat::png);
    EXPECT_EQ(picture_format("b.jpeg"), PictureFormat::jpeg);
    EXPECT_EQ(picture_format("b.0001.exr"), PictureFormat::exr);
    EXPECT_EQ(picture_format("b.hdr"), PictureFormat::hdr);
    EXPECT_FALSE(picture_format("b.gif"));
    EXPECT_FALSE(picture_format("png"));
}

}  // namespace
}  // namespace fieldwright::tests

// What the window writes to files of every format, and what it asks to be drawn for them.
#include "app/picture_export.h"

#include "renderer/devices.h"
#include "tests/app/program.h"
#include "tests/support/scene.h"
#include "ui/picture_formats.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <set>

namespace fieldwright::tests {
namespace {

using app::PictureExport;
using renderer::PictureRequest;
using renderer::Stereo;
using renderer::View;

struct File {
    OIIO::ImageSpec spec;
    std::vector<float> values;

    bool has(const char* channel) const
    {
        return std::find(spec.channelnames.begin(), spec.channelnames.end(), channel) != spec.channelnames.end();
    }
};

class PictureFile : public InFolder {
protected:
    PictureFile()
    {
        Scene s;
        s.show(s.node("sphere"));
        s.node("sun");
        request.program = std::make_shared<const graph::Program>(s.program());
        request.frame.width = 32, request.frame.height = 18;
        request.exposure.checkered = true;
    }

    // As the window does: asks for what the file needs, draws, writes.
    File written(const std::string& name)
    {
        PictureExport file(path(name));
        file.prepare(request);
        EXPECT_TRUE(file.suits(request)) << name;
        renderer::Frame frame = render_on_cpu(*request.program, request.frame);
        renderer::Area whole{0, 0, frame.width, frame.height};
        lay_backdrop(frame, whole, request.exposure, whole);
        renderer::DrawnPicture drawn;
        drawn.picture = std::make_shared<const renderer::Picture>(renderer::picture(frame, View::beauty, 256));
        drawn.frame = std::make_shared<const renderer::Frame>(std::move(frame));
        file.write(drawn, request);
        File read;
        auto input = OIIO::ImageInput::open(path(name));
        if (!input) return read;
        read.spec = input->spec();
        read.values.resize(read.spec.image_pixels() * static_cast<std::size_t>(read.spec.nchannels));
        EXPECT_TRUE(input->read_image(0, 0, 0, read.spec.nchannels, OIIO::TypeDesc::FLOAT, read.values.data()));
        return read;
    }

    PictureRequest request;
};

TEST_F(PictureFile, writes_the_format_that_the_name_means)
{
    for (const char* name : {"a.png", "a.jpg", "a.JPEG", "a.hdr", "a.exr"}) {
        File file = written(name);
        EXPECT_EQ(file.spec.width, 32) << name;
        EXPECT_EQ(file.spec.height, 18) << name;
    }
    EXPECT_EQ(PictureExport(path("plain")).path(), path("plain.png"));
}

TEST_F(PictureFile, draws_the_layers_that_openexr_holds)
{
    EXPECT_FALSE(PictureExport(path("a.exr")).suits(request)) << "its layers are not drawn yet";
    File file = written("a.exr");
    for (const char* channel : {"R", "A", "Z", "N.X", "P.Y", "albedo.R", "ambient.G", "id.Y", "shadow_steps.Y"})
        EXPECT_TRUE(file.has(channel)) << channel;
}

TEST_F(PictureFile, keeps_holes_where_the_format_can)
{
    request.exposure.backdrop = graph::Backdrop::transparent;
    EXPECT_TRUE(PictureExport(path("a.jpg")).suits(request)) << "a checkerboard is what a JPEG can show";
    EXPECT_FALSE(PictureExport(path("a.png")).suits(request));
    for (const char* name : {"a.png", "a.exr"}) {
        File file = written(name);
        ASSERT_GE(file.spec.nchannels, 4) << name;
        ASSERT_EQ(file.spec.channelnames[3], "A") << name;
        EXPECT_EQ(file.values[3], 0.0f) << name << ": nothing in the corner";
        std::size_t middle = 9 * 32 + 16;
        EXPECT_EQ(file.values[middle * static_cast<std::size_t>(file.spec.nchannels) + 3], 1.0f) << name;
    }
}

TEST_F(PictureFile, says_what_a_format_cannot_hold)
{
    PictureExport png(path("a.png")), hdr(path("a.hdr")), exr(path("a.exr"));
    EXPECT_EQ(png.refusal({.view = View::steps, .stereo = Stereo::off}), "");
    EXPECT_EQ(exr.refusal({.stereo = Stereo::dubois}), "");
    EXPECT_NE(hdr.refusal({.stereo = Stereo::dubois}).find("turn stereo off"), std::string::npos);
    EXPECT_NE(exr.refusal({.view = View::steps}).find("Beauty"), std::string::npos);
    try {
        PictureExport(path("a.bmp"));
        FAIL() << "a format that is none";
    } catch (const graph::Failure& failure) {
        EXPECT_STREQ(failure.what(), "No picture format ends in .bmp: end the name in .png, .jpg, .hdr or .exr");
    }
}

TEST(PictureFormats, of_the_window_are_those_of_the_renderer)
{
    std::set<renderer::PictureFormat> formats;
    for (const ui::PictureFormat& format : ui::picture_formats())
        for (std::string_view suffix : format.suffixes) {
            auto known = renderer::picture_format("a" + std::string(suffix));
            ASSERT_TRUE(known) << suffix;
            formats.insert(*known);
        }
    EXPECT_EQ(formats.size(), 4u);
}

}  // namespace
}  // namespace fieldwright::tests

// Pictures as PNG files, through OpenImageIO.
#include "renderer/picture.h"

#include "graph/problem.h"
#include "graph/scene_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace fieldwright::renderer {
namespace {

// The file's bytes. Only the pixels: no dates or program names, so that the same pixels are the same bytes.
std::vector<unsigned char> encoded_png(const std::filesystem::path& path, const Picture& picture)
{
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    bool encoded = output && output->set_ioproxy(&memory) && output->open("picture.png", spec) &&
                   output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) && output->close();
    if (!encoded)
        throw graph::Failure(5, path.string() + ": the picture cannot be encoded (" +
                                    (output ? output->geterror() : OIIO::geterror()) + "); choose a smaller --size");
    return bytes;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture)
{
    std::vector<unsigned char> bytes = encoded_png(path, picture);
    graph::save_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Picture read_png(const std::filesystem::path& path)
{
    auto refuse = [&](const std::string& reason) -> graph::Failure {
        return {3, path.string() + ": is not a picture that can be read (" + reason + "); name an 8-bit RGB PNG file"};
    };
    auto input = OIIO::ImageInput::create("png");
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec)) throw refuse(input ? input->geterror() : OIIO::geterror());
    if (spec.nchannels < 3) throw refuse("it has fewer than three channels");
    Picture picture{spec.width, spec.height, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data())) throw refuse(input->geterror());
    return picture;
}

}  // namespace fieldwright::renderer

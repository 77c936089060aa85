// Pictures as PNG files, through OpenImageIO.
#include "renderer/picture.h"

#include "graph/problem.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

namespace fieldwright::renderer {
namespace {

[[noreturn]] void refuse_write(const std::filesystem::path& path, const std::string& reason)
{
    throw graph::Failure(5, path.string() + ": the picture cannot be written (" + reason +
                                "); check the folder, its permissions and the free space");
}

// Removes the file unless it was kept under another name.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target)
        : path_(target.parent_path() / ("." + target.stem().string() + "." + std::to_string(getpid()) + ".part.png"))
    {
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // Bytes are on the disk before the name points at them.
    void keep_as(const std::filesystem::path& target)
    {
        int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
        bool synced = file >= 0 && ::fsync(file) == 0;
        if (file >= 0) ::close(file);
        std::error_code error;
        if (synced) std::filesystem::rename(path_, target, error);
        if (!synced || error) refuse_write(target, synced ? error.message() : "the disk does not take it");
        path_.clear();
    }

private:
    std::filesystem::path path_;
};

// Only the pixels: no dates or program names, so that the same pixels are the same bytes.
std::string save(const std::filesystem::path& path, const Picture& picture)
{
    auto output = OIIO::ImageOutput::create("png");
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 6);
    bool saved = output->open(path.string(), spec) &&
                 output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) && output->close();
    return saved ? std::string() : output->geterror();
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture)
{
    TemporaryFile file(path);
    if (std::string reason = save(file.path(), picture); !reason.empty()) refuse_write(path, reason);
    file.keep_as(path);
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

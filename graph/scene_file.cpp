// Scene files: opened without ever blocking, saved only when the text reads back.
#include "graph/scene_file.h"

#include "graph/json.h"
#include "graph/picture_scene.h"
#include "graph/problem.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>

namespace fieldwright::graph {
namespace {

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& sentence)
{
    throw Failure(3, path.string() + ": " + sentence);
}

std::string open_error(int error)
{
    switch (error) {
        case ENOENT: return "there is no such file; check the name";
        case EACCES:
        case EPERM: return "may not be read; check its permissions";
        case ELOOP: return "is a loop of symbolic links; name the file itself";
        case ENAMETOOLONG: return "is too long a name for a file";
        case ENOTDIR: return "lies in something that is not a folder; check the name";
        case ENXIO: return "is not a regular file; name a scene file";
        default: return std::string("cannot be opened: ") + std::strerror(error);
    }
}

// At most one byte more than a scene may have, whatever the file claims to be.
std::string read_all(int file, std::size_t expected, const std::filesystem::path& path)
{
    std::string text;
    text.resize(expected + 1);
    std::size_t size = 0;
    while (true) {
        ssize_t count = ::read(file, text.data() + size, text.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
        size += static_cast<std::size_t>(count);
        if (count == 0 || size > json_text_limit) break;
        if (size == text.size()) text.resize(std::min(2 * size, json_text_limit + 1));
    }
    text.resize(size);
    return text;
}

}  // namespace

Document open_scene(const std::filesystem::path& path, const Library& library)
{
    // Without O_NONBLOCK a FIFO would wait for its writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) refuse(path, open_error(errno));
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
    if (S_ISDIR(status.st_mode)) refuse(path, "is a folder; name a scene file in it");
    if (!S_ISREG(status.st_mode)) refuse(path, "is not a regular file; name a scene file");
    if (status.st_size > static_cast<off_t>(json_text_limit)) refuse(path, "is larger than 16 MB; split the scene");
    std::string text = read_all(file.number(), static_cast<std::size_t>(status.st_size), path);
    if (std::string_view(text).starts_with(png_signature)) {
        std::optional<std::string> scene = scene_in_png(text);
        if (!scene) refuse(path, "is a picture that keeps no scene; `render --keep-scene` makes ones that do");
        text = std::move(*scene);
    }
    return read_scene(text, library, path.string());
}

void save_scene(const std::filesystem::path& path, const Document& document, const Library& library)
{
    std::string text = write_scene(document, library);
    try {
        // A fault of the writer must not replace a good file.
        if (write_scene(read_scene(text, library), library) != text)
            throw Failure(5, "it would read back as another scene");
    } catch (const Failure& failure) {
        throw Failure(5, path.string() + ": the scene was not saved because the text is not valid: " + failure.what());
    }
    save_atomically(path, text);
}

}  // namespace fieldwright::graph

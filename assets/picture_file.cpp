// Our side of picture files: bytes off the disk, then everything else by the worker.
#include "assets/picture_file.h"

#include "assets/picture_wire.h"
#include "graph/problem.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

namespace fieldwright::assets {
namespace {

using namespace std::string_view_literals;

struct Format {
    std::string_view start, name;
};

// Radiance writes either word; TIFF is of both byte orders, in its classic and its large form.
constexpr Format formats[] = {{"\x89PNG\r\n\x1a\n"sv, "png"},
                              {"\xff\xd8\xff"sv, "jpeg"},
                              {"#?RADIANCE"sv, "hdr"},
                              {"#?RGBE"sv, "hdr"},
                              {"\x76\x2f\x31\x01"sv, "openexr"},
                              {"II*\0"sv, "tiff"},
                              {"MM\0*"sv, "tiff"},
                              {"II+\0"sv, "tiff"},
                              {"MM\0+"sv, "tiff"}};

class OpenFile {
public:
    // Not waiting, so that a pipe with no writer cannot hold us.
    explicit OpenFile(const std::filesystem::path& path)
        : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY))
    {
    }
    ~OpenFile()
    {
        if (number_ >= 0) ::close(number_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

graph::Failure unreadable(const std::string& reason) { return {3, reason}; }

std::string limit_words() { return "is larger than " + std::to_string(picture_bytes_limit >> 20) + " MB"; }

}  // namespace

std::string_view picture_format(std::string_view bytes)
{
    for (const Format& format : formats)
        if (bytes.starts_with(format.start)) return format.name;
    return {};
}

std::string picture_bytes(const std::filesystem::path& path)
{
    OpenFile file(path);
    if (file.number() < 0) {
        bool missing = errno == ENOENT || errno == ENOTDIR;
        throw unreadable(missing ? "is not there" : "cannot be opened (" + std::string(std::strerror(errno)) + ")");
    }
    struct stat facts = {};
    if (::fstat(file.number(), &facts) != 0 || !S_ISREG(facts.st_mode)) throw unreadable("is not a file");
    if (facts.st_size > picture_bytes_limit) throw unreadable(limit_words());
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(facts.st_size));
    char buffer[1 << 16];
    while (true) {
        ssize_t count = ::read(file.number(), buffer, sizeof buffer);
        if (count == 0) return bytes;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw unreadable("cannot be read (" + std::string(std::strerror(errno)) + ")");
        bytes.append(buffer, static_cast<std::size_t>(count));
        if (std::int64_t(bytes.size()) > picture_bytes_limit) throw unreadable(limit_words());
    }
}

PictureAnswer read_picture(const Worker& worker, const std::string& bytes, const std::string& subject,
                           const PictureQuestion& question, const std::stop_token& stop)
{
    WorkerJob job{std::string(picture_job), subject, text_from(question, bytes)};
    job.limits.address_bytes = std::int64_t(4) << 30;
    job.limits.answer_bytes = sizeof(float) * 4 * std::size_t(pixels_side_limit) * pixels_side_limit + 64;
    WorkerAnswer answer = worker.run(job, stop);
    if (!answer) return {answer.ending, {}, answer.sentence};
    if (auto pixels = pixels_from(answer.bytes)) return {Ending::answered, std::move(*pixels), {}};
    return {Ending::nonsense, {}, subject + " made the process that reads it answer nonsense"};
}

}  // namespace fieldwright::assets

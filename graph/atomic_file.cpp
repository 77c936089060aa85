// Replacing a file in one step, so that it is at every moment either the old or the new one.
#include "graph/problem.h"
#include "graph/scene_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <random>
#include <utility>

namespace fieldwright::graph {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& sentence)
{
    throw Failure(5, path.string() + ": was not saved: " + sentence);
}

[[noreturn]] void refuse_errno(const fs::path& path, const char* step)
{
    refuse(path, std::string(step) + ": " + std::strerror(errno));
}

template <typename Call>
auto retried(Call call)
{
    auto result = call();
    while (result < 0 && errno == EINTR) result = call();
    return result;
}

// Follows symbolic links to the file they mean, which need not exist yet.
fs::path followed(const fs::path& path)
{
    fs::path target = path;
    std::error_code error;
    for (int links = 0; links < 40; ++links) {
        if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
        fs::path next = fs::read_symlink(target, error);
        if (error) refuse(path, "its link cannot be read: " + error.message());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    refuse(path, "it is a loop of symbolic links; name the file itself");
}

// The file beside the target that becomes it; gone on every way out but `become`.
class TemporaryFile {
public:
    // `path` is the user's, for messages; `old` is the target's status, or null when there is none.
    TemporaryFile(const fs::path& path, const fs::path& target, const struct stat* old) : path_(path), target_(target)
    {
        fs::path folder = target.parent_path().empty() ? "." : target.parent_path();
        std::random_device random;
        for (int attempt = 0; attempt < 100 && file_ < 0; ++attempt) {
            temporary_ = folder / (".fieldwright-" + std::to_string(random()) + ".tmp");
            // Nobody else may read a private scene while it is being written.
            mode_t mode = old ? 0600 : 0666;
            file_ = retried(
                [&] { return ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode); });
            if (file_ < 0 && errno != EEXIST) refuse_errno(path_, "its folder takes no new file");
        }
        if (file_ < 0) refuse(path_, "its folder is full of temporary files; delete .fieldwright-*.tmp");
    }

    ~TemporaryFile()
    {
        if (file_ >= 0) ::close(file_);
        if (!temporary_.empty()) ::unlink(temporary_.c_str());
    }

    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    // Only root may give a file to another owner; for others it stays theirs.
    void copy_mode(const struct stat& old)
    {
        if (::fchown(file_, old.st_uid, old.st_gid) != 0 && errno != EPERM)
            refuse_errno(path_, "its owner cannot be kept");
        if (::fchmod(file_, old.st_mode & 07777) != 0) refuse_errno(path_, "its mode cannot be kept");
    }

    void write(std::string_view bytes)
    {
        for (std::size_t done = 0; done < bytes.size();) {
            ssize_t count = retried([&] { return ::write(file_, bytes.data() + done, bytes.size() - done); });
            if (count < 0) refuse_errno(path_, "it cannot be written");
            done += static_cast<std::size_t>(count);
        }
        if (retried([&] { return ::fsync(file_); }) != 0) refuse_errno(path_, "it cannot be synced to the disk");
    }

    void compare(std::string_view bytes) const
    {
        std::string buffer(std::size_t(1) << 16, '\0');
        std::size_t done = 0;
        while (true) {
            ssize_t count =
                retried([&] { return ::pread(file_, buffer.data(), buffer.size(), static_cast<off_t>(done)); });
            if (count < 0) refuse_errno(path_, "it cannot be read back");
            auto size = static_cast<std::size_t>(count);
            if (size == 0 && done == bytes.size()) return;
            if (size == 0 || bytes.substr(done, size) != std::string_view(buffer.data(), size))
                refuse(path_, "the disk gave back other bytes than were written");
            done += size;
        }
    }

    void become()
    {
        // close() may report what the disk only now found out; it never needs a second call.
        if (::close(std::exchange(file_, -1)) != 0 && errno != EINTR) refuse_errno(path_, "it cannot be closed");
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) refuse_errno(path_, "it cannot be put in place");
        temporary_.clear();
    }

private:
    const fs::path& path_;
    const fs::path& target_;
    fs::path temporary_;
    int file_ = -1;
};

// From here on the new file is in place, so what goes wrong is no longer a reason to report a failed save.
void sync_folder(const fs::path& target)
{
    fs::path folder = target.parent_path().empty() ? "." : target.parent_path();
    int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    retried([&] { return ::fsync(file); });
    ::close(file);
}

}  // namespace

void save_atomically(const fs::path& path, std::string_view bytes)
{
    if (path.filename().empty()) refuse(path, "it names no file");
    fs::path target = followed(path);
    struct stat status = {};
    bool exists = ::stat(target.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) refuse_errno(path, "it cannot be looked at");
    if (exists && S_ISDIR(status.st_mode)) refuse(path, "it is a folder; name a file in it");
    if (exists && !S_ISREG(status.st_mode)) refuse(path, "it is not a regular file; name another");
    if (exists && ::access(target.c_str(), W_OK) != 0) refuse_errno(path, "it may not be written");
    TemporaryFile temporary(path, target, exists ? &status : nullptr);
    temporary.write(bytes);
    if (exists) temporary.copy_mode(status);
    temporary.compare(bytes);
    temporary.become();
    sync_folder(target);
}

}  // namespace fieldwright::graph

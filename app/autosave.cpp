// Copies unsaved work and finds the copies that nobody came back for.
#include "app/autosave.h"

#include "app/state_file.h"
#include "graph/scene_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>
#include <utility>

namespace fieldwright::app {

namespace fs = std::filesystem;

namespace {

constexpr double look_interval_s = 1;
constexpr std::string_view scene_extension = ".scene.json";

std::int64_t seconds_since_1970()
{
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::string fresh_id() { return std::to_string(::getpid()) + "-" + std::to_string(std::random_device()()); }

// What a process that was killed while saving left behind; no save takes an hour.
void sweep(const fs::path& folder)
{
    std::error_code error;
    auto an_hour_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        bool temporary =
            it->path().extension() == ".tmp" && it->path().filename().string().starts_with(".fieldwright-");
        if (temporary && it->last_write_time(ignored) < an_hour_ago && !ignored) fs::remove(it->path(), ignored);
    }
}

StateJson json_of(const FileStamp& stamp)
{
    return {{"device", stamp.device}, {"inode", stamp.inode}, {"size", stamp.size}, {"modified_ns", stamp.modified_ns}};
}

FileStamp stamp_of(const StateJson& json)
{
    return {static_cast<std::uint64_t>(integer_member(json, "device")),
            static_cast<std::uint64_t>(integer_member(json, "inode")), integer_member(json, "size"),
            integer_member(json, "modified_ns")};
}

// The failure, or nothing.
std::string write_copy(const fs::path& copy, const fs::path& sidecar, const StateJson& description,
                       const graph::Document& document, const graph::Library& library)
{
    try {
        graph::save_scene(copy, document, library);
        write_state(sidecar, description);
        return {};
    } catch (const std::exception& failure) {
        return failure.what();
    }
}

}  // namespace

LifeLock::LifeLock(fs::path file) : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600))
{
    if (descriptor_ < 0) throw graph::Failure(5, file.string() + ": cannot be made: " + std::strerror(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) release();
}

LifeLock& LifeLock::operator=(LifeLock&& other) noexcept
{
    if (this != &other) {
        release();
        descriptor_ = std::exchange(other.descriptor_, -1);
    }
    return *this;
}

void LifeLock::release()
{
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

Autosave::Autosave(fs::path folder, std::function<double()> clock_s)
    : folder_(std::move(folder)), clock_s_(std::move(clock_s)), id_(fresh_id())
{
    sweep(folder_);
}

void Autosave::wait() const
{
    if (writer_.valid()) writer_.wait();
}

fs::path Autosave::file(const std::string& id, const char* extension) const { return folder_ / (id + extension); }

void Autosave::update(const EditSession& session)
{
    double now_s = clock_s_();
    if (now_s < next_look_s_ || writing()) return;
    next_look_s_ = now_s + look_interval_s;
    if (!session.dirty()) return clear();
    if (copied_ == session.document()) return changed_since_s_.reset();
    if (!changed_since_s_) changed_since_s_ = now_s;
    if (now_s - *changed_since_s_ < interval_s) return;
    changed_since_s_.reset();
    write(session);
}

// Whether the writer is still at work; takes what it says when it is not.
bool Autosave::writing()
{
    if (!writer_.valid()) return false;
    if (writer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return true;
    failure_ = writer_.get();
    if (!failure_.empty()) copied_.reset();
    return false;
}

void Autosave::write(const EditSession& session)
{
    try {
        fs::create_directories(folder_);
        fs::permissions(folder_, fs::perms::owner_all);
        if (!lock_) lock_ = LifeLock(file(id_, ".lock"));
    } catch (const std::exception& failure) {
        failure_ = failure.what();
        return;
    }
    StateJson description = {{"title", session.name()}, {"pid", ::getpid()}, {"time", seconds_since_1970()}};
    if (session.path()) description["origin"] = session.path()->string();
    if (session.stamp()) description["origin_stamp"] = json_of(*session.stamp());
    copied_ = session.document();
    writer_ = std::async(std::launch::async, [copy = file(id_, scene_extension.data()), sidecar = file(id_, ".json"),
                                              description, document = *copied_, library = session.library()] {
        return write_copy(copy, sidecar, description, document, *library);
    });
}

void Autosave::clear()
{
    if (writer_.valid()) writer_.get();
    failure_.clear();
    changed_since_s_.reset();
    if (!lock_) return;
    copied_.reset();
    remove_files(id_);
    lock_.release();
}

void Autosave::remove_files(const std::string& id) const
{
    // The lock last: a copy without one would pass for an orphan.
    for (const char* extension : {scene_extension.data(), ".json", ".lock"}) {
        std::error_code ignored;
        fs::remove(file(id, extension), ignored);
    }
}

bool Autosave::is_orphan(const std::string& id) const
{
    if (id == id_) return false;
    int lock = ::open(file(id, ".lock").c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (lock < 0) return errno == ENOENT;
    // Shared, so that two windows that look at once do not take each other for the owner.
    bool free = ::flock(lock, LOCK_SH | LOCK_NB) == 0;
    ::close(lock);
    return free;
}

Recovery Autosave::described(const std::string& id) const
{
    StateJson sidecar = read_state(file(id, ".json"));
    Recovery recovery{id,
                      file(id, scene_extension.data()),
                      {},
                      {},
                      string_member(sidecar, "title", "Untitled"),
                      integer_member(sidecar, "time")};
    fs::path origin = string_member(sidecar, "origin");
    if (origin.is_absolute()) recovery.origin = origin;
    if (sidecar.is_object() && sidecar.contains("origin_stamp"))
        recovery.origin_stamp = stamp_of(sidecar["origin_stamp"]);
    return recovery;
}

std::vector<Recovery> Autosave::recoverable() const
{
    std::vector<Recovery> recoveries;
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        std::string name = it->path().filename().string();
        if (!name.ends_with(scene_extension)) continue;
        std::string id = name.substr(0, name.size() - scene_extension.size());
        if (is_orphan(id)) recoveries.push_back(described(id));
    }
    std::sort(recoveries.begin(), recoveries.end(),
              [](const Recovery& a, const Recovery& b) { return std::tie(b.time_s, b.id) < std::tie(a.time_s, a.id); });
    return recoveries;
}

void Autosave::recover(const Recovery& recovery, EditSession& session)
{
    LifeLock lock(file(recovery.id, ".lock"));
    if (!lock) throw graph::Failure(3, recovery.title + ": another window has recovered it already");
    session.recover(recovery.copy, recovery.origin, recovery.origin_stamp);
    clear();
    id_ = recovery.id;
    lock_ = std::move(lock);
    copied_ = session.document();
}

void Autosave::discard(const Recovery& recovery)
{
    if (is_orphan(recovery.id)) remove_files(recovery.id);
}

}  // namespace fieldwright::app

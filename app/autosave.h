// A copy of unsaved work in the state folder, from which a crash is recovered.
#pragma once

#include "app/session.h"

#include <functional>
#include <future>
#include <vector>

namespace fieldwright::app {

// A copy whose program is gone.
struct Recovery {
    std::string id;
    std::filesystem::path copy;                   // a scene file
    std::optional<std::filesystem::path> origin;  // of the scene, when it had a file
    FileStamp origin_stamp;                       // of the file that the work began with
    std::string title;
    std::int64_t time_s = 0;  // of writing, since 1970
};

// A file as long as it lives is proof that this process lives: others cannot lock it.
class LifeLock {
public:
    LifeLock() = default;
    // Not held when another process holds it; graph::Failure when the file cannot be made.
    explicit LifeLock(std::filesystem::path file);
    ~LifeLock() { release(); }
    LifeLock(LifeLock&& other) noexcept { *this = std::move(other); }
    LifeLock& operator=(LifeLock&& other) noexcept;
    explicit operator bool() const { return descriptor_ >= 0; }
    void release();  // the file stays

private:
    int descriptor_ = -1;
};

// One window's copy: <id>.scene.json, a sidecar <id>.json that says what it is of, and <id>.lock.
class Autosave {
public:
    static constexpr double interval_s = 30;  // of change

    // `clock_s` never goes back. `folder` is made when it is needed.
    Autosave(std::filesystem::path folder, std::function<double()> clock_s);
    ~Autosave() { wait(); }  // the copy stays: whoever closes cleanly clears before
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    // Call each frame. Copies unsaved work on a thread of its own, and removes the copy once there is none.
    void update(const EditSession& session);
    void clear();                                            // the copy's work is saved, or the user let it go
    void wait() const;                                       // for a copy that is being written
    const std::string& failure() const { return failure_; }  // why the last copy was not written; empty when it was

    std::vector<Recovery> recoverable() const;  // newest first
    // Opens the copy as unsaved changes and goes on with it as this window's own copy. graph::Failure, then nothing changed.
    void recover(const Recovery& recovery, EditSession& session);
    void discard(const Recovery& recovery);  // only when the user said so

private:
    std::filesystem::path file(const std::string& id, const char* extension) const;
    bool is_orphan(const std::string& id) const;
    Recovery described(const std::string& id) const;
    void remove_files(const std::string& id) const;
    bool writing();
    void write(const EditSession& session);

    std::filesystem::path folder_;
    std::function<double()> clock_s_;
    std::string id_;
    LifeLock lock_;
    double next_look_s_ = 0;
    std::optional<double> changed_since_s_;
    std::optional<graph::Document> copied_;  // what the copy holds, or is being written
    std::future<std::string> writer_;        // gives the failure
    std::string failure_;
};

}  // namespace fieldwright::app

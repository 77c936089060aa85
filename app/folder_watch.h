// Tells when the shaders in a folder have changed, by looking at their stamps a few times a second.
#pragma once

#include "app/file_stamp.h"

#include <map>
#include <string>

namespace fieldwright::app {

class FolderWatch {
public:
    static constexpr double interval_s = 0.25;

    // All *.glsl files in the folder and below it.
    explicit FolderWatch(std::filesystem::path folder);

    // Call each frame. True once for each change, when two looks in a row saw the same: a file half written is left
    // alone. `now_s` never goes back.
    bool changed(double now_s);
    const std::filesystem::path& folder() const { return folder_; }

private:
    using Stamps = std::map<std::string, FileStamp>;
    Stamps look() const;

    std::filesystem::path folder_;
    Stamps reported_, seen_;
    double next_look_s_ = 0;
};

}  // namespace fieldwright::app

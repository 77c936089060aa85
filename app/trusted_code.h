// Which node texts this user wrote or allowed to run, as digests in the state folder.
#pragma once

#include "graph/own_type.h"

#include <filesystem>
#include <vector>

namespace fieldwright::app {

class TrustedCode {
public:
    static constexpr std::size_t limit = 4000;  // the latest ones

    // Reads the file; a broken one counts as empty.
    explicit TrustedCode(std::filesystem::path file);

    // Under whatever name the type goes.
    bool trusts(const graph::OwnType& type) const;
    // Writes the file, keeping what other windows added; graph::Failure, and then only this window knows.
    void trust(const std::vector<graph::OwnType>& types);

private:
    void read();

    std::filesystem::path file_;
    std::vector<std::string> digests_;  // latest last
};

// The text as it would be under one name for all.
std::string nameless(const graph::OwnType& type);

}  // namespace fieldwright::app

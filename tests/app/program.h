// Runs the finished program and collects what it says; a temporary folder for its files.
#pragma once

#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <vector>

namespace fieldwright::tests {

struct Outcome {
    int code = -1;
    std::string output, errors;
};

// `arguments` are shell words; `input` goes to stdin.
Outcome run_program(const std::string& arguments, const std::string& input = {});
// Any command line of the shell, in the same way.
Outcome run_shell(const std::string& command, const std::string& input = {});

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

std::filesystem::path source_folder();
std::vector<std::filesystem::path> example_scenes();  // sorted

// A folder of its own per test, removed with the test.
class InFolder : public testing::Test {
protected:
    InFolder();
    ~InFolder() override;
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::filesystem::path folder_;
};

}  // namespace fieldwright::tests

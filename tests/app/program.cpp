// Runs the finished program through the shell, with its streams in files.
#include "tests/app/program.h"

#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <fstream>
#include <sstream>

namespace fieldwright::tests {
namespace {

std::filesystem::path new_folder()
{
    static std::atomic<int> count = 0;
    std::string name = "fieldwright-test-" + std::to_string(getpid()) + "-" + std::to_string(count++);
    std::filesystem::path folder = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace

Outcome run_shell(const std::string& command, const std::string& input)
{
    std::filesystem::path folder = new_folder();
    write_text(folder / "in", input);
    std::string streams =
        " <" + (folder / "in").string() + " >" + (folder / "out").string() + " 2>" + (folder / "err").string();
    int status = std::system((command + streams).c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(folder / "out"),
                    read_text(folder / "err")};
    std::filesystem::remove_all(folder);
    return outcome;
}

Outcome run_program(const std::string& arguments, const std::string& input)
{
    return run_shell(std::string(FIELDWRIGHT_BINARY) + " " + arguments, input);
}

std::string read_text(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

std::filesystem::path source_folder() { return FIELDWRIGHT_SOURCE_DIR; }

std::vector<std::filesystem::path> example_scenes()
{
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "examples"))
        if (entry.path().string().ends_with(".scene.json")) scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

InFolder::InFolder() : folder_(new_folder()) {}

InFolder::~InFolder()
{
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
}

}  // namespace fieldwright::tests

// Compiles shaders with glslangValidator, a second opinion beside Mesa: one child process for many files.
#pragma once

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fieldwright::tests {

// The errors, each under its shader's file name; empty when every fragment shader compiles.
inline std::string glslang_errors(const std::vector<std::string>& shaders)
{
    namespace fs = std::filesystem;
    static int count = 0;
    fs::path folder =
        fs::temp_directory_path() / ("fieldwright-glslang-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    fs::create_directories(folder);
    for (std::size_t i = 0; i < shaders.size(); ++i)
        std::ofstream(folder / (std::to_string(i) + ".frag")) << shaders[i];
    std::string command =
        "cd " + folder.string() + " && ls *.frag | sort -n | xargs -n 200 glslangValidator > log 2>&1";
    int status = std::system(command.c_str());
    std::stringstream log;
    log << std::ifstream(folder / "log").rdbuf();
    fs::remove_all(folder);
    return status == 0 ? std::string() : "glslangValidator:\n" + log.str();
}

}  // namespace fieldwright::tests

// `eval`: distances of a scene at the points that stdin names, one per line.
#include "app/commands.h"
#include "app/scene_arguments.h"
#include "field/evaluator.h"
#include "renderer/devices.h"

#include <unistd.h>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>

namespace fieldwright::app {
namespace {

struct EvalArguments {
    SceneArguments scene;
    std::string device = "cpu";
};

// Complete lines of stdin as soon as they arrive, so that a program at the other end of a pipe gets its answers.
class Lines {
public:
    // The next batch of lines, without their ends; empty at the end of the input.
    std::vector<std::string> next()
    {
        std::vector<std::string> lines;
        while (lines.empty() && !ended_) {
            fill();
            std::size_t start = 0;
            for (std::size_t end; (end = pending_.find('\n', start)) != std::string::npos; start = end + 1)
                lines.push_back(pending_.substr(start, end - start));
            pending_.erase(0, start);
            if (ended_ && !pending_.empty()) lines.push_back(std::move(pending_));
            if (pending_.size() > 65536) throw graph::Failure(3, "stdin: a line is longer than 65536 bytes");
        }
        return lines;
    }

private:
    void fill()
    {
        std::array<char, 16384> buffer;
        ssize_t count = 0;
        do count = read(STDIN_FILENO, buffer.data(), buffer.size());
        while (count < 0 && errno == EINTR);
        if (count < 0) throw graph::Failure(3, "stdin: cannot be read");
        ended_ = count == 0;
        pending_.append(buffer.data(), static_cast<std::size_t>(count));
    }

    std::string pending_;
    bool ended_ = false;
};

void skip_space(std::string_view& text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r'))
        text.remove_prefix(1);
}

// `x y z`; nothing for a blank line or a comment.
std::optional<glm::vec3> parse_point(std::string_view text, std::int64_t number)
{
    skip_space(text);
    if (text.empty() || text.front() == '#') return std::nullopt;
    glm::vec3 point;
    for (int i = 0; i < 3; ++i) {
        auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), point[i]);
        std::size_t used = static_cast<std::size_t>(end - text.data());
        bool separated = used == text.size() || text[used] == ' ' || text[used] == '\t' || text[used] == '\r';
        if (error != std::errc() || !separated || !std::isfinite(point[i]))
            throw graph::Failure(3, "stdin:" + std::to_string(number) + ": is not a point; write three numbers, x y z");
        text.remove_prefix(used);
        skip_space(text);
    }
    if (!text.empty())
        throw graph::Failure(3, "stdin:" + std::to_string(number) + ": holds more than the three numbers x y z");
    return point;
}

void print(const std::vector<float>& distances)
{
    std::array<char, 32> digits;
    for (float distance : distances) {
        auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), distance);
        std::cout.write(digits.data(), end - digits.data()) << '\n';
    }
}

// Distances by the device that the user asked for.
class Field {
public:
    Field(const graph::Program& program, const EvalArguments& arguments)
        : program_(program), time_(arguments.scene.time)
    {
        if (arguments.device == "gpu") gpu_.emplace();
        else block_ = field::evaluate_frame(program, time_);
    }

    std::vector<float> at(const std::vector<glm::vec3>& points)
    {
        if (points.empty()) return {};
        return gpu_ ? gpu_->distances(program_, time_, points) : field::distances(program_, block_, points);
    }

private:
    const graph::Program& program_;
    float time_;
    std::optional<renderer::GpuDevice> gpu_;
    std::vector<float> block_;
};

int evaluate(const EvalArguments& arguments, const Session& session)
{
    auto [document, library] = open_document(arguments.scene, session.library());
    if (arguments.device == "gpu") require_allowed_code(arguments.scene, document);
    graph::Program program = lower_scene(arguments.scene, document, library);
    report_problems(program, document);
    Field field(program, arguments);
    Lines lines;
    std::int64_t number = 0;
    std::vector<glm::vec3> points;
    for (auto batch = lines.next(); !batch.empty() && std::cout; batch = lines.next()) {
        points.clear();
        try {
            for (const std::string& line : batch)
                if (auto point = parse_point(line, ++number)) points.push_back(*point);
        } catch (const graph::Failure&) {
            print(field.at(points));  // the good lines before the bad one are answered
            std::cout.flush();
            throw;
        }
        print(field.at(points));
        std::cout.flush();
    }
    return 0;
}

}  // namespace

void add_eval(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<EvalArguments>();
    CLI::App& command = *parser.add_subcommand("eval", "Read `x y z` lines from stdin and print the distance at each");
    add_scene(command, arguments->scene);
    command.add_option("--device", arguments->device, "Which machine evaluates")
        ->check(CLI::IsMember({"gpu", "cpu"}))
        ->capture_default_str();
    add_time(command, arguments->scene);
    add_changes(command, arguments->scene);
    add_allow_code(command, arguments->scene);
    command.callback(
        [arguments, &session] { session.action = [arguments, &session] { return evaluate(*arguments, session); }; });
}

}  // namespace fieldwright::app

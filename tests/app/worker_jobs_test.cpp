// The program as its own worker: it tries shaders that would take it along.
#include "app/worker_jobs.h"

#include "graph/library.h"
#include "tests/app/program.h"

#include <chrono>

namespace fieldwright::tests {
namespace {

const assets::Worker worker{FIELDWRIGHT_BINARY};

std::string shader(const std::string& colour)
{
    return "#version 330\nlayout(location = 0) out vec4 colour;\nvoid main()\n{\n    colour = vec4(" + colour +
           ");\n}\n";
}

app::ShaderVerdict verdict(const std::string& text, const assets::WorkerLimits& limits = app::shader_limits)
{
    return app::try_shader(worker, text, "The shader", {}, limits);
}

// Each line doubles the text: 2^40 additions.
std::string macro_bomb()
{
    std::string text = "#version 330\nlayout(location = 0) out vec4 colour;\n#define M0 + 1.0\n";
    for (int i = 1; i <= 40; ++i) {
        std::string before = "M" + std::to_string(i - 1);
        text += "#define M" + std::to_string(i) + " " + before + " " + before + "\n";
    }
    return text + "void main()\n{\n    colour = vec4(0.0 M40);\n}\n";
}

TEST(WorkerJobs, a_good_shader_is_good)
{
    app::ShaderVerdict answer = verdict(shader("0.5"));
    EXPECT_TRUE(answer.good()) << answer.log << answer.sentence;
}

TEST(WorkerJobs, a_bad_shader_comes_back_with_the_drivers_words)
{
    app::ShaderVerdict answer = verdict(shader("unheard_of"));
    EXPECT_EQ(answer.ending, assets::Ending::answered) << answer.sentence;
    EXPECT_FALSE(answer.good());
    EXPECT_NE(answer.log.find("unheard_of"), std::string::npos) << answer.log;
}

TEST(WorkerJobs, a_macro_bomb_ends_in_one_sentence_and_time)
{
    auto start = std::chrono::steady_clock::now();
    app::ShaderVerdict answer = verdict(macro_bomb(), {.memory_bytes = 512 << 20, .cpu_s = 3, .wall_s = 10});
    EXPECT_FALSE(answer.good());
    EXPECT_NE(answer.ending, assets::Ending::answered);
    EXPECT_TRUE(answer.sentence.starts_with("The shader ")) << answer.sentence;
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 15);
    EXPECT_TRUE(verdict(shader("0.5")).good());
}

TEST(WorkerJobs, the_worker_is_no_command_of_the_user)
{
    EXPECT_EQ(run_program("--help").output.find("worker"), std::string::npos);
    EXPECT_EQ(run_program("--worker").code, 2);
    EXPECT_EQ(run_program("--worker nothing 1 1 1").code, 2);
}

}  // namespace
}  // namespace fieldwright::tests

// Bad scene files: each refused in one sentence with exit code 3, soon, and without harm.
#include "graph/problem.h"
#include "graph/scene_file.h"
#include "tests/graph/small_library.h"
#include "tests/graph/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>

namespace fieldwright::graph {
namespace {

namespace fs = std::filesystem;

class BadFiles : public testing::Test {
protected:
    // The sentence, after checking that it came soon and is one line that names the file.
    std::string refusal(const fs::path& path)
    {
        auto begin = std::chrono::steady_clock::now();
        std::string sentence = "accepted";
        try {
            open_scene(path, *small_library());
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.exit_code, 3);
            sentence = failure.what();
        }
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
        EXPECT_EQ(sentence.rfind(path.string() + ":", 0), 0u) << sentence;
        EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0);
        EXPECT_LT(sentence.size(), path.string().size() + 600);
        return sentence;
    }
    std::string refusal_of_text(std::string_view text)
    {
        write_file(folder / "bad.scene.json", text);
        return refusal(folder / "bad.scene.json").substr((folder / "bad.scene.json").string().size() + 1);
    }
    std::string with_radius(const std::string& radius)
    {
        return "{\"format\": \"fieldwright\", \"version\": 1, \"graphs\": {\"root\": {\"nodes\": {\n"
               "\"1\": {\"type\": \"sphere\", \"parameters\": {\"radius\": " +
               radius + "}}}}}}";
    }

    TemporaryFolder folder;
};

#define EXPECT_SAYS(sentence, part) EXPECT_NE((sentence).find(part), std::string::npos) << (sentence)

TEST_F(BadFiles, truncated_anywhere)
{
    std::string text = with_radius("1.5");
    EXPECT_NO_THROW(read_scene(text, *small_library()));
    for (std::size_t size = 0; size < text.size(); size += 37)
        EXPECT_SAYS(refusal_of_text(text.substr(0, size)), "cut off");
    for (std::size_t size = 0; size < text.size(); ++size)
        EXPECT_THROW(read_scene(text.substr(0, size), *small_library()), Failure) << size;
}

TEST_F(BadFiles, one_wrong_byte_anywhere_is_refused_or_read_but_never_harmful)
{
    const std::string text = with_radius("1.5");
    for (std::size_t i = 0; i < text.size(); ++i)
        for (char wrong : {'\0', '"', '{', ']', ',', '\\', '9', '\xFF', '\n'}) {
            std::string changed = text;
            changed[i] = wrong;
            try {
                read_scene(changed, *small_library());
            } catch (const Failure& failure) {
                EXPECT_EQ(failure.exit_code, 3);
            }
        }
}

TEST_F(BadFiles, empty) { EXPECT_SAYS(refusal_of_text(""), "1:1: $: the text ends too early"); }

TEST_F(BadFiles, not_json_at_all)
{
    EXPECT_SAYS(refusal_of_text("hello"), "1:1: $: unexpected `hello`");
    EXPECT_SAYS(refusal_of_text(std::string_view("\x89PNG\r\n\x1a\n\0\0", 10)),
                "is a picture that keeps no scene; `render --keep-scene` makes ones that do");
}

TEST_F(BadFiles, cyclic)
{
    EXPECT_SAYS(refusal_of_text("{\"format\": \"fieldwright\", \"version\": 1, \"graphs\": {\"root\": {\"nodes\": {\n"
                                "\"1\": {\"type\": \"union\", \"inputs\": {\"a\": 1}}}}}}"),
                "2:34: $.graphs.root.nodes.1.inputs: is part of a cycle, 1 -> 1");
}

TEST_F(BadFiles, mistyped)
{
    EXPECT_SAYS(refusal_of_text(with_radius("true")),
                "2:50: $.graphs.root.nodes.1.parameters.radius: must be a number");
}

TEST_F(BadFiles, duplicate_key)
{
    EXPECT_SAYS(refusal_of_text(with_radius("1, \"radius\": 2")),
                "2:53: $.graphs.root.nodes.1.parameters.radius: is written twice");
}

TEST_F(BadFiles, numbers_that_are_none)
{
    for (const char* number :
         {"NaN", "nan", "Infinity", "-Infinity", "1e999", "1e39", "-1e39", "0x10", "1.", ".5", "+1", "--1"})
        EXPECT_SAYS(refusal_of_text(with_radius(number)), "2:5");
}

TEST_F(BadFiles, bad_utf8) { EXPECT_SAYS(refusal_of_text(with_radius("\"\xC3(\"")), "are not UTF-8"); }

TEST_F(BadFiles, a_hundred_thousand_deep)
{
    std::string deep(100'000, '[');
    EXPECT_SAYS(refusal_of_text(deep), "nested more than 32 deep");
    EXPECT_SAYS(refusal_of_text(with_radius(deep + std::string(100'000, ']'))), "nested more than 32 deep");
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    EXPECT_SAYS(refusal_of_text(objects), "nested more than 32 deep");
}

TEST_F(BadFiles, too_many_of_anything)
{
    std::string text = "{\"format\": \"fieldwright\", \"version\": 1, \"x\": [";
    for (int i = 0; i < 5'000'000; ++i) text += "{},";
    EXPECT_SAYS(refusal_of_text(text + "{}]}"), "limit of 1000000 values");
    std::string nodes;
    for (int i = 1; i <= 20'001; ++i) nodes += (i > 1 ? ",\"" : "\"") + std::to_string(i) + "\":{\"type\":\"sphere\"}";
    EXPECT_SAYS(refusal_of_text("{\"format\": \"fieldwright\", \"version\": 1, \"graphs\": {\"root\": {\"nodes\": {" +
                                nodes + "}}}}"),
                "more than 20000 nodes");
}

TEST_F(BadFiles, sixty_four_megabytes)
{
    write_file(folder / "big", "");
    fs::resize_file(folder / "big", 64u << 20);
    EXPECT_SAYS(refusal(folder / "big"), "larger than 16 MB");
}

TEST_F(BadFiles, not_a_file)
{
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    fs::create_symlink("loop", folder / "loop");
    EXPECT_SAYS(refusal(folder / "fifo"), "is not a regular file");
    EXPECT_SAYS(refusal("/dev/zero"), "is not a regular file");
    EXPECT_SAYS(refusal(folder / "loop"), "loop of symbolic links");
    EXPECT_SAYS(refusal(folder.path()), "is a folder");
    EXPECT_SAYS(refusal(folder / "none"), "no such file");
    EXPECT_SAYS(refusal(folder / "none/below"), "no such file");
    EXPECT_SAYS(refusal(folder / std::string(300, 'x')), "too long a name");
    write_file(folder / "file", "");
    EXPECT_SAYS(refusal(folder / "file/below"), "not a folder");
}

}  // namespace
}  // namespace fieldwright::graph

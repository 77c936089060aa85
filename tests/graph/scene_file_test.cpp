// Scene files: round trips, placeholders, and saving without ever losing the old file.
#include "graph/scene_file.h"

#include "graph/edits.h"
#include "tests/graph/small_library.h"
#include "tests/graph/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>

namespace fieldwright::graph {
namespace {

namespace fs = std::filesystem;

const Library& library() { return *small_library(); }

Document rich_document()
{
    Document document;
    NodeId star = add_node(document, library(), "star", {12.5f, -3});
    NodeId extrude = add_node(document, library(), "extrude");
    NodeId sphere = add_node(document, library(), "sphere");
    NodeId both = add_node(document, library(), "union");
    NodeId output = add_node(document, library(), "output");
    NodeId gone = add_node(document, library(), "sphere");
    EXPECT_EQ(remove_node(document, gone), std::nullopt);
    EXPECT_EQ(connect(document, library(), star, extrude, "d"), std::nullopt);
    EXPECT_EQ(connect(document, library(), extrude, both, "a"), std::nullopt);
    EXPECT_EQ(connect(document, library(), sphere, both, "b"), std::nullopt);
    EXPECT_EQ(connect(document, library(), both, output, "d"), std::nullopt);
    PointList points = {{0, 0.1f, 0, 0}, {1, -0.0f, -0.0f, 0}, {2, 3, 4, 5}, {1, 2, 0, 1e-20f}};
    EXPECT_EQ(set_parameter(document, library(), star, "points", points), std::nullopt);
    EXPECT_EQ(set_parameter(document, library(), star, "tint", glm::vec3(0.1f, 1.0f / 3, 1)), std::nullopt);
    EXPECT_EQ(set_parameter(document, library(), star, "filled", false), std::nullopt);
    EXPECT_EQ(rename_node(document, sphere, "the \"ball\"\n\xE2\x82\xAC"), std::nullopt);
    EXPECT_EQ(set_muted(document, sphere, true), std::nullopt);
    NodeId words = add_node(document, library(), "words");
    EXPECT_EQ(set_parameter(document, library(), words, "motto", std::string("two\n\"lines\" \xE2\x82\xAC")),
              std::nullopt);
    EXPECT_EQ(set_parameter(document, library(), words, "result", std::string("x + (")), std::nullopt);
    document.march.out_of_steps_hits = true;
    document.fog = {.colour = {0.1f, 0.2f, 0.3f}, .density = 0.05f, .start = 2, .height_falloff = 0.5f};
    document.bounces = 4;
    document.extras = {{"$schema", "\"x.json\""}, {"notes", "{\"a\":  [1,2]}"}};
    return document;
}

std::string with_nodes(const std::string& nodes, const std::string& version = "1")
{
    return "{\"format\": \"fieldwright\", \"version\": " + version + ", \"graphs\": {\"root\": {\"nodes\": {" + nodes +
           "}}}}";
}

std::string message(const std::string& text)
{
    try {
        read_scene(text, library(), "s");
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.exit_code, 3);
        return failure.what();
    }
    return "accepted";
}

TEST(scene_file, what_is_written_reads_back_equal_and_writes_the_same_text)
{
    Document document = rich_document();
    std::string text = write_scene(document, library());
    Document again = read_scene(text, library());
    EXPECT_EQ(again, document);
    EXPECT_EQ(write_scene(again, library()), text);
    EXPECT_EQ(validate(again, library()), std::nullopt);
    EXPECT_EQ(write_scene(read_scene(write_scene({}, library()), library()), library()), write_scene({}, library()));
}

TEST(scene_file, the_text_is_one_value_per_line_with_the_format_first)
{
    Document document;
    NodeId sphere = add_node(document, library(), "sphere");
    NodeId both = add_node(document, library(), "union");
    ASSERT_EQ(connect(document, library(), sphere, both, "a"), std::nullopt);
    std::string text = write_scene(document, library());
    EXPECT_EQ(text.find("{\n  \"format\": \"fieldwright\",\n  \"version\": 1,\n  \"next_id\": 3,\n  \"march\": {\n"),
              0u);
    EXPECT_NE(text.find(R"(
        "1": {
          "type": "sphere",
          "name": "",
          "position": [0, 0],
          "muted": false,
          "parameters": {
            "radius": 1.0
          },
          "inputs": {}
        },
        "2": {)"),
              std::string::npos)
        << text;
    EXPECT_TRUE(text.ends_with("}\n"));
}

TEST(scene_file, what_is_missing_takes_its_default)
{
    Document document =
        read_scene(with_nodes("\"7\": {\"type\": \"sphere\"}, \"2\": {\"type\": \"sphere\"}"), library());
    EXPECT_EQ(document.march, MarchSettings{});
    EXPECT_EQ(document.fog, FogSettings{});
    EXPECT_EQ(document.bounces, 0);
    EXPECT_EQ(document.next_id, 8);
    EXPECT_EQ(document.root.nodes.front().id, NodeId{2});
    EXPECT_EQ(std::get<float>(*document.root.nodes[0].parameter("radius")), 1.0f);
}

TEST(scene_file, line_endings_and_byte_order_mark_do_not_matter)
{
    Document document = rich_document();
    std::string text = write_scene(document, library()), windows = "\xEF\xBB\xBF";
    for (char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(read_scene(windows, library()), document);
}

TEST(scene_file, an_unknown_node_survives_byte_for_byte_with_its_wires)
{
    std::string placeholder =
        "{ \"type\" :\"gyroid\",  \"parameters\":{\"k\":1e0, \"x\": null},\n\t\"inputs\": {\"d\": 1, \"e\": {\"node\": "
        "1}, \"f\": 3} }";
    std::string text = with_nodes("\"1\": {\"type\": \"sphere\"}, \"4\": " + placeholder +
                                  ", \"5\": {\"type\": \"union\", \"inputs\": {\"a\": 4, \"b\": 1}}");
    Document document = read_scene(text, library());
    EXPECT_EQ(document.root.find({4})->unknown_source, placeholder);
    EXPECT_EQ(document.root.find({4})->input("d"), NodeId{1});
    EXPECT_EQ(document.root.find({5})->input("a"), NodeId{4});
    EXPECT_EQ(validate(document, library()), std::nullopt);
    std::string saved = write_scene(document, library());
    EXPECT_NE(saved.find("\"4\": " + placeholder + ","), std::string::npos);
    EXPECT_EQ(read_scene(saved, library()), document);
}

TEST(scene_file, edits_leave_an_unknown_node_as_it_is_but_may_remove_it)
{
    Document document =
        read_scene(with_nodes("\"1\": {\"type\": \"gyroid\"}, \"2\": {\"type\": \"sphere\"}"), library());
    EXPECT_TRUE(rename_node(document, {1}, "x"));
    EXPECT_TRUE(move_node(document, {1}, {1, 1}));
    EXPECT_TRUE(set_muted(document, {1}, true));
    EXPECT_TRUE(connect(document, library(), {2}, {1}, "d"));
    EXPECT_TRUE(set_parameter(document, library(), {1}, "k", 1.0f));
    EXPECT_EQ(remove_node(document, {1}), std::nullopt);
}

TEST(scene_file, removing_what_feeds_an_unknown_node_still_reads_back)
{
    Document document = read_scene(
        with_nodes("\"1\": {\"type\": \"sphere\"}, \"2\": {\"type\": \"gyroid\", \"inputs\": {\"d\": 1}}"), library());
    ASSERT_EQ(remove_node(document, {1}), std::nullopt);
    EXPECT_EQ(read_scene(write_scene(document, library()), library()), document);
}

TEST(scene_file, a_newer_version_opens_with_placeholders_and_keeps_its_number)
{
    Document document = read_scene(with_nodes("\"1\": {\"type\": \"gyroid\", \"new\": []}", "3"), library());
    EXPECT_EQ(document.version, 3);
    EXPECT_EQ(read_scene(write_scene(document, library()), library()), document);
    EXPECT_NE(message(with_nodes("\"1\": {\"type\": \"sphere\", \"new\": 1}", "3")).find("the scene is of version 3"),
              std::string::npos);
}

TEST(scene_file, refusals_name_the_place_and_what_to_do)
{
    auto node = [](const std::string& members) { return message(with_nodes("\n\"1\": {" + members + "}")); };
    EXPECT_EQ(node("\"type\": \"sphere\", \"parameters\": {\"radius\": \"big\"}"),
              "s:2:50: $.graphs.root.nodes.1.parameters.radius: must be a number; write e.g. 1.0");
    EXPECT_EQ(node("\"type\": \"sphere\", \"parameters\": {\"radius\": 0}"),
              "s:2:50: $.graphs.root.nodes.1.parameters.radius: must lie between 0.01 and 10 m");
    EXPECT_EQ(
        node("\"type\": \"sphere\", \"parameters\": {\"radios\": 1}"),
        "s:2:40: $.graphs.root.nodes.1.parameters.radios: is not a parameter of `sphere`; its parameters are `radius`");
    EXPECT_NE(node("\"type\": \"sphere\", \"colour\": 1").find("$.graphs.root.nodes.1.colour: is not known here"),
              std::string::npos);
    EXPECT_NE(node("\"type\": \"sphere\", \"position\": [0]").find("position: must be two numbers"), std::string::npos);
    EXPECT_NE(node("\"type\": \"sphere\", \"inputs\": {\"radius\": 9}").find("there is no node 9"), std::string::npos);
    EXPECT_NE(node("\"type\": \"paint\", \"parameters\": {\"material\": 1}").find("wire a material to it"),
              std::string::npos);
    EXPECT_NE(node("\"type\": \"star\", \"parameters\": {\"corners\": 3.5}").find("must be a whole number"),
              std::string::npos);
    EXPECT_NE(
        node("\"type\": \"star\", \"parameters\": {\"points\": [[1]]}").find("parameters.points[0]: must be a point"),
        std::string::npos);
    EXPECT_NE(node("\"type\": \"star\", \"parameters\": {\"style\": \"oval\"}").find("must be one of: sharp, round"),
              std::string::npos);
    EXPECT_NE(node("\"name\": \"x\"").find("$.graphs.root.nodes.1: lacks its member `type`"), std::string::npos);
    EXPECT_NE(message(with_nodes("\"01\": {\"type\": \"sphere\"}")).find("is not an id"), std::string::npos);
    EXPECT_NE(message("[]").find("must be an object"), std::string::npos);
    EXPECT_NE(message("{\"format\": \"gltf\", \"version\": 1}").find("another kind of file"), std::string::npos);
    EXPECT_NE(message("{\"format\": \"fieldwright\", \"version\": 0}").find("$.version: must be 1"), std::string::npos);
    std::string low =
        "{\"format\": \"fieldwright\", \"version\": 1, \"next_id\": 1, \"graphs\": {\"root\": {\"nodes\": {\"1\": "
        "{\"type\": \"sphere\"}}}}}";
    EXPECT_NE(message(low).find("$.next_id: must be larger than every id; the largest is 1"), std::string::npos);
    std::string flat =
        "{\"format\": \"fieldwright\", \"version\": 1, \"march\": {\"near\": 200}, \"graphs\": {\"root\": {\"nodes\": "
        "{}}}}";
    EXPECT_NE(message(flat).find("$.march.near: must be smaller than far"), std::string::npos);
    auto with = [](const std::string& setting) {
        return message("{\"format\": \"fieldwright\", \"version\": 1, " + setting +
                       ", \"graphs\": {\"root\": {\"nodes\": {}}}}");
    };
    EXPECT_NE(with("\"bounces\": 9").find("$.bounces: must lie between 0 and 8"), std::string::npos);
    EXPECT_NE(with("\"fog\": {\"density\": -1}").find("$.fog.density: must lie between 0 and 1000"), std::string::npos);
    EXPECT_NE(with("\"fog\": {\"colour\": [1, 1, -1]}").find("$.fog.colour: must lie between"), std::string::npos);
    EXPECT_NE(with("\"fog\": {\"mist\": 1}").find("is not known here"), std::string::npos);
}

TEST(scene_file, without_fog_and_bounces_the_text_names_neither)
{
    std::string text = write_scene({}, library());
    EXPECT_EQ(text.find("fog"), std::string::npos);
    EXPECT_EQ(text.find("bounces"), std::string::npos);
}

TEST(scene_file, cycles_and_mixed_dimensions_are_refused_with_their_nodes)
{
    std::string cycle = with_nodes(
        "\"1\": {\"type\": \"union\", \"inputs\": {\"a\": 2}}, \"2\": {\"type\": \"union\", \"inputs\": {\"b\": 1}}");
    EXPECT_NE(message(cycle).find(".inputs: is part of a cycle, 2 -> 1 -> 2; remove one of its wires"),
              std::string::npos)
        << message(cycle);
    std::string mixed = with_nodes(
        "\"1\": {\"type\": \"circle\"}, \"2\": {\"type\": \"sphere\"}, "
        "\"3\": {\"type\": \"union\", \"inputs\": {\"a\": 1, \"b\": 2}}");
    EXPECT_NE(message(mixed).find("$.graphs.root.nodes.3.inputs.b: node 2 (`sphere`) gives a 3D field"),
              std::string::npos)
        << message(mixed);
}

TEST(scene_file, ten_thousand_nodes_read_quickly)
{
    Document document;
    NodeId last = add_node(document, library(), "sphere");
    while (document.root.nodes.size() < 10'000) {
        NodeId ball = add_node(document, library(), "sphere"), both = add_node(document, library(), "union");
        document.root.nodes.back().inputs = {{"a", last}, {"b", ball}};
        last = both;
    }
    std::string text = write_scene(document, library());
    auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(read_scene(text, library()), document);
    double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    RecordProperty("milliseconds", std::to_string(1000 * seconds));
    EXPECT_LT(seconds, 2.0) << "0.1 s in an optimized build";
}

class Saving : public testing::Test {
protected:
    std::string refused(const fs::path& path, std::string_view bytes = "new")
    {
        try {
            save_atomically(path, bytes);
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.exit_code, 5);
            return failure.what();
        }
        return "saved";
    }
    // What is in the folder beside the named files.
    std::vector<std::string> strays(const std::vector<std::string>& expected) const
    {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            std::string name = entry.path().filename().string();
            if (std::find(expected.begin(), expected.end(), name) == expected.end()) names.push_back(name);
        }
        return names;
    }

    TemporaryFolder folder;
};

TEST_F(Saving, a_saved_scene_opens_equal)
{
    Document document = rich_document();
    save_scene(folder / "a.scene.json", document, library());
    EXPECT_EQ(open_scene(folder / "a.scene.json", library()), document);
    EXPECT_TRUE(strays({"a.scene.json"}).empty());
}

TEST_F(Saving, an_invalid_document_never_replaces_a_good_file)
{
    Document document = rich_document();
    save_scene(folder / "a", document, library());
    std::string old = read_file(folder / "a");
    document.root.find({3})->parameters[0].second = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(save_scene(folder / "a", document, library()), Failure);
    document = rich_document();
    document.extras.emplace_back("broken", "}");
    EXPECT_THROW(save_scene(folder / "a", document, library()), Failure);
    EXPECT_EQ(read_file(folder / "a"), old);
}

TEST_F(Saving, mode_and_link_are_kept)
{
    write_file(folder / "real", "old");
    fs::create_directory(folder / "sub");
    fs::create_symlink("../real", folder / "sub/link");
    fs::create_symlink("sub/link", folder / "link");
    ASSERT_EQ(::chmod((folder / "real").c_str(), 0640), 0);
    save_atomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "sub/link"));
    EXPECT_EQ(read_file(folder / "real"), "new");
    struct stat status = {};
    ASSERT_EQ(::stat((folder / "real").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST_F(Saving, a_link_to_a_file_that_does_not_exist_yet_makes_it)
{
    fs::create_symlink("later", folder / "link");
    save_atomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(folder / "later"), "new");
}

TEST_F(Saving, what_is_not_a_file_is_refused_and_stays)
{
    fs::create_directory(folder / "sub");
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    fs::create_symlink("loop", folder / "loop");
    EXPECT_NE(refused(folder / "sub").find("is a folder"), std::string::npos);
    EXPECT_NE(refused(folder / "fifo").find("is not a regular file"), std::string::npos);
    EXPECT_NE(refused("/dev/full").find("is not a regular file"), std::string::npos);
    EXPECT_NE(refused(folder / "loop").find("loop of symbolic links"), std::string::npos);
    EXPECT_NE(refused(folder / "none/a").find("No such file"), std::string::npos);
    EXPECT_NE(refused(folder / std::string(300, 'x')).find("too long"), std::string::npos);
    EXPECT_NE(refused(folder.path() / "").find("names no file"), std::string::npos);
    EXPECT_TRUE(strays({"sub", "fifo", "loop"}).empty());
}

TEST_F(Saving, the_longest_name_a_folder_takes_is_saved)
{
    std::string name(255, 'x');
    save_atomically(folder / name, "new");
    EXPECT_EQ(read_file(folder / name), "new");
}

// Runs `body` in a child process that may spoil itself; true when it says so.
template <typename Body>
bool in_child(Body body)
{
    pid_t child = ::fork();
    if (child == 0) ::_exit(body() ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(Saving, a_full_disk_leaves_the_old_file_and_nothing_else)
{
    write_file(folder / "a", "old");
    EXPECT_TRUE(in_child([&] {
        // The size limit fails writes half-way as a full disk does, for root too.
        ::signal(SIGXFSZ, SIG_IGN);
        rlimit limit = {1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        return refused(folder / "a", std::string(5000, 'x')).find("cannot be written") != std::string::npos;
    }));
    EXPECT_EQ(read_file(folder / "a"), "old");
    EXPECT_TRUE(strays({"a"}).empty());
}

TEST_F(Saving, a_read_only_folder_leaves_the_old_file)
{
    write_file(folder / "a", "old");
    ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
    EXPECT_TRUE(in_child([&] {
        // Root may write anywhere, so the child becomes somebody else.
        if (::geteuid() == 0 && ::setuid(65534) != 0) return false;
        return refused(folder / "a").find("was not saved") != std::string::npos;
    }));
    EXPECT_EQ(read_file(folder / "a"), "old");
    EXPECT_TRUE(strays({"a"}).empty());
    ::chmod(folder.path().c_str(), 0755);
}

TEST_F(Saving, a_kill_at_any_time_leaves_the_old_file_or_the_new)
{
    std::string old(200'000, 'o'), fresh(200'000, 'n');
    for (int i = 0; i < 60; ++i) {
        write_file(folder / "a", old);
        pid_t child = ::fork();
        if (child == 0) {
            for (;;) save_atomically(folder / "a", fresh);
        }
        ::usleep(static_cast<useconds_t>(i * 100));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        std::string found = read_file(folder / "a");
        ASSERT_TRUE(found == old || found == fresh);
    }
}

}  // namespace
}  // namespace fieldwright::graph

// Groups kept in the user's folder: what is saved there is what is read, and bad files keep nothing else out.
#include "app/group_library.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "tests/app/program.h"
#include "tests/support/scene.h"

namespace fieldwright::app {
namespace {

namespace fs = std::filesystem;
using graph::NodeId;

class GroupLibraryTest : public tests::InFolder {
protected:
    // A ball that is moved, whose radius is set from outside.
    GroupLibraryTest()
    {
        NodeId ball = scene.node("sphere", {{"radius", 0.7f}}), moved = scene.node("translate", {{"d", ball}});
        graph::group_nodes(scene.document, *scene.library, {ball, moved}, "Pearl");
        scene.library = graph::with_groups(*scene.library, scene.document);
        graph::expose(scene.document, *scene.library, "Pearl", ball, "radius");
        scene.library = graph::with_groups(*scene.library, scene.document);
    }
    std::string text() const { return graph::saved_group_text(scene.document, *scene.library, "Pearl"); }
    std::vector<ui::SavedGroup> read()
    {
        failure.clear();
        return GroupLibrary(folder_ / "groups").read(*graph::Library::embedded(), failure);
    }
    bool save(const std::string& name) { return GroupLibrary(folder_ / "groups").save(name, text()); }

    tests::Scene scene;
    std::string failure;
};

TEST_F(GroupLibraryTest, gives_back_what_was_saved)
{
    EXPECT_TRUE(read().empty()) << "there is no folder yet";
    EXPECT_FALSE(save("Pearl"));
    std::vector<ui::SavedGroup> groups = read();
    EXPECT_EQ(failure, "");
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].type.title, "Pearl");
    EXPECT_NE(groups[0].type.parameter("radius"), nullptr);
    graph::Document other;
    graph::Placed placed = graph::add_saved_group(other, *graph::Library::embedded(), groups[0].text, {0, 0}, {});
    ASSERT_EQ(placed.refusal, std::nullopt);
    EXPECT_EQ(*other.root.find(placed.node)->parameter("radius"), graph::Value(0.7f));
    EXPECT_EQ(graph::validate(other, *graph::with_groups(*graph::Library::embedded(), other)), std::nullopt);
}

TEST_F(GroupLibraryTest, replaces_the_group_of_that_name_and_says_so)
{
    EXPECT_FALSE(save("Pearl"));
    EXPECT_TRUE(save("Pearl"));
    EXPECT_EQ(read().size(), 1u);
}

TEST_F(GroupLibraryTest, names_make_files_of_that_folder_alone)
{
    for (const char* name : {"../above", ".hidden", "a/b", "a\\b"}) save(name);
    EXPECT_EQ(read().size(), 3u) << "two of them are written alike";
    EXPECT_FALSE(fs::exists(path("above.json")));
}

TEST_F(GroupLibraryTest, leaves_out_what_it_cannot_read_and_says_why)
{
    save("Pearl");
    const std::pair<const char*, std::string> bad[] = {{"empty", ""},
                                                       {"scene", "{\"format\": \"fieldwright\", \"version\": 1}"},
                                                       {"cut", text().substr(0, text().size() / 2)},
                                                       {"bytes", "\xff\xfe"},
                                                       {"large", std::string((1u << 20) + 1, ' ')}};
    for (const auto& [name, words] : bad) {
        tests::write_text(folder_ / "groups" / (std::string(name) + ".json"), words);
        EXPECT_EQ(read().size(), 1u) << name;
        EXPECT_NE(failure.find(std::string(name) + ".json"), std::string::npos) << failure;
        fs::remove(folder_ / "groups" / (std::string(name) + ".json"));
    }
    tests::write_text(folder_ / "groups/notes.txt", "no group");
    EXPECT_EQ(read().size(), 1u);
    EXPECT_EQ(failure, "") << "other files are none of its business";
}

TEST_F(GroupLibraryTest, without_a_folder_is_empty_and_says_so_when_something_is_to_be_kept)
{
    GroupLibrary nowhere(std::nullopt);
    EXPECT_TRUE(nowhere.read(*graph::Library::embedded(), failure).empty());
    EXPECT_EQ(failure, "");
    EXPECT_THROW(nowhere.save("Pearl", text()), graph::Failure);
}

}  // namespace
}  // namespace fieldwright::app

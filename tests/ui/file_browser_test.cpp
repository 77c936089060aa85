// The built-in file browser finds files and asks before it replaces one.
#include "tests/ui/driver.h"
#include "ui/folder_listing.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <fstream>

namespace fieldwright::tests {
namespace {

namespace fs = std::filesystem;
using Then = ui::ChooseFile::Then;

class Browser : public testing::Test {
protected:
    Browser() : driver({})
    {
        std::string pattern = (fs::temp_directory_path() / "fieldwright_browser_XXXXXX").string();
        folder = fs::canonical(mkdtemp(pattern.data()));
        fs::create_directory(folder / "inner");
        for (const char* name :
             {"b.scene.json", "A.scene.json", "notes.txt", ".hidden.scene.json", "inner/c.scene.json"})
            std::ofstream(folder / name) << "{}";
    }
    ~Browser() override { fs::remove_all(folder); }

    void browse(Then then, std::string name = {}, std::string target = {})
    {
        driver.editor.browse({then, std::move(target)}, folder.string(), std::move(name));
        driver.frames(4);
    }
    template <typename Kind>
    std::string requested() const
    {
        if (driver.requests.size() != 1 || !std::holds_alternative<Kind>(driver.requests[0])) return "nothing";
        return std::get<Kind>(driver.requests[0]).path;
    }

    Driver driver;
    fs::path folder;
};

TEST_F(Browser, opens_the_file_that_is_chosen)
{
    browse(Then::open);
    driver.click("browser/file/b.scene.json");
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::OpenFile>(), (folder / "b.scene.json").string());
    EXPECT_FALSE(driver.shows("browser/accept"));
}

TEST_F(Browser, shows_pictures_whatever_their_letters)
{
    for (const char* name : {"photo.JPG", "drawing.png"}) std::ofstream(folder / name) << "x";
    driver.editor.browse({Then::picture, {}, graph::NodeId{7}}, folder.string(), {});
    driver.frames(4);
    EXPECT_TRUE(driver.shows("browser/file/drawing.png"));
    EXPECT_FALSE(driver.shows("browser/file/notes.txt"));
    driver.click("browser/file/photo.JPG");
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::UsePicture>(), (folder / "photo.JPG").string());
    EXPECT_EQ(std::get<ui::UsePicture>(driver.requests[0]).node, graph::NodeId{7});
}

TEST_F(Browser, shows_scenes_and_folders_and_all_when_told)
{
    browse(Then::open);
    EXPECT_TRUE(driver.shows("browser/file/inner"));
    EXPECT_FALSE(driver.shows("browser/file/notes.txt"));
    EXPECT_FALSE(driver.shows("browser/file/.hidden.scene.json"));
    driver.click("browser/all_files");
    EXPECT_TRUE(driver.shows("browser/file/notes.txt"));
}

TEST_F(Browser, walks_folders_by_double_click_and_keys)
{
    browse(Then::open);
    driver.double_click(driver.place("browser/file/inner"));
    EXPECT_TRUE(driver.shows("browser/file/c.scene.json"));
    driver.key(ui::key::backspace);
    EXPECT_TRUE(driver.shows("browser/file/A.scene.json"));
    driver.key(ui::key::enter);  // the folder one came from is highlighted
    driver.key(ui::key::down);
    driver.key(ui::key::enter);
    EXPECT_EQ(requested<ui::OpenFile>(), (folder / "inner/c.scene.json").string());
}

TEST_F(Browser, adds_the_extension_when_saving)
{
    browse(Then::save_as, "untitled");
    driver.key(ui::key::enter);
    EXPECT_EQ(requested<ui::SaveFileAs>(), (folder / "untitled.scene.json").string());
}

TEST_F(Browser, asks_before_it_replaces_a_file)
{
    browse(Then::save_as, "b.scene.json");
    driver.click("browser/accept");
    EXPECT_TRUE(driver.requests.empty());
    EXPECT_TRUE(driver.shows("browser/error"));
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::SaveFileAs>(), (folder / "b.scene.json").string());
}

TEST_F(Browser, exports_to_the_target_it_was_opened_for)
{
    browse(Then::export_shader, "scene", "shadertoy");
    driver.click("browser/accept");
    ASSERT_EQ(requested<ui::ExportFile>(), (folder / "scene.glsl").string());
    EXPECT_EQ(std::get<ui::ExportFile>(driver.requests[0]).target, "shadertoy");
}

TEST_F(Browser, exports_pictures)
{
    browse(Then::export_picture, "scene.png");
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::ExportPicture>(), (folder / "scene.png").string());
}

TEST_F(Browser, chooses_the_format_of_a_picture_by_its_name_or_from_a_list)
{
    std::ofstream(folder / "there.exr") << "x";
    browse(Then::export_picture, "scene.png");
    EXPECT_TRUE(driver.shows("browser/file/there.exr"));
    driver.click("browser/format");
    driver.click("browser/format/choice/exr");
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::ExportPicture>(), (folder / "scene.exr").string());
}

TEST_F(Browser, adds_an_end_to_a_picture_and_refuses_one_of_no_format)
{
    browse(Then::export_picture, "scene.bmp");
    driver.click("browser/accept");
    EXPECT_TRUE(driver.requests.empty());
    EXPECT_TRUE(driver.shows("browser/error"));
    driver.double_click(driver.place("browser/name"));
    driver.key('A', true);
    driver.type("scene");
    driver.key(ui::key::enter);
    EXPECT_EQ(requested<ui::ExportPicture>(), (folder / "scene.png").string());
}

TEST_F(Browser, goes_where_a_typed_path_leads)
{
    browse(Then::open);
    driver.double_click(driver.place("browser/path"));
    driver.key('A', true);
    driver.type((folder / "inner").string());
    driver.key(ui::key::enter);
    EXPECT_TRUE(driver.shows("browser/file/c.scene.json"));
}

TEST_F(Browser, makes_a_folder_and_goes_there)
{
    browse(Then::save_as, "x");
    driver.click("browser/new_folder");
    driver.type("fresh");
    driver.click("browser/make_folder");
    EXPECT_TRUE(fs::is_directory(folder / "fresh"));
    driver.click("browser/accept");
    EXPECT_EQ(requested<ui::SaveFileAs>(), (folder / "fresh/x.scene.json").string());
}

TEST_F(Browser, says_what_is_wrong_and_stays)
{
    browse(Then::open);
    driver.click("browser/accept");
    EXPECT_TRUE(driver.shows("browser/error"));
    driver.click("browser/name");
    driver.type("missing.scene.json");
    driver.key(ui::key::enter);
    EXPECT_TRUE(driver.shows("browser/error"));
    EXPECT_TRUE(driver.requests.empty());
    driver.key(ui::key::escape);
    driver.key(ui::key::escape);
    EXPECT_FALSE(driver.shows("browser/accept"));
}

TEST_F(Browser, starts_in_the_nearest_folder_that_exists)
{
    driver.editor.browse({Then::open, {}}, (folder / "gone/deeper").string(), {});
    driver.frames(4);
    EXPECT_TRUE(driver.shows("browser/file/b.scene.json"));
}

TEST_F(Browser, lists_folders_first_then_names_without_regard_to_case)
{
    std::vector<std::string> names;
    for (const ui::FolderEntry& entry : ui::list_folder(folder, {".scene.json"}).entries) names.push_back(entry.name);
    EXPECT_EQ(names, (std::vector<std::string>{"inner", "A.scene.json", "b.scene.json"}));
}

TEST_F(Browser, an_unreadable_folder_is_a_sentence)
{
    EXPECT_TRUE(ui::list_folder(folder / "gone", {}).error.starts_with("Cannot read"));
}

}  // namespace
}  // namespace fieldwright::tests

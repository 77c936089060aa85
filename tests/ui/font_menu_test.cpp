// The list of installed fonts beside a text's font.
#include "tests/ui/driver.h"

#include "ui/keys.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

struct FontMenu : testing::Test {
    FontMenu() : driver(graph::Document{}, {1280, 1000})
    {
        driver.editor.view.panes.inspector_share = 0.85f;
        driver.readings.font_families = [this]() -> const std::vector<std::string>& { return families; };
        text = graph::add_node(driver.document, *driver.library, "text");
        driver.editor.view.selection.only(text);
        driver.frames(2);
    }
    std::string font() const { return std::get<std::string>(*driver.document.root.find(text)->parameter("font")); }

    std::vector<std::string> families = {"Alpha Serif", "Beta Mono", "Gamma Sans"};
    Driver driver;
    graph::NodeId text;
};

TEST_F(FontMenu, lists_what_is_installed_and_takes_what_is_clicked)
{
    driver.click("inspector/font/menu");
    driver.frames(2);
    for (const std::string& family : families) EXPECT_TRUE(driver.shows("inspector/font/family/" + family));
    driver.click("inspector/font/family/Beta Mono");
    EXPECT_EQ(font(), "Beta Mono");
    EXPECT_FALSE(driver.shows("inspector/font/search"));
    driver.click("inspector/font/menu");
    driver.frames(2);
    driver.click("inspector/font/family/");
    EXPECT_EQ(font(), "") << "the built-in one";
}

TEST_F(FontMenu, is_searched_by_name_and_enter_takes_the_first)
{
    driver.click("inspector/font/menu");
    driver.frames(2);
    driver.type("SANS");
    EXPECT_TRUE(driver.shows("inspector/font/family/Gamma Sans"));
    EXPECT_FALSE(driver.shows("inspector/font/family/Alpha Serif"));
    driver.key(ui::key::enter);
    EXPECT_EQ(font(), "Gamma Sans");
}

TEST_F(FontMenu, is_there_for_fonts_alone)
{
    EXPECT_TRUE(driver.shows("inspector/font/menu"));
    EXPECT_FALSE(driver.shows("inspector/text/menu"));
}

}  // namespace
}  // namespace fieldwright::tests

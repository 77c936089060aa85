// Search in the add menu: what people type finds what they mean.
#include "graph/search.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fieldwright::graph {
namespace {

class Search : public testing::Test {
protected:
    std::vector<std::string> found(std::string_view query, const std::vector<std::string>& recent = {})
    {
        std::vector<std::string> names;
        for (const NodeType* type : search_types(library->types(), query, recent)) names.push_back(type->name);
        return names;
    }
    std::string first(std::string_view query, const std::vector<std::string>& recent = {})
    {
        std::vector<std::string> names = found(query, recent);
        return names.empty() ? "" : names.front();
    }

    std::shared_ptr<const Library> library = Library::embedded();
};

TEST_F(Search, words_people_use_come_first)
{
    const std::pair<const char*, const char*> expected[] = {
        {"smin", "smooth_union"},
        {"cube", "box"},
        {"ball", "sphere"},
        {"donut", "torus"},
        {"move", "translate"},
        {"floor", "plane"},
        {"xor", "exclusive_or"},
        {"difference", "subtract"},
        {"lerp", "mix"},
        {"lathe", "revolve"},
        {"onion", "shell"},
        {"smax", "smooth_intersect"},
        {"lamp", "point"},
        {"disc", "circle"},
        {"disk", "circle"},
        {"pill", "capsule"},
        {"square", "rectangle"},
        {"array", "repeat_limited"},
        {"tile", "repeat"},
        {"mirror", "mirror"},
        {"background", "gradient"},
        {"environment", "environment"},
        {"hollow", "shell"},
        {"cylinder", "cylinder"},
        {"offset", "offset"},
        {"Smooth Union", "smooth_union"},
        {"smooth_union", "smooth_union"},
        {"  BOX ", "box"},
        {"hash", "random"},
        {"noise", "random"},
        {"sin", "sine"},
        {"constant", "number"},
        {"instance", "cell"},
        {"bevel", "rounded_box"},
        {"heart", "heart"},
        {"teapot", ""},
    };
    for (auto [query, name] : expected) EXPECT_EQ(first(query), name) << query;
}

TEST_F(Search, whole_names_beat_prefixes_beat_words_beat_letters)
{
    std::vector<std::string> names = found("box");
    auto place = [&](std::string_view name) { return std::find(names.begin(), names.end(), name) - names.begin(); };
    EXPECT_EQ(place("box"), 0);
    EXPECT_EQ(place("box_frame"), 1);
    EXPECT_LT(place("box_frame"), place("rectangle")) << "a name before a synonym (box 2d)";
    EXPECT_LT(place("rectangle"), place("rounded_box")) << "a prefix before a word inside";
    EXPECT_EQ(first("smun"), "smooth_union") << "letters in order";
    EXPECT_EQ(first("rdbx"), "rounded_box");
    EXPECT_EQ(first("union smooth"), "smooth_union") << "words in any order";
    EXPECT_TRUE(found("zzzq").empty());
    EXPECT_TRUE(found("mooth").empty()) << "letters begin at a word";
}

TEST_F(Search, a_category_finds_all_of_it)
{
    std::vector<std::string> names = found("light");
    for (const char* name : {"point", "spot", "sphere_area", "sun"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    std::size_t primitives = 0;
    for (const NodeType* type : library->types()) primitives += type->category == "primitive";
    EXPECT_GE(found("primitive").size(), primitives);
}

TEST_F(Search, recent_types_come_first_on_ties_only)
{
    EXPECT_EQ(first("rot", {}), "rotate");
    EXPECT_EQ(first("rot", {"rotate_2d"}), "rotate_2d");
    EXPECT_EQ(first("rot", {"rotate", "rotate_2d"}), "rotate");
    EXPECT_EQ(first("box", {"box_frame"}), "box") << "better matches stay before";
}

TEST_F(Search, of_equals_the_shorter_title_comes_first)
{
    std::vector<const NodeType*> two = {library->type("rotate"), library->type("round")};
    EXPECT_EQ(search_types(two, "ro").front(), library->type("round"));
    EXPECT_EQ(search_types(two, "ro", {"rotate"}).front(), library->type("rotate")) << "what is recent stays before";
}

TEST_F(Search, an_empty_query_lists_all_by_category)
{
    std::vector<const NodeType*> all = search_types(library->types(), " ", {"torus"});
    EXPECT_EQ(all, library->types());
}

TEST_F(Search, every_type_is_found_by_its_name_its_title_and_its_synonyms)
{
    for (const NodeType* type : library->types()) {
        EXPECT_EQ(first(type->name), type->name);
        std::vector<std::string> by_title = found(type->title);
        EXPECT_EQ(std::count(by_title.begin(), by_title.end(), type->name), 1) << type->title;
        for (const std::string& synonym : type->synonyms) {
            std::vector<std::string> names = found(synonym);
            EXPECT_EQ(std::count(names.begin(), names.end(), type->name), 1) << synonym;
        }
    }
}

TEST_F(Search, a_list_already_filtered_stays_filtered)
{
    std::vector<const NodeType*> few = {library->type("torus"), library->type("box")};
    EXPECT_EQ(search_types(few, "o"), std::vector<const NodeType*>{}) << "no word of theirs begins with o";
    EXPECT_EQ(search_types(few, "b").front(), library->type("box"));
    EXPECT_EQ(search_types(few, "cylinder"), std::vector<const NodeType*>{});
}

}  // namespace
}  // namespace fieldwright::graph

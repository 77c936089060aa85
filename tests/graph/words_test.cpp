// What things are called: one title for each type, and the same words everywhere.
#include "graph/words.h"

#include <gtest/gtest.h>

#include <map>

namespace fieldwright::graph {
namespace {

TEST(Words, no_two_types_share_a_title)
{
    std::map<std::string, std::string> by_title;
    for (const NodeType* type : Library::embedded()->types()) {
        auto [other, fresh] = by_title.try_emplace(inside_a_sentence(type->title), type->name);
        EXPECT_TRUE(fresh) << type->name << " and " << other->second << " are both called " << type->title;
    }
}

TEST(Words, titles_are_lower_case_inside_a_sentence_and_names_stay)
{
    EXPECT_EQ(inside_a_sentence("Torus"), "torus");
    EXPECT_EQ(inside_a_sentence("2D ring"), "2D ring");
    EXPECT_EQ(inside_a_sentence("XOR"), "XOR");
    EXPECT_EQ(inside_a_sentence("X shape"), "X shape");
    EXPECT_EQ(in_words("half_size"), "Half size");
    std::shared_ptr<const Library> library = Library::embedded();
    Node node;
    node.type = "torus";
    EXPECT_EQ(title_inside(node, *library), "torus");
    node.name = "Left Wheel";
    EXPECT_EQ(title_inside(node, *library), "Left Wheel");
}

TEST(Words, sockets_have_words_in_every_type)
{
    std::shared_ptr<const Library> library = Library::embedded();
    EXPECT_EQ(socket_label(library->type("union"), "a"), "First shape");
    EXPECT_EQ(socket_label(library->type("output"), "d"), "Shape");
    for (const NodeType* type : library->types())
        for (const Socket& socket : type->inputs) {
            std::string words = socket_label(type, socket.name);
            EXPECT_TRUE(words.size() > 1 || type->parameter(socket.name)) << type->name << "." << socket.name;
            EXPECT_EQ(words.find('_'), std::string::npos) << words;
        }
}

}  // namespace
}  // namespace fieldwright::graph

// Undo and redo.
#include "graph/history.h"

#include "graph/edits.h"
#include "tests/graph/small_library.h"

#include <gtest/gtest.h>

namespace fieldwright::graph {
namespace {

class HistoryOfThree : public testing::Test {
protected:
    HistoryOfThree()
    {
        for (const char* name : {"one", "two", "three"}) {
            Document document = history.current();
            add_node(document, *small_library(), "sphere");
            documents.push_back(document);
            history.record(document, name);
        }
    }

    std::vector<Document> documents = {Document{}};
    History history{Document{}};
};

TEST_F(HistoryOfThree, undo_and_redo_walk_every_step_and_stop_at_the_ends)
{
    for (std::size_t step = 3; step > 0; --step) {
        EXPECT_EQ(history.current(), documents[step]);
        EXPECT_TRUE(history.undo());
    }
    EXPECT_FALSE(history.undo());
    EXPECT_EQ(history.current(), documents[0]);
    for (std::size_t step = 1; step <= 3; ++step) {
        EXPECT_TRUE(history.redo());
        EXPECT_EQ(history.current(), documents[step]);
    }
    EXPECT_FALSE(history.redo());
}

TEST_F(HistoryOfThree, jump_goes_to_any_step)
{
    history.jump(1);
    EXPECT_EQ(history.step(), 1u);
    EXPECT_EQ(history.current(), documents[1]);
    history.jump(3);
    EXPECT_EQ(history.current(), documents[3]);
}

TEST_F(HistoryOfThree, a_new_step_drops_what_was_undone)
{
    history.jump(1);
    history.record(documents[3], "other");
    EXPECT_EQ(history.names(), (std::vector<std::string>{"start", "one", "other"}));
    EXPECT_FALSE(history.redo());
}

TEST_F(HistoryOfThree, an_unchanged_document_is_no_step)
{
    history.jump(2);
    history.record(documents[2], "nothing");
    EXPECT_EQ(history.names().size(), 4u);
    EXPECT_TRUE(history.redo());
}

TEST_F(HistoryOfThree, undo_and_redo_are_named_after_the_step_they_walk_over)
{
    EXPECT_EQ(history.undo_name(), "three");
    EXPECT_EQ(history.redo_name(), "");
    history.jump(1);
    EXPECT_EQ(history.undo_name(), "one");
    EXPECT_EQ(history.redo_name(), "two");
    history.jump(0);
    EXPECT_EQ(history.undo_name(), "");
}

TEST_F(HistoryOfThree, walking_back_to_the_saved_step_is_saved_again)
{
    EXPECT_FALSE(history.at_saved_step());
    history.jump(2);
    history.mark_saved();
    EXPECT_TRUE(history.at_saved_step());
    history.redo();
    EXPECT_FALSE(history.at_saved_step());
    history.undo();
    EXPECT_TRUE(history.at_saved_step());
    history.undo();
    EXPECT_FALSE(history.at_saved_step());
}

TEST_F(HistoryOfThree, a_saved_step_that_was_overwritten_never_counts_again)
{
    history.mark_saved();
    history.jump(2);
    Document other = documents[2];
    add_node(other, *small_library(), "circle");
    history.record(other, "other");
    EXPECT_EQ(history.step(), 3u);
    EXPECT_FALSE(history.at_saved_step());
    for (std::size_t step = 0; step < history.size(); ++step) {
        history.jump(step);
        EXPECT_FALSE(history.at_saved_step());
    }
}

TEST_F(HistoryOfThree, a_replaced_step_keeps_its_name_its_neighbours_and_its_mark)
{
    history.jump(2);
    history.mark_saved();
    Document other = documents[2];
    set_muted(other, {1}, true);
    history.replace_current(other);
    EXPECT_EQ(history.current(), other);
    EXPECT_TRUE(history.at_saved_step());
    EXPECT_EQ(history.undo_name(), "two");
    history.redo();
    EXPECT_EQ(history.current(), documents[3]);
    history.undo();
    EXPECT_EQ(history.current(), other);
}

Document moved(const Document& document, NodeId node, float x)
{
    Document result = document;
    EXPECT_EQ(move_node(result, node, {x, 0}), std::nullopt);
    return result;
}

TEST(History, beyond_the_limit_the_oldest_steps_go_and_the_others_stay_equal)
{
    Document document;
    NodeId node = add_node(document, *small_library(), "sphere");
    add_node(document, *small_library(), "star");
    History history(document);
    const int count = static_cast<int>(History::step_limit) + 20;
    for (int x = 1; x <= count; ++x) history.record(moved(document, node, static_cast<float>(x)), std::to_string(x));
    EXPECT_EQ(history.size(), History::step_limit);
    EXPECT_EQ(history.dropped(), 21u);
    EXPECT_EQ(history.names().front(), "21");
    EXPECT_EQ(history.names().back(), std::to_string(count));
    EXPECT_FALSE(history.at_saved_step());
    for (int x = count; x >= 21; --x) {
        ASSERT_EQ(history.current(), moved(document, node, static_cast<float>(x)));
        EXPECT_EQ(history.undo(), x > 21);
    }
    EXPECT_FALSE(history.at_saved_step()) << "the saved step was dropped";
}

TEST(History, the_saved_mark_moves_with_its_step_when_older_ones_go)
{
    Document document;
    NodeId node = add_node(document, *small_library(), "sphere");
    History history(document);
    for (int x = 1; x <= 900; ++x) history.record(moved(document, node, static_cast<float>(x)), "move");
    history.mark_saved();
    for (int x = 901; x <= 1500; ++x) history.record(moved(document, node, static_cast<float>(x)), "move");
    while (!history.at_saved_step()) ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.current(), moved(document, node, 900));
}

TEST(History, deleting_and_bringing_back_restores_equal_documents)
{
    Document full;
    for (const char* type : {"sphere", "star", "sphere", "circle"}) add_node(full, *small_library(), type);
    Document less = full;
    EXPECT_EQ(remove_node(less, {2}), std::nullopt);
    Document more = less;
    add_node(more, *small_library(), "union");
    History history(full);
    history.record(less, "delete");
    history.record(more, "add");
    history.jump(0);
    EXPECT_EQ(history.current(), full);
    history.jump(2);
    EXPECT_EQ(history.current(), more);
    history.undo();
    EXPECT_EQ(history.current(), less);
}

}  // namespace
}  // namespace fieldwright::graph

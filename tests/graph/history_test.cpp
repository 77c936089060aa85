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

}  // namespace
}  // namespace fieldwright::graph

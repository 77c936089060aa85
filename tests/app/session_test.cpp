// The edited scene: gestures, files, and what would be lost.
#include "app/session.h"

#include "graph/edits.h"
#include "graph/layout.h"
#include "graph/scene_file.h"
#include "tests/app/program.h"

#include <unistd.h>

namespace fieldwright::app {
namespace {

using graph::Document;
using graph::NodeId;

class EditSessionTest : public tests::InFolder {
protected:
    const graph::Library& library() const { return *session.library(); }
    NodeId add(const char* type) { return graph::add_node(session.document(), library(), type); }
    void gesture(const char* type)
    {
        add(type);
        ASSERT_TRUE(session.settle(std::string("Add ") + type));
    }
    std::string refusal(const std::function<void()>& action)
    {
        try {
            action();
        } catch (const graph::Failure& failure) {
            return failure.what();
        }
        return {};
    }

    EditSession session{graph::Library::embedded()};
};

TEST_F(EditSessionTest, starts_clean_and_untitled_with_a_scene)
{
    EXPECT_FALSE(session.dirty());
    EXPECT_EQ(session.title(), "Untitled");
    EXPECT_FALSE(session.path());
    EXPECT_GT(session.document().root.nodes.size(), 5u);
}

TEST_F(EditSessionTest, an_edit_is_dirty_at_once_and_one_step_once_settled)
{
    add("sphere");
    EXPECT_TRUE(session.dirty());
    EXPECT_EQ(session.history().size(), 1u);
    EXPECT_TRUE(session.settle("Add sphere"));
    EXPECT_FALSE(session.settle("Nothing")) << "nothing changed";
    EXPECT_EQ(session.history().names(), (std::vector<std::string>{"start", "Add sphere"}));
    EXPECT_EQ(session.title(), "Untitled \u2022");
}

TEST_F(EditSessionTest, undo_restores_equal_documents_and_is_clean_again)
{
    std::vector<Document> documents = {session.document()};
    for (const char* type : {"sphere", "torus", "box"}) {
        gesture(type);
        documents.push_back(session.document());
    }
    for (std::size_t i = 3; i > 0; --i) {
        EXPECT_EQ(session.document(), documents[i]);
        EXPECT_TRUE(session.dirty());
        EXPECT_TRUE(session.undo());
    }
    EXPECT_EQ(session.document(), documents[0]);
    EXPECT_FALSE(session.dirty());
    EXPECT_FALSE(session.undo());
    EXPECT_TRUE(session.jump(2));
    EXPECT_EQ(session.document(), documents[2]);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(session.document(), documents[3]);
    EXPECT_FALSE(session.jump(4));
    EXPECT_EQ(session.document(), documents[3]);
}

TEST_F(EditSessionTest, undo_in_the_middle_of_a_gesture_takes_back_the_gesture)
{
    gesture("sphere");
    Document before = session.document();
    add("torus");
    Document after = session.document();
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(session.document(), before);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(session.document(), after);
}

TEST_F(EditSessionTest, a_jump_with_an_open_gesture_at_the_limit_lands_on_the_step_that_was_named)
{
    std::vector<std::string> names = session.history().names();
    for (int i = 1; i < static_cast<int>(graph::History::step_limit); ++i) {
        graph::move_node(session.document(), {1}, {i, 0});
        session.settle("Move " + std::to_string(i));
    }
    ASSERT_EQ(session.history().names()[500], "Move 500");
    graph::move_node(session.document(), {1}, {-5, 0});
    EXPECT_TRUE(session.jump(500));
    EXPECT_EQ(session.history().names()[session.history().step()], "Move 500");
    EXPECT_EQ(session.document().root.find({1})->position, glm::vec2(500, 0));
    EXPECT_TRUE(session.jump(1));
}

TEST_F(EditSessionTest, save_as_adds_the_extension_and_saves_what_is_seen)
{
    add("torus");
    session.save_as(path("ring"));
    EXPECT_EQ(session.path(), folder_ / "ring.scene.json");
    EXPECT_EQ(session.title(), "ring.scene.json");
    EXPECT_FALSE(session.dirty());
    EXPECT_EQ(graph::open_scene(*session.path(), library()), session.document());
    EXPECT_TRUE(session.undo()) << "the open gesture became a step";
    EXPECT_TRUE(session.dirty());
    EXPECT_TRUE(session.redo());
    EXPECT_FALSE(session.dirty());
    EXPECT_EQ(scene_path("a.json"), "a.json");
    EXPECT_EQ(scene_path("a.scene.json"), "a.scene.json");
    EXPECT_EQ(scene_path("v1.2"), "v1.2.scene.json");
}

TEST_F(EditSessionTest, a_scene_in_a_heap_is_laid_out_on_opening_and_stays_clean)
{
    Document heap;
    NodeId output = graph::add_node(heap, library(), "output");
    for (int i = 0; i < 900; ++i) {
        NodeId ball = graph::add_node(heap, library(), "sphere");
        if (i == 0) graph::connect(heap, library(), ball, output, "d");
    }
    graph::save_scene(folder_ / "heap.json", heap, library());
    session.open(folder_ / "heap.json");
    EXPECT_TRUE(session.laid_out());
    EXPECT_FALSE(session.dirty());
    EXPECT_FALSE(graph::lies_in_heaps(session.document().root));
    EXPECT_EQ(graph::validate(session.document(), library()), std::nullopt);
    session.save();
    session.open(folder_ / "heap.json");
    EXPECT_FALSE(session.laid_out()) << "the file has places now";
    session.new_scene();
    EXPECT_FALSE(session.laid_out());
}

TEST_F(EditSessionTest, save_writes_to_the_same_file_again)
{
    EXPECT_NE(refusal([&] { session.save(); }).find("Save as"), std::string::npos);
    session.save_as(path("scene.scene.json"));
    gesture("box");
    session.save();
    EXPECT_FALSE(session.dirty());
    EXPECT_EQ(graph::open_scene(path("scene.scene.json"), library()), session.document());
}

TEST_F(EditSessionTest, a_refused_save_says_why_and_stays_dirty)
{
    gesture("box");
    Document before = session.document();
    std::string reason = refusal([&] { session.save_as(path("no/such/folder/scene")); });
    EXPECT_NE(reason.find("no/such/folder/scene.scene.json"), std::string::npos) << reason;
    EXPECT_TRUE(session.dirty());
    EXPECT_FALSE(session.path());
    EXPECT_EQ(session.document(), before);
    std::filesystem::create_directory(folder_ / "folder.json");
    EXPECT_NE(refusal([&] { session.save_as(path("folder.json")); }).find("is a folder"), std::string::npos);
}

TEST_F(EditSessionTest, open_starts_a_new_history_and_a_failed_open_changes_nothing)
{
    gesture("box");
    std::filesystem::path example = tests::source_folder() / "examples/first.scene.json";
    session.open(example);
    EXPECT_EQ(session.document(), graph::open_scene(example, library()));
    EXPECT_EQ(session.history().size(), 1u);
    EXPECT_EQ(session.title(), "first.scene.json");
    gesture("sphere");
    Document before = session.document();
    tests::write_text(path("broken.scene.json"), "{\"format\": \"fieldwright\"");
    EXPECT_NE(refusal([&] { session.open(path("broken.scene.json")); }).find("broken.scene.json:1"), std::string::npos);
    EXPECT_FALSE(refusal([&] { session.open(path("absent.scene.json")); }).empty());
    EXPECT_EQ(session.document(), before);
    EXPECT_EQ(session.title(), "first.scene.json \u2022");
    EXPECT_EQ(session.history().size(), 2u);
    EXPECT_FALSE(session.changed_on_disk());
    session.new_scene();
    EXPECT_EQ(session.title(), "Untitled");
    EXPECT_EQ(session.history().size(), 1u);
}

TEST_F(EditSessionTest, a_relative_path_survives_a_change_of_folder)
{
    session.save_as(path("scene"));
    std::filesystem::path old = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    session.open("scene.scene.json");
    std::filesystem::current_path(old);
    EXPECT_EQ(std::filesystem::canonical(*session.path()), std::filesystem::canonical(folder_ / "scene.scene.json"));
}

TEST_F(EditSessionTest, a_write_by_someone_else_is_noticed_and_our_own_is_not)
{
    session.save_as(path("scene"));
    EXPECT_FALSE(session.changed_on_disk());
    std::string text = tests::read_text(*session.path());
    tests::write_text(*session.path(), text + " ");
    EXPECT_TRUE(session.changed_on_disk());
    session.save();
    EXPECT_FALSE(session.changed_on_disk());
    // Same size, other file.
    graph::save_atomically(*session.path(), tests::read_text(*session.path()));
    EXPECT_TRUE(session.changed_on_disk());
    session.open(*session.path());
    EXPECT_FALSE(session.changed_on_disk());
    std::filesystem::remove(*session.path());
    EXPECT_FALSE(session.changed_on_disk()) << "there is nothing to overwrite";
}

TEST_F(EditSessionTest, a_newer_version_warns_before_it_is_overwritten)
{
    EXPECT_EQ(session.overwrite_warning(), "");
    tests::write_text(path("new.scene.json"),
                      R"({"format": "fieldwright", "version": 7, "graphs": {"root": {"nodes": {}}}})");
    session.open(path("new.scene.json"));
    EXPECT_NE(session.overwrite_warning().find("version 7"), std::string::npos);
    session.save();
    EXPECT_EQ(session.overwrite_warning(), "") << "asked once";
    session.open(path("new.scene.json"));
    EXPECT_NE(session.overwrite_warning(), "");
}

TEST_F(EditSessionTest, a_recovered_copy_is_unsaved_work_of_its_origin)
{
    gesture("torus");
    Document work = session.document();
    graph::save_scene(path("copy.scene.json"), work, library());
    session.new_scene();
    session.recover(path("copy.scene.json"), folder_ / "origin.scene.json", {});
    EXPECT_EQ(session.document(), work);
    EXPECT_EQ(session.title(), "origin.scene.json \u2022");
    session.save();
    EXPECT_FALSE(session.dirty());
    EXPECT_EQ(graph::open_scene(path("origin.scene.json"), library()), work);
}

std::shared_ptr<const graph::Library> without(const std::string& type)
{
    auto texts = graph::embedded_texts();
    texts.erase(graph::Library::embedded()->type(type)->source.path);
    return graph::Library::from_texts(texts, graph::embedded_texts());
}

TEST_F(EditSessionTest, a_type_that_vanishes_is_kept_through_undo_save_and_return)
{
    gesture("torus");
    Document with_torus = session.document();
    session.save_as(path("scene"));
    std::string text = tests::read_text(*session.path());
    gesture("box");
    session.use_library(without("torus"));
    EXPECT_TRUE(session.dirty());
    EXPECT_TRUE(session.undo());
    EXPECT_FALSE(session.document().root.nodes.back().unknown_source.empty());
    EXPECT_FALSE(session.dirty()) << "the file would be the same";
    session.save();
    EXPECT_EQ(tests::read_text(*session.path()), text);
    session.use_library(graph::Library::embedded());
    EXPECT_EQ(session.document(), with_torus);
    EXPECT_FALSE(session.dirty());
}

TEST_F(EditSessionTest, a_reload_that_changes_the_file_makes_the_scene_dirty)
{
    auto texts = graph::embedded_texts();
    std::string& sphere = texts.at("nodes/primitive/sphere.glsl");
    std::size_t place = sphere.find("float radius)");
    ASSERT_NE(place, std::string::npos);
    sphere.replace(place, 13, "float extra,  // 1.0 [0, 2] m  More.\n    float radius)");
    gesture("sphere");
    session.save_as(path("scene"));
    std::size_t steps = session.history().size();
    session.use_library(graph::Library::from_texts(texts, graph::embedded_texts()));
    EXPECT_TRUE(session.dirty());
    EXPECT_EQ(session.history().size(), steps) << "a reload is no step";
    EXPECT_EQ(*session.document().root.nodes.back().parameter("extra"), graph::Value(1.0f));
    EXPECT_FALSE(session.settle("Nothing"));
}

}  // namespace
}  // namespace fieldwright::app

// Code that users write: what is trusted, what a worker says about it, and what the window and commands do with it.
#include "app/code_review.h"
#include "app/digest.h"
#include "app/session.h"
#include "app/starter_scene.h"
#include "app/user_folders.h"
#include "app/user_nodes.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/adapt.h"
#include "graph/custom_nodes.h"
#include "graph/own_type_edits.h"
#include "graph/scene_file.h"
#include "tests/app/program.h"
#include "tests/support/glslang.h"

#include <unistd.h>
#include <atomic>
#include <chrono>

namespace fieldwright::app {
namespace {

#define EXPECT_SAYS(sentence, part) EXPECT_NE((sentence).find(part), std::string::npos) << (sentence)

std::string ball_text(const std::string& name, const std::string& body = "return length(p) - 0.5f;")
{
    return "// Ball: round.\n// field: exact\nfloat " + name + "_distance(vec3 p)\n{\n    " + body + "\n}\n\nBox " +
           name + "_bounds() { return make_box(vec3(0.0f), vec3(0.5f)); }\n";
}

// A small lit scene with an own node in it.
graph::Document scene_with(const graph::OwnType& own)
{
    auto library = graph::with_own_types(*graph::Library::embedded(), {own});
    StarterScene scene(library, *library->type(own.name));
    scene.document.own_types = {own};
    return scene.document;
}

TEST(Digest, agrees_with_the_standards_examples)
{
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

using TrustedCodeTest = tests::InFolder;

TEST_F(TrustedCodeTest, is_remembered_under_any_name_and_only_as_it_was)
{
    TrustedCode first(folder_ / "trusted.json"), second(folder_ / "trusted.json");
    first.trust({{"ball", ball_text("ball")}});
    EXPECT_TRUE(first.trusts({"pearl", ball_text("pearl")}));
    EXPECT_FALSE(first.trusts({"ball", ball_text("ball") + " "}));
    second.trust({{"other", ball_text("other", "return 1.0f;")}});
    TrustedCode later(folder_ / "trusted.json");
    EXPECT_TRUE(later.trusts({"ball", ball_text("ball")})) << "what another window trusts is kept";
    EXPECT_TRUE(later.trusts({"other", ball_text("other", "return 1.0f;")}));
    tests::write_text(folder_ / "trusted.json", "[1, \"short\", {}]");
    EXPECT_FALSE(TrustedCode(folder_ / "trusted.json").trusts({"ball", ball_text("ball")}));
}

class CodeReviewTest : public tests::InFolder {
protected:
    CodeReview review_of(ShaderVerdict verdict)
    {
        return {folder_ / "trusted.json",
                [this, verdict](const std::string& shader, const std::stop_token&) {
                    tried_ = shader;
                    return verdict;
                },
                [this] { ready_ = true; }};
    }
    // Until the trial that is under way has ended.
    void wait(CodeReview& review)
    {
        review.update(library_);
        for (int i = 0; i < 5000 && !ready_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_TRUE(review.update(library_));
    }

    std::shared_ptr<const graph::Library> library_ = graph::Library::embedded();
    graph::OwnType ball_{"ball", ball_text("ball")};
    std::string tried_;
    std::atomic<bool> ready_ = false;
};

TEST_F(CodeReviewTest, foreign_code_waits_for_a_word_and_is_not_even_tried)
{
    CodeReview review = review_of({});
    ASSERT_TRUE(review.verdict(ball_));
    EXPECT_FALSE(review.verdict(ball_)->waiting);
    EXPECT_SAYS(review.verdict(ball_)->rule, "came with the scene");
    EXPECT_FALSE(review.update(library_));
    EXPECT_FALSE(ready_);
    graph::Document document = scene_with(ball_);
    EXPECT_EQ(review.foreign(document).size(), 1u);
    review.trust(review.foreign(document));
    EXPECT_TRUE(review.foreign(document).empty());
    EXPECT_TRUE(review.verdict(ball_)->waiting);
}

TEST_F(CodeReviewTest, trusted_code_is_tried_once_and_then_runs)
{
    CodeReview review = review_of({});
    review.trust({ball_});
    ASSERT_TRUE(review.verdict(ball_)->waiting);
    wait(review);
    EXPECT_EQ(review.verdict(ball_), std::nullopt);
    EXPECT_EQ(review.verdict({"pearl", ball_text("pearl")}), std::nullopt) << "the same under another name";
    EXPECT_SAYS(tried_, "float ball_distance(vec3 p)");
    EXPECT_EQ(tests::glslang_errors({tried_}), "");
}

TEST_F(CodeReviewTest, what_became_of_the_worker_is_the_nodes_sentence)
{
    CodeReview review = review_of({assets::Ending::too_slow, "", "its code takes too long"});
    review.trust({ball_});
    review.verdict(ball_);
    wait(review);
    EXPECT_EQ(sentence(*review.verdict(ball_)), "its code takes too long");
}

TEST_F(CodeReviewTest, the_drivers_words_are_told_at_their_line)
{
    auto library = graph::with_own_types(*library_, {{"ball", ball_text("ball", "return size;")}});
    graph::Document document = scene_with({"ball", ball_text("ball", "return size;")});
    graph::Program program = graph::lower(document, library);
    std::string shader =
        codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), codegen::Placement::literals);
    std::string before = shader.substr(0, shader.find("return size;"));
    std::string line = std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
    graph::TextError error =
        error_in_type("0:" + line + "(12): error: `size' undeclared\nmore", "ball", *library, shader);
    EXPECT_EQ(sentence(error), "line 5: the driver does not take it: `size' undeclared");
}

// In a process of its own, by the driver of this machine.
TEST_F(CodeReviewTest, this_machines_driver_tells_good_code_from_bad)
{
    CodeReview review(
        folder_ / "trusted.json",
        [](const std::string& shader, const std::stop_token& stop) {
            return try_shader(assets::Worker(FIELDWRIGHT_BINARY), shader, "its code", stop);
        },
        [this] { ready_ = true; });
    graph::OwnType bad{"ball", ball_text("ball", "return unheard_of;")};
    review.trust({ball_, bad});
    review.verdict(ball_);
    review.verdict(bad);
    for (int i = 0; i < 30000 && (!review.verdict(bad) || review.verdict(bad)->waiting); ++i) {
        review.update(library_);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(review.verdict(ball_), std::nullopt);
    ASSERT_TRUE(review.verdict(bad));
    EXPECT_EQ(review.verdict(bad)->line, 5);
    EXPECT_SAYS(review.verdict(bad)->rule, "unheard_of");
}

class OwnTypeSession : public testing::Test {
protected:
    OwnTypeSession()
    {
        document() = scene_with({"ball", ball_text("ball")});
        session.settle("Add");
        session.use_judge([this](const graph::OwnType&) { return judgement; });
    }
    graph::Document& document() { return session.document(); }
    graph::Program lowered() { return graph::lower(document(), session.library()); }
    bool set_text(const std::string& text)
    {
        graph::set_own_type_text(document(), "ball", text);
        session.follow_types();
        return session.settle("Edit");
    }

    EditSession session{graph::Library::embedded()};
    std::optional<graph::TextError> judgement;
};

TEST_F(OwnTypeSession, the_library_follows_edits_and_undo)
{
    EXPECT_TRUE(session.library()->type("ball"));
    ASSERT_TRUE(set_text(ball_text("ball", "return 1.0f;")));
    EXPECT_EQ(session.library()->type("ball")->source.text, ball_text("ball", "return 1.0f;"));
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.library()->type("ball")->source.text, ball_text("ball"));
    ASSERT_TRUE(session.undo());
    EXPECT_FALSE(session.library()->type("ball"));
    ASSERT_TRUE(session.redo());
    EXPECT_TRUE(session.library()->type("ball"));
    session.new_scene();
    EXPECT_FALSE(session.library()->type("ball"));
}

TEST_F(OwnTypeSession, what_ran_last_is_shown_while_the_text_is_broken)
{
    ASSERT_TRUE(set_text("// Ball\n"));
    EXPECT_TRUE(lowered().gpu_only) << "it is drawn";
    EXPECT_SAYS(lowered().problems.at(0).sentence, "line 1: the first line must read");
    EXPECT_EQ(graph::validate(document(), *session.library()), std::nullopt);
    ASSERT_TRUE(set_text(ball_text("ball")));
    EXPECT_FALSE(session.library()->left_out("ball"));
}

TEST_F(OwnTypeSession, code_that_is_being_tried_changes_nothing_until_it_is_good)
{
    judgement = graph::TextError{.rule = "its code is being tried", .waiting = true};
    ASSERT_TRUE(
        set_text("// Ball: round.\n// field: exact\nfloat ball_distance(\n    vec3 p,\n    float girth)  // 0.25 "
                 "[0, 1] m  Radius.\n{\n    return length(p) - girth;\n}\nBox ball_bounds(float girth) { return "
                 "make_box(vec3(0.0f), vec3(girth)); }\n"));
    EXPECT_FALSE(session.library()->type("ball")->parameter("girth"));
    for (const graph::Problem& problem : lowered().problems)
        EXPECT_EQ(problem.severity, graph::Problem::Severity::note) << problem.sentence;
    judgement.reset();
    std::size_t steps = session.history().size();
    session.judge_again();
    EXPECT_TRUE(session.library()->type("ball")->parameter("girth"));
    EXPECT_EQ(graph::validate(document(), *session.library()), std::nullopt);
    EXPECT_EQ(session.history().size(), steps);
    EXPECT_EQ(session.history().current(), document()) << "not an edit of the user's";
}

TEST_F(OwnTypeSession, a_foreign_scene_is_shown_without_its_code)
{
    judgement = graph::TextError{.rule = "its code waits"};
    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("fieldwright-foreign-" + std::to_string(::getpid()) + ".scene.json");
    graph::save_scene(file, document(), *session.library());
    session.open(file);
    std::filesystem::remove(file);
    EXPECT_FALSE(lowered().gpu_only);
    EXPECT_SAYS(lowered().problems.at(0).sentence, "its code waits; it counts as unconnected");
    EXPECT_FALSE(session.dirty());
}

// Every template in the scene around it, as text and as a second compiler sees it.
TEST(CustomTemplates, are_good_nodes_of_their_category)
{
    std::vector<std::string> shaders, categories;
    for (const graph::CustomTemplate& custom : graph::custom_templates()) {
        graph::Document document;
        auto base = graph::Library::embedded();
        graph::Placed placed = graph::add_custom_node(document, *base, custom.name, {0, 0}, {});
        ASSERT_EQ(placed.refusal, std::nullopt);
        auto library = graph::with_own_types(*base, document.own_types);
        const graph::NodeType* type = library->type(custom.name);
        ASSERT_TRUE(type) << sentence(*library->left_out(custom.name));
        EXPECT_EQ(type->title, custom.title);
        categories.push_back(type->category);
        StarterScene scene(library, *type);
        graph::Program program = graph::lower(scene.document, library);
        EXPECT_TRUE(program.gpu_only) << custom.name << " is not drawn";
        shaders.push_back(
            codegen::print_fragment_shader(program, field::evaluate_frame(program, 0), codegen::Placement::literals));
        EXPECT_SAYS(shaders.back(), std::string(custom.name) + "_");
    }
    EXPECT_EQ(categories, (std::vector<std::string>{"primitive", "shape2d", "modify", "domain", "value", "material"}));
    EXPECT_EQ(tests::glslang_errors(shaders), "");
}

class OwnTypeCommands : public tests::InFolder {
protected:
    OwnTypeCommands()
    {
        graph::Document document = scene_with({"ball", ball_text("ball")});
        graph::save_scene(path("own.scene.json"), document,
                          *graph::with_own_types(*graph::Library::embedded(), document.own_types));
    }
    tests::Outcome run(const std::string& words) { return tests::run_program(words + " " + path("own.scene.json")); }
};

TEST_F(OwnTypeCommands, render_runs_a_scenes_code_only_when_allowed)
{
    std::string words = "render -q --size 64x48 -o " + path("own.png");
    tests::Outcome refused = run(words);
    EXPECT_EQ(refused.code, 3);
    EXPECT_SAYS(refused.errors, "brings its own shader code (1 node type)");
    EXPECT_SAYS(refused.errors, "--allow-code");
    EXPECT_FALSE(std::filesystem::exists(path("own.png")));
    tests::Outcome drawn = run(words + " --allow-code");
    EXPECT_EQ(drawn.code, 0) << drawn.errors;
    EXPECT_TRUE(std::filesystem::exists(path("own.png")));
}

TEST_F(OwnTypeCommands, check_and_export_run_nothing_and_need_no_leave)
{
    EXPECT_EQ(run("check").code, 0);
    EXPECT_EQ(run("export --target glsl -o " + path("own.glsl")).code, 0);
    EXPECT_SAYS(tests::read_text(path("own.glsl")), "float ball_distance(vec3 p)");
}

TEST_F(OwnTypeCommands, the_users_folder_adds_nodes)
{
    auto folder = folder_ / "data/fieldwright/nodes";
    auto library = graph::with_own_types(*graph::Library::embedded(), {{"pearl", ball_text("pearl")}});
    EXPECT_EQ(save_user_node(folder, *library->type("pearl")), folder / "primitive/pearl.glsl");
    EXPECT_THROW(save_user_node(folder, *library->type("pearl")), graph::Failure);
    tests::write_text(folder / "broken.glsl", "// Broken\n");
    auto with_user = with_user_nodes(*graph::Library::embedded(), folder);
    EXPECT_EQ(with_user->type("pearl")->origin, graph::Origin::user_folder);
    ASSERT_EQ(with_user->left_out_of(graph::Origin::user_folder).size(), 1u);
    tests::Outcome listed = tests::run_shell("XDG_DATA_HOME=" + path("data") + " " + FIELDWRIGHT_BINARY + " nodes");
    EXPECT_EQ(listed.code, 0);
    EXPECT_SAYS(listed.output, "\n  pearl ");
}

}  // namespace
}  // namespace fieldwright::app

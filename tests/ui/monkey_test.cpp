// Whatever the hands do, the window stands and the document keeps its promises.
#include "graph/scene_file.h"
#include "tests/ui/driver.h"
#include "ui/commands.h"
#include "ui/keys.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace fieldwright::tests {
namespace {

using Kind = ui::InputEvent::Kind;
constexpr int event_count = 20'000, frames_per_check = 100;

unsigned seed()
{
    const char* wanted = std::getenv("FIELDWRIGHT_SEED");
    return wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : 20'240'607u;
}

class Monkey {
public:
    Monkey()
        : random_(seed()),
          driver_(graph::open_scene(std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples/first.scene.json",
                                    *graph::Library::embedded()))
    {
        for (const ui::Command& command : ui::commands(driver_.readings, *driver_.library))
            for (const ui::Shortcut& shortcut : command.shortcuts) shortcuts_.push_back(shortcut);
        for (const ui::Command& command : ui::commands(driver_.readings, *driver_.library)) ids_.push_back(command.id);
    }

    void play()
    {
        int frames = 0;
        while (told_ < event_count && !testing::Test::HasFailure()) {
            act();
            while (!driver_.queue.empty()) {
                std::size_t before = driver_.step;
                driver_.frame();
                made_ += driver_.step != before ? 1 : 0;
                if (++frames % frames_per_check == 0) check();
            }
            answer();
        }
        check();
        std::cout << frames << " frames, " << made_ << " steps made, undone or redone" << std::endl;
        EXPECT_GT(made_, 300) << "the hands were tied";
    }

private:
    int below(int limit) { return std::uniform_int_distribution(0, limit - 1)(random_); }
    glm::vec2 anywhere()
    {
        ImVec2 size = ImGui::GetIO().DisplaySize;
        return {static_cast<float>(below(static_cast<int>(size.x) + 20) - 10),
                static_cast<float>(below(static_cast<int>(size.y) + 20) - 10)};
    }
    // Mostly the middle of a widget, of a node more than of others: hands go where something is.
    glm::vec2 somewhere()
    {
        const auto& rects = driver_.editor.rects.all();
        auto first = rects.begin(), last = rects.end();
        int choice = below(3);
        if (choice == 0) first = rects.lower_bound("canvas/node"), last = rects.lower_bound("canvas/nodf");
        auto count = std::distance(first, last);
        if (choice == 1 || count == 0) return anywhere();
        return std::next(first, below(static_cast<int>(count)))->second.centre();
    }

    void tell(ui::InputEvent event)
    {
        driver_.queue.push(event);
        ++told_;
    }
    void button(int code, bool down) { tell({.kind = Kind::button, .code = code, .down = down}); }
    void key(int code, bool down) { tell({.kind = Kind::key, .code = code, .down = down}); }
    void move(glm::vec2 at) { tell({.kind = Kind::move, .at = at}); }

    void act()
    {
        switch (below(18)) {
            case 0:
            case 1:
            case 2: move(somewhere()); break;
            case 3:
            case 4:
            case 5: click(); break;
            case 6:
            case 7:
            case 8: drag(); break;
            case 9: tell({.kind = Kind::wheel, .at = {0, static_cast<float>(below(7) - 3)}}); break;
            case 10:
            case 11:
            case 12: press_shortcut(); break;
            case 13: press_key(below(3) ? ui::key::escape : 32 + below(316)); break;
            case 14: type(); break;
            case 15:
            case 16: driver_.editor.run(ids_[static_cast<std::size_t>(below(static_cast<int>(ids_.size())))]); break;
            case 17: tell({.kind = Kind::focus, .down = below(2) == 0}); break;
        }
    }

    void click()
    {
        int code = below(4) ? 0 : below(3);
        move(somewhere());
        for (int times = below(4) ? 1 : 2; times > 0; --times) button(code, true), button(code, false);
    }

    void drag()
    {
        int code = below(3) ? 0 : below(3), modifier = ui::key::left_shift + below(3);
        bool modified = below(3) == 0;
        if (modified) key(modifier, true);
        move(somewhere());
        button(code, true);
        for (int moves = below(5); moves > 0; --moves) move(somewhere());
        if (below(8) == 0) press_shortcut();
        button(code, false);
        if (modified) key(modifier, false);
    }

    void press_key(int code) { key(code, true), key(code, false); }

    void press_shortcut()
    {
        const ui::Shortcut& shortcut = shortcuts_[static_cast<std::size_t>(below(static_cast<int>(shortcuts_.size())))];
        if (shortcut.control) key(ui::key::left_control, true);
        if (shortcut.shift) key(ui::key::left_shift, true);
        if (shortcut.alt) key(ui::key::left_alt, true);
        press_key(shortcut.key);
        if (shortcut.control) key(ui::key::left_control, false);
        if (shortcut.shift) key(ui::key::left_shift, false);
        if (shortcut.alt) key(ui::key::left_alt, false);
    }

    void type()
    {
        constexpr char32_t letters[] = U"0123456789.-+eEabz \U000000e9\U000003b1";
        for (int count = 1 + below(5); count > 0; --count)
            tell({.kind = Kind::character, .code = static_cast<int>(letters[below(std::size(letters) - 1)])});
        if (below(2)) press_key(ui::key::enter);
    }

    // The program's part: files that change, dialogs that are asked for.
    void answer()
    {
        for (const ui::Request& request : driver_.requests) {
            const auto* choose = std::get_if<ui::ChooseFile>(&request);
            if (choose && below(2))
                driver_.editor.browse(*choose, std::string(FIELDWRIGHT_SOURCE_DIR) + "/examples", "x");
            if (std::holds_alternative<ui::SaveFile>(request)) driver_.readings.dirty = false;
        }
        driver_.requests.clear();
        if (below(50) == 0) driver_.readings.dirty = !driver_.readings.dirty;
        if (below(200) == 0) driver_.readings.changed_on_disk = !driver_.readings.changed_on_disk;
        if (below(500) == 0) driver_.editor.ask_quit();
        keep_small();
    }

    // A scene that grows without end would only make the test slow.
    void keep_small()
    {
        if (driver_.document.root.nodes.size() < 150) return;
        let_go();
        driver_.editor.run("edit.select_all");
        driver_.editor.run("edit.delete");
        driver_.frames(3);
    }

    void let_go()
    {
        driver_.queue.push({.kind = Kind::focus, .down = false});
        driver_.run_until_quiet();
        driver_.queue.push({.kind = Kind::focus, .down = true});
        driver_.move({5, 5});
        for (int i = 0; i < 4; ++i) driver_.key(ui::key::escape);
    }

    // Hands off: what they held is a step now. Undone and redone, a step is what it was.
    void check()
    {
        let_go();
        SCOPED_TRACE("after " + std::to_string(told_) + " events of seed " + std::to_string(seed()));
        EXPECT_EQ(graph::validate(driver_.document, *driver_.library), std::nullopt);
        ASSERT_TRUE(driver_.document == driver_.steps[driver_.step].first) << "a gesture left no step";
        EXPECT_FALSE(driver_.steps[driver_.step].second.empty());
        std::size_t step = driver_.step;
        if (step == 0) return;
        graph::Document now = driver_.document;
        ask(ui::Undo{});
        EXPECT_TRUE(driver_.document == driver_.steps[step - 1].first);
        ask(ui::Redo{});
        EXPECT_TRUE(driver_.document == now);
        forget_old_steps();
    }

    void ask(ui::Request request)
    {
        driver_.editor.ask(std::move(request));
        driver_.frames(2);
    }

    void forget_old_steps()
    {
        if (driver_.step + 1 != driver_.steps.size() || driver_.steps.size() < 40) return;
        driver_.steps.erase(driver_.steps.begin(), driver_.steps.end() - 20);
        driver_.step = driver_.steps.size() - 1;
    }

    std::mt19937 random_;
    Driver driver_;
    std::vector<ui::Shortcut> shortcuts_;
    std::vector<std::string> ids_;  // of commands
    int told_ = 0, made_ = 0;
};

TEST(Monkey, breaks_nothing_in_20000_events)
{
    std::cout << "FIELDWRIGHT_SEED=" << seed() << std::endl;
    Monkey().play();
}

}  // namespace
}  // namespace fieldwright::tests

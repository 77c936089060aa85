// The scenes that rebuild the seeds: each opens, lowers and shows what it should (devices_agree_test.cpp: the same on both devices).
#include "graph/scene_file.h"
#include "tests/app/program.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fieldwright::tests {
namespace {

using namespace renderer;
namespace fs = std::filesystem;

struct Expected {
    int nodes, materials;  // surfaces of that many shapes and materials are seen, at least
};

const std::map<std::string, Expected>& expected()
{
    static const std::map<std::string, Expected> scenes = {
        {"000_bending", {6, 6}},       {"000_bending_stripes", {6, 6}},
        {"000_booleans", {5, 4}},      {"000_glass", {7, 7}},
        {"000_repetition", {3, 3}},    {"000_soft_shadow", {7, 3}},
        {"001_magnemite", {9, 7}},     {"002_circle", {2, 2}},
        {"002_intersection", {3, 2}},  {"002_square", {2, 2}},
        {"002_squircle", {2, 2}},      {"002_subtraction", {2, 2}},
        {"002_three_tori", {4, 2}},    {"002_three_tori_orthographic", {4, 2}},
        {"002_union", {3, 2}},         {"003_square_triangle_circle", {5, 2}},
        {"003_three_circles", {3, 1}}, {"003_three_letters", {5, 2}},
        {"004_csg", {10, 10}},
    };
    return scenes;
}

std::vector<std::string> seed_scenes()
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source_folder() / "examples" / "seeds")) {
        std::string name = entry.path().filename();
        names.push_back(name.substr(0, name.find('.')));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t kinds(const std::vector<int>& ids)
{
    std::set<int> seen(ids.begin(), ids.end());
    seen.erase(0);
    return seen.size();
}

class SeedScene : public testing::TestWithParam<std::string> {
protected:
    graph::Program program() const
    {
        auto library = graph::Library::embedded();
        fs::path path = source_folder() / "examples" / "seeds" / (GetParam() + ".scene.json");
        return graph::lower(graph::open_scene(path, *library), library);
    }
};

TEST_P(SeedScene, opens_and_lowers_without_problems)
{
    for (const graph::Problem& problem : program().problems) ADD_FAILURE() << problem.sentence;
}

TEST_P(SeedScene, shows_its_surfaces)
{
    ASSERT_TRUE(expected().contains(GetParam())) << "say what is seen in it";
    Frame frame = render_on_cpu(program(), {.width = 240, .height = 135, .time = 0.6f});
    EXPECT_GE(kinds(frame.node_id), static_cast<std::size_t>(expected().at(GetParam()).nodes));
    EXPECT_GE(kinds(frame.material_id), static_cast<std::size_t>(expected().at(GetParam()).materials));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SeedScene, testing::ValuesIn(seed_scenes()),
                         [](const auto& seed) { return "scene_" + seed.param; });

TEST(SeedScenes, are_of_all_five_seeds)
{
    std::set<std::string> numbers;
    for (const std::string& name : seed_scenes()) numbers.insert(name.substr(0, 3));
    EXPECT_EQ(numbers, (std::set<std::string>{"000", "001", "002", "003", "004"}));
}

// File names of the pictures that the gallery's list draws, and the scenes they are of.
std::map<std::string, std::string> listed_pictures()
{
    std::map<std::string, std::string> pictures;
    std::istringstream list(read_text(source_folder() / "docs/gallery/pictures.txt"));
    for (std::string line; std::getline(list, line);) {
        std::istringstream words(line);
        std::string name, scene;
        if (!line.starts_with('#') && words >> name >> scene)
            pictures[name.find('.') == std::string::npos ? name + ".png" : name] = scene;
    }
    return pictures;
}

TEST(Gallery, shows_every_scene)
{
    std::set<std::string> shown;
    for (const auto& [name, scene] : listed_pictures()) shown.insert(scene);
    std::vector<std::string> all = seed_scenes();
    EXPECT_EQ(shown, std::set<std::string>(all.begin(), all.end()));
}

TEST(Gallery, has_the_pictures_of_its_pages_and_no_others)
{
    static const std::regex picture(R"(\(images/([\w.]+)\))");
    std::set<std::string> used, listed;
    for (const char* page : {"README", "000", "001", "002", "003", "004"}) {
        std::string text = read_text(source_folder() / "docs/gallery" / (std::string(page) + ".md"));
        for (std::sregex_iterator match(text.begin(), text.end(), picture), end; match != end; ++match)
            used.insert((*match)[1]);
    }
    for (const auto& [name, scene] : listed_pictures()) listed.insert(name);
    EXPECT_EQ(used, listed);
    for (const std::string& name : used) {
        fs::path file = source_folder() / "docs/gallery/images" / name;
        ASSERT_TRUE(fs::exists(file)) << file << ": `./dev docs` draws it";
        EXPECT_LE(fs::file_size(file), 250'000u) << file;
    }
}

}  // namespace
}  // namespace fieldwright::tests

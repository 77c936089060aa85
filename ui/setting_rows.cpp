// The words of settings, and their rows.
#include "ui/setting_rows.h"

#include "ui/colour_field.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace fieldwright::ui {
namespace {

constexpr SettingWords all_words[] = {
    {"march", "step_limit", "Step limit", "",
     "Most steps that a ray takes. More reaches farther into grazing angles and costs time.", 16, 512},
    {"march", "minimum_step", "Minimum step", "m", "Shortest step; longer is faster and may pass through thin things.",
     0, 0.01},
    {"march", "tolerance", "Tolerance", "m",
     "How near to a surface a ray counts as arrived; smaller shows finer detail.", 0, 0.01},
    {"march", "near", "Near", "m", "Where along the ray the scene begins.", 0, 1},
    {"march", "far", "Far", "m", "Where along the ray the scene ends.", 1, 500},
    {"march", "step_scale", "Own scale", "",
     "Length of a step in distances. Above what the scene allows, steps pass through surfaces, which shows as stripes.",
     0.1, 2},
    {"march", "constant_step", "Step", "m", "Length of every step; what is thinner may be passed through.", 0.005, 0.5},
    {"march", "normal_step", "Normal step", "m",
     "How far from a surface its slope is measured; longer rounds edges. 0 fits it to the distance from the eye.", 0,
     0.05, "By distance"},
    {"march", "out_of_steps", "Out of steps", "",
     "What a ray that ran out of steps shows: the sky, or the place where it stopped."},
    {"march", "method", "Method", "",
     "Sphere tracing steps as far as the distance allows. Constant steps, halved where they cross a surface, are for "
     "comparison: slower, and blind to thin things."},
    {"march", "step_scale_from", "Step scale", "",
     "Derived: bent and stretched parts are slowed by what their nodes say. Own: by a number of yours instead, for "
     "comparison."},
    {"march", "normals", "Normals", "",
     "How slopes are measured: with four distances at the corners of a tetrahedron, or with six along the axes."},
    {"march", "anti_aliasing", "Anti-aliasing", "",
     "Coverage: where an edge passes through a pixel, what lies on both sides shares it, at the cost of one more ray "
     "there. "
     "None: samples alone smooth edges."},
    {"occlusion", "kind", "Kind", "",
     "What darkens: the mean of distance and height over the samples, or their smallest ratio."},
    {"occlusion", "strength", "Strength", "", "How dark corners get where little of the sky is seen; 0 is off.", 0, 1,
     "Off"},
    {"occlusion", "radius", "Radius", "m", "How far above a surface other things darken it.", 0.01, 5},
    {"occlusion", "samples", "Samples", "", "How many distances are taken on the way to the radius.", 1, 16},
    {"occlusion", "step", "Step", "m",
     "From one distance to the next: the radius by the samples. A change moves the radius; of the smallest ratio it is "
     "the shortest step.",
     0.001, 1},
    {"bounces", "bounces", "Bounces", "",
     "How often mirrors and glass send a ray on. Two see through a solid of glass; each may double the time. At 0 they "
     "show the sky at one look.",
     0, 8, "None"},
    {"fog", "density", "Density", "1/m", "Share of the light that a short way through the air takes; 0 is off.", 0, 0.2,
     "Off"},
    {"fog", "start", "Start", "m", "Way in front of the eye that is free of fog.", 0, 50},
    {"fog", "height_falloff", "Height falloff", "1/m",
     "How fast the fog thins out with height, from y = 0 up; 0: the same everywhere.", 0, 2, "Uniform"},
    {"fog", "colour", "Fog's colour", "", "What the fog looks like where one sees no farther."},
    {"picture", "samples", "Samples", "",
     "Rays through a pixel of a finished picture: smooth edges, depth of field and motion blur.", 1, 256},
    {"picture", "shutter", "Shutter", "s",
     "How long a picture is exposed, around its moment: what moves is blurred. 0 freezes it.", 0, 0.5, "Frozen"},
    {"picture", "tone_map", "Tone map", "",
     "How bright light is compressed: not at all, keeping base colours, or as on film."},
    {"picture", "exposure", "Exposure", "stops",
     "Brightens the picture before tone mapping; each stop doubles the light.", -5, 5},
    {"picture", "backdrop", "Backdrop", "", "What the picture shows where there is nothing."},
    {"picture", "backdrop_colour", "Backdrop colour", "", "What shows where there is nothing."},
    {"animation", "first_frame", "First frame", "", "Where the animation begins. Frame 1 shows the time 0.", 1, 250},
    {"animation", "last_frame", "Last frame", "", "Where the animation ends.", 1, 250},
    {"animation", "frames_per_second", "Frames per second", "", "How many frames of the animation make a second.", 1,
     60},
};

// Of the words of files.
constexpr std::pair<std::string_view, std::string_view> choice_titles[] = {{"miss", "Sky"},
                                                                           {"hit", "Surface"},
                                                                           {"sphere_tracing", "Sphere tracing"},
                                                                           {"constant_steps", "Constant"},
                                                                           {"derived", "Derived"},
                                                                           {"own", "Own"},
                                                                           {"tetrahedron", "Tetrahedron"},
                                                                           {"central", "Central"},
                                                                           {"coverage", "Coverage"},
                                                                           {"mean", "Mean"},
                                                                           {"smallest_ratio", "Smallest ratio"},
                                                                           {"none", "None"},
                                                                           {"neutral", "Neutral"},
                                                                           {"agx", "AgX"},
                                                                           {"aces", "ACES"},
                                                                           {"sky", "Sky"},
                                                                           {"colour", "Colour"},
                                                                           {"transparent", "None"}};

std::string choice_title(std::string_view word)
{
    return std::string(std::find_if(std::begin(choice_titles), std::end(choice_titles) - 1, [&](const auto& title) {
                           return title.first == word;
                       })->second);
}

std::string in_sentence(const SettingWords& words) { return graph::inside_a_sentence(std::string(words.title)); }

}  // namespace

const SettingWords& setting_words(std::string_view group, std::string_view name)
{
    return *std::find_if(std::begin(all_words), std::end(all_words) - 1,
                         [&](const SettingWords& words) { return words.group == group && words.name == name; });
}

bool number_setting(FrameContext& frame, const std::string& mark, const SettingWords& words, double& value,
                    double initial, NumberStyle style, std::string& step)
{
    style.soft_minimum = std::max(words.soft_minimum, style.minimum);
    style.soft_maximum = words.soft_maximum;
    style.unit = words.unit;
    style.at_zero = words.at_zero;
    style.tip = words.help;
    ImGui::PushID(mark.c_str());
    style.width_px = begin_row(frame, words.title, words.help);
    bool changed = number_field(frame, "##number", std::string(words.title), value, style);
    frame.rects.mark(mark);
    if (changed) step = "Change " + in_sentence(words);
    if (value != initial) {
        to_row_end(frame);
        if (icon_button(frame, "reset", icon::undo, "Reset to the default")) {
            value = initial;
            step = "Reset " + in_sentence(words);
            changed = true;
        }
        frame.rects.mark(mark + "/reset");
    }
    ImGui::PopID();
    return changed;
}

bool choice_setting(FrameContext& frame, const std::string& mark, const SettingWords& words,
                    std::span<const std::string_view> choices, std::size_t& chosen, std::string& step)
{
    begin_row(frame, words.title, words.help);
    std::vector<std::pair<std::string, std::string>> titled;
    for (std::string_view choice : choices) titled.emplace_back(choice, choice_title(choice));
    std::string word = titled[chosen].first;
    if (!segments(frame, mark, titled, word)) return false;
    chosen = static_cast<std::size_t>(std::find(choices.begin(), choices.end(), word) - choices.begin());
    step = "Change " + in_sentence(words);
    return true;
}

bool colour_setting(FrameContext& frame, const std::string& mark, const SettingWords& words, glm::vec3& colour,
                    std::string& step)
{
    float width_px = begin_row(frame, words.title, words.help);
    ImGui::PushID(mark.c_str());
    bool changed = colour_field(frame, mark, in_sentence(words), colour, width_px);
    ImGui::PopID();
    if (changed) step = "Change " + in_sentence(words);
    return changed;
}

}  // namespace fieldwright::ui

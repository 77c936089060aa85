// The sections of the scene's settings: which rows they have, and when.
#include "ui/scene_settings.h"

#include "graph/edits.h"
#include "ui/setting_rows.h"
#include "ui/widgets.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

// Rows of one structure, and what becomes of a change.
template <typename Settings, typename Draw, typename Change>
void settings(FrameContext& frame, std::string path, std::string_view group, const graph::SettingTable<Settings>& table,
              const Settings& now, const Draw& draw, const Change& change)
{
    SettingRows rows(frame, std::move(path), group, table, now);
    draw(rows);
    if (!rows.step().empty()) frame.draft.done(rows.step(), change(frame.draft.document, rows.settings()));
}

void march_rows(FrameContext& frame, SettingRows<graph::MarchSettings>& rows)
{
    section(frame, "Ray marching");
    rows.row("method");
    bool constant = rows.settings().constant_steps;
    if (constant) rows.row("constant_step");
    rows.row("step_limit");
    if (!constant) rows.row("minimum_step");
    for (const char* name : {"tolerance", "near", "far"}) rows.row(name);
    if (!constant) rows.row("step_scale_from");
    if (!constant && rows.settings().own_step_scale) rows.row("step_scale");
    rows.row("out_of_steps");
    rows.row("anti_aliasing");
    section(frame, "Normals");
    rows.row("normals");
    rows.row("normal_step");
}

void occlusion_rows(FrameContext& frame, SettingRows<graph::OcclusionSettings>& rows)
{
    section(frame, "Occlusion");
    for (const char* name : {"kind", "strength", "radius", "samples"}) rows.row(name);
    auto step = [](const graph::OcclusionSettings& settings) {
        return static_cast<double>(settings.radius) / settings.samples;
    };
    NumberStyle style{.minimum = 1e-4, .maximum = 1e3};
    rows.derived_row("step", step(rows.settings()), step({}), style, [](graph::OcclusionSettings& settings, double m) {
        settings.radius = std::clamp(static_cast<float>(m * settings.samples), 1e-3f, 1e3f);
    });
}

// A reset gives the bounces of new scenes.
void bounces_row(FrameContext& frame, const std::string& path)
{
    section(frame, "Mirrors and glass");
    std::string step;
    double bounces = frame.draft.document.bounces;
    NumberStyle style{.minimum = 0, .maximum = graph::bounces_maximum, .whole = true};
    if (number_setting(frame, path + "/bounces", setting_words("bounces", "bounces"), bounces,
                       graph::bounces_of_new_scenes, style, step))
        frame.draft.done(step, graph::set_bounces(frame.draft.document, static_cast<int>(bounces)));
}

void fog_rows(FrameContext& frame, SettingRows<graph::FogSettings>& rows)
{
    section(frame, "Fog");
    for (const char* name : {"density", "start", "height_falloff", "colour"}) rows.row(name);
}

void picture_rows(FrameContext& frame, SettingRows<graph::PictureSettings>& rows)
{
    section(frame, "Picture");
    for (const char* name : {"samples", "tone_map", "exposure", "shutter", "backdrop"}) rows.row(name);
    if (rows.settings().backdrop == graph::Backdrop::colour) rows.row("backdrop_colour");
}

void animation_rows(FrameContext& frame, SettingRows<graph::AnimationSettings>& rows)
{
    section(frame, "Animation");
    for (const char* name : {"first_frame", "last_frame", "frames_per_second"}) rows.row(name);
}

}  // namespace

void scene_settings(FrameContext& frame, std::string_view path)
{
    const graph::Document& document = frame.draft.document;
    std::string place(path);
    settings(
        frame, place, "march", graph::march_table, document.march, [&](auto& rows) { march_rows(frame, rows); },
        graph::set_march);
    settings(
        frame, place + "/occlusion", "occlusion", graph::occlusion_table, document.occlusion,
        [&](auto& rows) { occlusion_rows(frame, rows); }, graph::set_occlusion);
    bounces_row(frame, place);
    settings(
        frame, place + "/fog", "fog", graph::fog_table, document.fog, [&](auto& rows) { fog_rows(frame, rows); },
        graph::set_fog);
    settings(
        frame, place, "picture", graph::picture_table, document.picture, [&](auto& rows) { picture_rows(frame, rows); },
        graph::set_picture);
    settings(
        frame, place, "animation", graph::animation_table, document.animation,
        [&](auto& rows) { animation_rows(frame, rows); }, graph::set_animation);
}

}  // namespace fieldwright::ui

// What the window is told.
#include "app/workbench.h"

#include "ui/group_actions.h"

namespace fieldwright::app {
namespace {

// "CPU", or "GPU" with the driver's own name for it; nothing before there is a picture.
std::string device_words(const std::optional<renderer::DrawnPicture>& drawn, const renderer::RenderStatus& status)
{
    if (!drawn) return {};
    if (drawn->device == renderer::Device::cpu) return "CPU";
    std::string name = status.gpu.substr(0, status.gpu.find_first_of("(,/"));
    return "GPU " + name.substr(0, name.find_last_not_of(' ') + 1);
}

}  // namespace

void Workbench::fill_readings()
{
    readings_.program = scene_.program();
    std::string open = ui::shown_group(session_.document(), editor_.view);
    const graph::Group* group = graph::find_group(session_.document(), open);
    readings_.problems = ui::shown_problems(scene_.problems(), group ? group->graph : session_.document().root);
    readings_.missed_cells = scene_.missed_cells();
    for (const std::string& error : {reload_error_, compile_error_, autosave_.failure()})
        if (!error.empty()) readings_.problems.push_back({{}, error});
    for (const auto& [name, error] : session_.library()->left_out_of(graph::Origin::user_folder))
        readings_.problems.push_back({{}, "your node " + name + ": " + sentence(error)});
    bool reads_shader = editor_.view.panes.shown && editor_.view.panel == ui::Panel::shader;
    readings_.shader_text = reads_shader ? scene_.shader_text(static_cast<float>(editor_.view.time_s)) : nullptr;
    readings_.picture.texture = picture_.texture();
    readings_.picture.width = picture_.size().x;
    readings_.picture.height = picture_.size().y;
    renderer::RenderStatus rendering = render_thread_.status();
    readings_.picture.compiling = rendering.compiling;
    readings_.picture.device = device_words(drawn_, rendering);
    readings_.step_names = session_.history().names();
    readings_.step = session_.history().step();
    readings_.file_name = session_.name();
    readings_.file_path = session_.path() ? session_.path()->string() : "";
    readings_.dirty = session_.dirty();
    readings_.changed_on_disk = session_.changed_on_disk();
    readings_.overwrite_warning = session_.overwrite_warning();
    readings_.recent.clear();
    for (const RecentFile& file : recent_.entries()) readings_.recent.push_back({file.path.string(), file.missing});
    readings_.dialog_open = dialog_.is_open();
    readings_.time_s = editor_.view.time_s;
    readings_.has_camera = scene_.has_camera();
    ray_.follow(scene_.program(), static_cast<float>(editor_.view.time_s));
    readings_.ray = ray_.reading();
    readings_.node_costs = node_costs_.costs();
    bool shows_cost = editor_.view.panes.shown && editor_.view.panel == ui::Panel::cost;
    if (shows_cost && requested_ && picture_.of_rays())
        steps_texture_.show(picture_.of_rays(), requested_->display, requested_->program->march.step_limit);
    readings_.steps_picture = shows_cost ? steps_texture_.reading() : ui::StepsPicture{};
    window_.rename(session_.title() + " - Fieldwright");
}

}  // namespace fieldwright::app

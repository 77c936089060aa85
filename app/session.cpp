// Gestures become steps, files become documents, and nothing is lost in between.
#include "app/session.h"

#include "app/new_scene.h"
#include "app/picture_paths.h"
#include "graph/adapt.h"
#include "graph/group_types.h"
#include "graph/layout.h"
#include "graph/scene_file.h"
#include "ui/node_geometry.h"

namespace fieldwright::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* unsettled_name = "Edit";

std::optional<fs::path> absolute_path(std::optional<fs::path> path)
{
    if (path) path = fs::absolute(*path).lexically_normal();
    return path;
}

bool lay_out_heaps(graph::Document& document, const graph::Library& library)
{
    if (!graph::lies_in_heaps(document.root)) return false;
    auto size_px = [&](graph::NodeId id) {
        const graph::Node& node = *document.root.find(id);
        return ui::node_size(node, library.type(node.type));
    };
    return !graph::arrange(document, {}, size_px);
}

}  // namespace

EditSession::EditSession(std::shared_ptr<const graph::Library> library)
    : library_(std::move(library)), document_(app::new_scene(*library_)), history_(document_)
{
}

bool EditSession::settle(const std::string& step_name)
{
    follow_types();
    return history_.record(document_, step_name);
}

bool EditSession::undo()
{
    settle(unsettled_name);
    bool found = history_.undo();
    if (found) land();
    return found;
}

bool EditSession::redo()
{
    settle(unsettled_name);
    bool found = history_.redo();
    if (found) land();
    return found;
}

bool EditSession::jump(std::size_t step)
{
    // Settling may drop the oldest steps, which moves the others forward, and drops the steps after the current one.
    std::size_t dropped_before = history_.dropped();
    settle(unsettled_name);
    std::size_t moved = history_.dropped() - dropped_before;
    if (step < moved || step - moved >= history_.size()) return false;
    history_.jump(step - moved);
    land();
    return true;
}

// Onto a step, which may have been made under another library.
void EditSession::land()
{
    document_ = history_.current();
    if (!library_fits()) rebuild_library();
    adapt();
}

bool EditSession::library_fits() const
{
    return document_.own_types == library_->own_types() && document_.groups == known_groups_;
}

void EditSession::rebuild_library()
{
    library_ = graph::with_own_types(*library_, document_.own_types, own_type_rules_);
    for (const graph::OwnType& own : document_.own_types)
        if (const graph::NodeType* type = library_->type(own.name); type && !type->held_back && !type->former)
            own_type_rules_.former[own.name] = own.text;
    if (!document_.groups.empty()) library_ = graph::with_groups(*library_, document_);
    known_groups_ = document_.groups;
}

bool EditSession::follow_types()
{
    if (library_fits()) return false;
    bool others = document_.own_types != library_->own_types();
    rebuild_library();
    if (others) document_ = graph::adapted(std::move(document_), *library_);
    return true;
}

void EditSession::use_judge(Judge judge)
{
    own_type_rules_.refuse = std::move(judge);
    judge_again();
}

void EditSession::judge_again()
{
    if (document_.own_types.empty()) return;
    rebuild_library();
    adapt();
}

// The document and the step it stands on; what is being edited stays unsettled.
void EditSession::adapt()
{
    bool settled = document_ == history_.current();
    graph::Document step = graph::adapted(history_.current(), *library_);
    if (step != history_.current()) {
        // A node that became a placeholder, or is none any more, is the same in the file.
        bool same_file = graph::write_scene(step, *library_) == graph::write_scene(history_.current(), *library_);
        if (!same_file && history_.at_saved_step()) history_.forget_saved();
        history_.replace_current(step);
    }
    document_ = settled ? std::move(step) : graph::adapted(std::move(document_), *library_);
}

void EditSession::use_library(std::shared_ptr<const graph::Library> library)
{
    settle(unsettled_name);
    library_ = std::move(library);
    rebuild_library();
    adapt();
}

void EditSession::start(graph::Document document, std::optional<fs::path> path)
{
    document_ = std::move(document);
    own_type_rules_.former.clear();
    rebuild_library();
    history_ = graph::History(document_);
    path_ = absolute_path(std::move(path));
    stamp_.reset();
    saved_ = false;
    laid_out_ = false;
}

void EditSession::new_scene() { new_scene(app::new_scene(*library_)); }

void EditSession::new_scene(graph::Document document) { start(std::move(document), std::nullopt); }

void EditSession::open(const fs::path& path)
{
    // Stamped before it is read: what is written in between counts as changed.
    std::optional<FileStamp> stamp = file_stamp(path);
    graph::Document document = graph::open_scene(path, *library_);
    bool heaps = lay_out_heaps(document, *library_);
    start(std::move(document), path);
    stamp_ = stamp;
    laid_out_ = heaps;
}

void EditSession::recover(const fs::path& copy, std::optional<fs::path> origin, const FileStamp& stamp)
{
    start(graph::open_scene(copy, *library_), std::move(origin));
    history_.forget_saved();
    if (path_) stamp_ = stamp;
}

void EditSession::save()
{
    if (!path_) throw graph::Failure(5, "the scene has no file yet; choose one with Save as");
    save_as(*path_);
}

void EditSession::save_as(const fs::path& path)
{
    fs::path target = *absolute_path(scene_path(path));
    settle(unsettled_name);
    if (target.parent_path() != folder()) {
        move_picture_paths(document_, *library_, folder(), target.parent_path());
        settle("Move the scene away from its pictures");
    }
    graph::save_scene(target, document_, *library_);
    path_ = target;
    stamp_ = file_stamp(target);
    history_.mark_saved();
    saved_ = true;
}

fs::path EditSession::folder() const { return path_ ? path_->parent_path() : fs::path(); }

std::string EditSession::name() const { return path_ ? path_->filename().string() : "Untitled"; }

bool EditSession::dirty() const { return !history_.at_saved_step() || document_ != history_.current(); }

std::string EditSession::title() const { return dirty() ? name() + " \u2022" : name(); }

std::string EditSession::overwrite_warning() const
{
    if (document_.version <= graph::document_version || saved_) return {};
    return "This scene is of version " + std::to_string(document_.version) + "; this program knows version " +
           std::to_string(graph::document_version) +
           ". What it does not know is kept as it is, but may no longer fit the rest. Save under another name to be "
           "safe.";
}

bool EditSession::changed_on_disk() const
{
    if (!path_ || !stamp_) return false;
    std::optional<FileStamp> now = file_stamp(*path_);
    return now && now != stamp_;
}

fs::path scene_path(fs::path path)
{
    if (path.extension() != ".json") path += ".scene.json";
    return path;
}

}  // namespace fieldwright::app

// The scene being edited: the live document, its history and the file it belongs to. Nothing of the window.
#pragma once

#include "app/file_stamp.h"
#include "graph/history.h"
#include "graph/own_types.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace fieldwright::app {

class EditSession {
public:
    // Starts with a new scene.
    explicit EditSession(std::shared_ptr<const graph::Library> library);

    // Knows the document's own types and groups.
    const std::shared_ptr<const graph::Library>& library() const { return library_; }
    // Call when the document was edited: where its own types or groups are others now, the library follows, and the nodes
    // of own types. True then.
    bool follow_types();
    // Says why the document's own type may not run; asked again by `judge_again`. Null = all may.
    using Judge = std::function<std::optional<graph::TextError>(const graph::OwnType&)>;
    void use_judge(Judge judge);
    void judge_again();
    // The live document, edited through graph/edits.h at any time.
    graph::Document& document() { return document_; }
    const graph::Document& document() const { return document_; }

    // Gestures. `settle` ends one: the live document becomes a step if it differs. The others settle first what is
    // unsettled, and say whether they found a step.
    bool settle(const std::string& step_name);
    bool undo();
    bool redo();
    bool jump(std::size_t step);
    const graph::History& history() const { return history_; }

    // Scenes. All but `save` drop the history; the window asks about unsaved changes before.
    void new_scene();
    void new_scene(graph::Document document);  // begins with it
    // graph::Failure; then nothing changed. Nodes that lie in heaps are laid out, which is no unsaved change.
    void open(const std::filesystem::path& path);
    bool laid_out() const { return laid_out_; }  // when it was opened
    // Opens a kept copy as unsaved changes of the file it came from, which had that stamp. graph::Failure
    void recover(const std::filesystem::path& copy, std::optional<std::filesystem::path> origin,
                 const FileStamp& stamp);
    void save();                                      // to path(); graph::Failure says why it was not
    void save_as(const std::filesystem::path& path);  // to scene_path(path), which becomes path()

    const std::optional<std::filesystem::path>& path() const { return path_; }  // absolute; none until saved
    std::filesystem::path folder() const;  // of the file, from which paths in it lead on; empty without one
    std::string name() const;              // of the file; "Untitled" without one
    bool dirty() const;                    // would be lost by closing
    std::string title() const;             // name, and a dot while dirty
    // Why the user should be asked before the next save; empty when nothing would be lost, or once it was saved.
    std::string overwrite_warning() const;
    const std::optional<FileStamp>& stamp() const { return stamp_; }  // of the file as last read or written
    bool changed_on_disk() const;  // someone else wrote the file since; false when it is gone

    // Goes on under another library; the document and every step returned to are adapted to it.
    void use_library(std::shared_ptr<const graph::Library> library);

private:
    void start(graph::Document document, std::optional<std::filesystem::path> path);
    void land();
    void adapt();
    bool library_fits() const;
    void rebuild_library();

    std::shared_ptr<const graph::Library> library_;
    graph::OwnTypeRules own_type_rules_;      // its former texts are those that ran last, of this scene
    std::vector<graph::Group> known_groups_;  // to the library
    graph::Document document_;
    graph::History history_;
    std::optional<std::filesystem::path> path_;
    std::optional<FileStamp> stamp_;
    bool saved_ = false;  // since it was opened
    bool laid_out_ = false;
};

// The path with `.scene.json` added, unless it ends in `.json` already.
std::filesystem::path scene_path(std::filesystem::path path);

}  // namespace fieldwright::app

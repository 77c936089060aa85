// Undo as a list of documents: one step per gesture, named. Steps share the nodes and groups they have in common.
#pragma once

#include "graph/document.h"

#include <deque>
#include <memory>
#include <optional>

namespace fieldwright::graph {

class History {
public:
    static constexpr std::size_t step_limit = 1000;
    static constexpr std::size_t reference_limit = 16'000'000;  // of steps to nodes: 256 MB

    // The document as opened: one step, saved.
    explicit History(Document document);
    const Document& current() const { return current_; }
    // Records a step unless the document is unchanged, and says whether; drops the redo tail, and the oldest steps beyond
    // the limits.
    bool record(Document document, std::string name);
    bool undo();
    bool redo();
    void jump(std::size_t step);
    std::size_t size() const { return steps_.size(); }
    std::size_t step() const { return step_; }        // of the current document, an index into names()
    std::vector<std::string> names() const;           // oldest kept step first
    std::size_t dropped() const { return dropped_; }  // oldest steps dropped so far: names() lost as many at its front
    // The step that undo would take back and that redo would make again; empty when there is none.
    std::string undo_name() const;
    std::string redo_name() const;

    void mark_saved() { saved_ = step_; }
    void forget_saved() { saved_.reset(); }
    bool at_saved_step() const { return saved_ == step_; }

    // Changes what the current step holds, as when the node library changes below it. Its mark as saved stays.
    void replace_current(Document document);

private:
    struct Step {
        std::string name;
        Document rest;  // without its nodes and groups
        std::vector<std::shared_ptr<const Node>> nodes;
        std::vector<std::shared_ptr<const Group>> groups;
    };
    Step step_of(Document document, std::string name) const;
    void stand_on(std::size_t step);
    void drop_redo_tail();
    void drop_oldest();

    std::deque<Step> steps_;
    std::size_t step_ = 0;
    Document current_;  // derived: steps_[step_] in full
    std::optional<std::size_t> saved_ = 0;
    std::size_t dropped_ = 0;
    std::size_t references_ = 0;  // derived: sum of the steps' nodes
};

}  // namespace fieldwright::graph

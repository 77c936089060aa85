// Undo and redo over whole documents.
#include "graph/history.h"

#include <cassert>

namespace fieldwright::graph {

History::History(Document document) : current_(document)
{
    steps_.push_back(step_of(std::move(document), "start"));
    references_ = current_.root.nodes.size();
}

// Nodes and groups that the current step has too are shared with it.
History::Step History::step_of(Document document, std::string name) const
{
    Step step{std::move(name), {}, {}, {}};
    step.nodes.reserve(document.root.nodes.size());
    std::size_t before = 0, before_count = steps_.empty() ? 0 : steps_[step_].nodes.size();
    for (Node& node : document.root.nodes) {
        while (before < before_count && steps_[step_].nodes[before]->id < node.id) ++before;
        bool same = before < before_count && *steps_[step_].nodes[before] == node;
        step.nodes.push_back(same ? steps_[step_].nodes[before] : std::make_shared<const Node>(std::move(node)));
    }
    for (Group& group : document.groups) {
        const std::shared_ptr<const Group>* same = nullptr;
        if (!steps_.empty())
            for (const auto& known : steps_[step_].groups)
                if (known->name == group.name && *known == group) same = &known;
        step.groups.push_back(same ? *same : std::make_shared<const Group>(std::move(group)));
    }
    document.root.nodes.clear();
    document.groups.clear();
    step.rest = std::move(document);
    return step;
}

void History::stand_on(std::size_t step)
{
    step_ = step;
    current_ = steps_[step_].rest;
    current_.root.nodes.reserve(steps_[step_].nodes.size());
    for (const auto& node : steps_[step_].nodes) current_.root.nodes.push_back(*node);
    for (const auto& group : steps_[step_].groups) current_.groups.push_back(*group);
}

bool History::record(Document document, std::string name)
{
    if (document == current_) return false;
    Step step = step_of(document, std::move(name));
    drop_redo_tail();
    references_ += step.nodes.size();
    steps_.push_back(std::move(step));
    ++step_;
    current_ = std::move(document);
    while (steps_.size() > 2 && (steps_.size() > step_limit || references_ > reference_limit)) drop_oldest();
    return true;
}

void History::drop_redo_tail()
{
    while (steps_.size() > step_ + 1) {
        references_ -= steps_.back().nodes.size();
        steps_.pop_back();
    }
    if (saved_ && *saved_ > step_) saved_.reset();
}

void History::drop_oldest()
{
    references_ -= steps_.front().nodes.size();
    steps_.pop_front();
    --step_;
    ++dropped_;
    if (saved_ == 0u) saved_.reset();
    else if (saved_) --*saved_;
}

void History::replace_current(Document document)
{
    references_ -= steps_[step_].nodes.size();
    steps_[step_] = step_of(document, steps_[step_].name);
    references_ += steps_[step_].nodes.size();
    current_ = std::move(document);
}

bool History::undo()
{
    if (step_ == 0) return false;
    stand_on(step_ - 1);
    return true;
}

bool History::redo()
{
    if (step_ + 1 == steps_.size()) return false;
    stand_on(step_ + 1);
    return true;
}

void History::jump(std::size_t step)
{
    assert(step < steps_.size());
    stand_on(step);
}

std::vector<std::string> History::names() const
{
    std::vector<std::string> names;
    for (const Step& step : steps_) names.push_back(step.name);
    return names;
}

std::string History::undo_name() const { return step_ == 0 ? "" : steps_[step_].name; }

std::string History::redo_name() const { return step_ + 1 == steps_.size() ? "" : steps_[step_ + 1].name; }

}  // namespace fieldwright::graph

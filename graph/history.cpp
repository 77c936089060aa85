// Undo and redo over whole documents.
#include "graph/history.h"

#include <cassert>

namespace fieldwright::graph {

History::History(Document document) { steps_.push_back({std::move(document), "start"}); }

const Document& History::current() const { return steps_[step_].document; }

void History::record(Document document, std::string name)
{
    if (document == current()) return;
    steps_.resize(step_ + 1);
    steps_.push_back({std::move(document), std::move(name)});
    ++step_;
}

bool History::undo()
{
    if (step_ == 0) return false;
    --step_;
    return true;
}

bool History::redo()
{
    if (step_ + 1 == steps_.size()) return false;
    ++step_;
    return true;
}

void History::jump(std::size_t step)
{
    assert(step < steps_.size());
    step_ = step;
}

std::vector<std::string> History::names() const
{
    std::vector<std::string> names;
    for (const Step& step : steps_) names.push_back(step.name);
    return names;
}

}  // namespace fieldwright::graph

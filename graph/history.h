// Undo as a list of documents: one step per gesture, named.
#pragma once

#include "graph/document.h"

namespace fieldwright::graph {

class History {
public:
    explicit History(Document document);
    const Document& current() const;
    // Records a step unless the document is unchanged; drops the redo tail.
    void record(Document document, std::string name);
    bool undo();
    bool redo();
    void jump(std::size_t step);
    std::size_t step() const { return step_; }
    std::vector<std::string> names() const;

private:
    struct Step {
        Document document;
        std::string name;
    };
    std::vector<Step> steps_;
    std::size_t step_ = 0;
};

}  // namespace fieldwright::graph

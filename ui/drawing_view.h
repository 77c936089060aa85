// What drawings are painted with, and the stroke under way.
#pragma once

#include "graph/drawing.h"

#include <string>

namespace fieldwright::ui {

struct DrawingView {
    std::string tool = "paint";  // erase, line, rectangle
    bool mirrored = false;       // what is done on the left is done on the right, too

    struct Stroke {
        graph::Drawing before{1};            // when the mouse went down: lines and rectangles start from it every frame
        glm::ivec2 start{0, 0}, last{0, 0};  // cells
        bool on = true;                      // fills; else empties
    } stroke;
};

}  // namespace fieldwright::ui

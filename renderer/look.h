// How scene light is shown on screens and in files of 8 bits.
#pragma once

#include "graph/document.h"
#include "renderer/rows.h"

namespace fieldwright::renderer {

struct Look {
    graph::ToneMap tone_map = graph::ToneMap::none;
    float exposure = 0;  // stops
    bool operator==(const Look&) const = default;
};

Look look_of(const graph::PictureSettings& settings);

// A look as functions over rows of linear colours. Threads share it.
class LookFunction {
public:
    explicit LookFunction(const Look& look);
    // shown: what a screen is to show, linear and not clamped; no alias of colour.
    void operator()(Rows& shown, int count, const Rows& colour) const;
    bool changes_nothing() const { return look_ == Look(); }

private:
    Look look_;
    RowFunction expose_, tone_map_;
    Rows stops_;
};

}  // namespace fieldwright::renderer

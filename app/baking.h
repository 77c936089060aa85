// Baking: what documents hold ready-made of their texts, the outlines of the letters; remade when words or font change.
#pragma once

#include "assets/outlines.h"
#include "graph/document.h"
#include "graph/library.h"

#include <map>
#include <string>

namespace fieldwright::app {

// A node is a text when its type has a list of contours (graph/contours.h) and a parameter `text`. A node of a group
// that lets the words inside be set from outside holds the contours of its own words. Documents are at rest.
class Baking {
public:
    // Takes every text as it is: its outlines are what the document holds.
    void follow(const graph::Document& document, const graph::Library& library);
    // Remakes the outlines of texts that are written otherwise than when they were last looked at, and of groups' nodes
    // that are new. Where that cannot be done, they keep what they have.
    void bake(graph::Document& document, const graph::Library& library);
    // On every text whose outlines could not be remade: why.
    std::vector<graph::Problem> notes(const graph::Document& document, const graph::Library& library);

private:
    const assets::Outlines& outlines(const assets::Writing& writing);

    std::map<std::pair<graph::NodeId, std::string>, assets::Writing> written_;  // by node and its list of contours
    std::map<assets::Writing, assets::Outlines> known_;
};

}  // namespace fieldwright::app

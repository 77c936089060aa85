// The JSON of a scene: a tree, the version that it says it has, and the members that all its readers share.
#pragma once

#include "graph/json.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace fieldwright::graph {

// Refusals throw Failure as those of JsonTree do.
class SceneJson : public JsonTree {
public:
    using JsonTree::JsonTree;

    // Of a newer version than this program's, unknown members are refused with that reason.
    void set_version(int version) { version_ = version; }

    // `example` ends the sentence: what to write.
    const JsonValue& required(const JsonValue& object, std::string_view key, const std::string& example) const;
    // `known` names the members that may stand here.
    [[noreturn]] void unknown_member(const JsonValue& member, const std::string& known) const;

    int small_integer(const JsonValue& value) const;
    std::string short_text(const JsonValue& value) const;  // at most name_limit bytes
    glm::vec2 pair(const JsonValue& value) const;
    glm::vec3 triple(const JsonValue& value) const;

private:
    int version_ = 1;
};

}  // namespace fieldwright::graph

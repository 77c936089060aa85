#include "graph/scene_json.h"

#include "graph/document.h"
#include "graph/limits.h"

#include <limits>

namespace fieldwright::graph {
namespace {

template <int size>
glm::vec<size, float> vector(const JsonTree& json, const JsonValue& value, const char* what_to_write)
{
    if (value.kind != JsonKind::array || value.count != size) json.fail(value, what_to_write);
    glm::vec<size, float> result(0.0f);
    int i = 0;
    for (const JsonValue* part = json.first_child(value); part; part = json.next_sibling(*part))
        result[i++] = json.number(*part);
    return result;
}

}  // namespace

const JsonValue& SceneJson::required(const JsonValue& object, std::string_view key, const std::string& example) const
{
    const JsonValue* value = member(object, key);
    if (!value) fail(object, "lacks its member `" + std::string(key) + "`; add " + example);
    return *value;
}

void SceneJson::unknown_member(const JsonValue& member, const std::string& known) const
{
    std::string hint;
    if (version_ > document_version)
        hint = "; the scene is of version " + std::to_string(version_) + ", this program reads version " +
               std::to_string(document_version);
    fail_at_key(member, "is not known here; the members are " + known + hint);
}

int SceneJson::small_integer(const JsonValue& value) const
{
    std::int64_t number = integer(value);
    if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
        fail(value, "is too large; write a whole number between -2^31 and 2^31 - 1");
    return static_cast<int>(number);
}

std::string SceneJson::short_text(const JsonValue& value) const
{
    std::string_view text = string(value);
    if (text.size() > name_limit) fail(value, "must have at most 256 bytes; shorten it");
    return std::string(text);
}

glm::vec2 SceneJson::pair(const JsonValue& value) const
{
    return vector<2>(*this, value, "must be two numbers; write e.g. [0.0, 0.0]");
}

glm::vec3 SceneJson::triple(const JsonValue& value) const
{
    return vector<3>(*this, value, "must be three numbers; write e.g. [0.0, 0.0, 0.0]");
}

}  // namespace fieldwright::graph

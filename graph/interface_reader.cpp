#include "graph/interface_reader.h"

#include "graph/group_rules.h"
#include "graph/limits.h"

namespace fieldwright::graph {
namespace {

Exposed exposed_of(const SceneJson& json, const JsonValue& object)
{
    Exposed exposed;
    exposed.name = json.string(json.required(object, "name", "\"name\": \"radius\""));
    exposed.node = {json.integer(json.required(object, "node", "the id of an inner node"))};
    exposed.socket = json.string(json.required(object, "socket", "the parameter or input that it drives"));
    if (const JsonValue* help = json.member(object, "help")) exposed.help = json.short_text(*help);
    for (const JsonValue* member = json.first_child(object); member; member = json.next_sibling(*member))
        if (member->key != "name" && member->key != "help" && member->key != "node" && member->key != "socket")
            json.unknown_member(*member, "`name`, `help`, `node`, `socket`");
    return exposed;
}

void read_exposed(const SceneJson& json, const JsonValue& list, const Library& library, Group& group)
{
    if (list.count > exposed_limit) json.fail(list, "has more than 256 entries");
    for (const JsonValue* value = json.first_child(list); value; value = json.next_sibling(*value)) {
        Exposed exposed = exposed_of(json, json.object(*value));
        if (Refusal refusal = exposed_name_error(exposed.name)) json.fail(*value, *refusal);
        if (free_exposed_name(group, exposed.name) != exposed.name)
            json.fail(*value, "has the name of another entry, " + in_quotes(exposed.name));
        if (Refusal refusal = exposed_error(exposed, group.graph, library)) json.fail(*value, *refusal);
        group.exposed.push_back(std::move(exposed));
    }
}

}  // namespace

void read_interface(const SceneJson& json, const JsonValue& value, const Library& library, Group& group)
{
    for (const JsonValue* member = json.first_child(value); member; member = json.next_sibling(*member)) {
        if (member->key == "nodes") continue;
        if (member->key == "output") group.output = {json.integer(*member)};
        else if (member->key == "exposed") read_exposed(json, json.array(*member), library, group);
        else json.unknown_member(*member, "`output`, `exposed`, `nodes`");
        if (member->key != "output") continue;
        if (Refusal refusal = group_output_error(group.output, group.graph, library)) json.fail(*member, *refusal);
    }
}

}  // namespace fieldwright::graph

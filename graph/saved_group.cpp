// Groups on their own: to text and back, for a user's library.
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/own_types.h"

namespace fieldwright::graph {

std::string saved_group_text(const Document& document, const Library& library, std::string_view group)
{
    Document one;
    one.own_types = document.own_types;
    one.groups = with_inner_groups(document, {std::string(group)});
    one.next_id = document.next_id;
    NodeId node = add_node(one, *with_groups(library, one), group_type_name(group));
    return copy_nodes(one, library, {node});
}

SavedGroupText read_saved_group(std::string_view text, const Library& library, std::string_view file_name)
{
    Fragment fragment = read_fragment(text, library, file_name);
    Document holder;
    holder.groups = fragment.groups;
    const Group* group = fragment.nodes.size() == 1 ? group_of(holder, fragment.nodes[0]) : nullptr;
    if (!group) throw Failure(3, std::string(file_name) + ": holds no single group; save it again from its scene");
    std::shared_ptr<const Library> known = with_groups(*with_own_types(library, fragment.own_types), holder);
    return {group->name, std::move(fragment.groups), *known->type(group_type_name(group->name))};
}

Placed add_saved_group(Document& document, const Library& library, std::string_view text, glm::vec2 position,
                       const std::vector<NodeId>& selection)
{
    try {
        Document changed = document;
        // Pasted for its groups and types; the node itself is placed as the add menu does.
        Pasted pasted = paste_nodes(changed, library, text, position);
        if (pasted.refusal) return {{}, pasted.refusal};
        std::string type = changed.root.find(pasted.nodes.front())->type;
        if (Refusal refusal = remove_nodes(changed, {pasted.nodes.begin(), pasted.nodes.end()})) return {{}, refusal};
        std::shared_ptr<const Library> known = with_own_types(library, changed.own_types);
        Placed placed = add_from_menu(changed, *library_of(changed, *known), type, position, selection);
        if (!placed.refusal) document = std::move(changed);
        return placed;
    } catch (const Failure& failure) {
        return {{}, std::string("the group cannot be added: ") + failure.what()};
    }
}

}  // namespace fieldwright::graph

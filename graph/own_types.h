// The library that goes with a document: the program's node types, those of the user's folder, and the document's own.
#pragma once

#include "graph/library.h"

#include <functional>

namespace fieldwright::graph {

// Which own types may run, and what stands in for those that may not.
struct OwnTypeRules {
    std::function<std::optional<TextError>(const OwnType& type)> refuse = {};  // empty: all may that are nodes
    std::map<std::string, std::string> former = {};  // texts by name, of types that ran before
};

// The library with these own types, and without those of another document; where one of the user's folder has the
// name, the document's own is meant. Texts that are not a node or must not run are left out, for Library::left_out to
// tell why; a former text takes their place, or the type is held back. They run on the GPU only.
std::shared_ptr<const Library> with_own_types(const Library& library, const std::vector<OwnType>& types,
                                              const OwnTypeRules& rules = {});
// The same, but `library` itself where it knows these types already.
std::shared_ptr<const Library> library_for(const std::shared_ptr<const Library>& library,
                                           const std::vector<OwnType>& types);
// With the node files of the user's folder: path below it ("<category>/<name>.glsl") -> text.
std::shared_ptr<const Library> with_user_nodes(const Library& library, const std::map<std::string, std::string>& texts);

// Empty, or why no new own type may have the name, as the end of a sentence. Other own types are not looked at.
std::string own_name_error(const Library& library, std::string_view name);
// The node that the text declares; throws DialectError. `library` says what is taken.
NodeType own_node_type(const OwnType& type, const Library& library);

}  // namespace fieldwright::graph

// Loads a library, or says why not.
#include "app/library_reload.h"

#include "app/user_nodes.h"
#include "graph/problem.h"

namespace fieldwright::app {

LibraryReload reload_library(const std::filesystem::path& shaders,
                             const std::optional<std::filesystem::path>& user_nodes)
{
    try {
        auto library = shaders.empty() ? graph::Library::embedded() : graph::Library::load(shaders);
        return {user_nodes ? with_user_nodes(*library, *user_nodes) : library, {}};
    } catch (const graph::DialectError& error) {
        return {nullptr, error.what()};
    } catch (const graph::Failure& failure) {
        return {nullptr, failure.what()};
    } catch (const std::filesystem::filesystem_error& error) {
        return {nullptr, error.what()};
    }
}

}  // namespace fieldwright::app

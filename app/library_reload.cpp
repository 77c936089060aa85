// Loads a library, or says why not.
#include "app/library_reload.h"

#include "graph/problem.h"

namespace fieldwright::app {

LibraryReload reload_library(const std::filesystem::path& folder)
{
    try {
        return {graph::Library::load(folder), {}};
    } catch (const graph::DialectError& error) {
        return {nullptr, error.what()};
    } catch (const graph::Failure& failure) {
        return {nullptr, failure.what()};
    } catch (const std::filesystem::filesystem_error& error) {
        return {nullptr, error.what()};
    }
}

}  // namespace fieldwright::app

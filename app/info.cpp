// `info` and `--version`: what this program is and what it finds on this machine.
#include "app/commands.h"
#include "field/kernel.h"
#include "graph/problem.h"
#include "renderer/devices.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

namespace fieldwright::app {
namespace {

using Json = nlohmann::ordered_json;

// GL_RENDERER, or null where there is no usable GL.
Json renderer_name()
{
    try {
        return renderer::GpuDevice().renderer_name();
    } catch (const graph::Failure&) {
        return nullptr;
    }
}

Json machine(const graph::Library& library)
{
    return {{"version", FIELDWRIGHT_VERSION},
            {"gl_renderer", renderer_name()},
            {"instruction_set", field::kernels().instruction_set},
            {"nodes", library.types().size()},
            {"threads", std::thread::hardware_concurrency()}};
}

void print_lines(const Json& machine)
{
    for (const auto& [name, value] : machine.items()) {
        std::string label = name;
        std::replace(label.begin(), label.end(), '_', ' ');
        std::cout << label << ": "
                  << (value.is_null()     ? "none"
                      : value.is_string() ? value.get<std::string>()
                                          : value.dump())
                  << "\n";
    }
}

}  // namespace

void print_version(bool json)
{
    if (json) std::cout << Json{{"version", FIELDWRIGHT_VERSION}}.dump() << "\n";
    else std::cout << "fieldwright " << FIELDWRIGHT_VERSION << "\n";
}

void add_info(CLI::App& parser, Session& session)
{
    auto json = std::make_shared<bool>(false);
    CLI::App& command = *parser.add_subcommand("info", "Say what this program finds on this machine");
    command.add_flag("--json", *json, "Print JSON");
    command.callback([json, &session] {
        session.action = [json, &session] {
            Json found = machine(*session.library());
            if (*json) std::cout << found.dump(2) << "\n";
            else print_lines(found);
            return 0;
        };
    });
}

}  // namespace fieldwright::app

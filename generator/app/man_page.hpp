// The manual pages of the tool and its commands, made from the option tree.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace symplant::app {

/// The commands that the help shows, in its order.
std::vector<const CLI::App*> visible_commands(const CLI::App& tool);

/// The page symplant(1), as roff with the macros of man(7). O(size of the option tree), as the next one.
std::string tool_page(const CLI::App& tool);

/// The page symplant-COMMAND(1). `command` is one of visible_commands(tool).
std::string command_page(const CLI::App& tool, const CLI::App& command);

}  // namespace symplant::app

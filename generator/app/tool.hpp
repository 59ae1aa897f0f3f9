// The tool as a function: files, streams and environment are parameters.
#pragma once

#include "app/context.hpp"

namespace CLI {
class App;
}

namespace symplant::app {

/// Runs one command line. Returns the exit code.
int run_tool(int argc, char** argv, Context& context);

/// Adds the whole option tree, with callbacks bound to `context`. The tree owns everything that a command parses.
void build_commands(CLI::App& app, Context& context);

}  // namespace symplant::app

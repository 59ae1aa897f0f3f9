// The tool as a function: files, streams and environment are parameters.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "base/file_system.hpp"
#include "base/process.hpp"

namespace CLI {
class App;
}

namespace symplant::app {

struct Context {
  base::FileSystem& files;
  std::ostream& out;        ///< results
  std::ostream& err;        ///< messages
  std::string today = {};   ///< YYYY-MM-DD; empty if unknown
  std::string folder = {};  ///< the working folder, absolute; empty if unknown
  bool colour_out = false;
  bool colour_err = false;
  bool progress = false;                    ///< there is a terminal for a progress line
  int exit_code = 0;                        ///< set by the command
  base::ProcessRunner* programs = nullptr;  ///< null: no other program is run
  /// The last plant of a command. Keeping it saves its destruction: the memory is freed when the process ends.
  std::shared_ptr<const void> kept = nullptr;
};

/// Runs one command line. Returns the exit code.
int run_tool(int argc, char** argv, Context& context);

/// Adds the whole option tree, with callbacks bound to `context`. The tree owns everything that a command parses.
void build_commands(CLI::App& app, Context& context);

}  // namespace symplant::app

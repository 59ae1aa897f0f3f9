// The tool as a function: its world comes in as parameters.
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
  std::string today = {};   ///< YYYY-MM-DD; empty where nobody knows
  std::string folder = {};  ///< the working folder, absolute; empty where nobody knows
  bool colour_out = false;
  bool colour_err = false;
  bool progress = false;                    ///< a terminal is there for a progress line
  int exit_code = 0;                        ///< what the command came to
  base::ProcessRunner* programs = nullptr;  ///< null: no other program is asked for help
  /// The plant that a command looked at last, which it need not take down: a large one's memory goes with the process.
  std::shared_ptr<const void> kept = nullptr;
};

/// Runs one command line. Gives the exit code.
int run_tool(int argc, char** argv, Context& context);

/// The whole option tree, its callbacks bound to `context`; all that a command parses lives in the tree.
void build_commands(CLI::App& app, Context& context);

}  // namespace symplant::app

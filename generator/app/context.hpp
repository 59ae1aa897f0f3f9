// What a command works with: files, streams, and what it leaves to its caller.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "base/file_system.hpp"
#include "base/process.hpp"

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
  std::istream* answers = nullptr;          ///< of a person at a terminal; null: no question is asked
  int exit_code = 0;                        ///< set by the command
  base::ProcessRunner* programs = nullptr;  ///< null: no other program is run
  /// The last plant of a command. Keeping it saves its destruction: the memory is freed when the process ends.
  std::shared_ptr<const void> kept = nullptr;
};

}  // namespace symplant::app

// One hostile input under every command.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "inputs.hpp"

namespace symplant::hostile {

/// A command line. File names are relative to the input's folder; output goes to `../out`.
struct Command {
  std::string_view column;  ///< of the page's table; commands of one column share a cell
  std::vector<std::string> arguments;
};

/// The commands for a list, a plant.json or a scenario.
std::span<const Command> commands(Input::Kind kind);

/// The result of a command.
struct Outcome {
  std::string_view column;
  std::string cell;                 ///< for the page: `good`, `findings`, `refused: unclosed-quote`
  std::vector<std::string> faults;  ///< faults, as text
};

struct Limits {
  double cpu_seconds = 10;
  long peak_kilobytes = 1024 * 1024;
};

/// Runs every command on an input, in separate folders below `scratch`, which it removes afterwards.
std::vector<Outcome> try_out(const std::string& tool, const Input& input, const Limits& limits,
                             const std::string& scratch);

/// An invalid command line, independent of the input's bytes: wrong kinds of files, wrong words.
struct Misuse {
  const char* what;
  std::vector<std::string> arguments;
};
std::span<const Misuse> misuses();

/// Runs one of these; the cell is the exit code and the first line of the message.
Outcome try_out(const std::string& tool, const Misuse& misuse, const Limits& limits, const std::string& scratch);

}  // namespace symplant::hostile

// One hostile input under every command.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "inputs.hpp"

namespace symplant::hostile {

/// A command line. Files are named from the input's folder; what it writes goes to `../out`.
struct Command {
  std::string_view column;  ///< of the page's table; commands of one column stand side by side
  std::vector<std::string> arguments;
};

/// What is asked of a list, a plant.json or a scenario.
std::span<const Command> commands(Input::Kind kind);

/// What a command came to.
struct Outcome {
  std::string_view column;
  std::string cell;                 ///< for the page: `good`, `findings`, `refused: unclosed-quote`
  std::vector<std::string> faults;  ///< what must not be, in words
};

struct Limits {
  double cpu_seconds = 10;
  long peak_kilobytes = 1024 * 1024;
};

/// Runs every command on an input, in folders of its own below `scratch`, which are gone afterwards.
std::vector<Outcome> try_out(const std::string& tool, const Input& input, const Limits& limits,
                             const std::string& scratch);

/// A misuse that is no matter of an input's bytes: wrong kinds of files, wrong words.
struct Misuse {
  const char* what;
  std::vector<std::string> arguments;
};
std::span<const Misuse> misuses();

/// Runs one of them; the cell is the exit code and the message's first line.
Outcome try_out(const std::string& tool, const Misuse& misuse, const Limits& limits, const std::string& scratch);

}  // namespace symplant::hostile

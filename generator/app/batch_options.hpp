// What the commands have in common that run many cases: test and campaign.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "batch/shard.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace symplant::app {

struct BatchOptions {
  std::vector<std::string> links;  ///< a PLC runs one case at a time
  std::size_t jobs = 0;            ///< 0: as many as there are processors
  batch::Shard shard;
  std::vector<std::string> merged;
  std::string output;
  std::string junit;
  std::string html;
};

/// The options that exclude those for one kind of run only.
struct BatchFlags {
  CLI::Option* shard;
  CLI::Option* merge;
};

/// Adds --jobs, --shard, --merge, --output, --junit and --html. `what` is `cases` or `faults`.
BatchFlags add_batch_options(CLI::App& command, BatchOptions& options, const std::string& what);

/// How many processes run cases.
std::size_t jobs_of(const BatchOptions& options);

/// Replaces earlier reports by ones that say that this run has not ended, so that whatever ends it leaves no green
/// ones. `inputs` are not replaced. False, with a message and the exit code, if that fails.
bool begin_reports(const BatchOptions& options, const std::string& command, const std::vector<std::string>& inputs,
                   Context& context);

/// Shows an error, and sets the exit code.
void fail_batch(Context& context, const std::string& message, int code);

}  // namespace symplant::app

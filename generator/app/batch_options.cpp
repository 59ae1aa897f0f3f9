// What the commands have in common that run many cases.
#include "app/batch_options.hpp"

#include <CLI/App.hpp>
#include <algorithm>
#include <ostream>
#include <sstream>
#include <thread>

#include "app/options.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/junit_xml.hpp"

namespace symplant::app {

BatchFlags add_batch_options(CLI::App& command, BatchOptions& options, const std::string& what) {
  command.add_option("--jobs", options.jobs, "processes that run " + what + " (default: the number of processors)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  CLI::Option* const shard =
      command
          .add_option_function<std::string>(
              "--shard",
              [&options](const std::string& text) {
                const auto read = batch::shard_of(text);
                if (!read) {
                  throw CLI::ValidationError("--shard", "`" + text + "` is not a part such as 1/8: I from 1 to N");
                }
                options.shard = *read;
              },
              "run only each N-th of the " + what + ", from the I-th on: part I of N")
          ->type_name("I/N");
  CLI::Option* const merge =
      command
          .add_option("--merge", options.merged, "join the results of parts, files written by `-o`, instead of running")
          ->type_name("FILE")
          ->excludes(shard)
          ->check(CLI::ExistingFile);
  command.add_option("-o,--output", options.output, "write each result to this file as soon as it is there")
      ->type_name("FILE");
  command.add_option("--junit", options.junit, "write the results for build servers")->type_name("FILE");
  command.add_option("--html", options.html, "write the results as a page, with a chart of each difference")
      ->type_name("FILE");
  return {shard, merge};
}

std::size_t jobs_of(const BatchOptions& options) {
  if (!options.links.empty()) return 1;  // there is one PLC
  return options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
}

bool begin_reports(const BatchOptions& options, const std::string& command, const std::vector<std::string>& inputs,
                   Context& context) {
  if (!options.junit.empty()) {
    const std::vector<trace::TestCase> cases = {{command, 0, "", "the run has not ended"}};
    if (!write_result(context, options.junit, base::whole(trace::junit_xml(command, cases, 0)), inputs)) return false;
  }
  const base::TextSource page = base::whole("<!DOCTYPE html><title>" + command + "</title>The run has not ended.\n");
  return options.html.empty() || write_result(context, options.html, page, inputs);
}

void fail_batch(Context& context, const std::string& message, int code) {
  context.err << "error: ";
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) context.err << diag::visible(line) << "\n";
  context.exit_code = code;
}

}  // namespace symplant::app

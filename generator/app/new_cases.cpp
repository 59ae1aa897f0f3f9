// Proposes cases for a suite, and writes them.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/suite_command.hpp"
#include "batch/workers.hpp"
#include "diag/visible_text.hpp"
#include "suite/propose.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"

namespace symplant::app {
namespace {

constexpr std::size_t kTried = 10;  ///< proposals that are run for each one that is wanted, at most

std::string joined(const std::vector<std::uint64_t>& numbers) { return fmt::format("{}", fmt::join(numbers, " ")); }

std::vector<std::uint64_t> numbers_of(const std::string& text) {
  std::vector<std::uint64_t> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  std::uint64_t number = 0;
  while (at != end) {
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc()) break;
    numbers.push_back(number);
    at = std::find_if(read.ptr, end, [](char c) { return c != ' '; });
  }
  return numbers;
}

}  // namespace

void propose_cases(const TestOptions& options, const suite::Suite& suite, const PreparedPlant& prepared,
                   Context& context) {
  if (!std::binary_search(suite.cases.begin(), suite.cases.end(), options.base)) {
    return fail_batch(context,
                      fmt::format("the suite has no case `{}`: it has {}", options.base, fmt::join(suite.cases, ", ")),
                      host::kBadInput);
  }
  if (!options.links.empty()) {
    return fail_batch(context, "`--new` needs a program in lock step: remove `--link`", host::kBadInput);
  }
  const CaseFolder folder;
  if (!folder.error().empty()) return fail_batch(context, folder.error(), host::kEnvironment);
  suite::Setup setup{suite, {}, false};
  setup.run.programs = options.programs.empty() ? suite.programs : options.programs;
  const host::PlantProgram plant = prepared.program();
  suite::BaseRun base;
  std::string error;
  if (!suite::run_base(setup, plant, suite.scenario(options.base), folder.path(), base, error)) {
    return fail_batch(context,
                      fmt::format("the case `{}` does not pass, so that nothing is proposed:\n{}", options.base, error),
                      host::kFindings);
  }
  const bool with_program = !setup.run.programs.empty() || !plant.programs.empty();
  std::vector<suite::Proposal> proposals = suite::proposals_of(base, options.base, plant.tables, with_program);
  std::erase_if(proposals, [&](const suite::Proposal& one) { return context.files.exists(suite.scenario(one.name)); });
  const std::size_t all = proposals.size();
  proposals = suite::spread(std::move(proposals), kTried * options.most);

  std::vector<std::vector<std::uint64_t>> pairs(proposals.size());
  const auto work = [&](std::size_t piece) {
    return joined(suite::new_pairs(setup, plant, proposals[piece], base, folder.path())) + " ";
  };
  const auto done = [&](const batch::Done& piece) { pairs[piece.piece] = numbers_of(piece.answer); };
  host::catch_signals();
  error = batch::do_in_processes(proposals.size(), jobs_of(options), work, done,
                                 [] { return host::stop_requested().load(); });
  if (!error.empty()) return fail_batch(context, error, host::kEnvironment);
  if (host::stop_requested().load())
    return fail_batch(context, "ended by a signal: nothing is written", host::kFindings);

  const std::vector<std::size_t> chosen = suite::choose(pairs, options.most);
  for (const std::size_t number : chosen) {
    const suite::Proposal& one = proposals[number];
    const auto written = context.files.write_new(suite.scenario(one.name), one.text);
    if (!written) return fail_batch(context, written.error().message, host::kEnvironment);
    context.out << "new    " << diag::visible(one.name) << ": " << diag::visible(one.words) << "\n";
  }
  context.out << fmt::format("{} of {} possible cases written", chosen.size(), all);
  if (proposals.size() != all) context.out << fmt::format(", chosen from {} that were tried", proposals.size());
  context.out << (chosen.empty() ? "\n" : "; look at what they do, then write their reference traces by `--update`\n");
}

}  // namespace symplant::app

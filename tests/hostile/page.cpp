// Writes docs/reliability.md from the results.
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace symplant::hostile {
namespace {

constexpr const char* kBegin =
    R"(# Reliability

<!-- Written by tests/hostile; SYMPLANT_UPDATE_GOLDENS=1 writes it anew. -->

Symbol lists come out of other programs, pass through spreadsheets and mail, and are cut, joined and typed over on the way. Whatever a
file holds, symplant either answers or refuses it, and says where the fault is.

What is promised, and tried on every input below:

- Each command ends within 10 s and 1 GB.
- It ends with one of the exit codes of [the command line](command-line.md): 0 good, 1 findings, 2 refused. It never ends in a crash.
- A refusal names the file and, where it has one, the place. See [checking](checking.md) for what each name in the tables means, or ask
  `symplant explain`.
- After a refusal nothing is written: no new file is there, and an old one is as it was.
- What it writes to a terminal cannot steer the terminal.
- What it generates is printable ASCII, compiles without a warning with g++ and clang, and gives every name back in traces, byte for
  byte.

## How it is tried

Five ways, all of them in `.ci/run`:

| what | how to repeat it |
|---|---|
| the tables of this page | `ctest --test-dir build/release -R hostile` |
| the fuzz targets: symbol lists, plant.json, conditions, names; each checks its answers as well | `scripts/fuzz --seconds 120` |
| the tests under the address and the undefined-behaviour sanitizer, with the assertions of the library | `scripts/test --sanitize` |
| links, cycle and the running program, all threads at once, under the thread sanitizer | `scripts/test --threads` |
| inputs that once broke something, and a small list cut at every byte | `ctest --test-dir build/release -R 'fuzz:\|cut'` |

An input that breaks something becomes a file in `tests/fuzz/crashes`, which every build tries.

## A plant that runs

| what happens | what holds | how to repeat it |
|---|---|---|
| memory, a lock, `write(2)`, an untouched page within a cycle | `--rt-check` finds each | `ctest --test-dir build/release -R 'rt: under load'` |
| 60 s at 1 ms beside a busy program, 10,000 devices, two PLCs (10 minutes with `--campaign`) | the guard finds nothing: no memory taken, no lock, no system call but the sleep, no page fault | the same test, behind the planted faults |
| priority, processor or locked memory is refused; memory at its limit | one warning each with what to do, the plant runs, `"rt":"degraded"` | `ctest --test-dir build/release -R 'rt: what the system refuses'` |
| a cycle takes once, three times, always longer than it may | overruns are counted to the one, plant time catches up or slips, never a spiral | `build/release/tests/unit/exec/test_exec` |
| the process stands still for 5 s | ten cycles are made up for, the rest is lost and counted | `ctest --test-dir build/release -R 'rt: a process that stood still'` |
| the time of day jumps by an hour and a day at every look (a clock of the test's own, put before the system's) | cycles, plant time and what is lost are the same | `ctest --test-dir build/release -R 'rt: jumps'` |
| SIGTERM, SIGINT, SIGHUP: waiting, in a cycle of an hour, awake before one, in a long catch-up | it ends within a second, with its statistics; where nobody takes its output, within a second with exit code 3 | `ctest --test-dir build/release -R 'rt: a signal'` |
| nobody reads its output any more | the plant runs on, and ends with exit code 3 | the same test |
| the cycle hangs under systemd | no sign of life is given, so that systemd starts it anew | `build/release/tests/unit/host/test_host` |

)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? "\\|" : std::string(1, c);
  return result;
}

/// The common result of all commands of a column; one by one if they differ.
std::string cell(const std::vector<Outcome>& outcomes, std::string_view column) {
  std::vector<std::string> cells;
  for (const Outcome& outcome : outcomes) {
    if (outcome.column == column) cells.push_back(outcome.cell);
  }
  // `check` reports its rules in the first format only.
  const auto begins_alike = [&](const std::string& other) { return cells.front().starts_with(other); };
  if (std::all_of(cells.begin(), cells.end(), begins_alike)) return cells.front();
  return fmt::format("{}", fmt::join(cells, " / "));
}

std::string table(const Trials& trials, Input::Kind kind) {
  std::vector<std::string_view> columns;
  for (const Command& command : commands(kind)) {
    if (std::find(columns.begin(), columns.end(), command.column) == columns.end()) columns.push_back(command.column);
  }
  std::string text =
      fmt::format("| input | `{}` |\n|{}\n", fmt::join(columns, "` | `"), repeated("---|", columns.size() + 1));
  for (const auto& [input, outcomes] : trials.inputs) {
    if (input.kind != kind) continue;
    text += fmt::format("| {} |", escaped(input.what));
    for (const std::string_view column : columns) text += fmt::format(" {} |", cell(outcomes, column));
    text += "\n";
  }
  return text;
}

}  // namespace

std::string page(const Trials& trials) {
  std::string text = kBegin;
  text +=
      "## Symbol lists\n\n"
      "`check` is tried as text and JSON, `model` in every `--format`. `good` is exit code 0, `findings` 1, "
      "`refused` 2, with the errors that\n"
      "`check` finds.\n\n" +
      table(trials, Input::Kind::list) +
      "\n## Plant descriptions\n\nEach beside a small symbol list without a fault.\n\n" +
      table(trials, Input::Kind::plant) + "\n## Scenarios\n\n" + table(trials, Input::Kind::scenario) +
      "\n## Wrong files, wrong words\n\n| what | exit code | what is said |\n|---|---|---|\n";
  for (const auto& [misuse, outcome] : trials.misuses) {
    const std::size_t bar = outcome.cell.find(" | ");
    text += fmt::format("| {} | {} | {} |\n", escaped(misuse.what), outcome.cell.substr(0, bar),
                        escaped(outcome.cell.substr(bar + 3)));
  }
  return text;
}

}  // namespace symplant::hostile

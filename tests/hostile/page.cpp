// Writes docs/reliability.md from the results.
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace symplant::hostile {
namespace {

constexpr const char* kBegin =
    R"(# Reliability

<!-- Written by tests/hostile; SYMPLANT_UPDATE_GOLDENS=1 regenerates it. -->

Other programs export symbol lists. Then the lists pass through spreadsheets and mail, and are cut, joined and retyped. For any content of a
file, symplant returns a result or refuses the file and reports the location of the fault.

The following holds for every input below, and is tested:

- Each command ends within 10 s and 1 GB.
- It ends with one of the exit codes of [the command line](command-line.md): 0 good, 1 findings, 2 refused. It never crashes.
- A refusal names the file and, if there is one, the location. [Checking](checking.md) and `symplant explain` describe each rule in the
  tables.
- A refused command writes nothing: it creates no file, and it does not change an existing one. Only `run`
  writes its error into the file of `--junit`, and removes [the results of an earlier run](#what-makes-a-run-red).
- Output to a terminal contains no control sequences.
- Generated code is printable ASCII and compiles without a warning with g++ and clang. Traces contain every name byte for byte.

## How it is tested

There are five kinds of tests, all of them in `.ci/run`:

| what | how to repeat it |
|---|---|
| the tables of this page | `ctest --test-dir build/release -R hostile` |
| the fuzz targets: symbol lists, plant.json, conditions, names, Modbus requests, replies to clients, URLs of links, requests to the panel; each also checks its results | `scripts/fuzz --seconds 120` |
| the tests with the address and the undefined-behavior sanitizer and the assertions of the library | `scripts/test --sanitize` |
| links, cycle and the running program, all threads at once, with the thread sanitizer | `scripts/test --threads` |
| inputs that caused a fault before, and a small list cut at every byte | `ctest --test-dir build/release -R 'fuzz:\|cut'` |

An input that causes a fault becomes a file in `tests/fuzz/crashes`, which every build tests.

## A running plant

| what happens | what holds | how to repeat it |
|---|---|---|
| heap, a lock, `write(2)`, an untouched page within a cycle | `--rt-check` reports each | `ctest --test-dir build/release -R 'rt: Under load'` |
| 60 s at 1 ms next to a busy program, 10,000 devices, two PLCs (10 minutes with `--campaign`) | the guard finds nothing: no heap, no lock, no system call except the sleep, no page fault | the same test, after the planted faults |
| priority, processor or locked memory is refused; memory is at its limit | one warning each with what to do, the plant runs, `"rt":"degraded"` | `ctest --test-dir build/release -R 'rt: '` |
| a cycle takes longer than its period: once, three times, always | every overrun is counted, plant time catches up or slips, overruns do not accumulate | `build/release/tests/unit/exec/test_exec` |
| a request to the panel makes symplant throw an error | the client gets 500, the terminal one message in 10 s, the plant runs on | `ctest --test-dir build/release -R 'panel: '` |
| 100,000 random requests to the panel (1,000 without `--campaign`) | each gets an answer of the [interface](panel-interface.md), or the connection ends; none ends the process | `build/release/tests/unit/panel/test_panel "Random requests*"` |
| 64 clients of the panel never read their answers, 8 never read their streams | memory is bounded, others are served, the silent ones are closed | `ctest --test-dir build/release -R 'panel: '` |
| the process is stopped for 5 s | ten cycles are caught up, the other ones are skipped and counted | `ctest --test-dir build/release -R 'rt: A process'` |
| the time of day jumps by an hour and a day at every call (a test clock replaces the system's) | cycles, plant time and skipped cycles are the same | `ctest --test-dir build/release -R 'rt: '` |
| SIGTERM, SIGINT, SIGHUP: while waiting, in a cycle of an hour, shortly before a cycle, in a long catch-up | the run ends within a second, with its statistics; if no program reads its output, within a second with exit code 3 | `ctest --test-dir build/release -R 'rt: A signal'` |
| no program reads its output any more | the plant continues, and ends with exit code 3 | the same test |
| `symplant record` is killed, 10 times at random times (200 with `--campaign`), as is a run with `--trace` | everything older than 100 ms is in the file, in whole lines; nothing was written to the PLC | `build/release/tests/unit/record/test_record "*killed*"` |
| the PLC that is recorded closes connections, refuses them, is silent, or sends wrong answers | the recording has gaps and only true values, and goes on by itself | `build/release/tests/unit/record/test_record` |
| the disk is full while recording | the file ends with its last whole line, exit code 3 | the same test |
| the cycle hangs under systemd | the program sends no keep-alive, so that systemd restarts it | `build/release/tests/unit/host/test_host` |

## What makes a run red

An exit code other than 0, each with the line on the terminal and the test case in the file of `--junit`. `tests/docs/red_runs.sh` makes each of them
happen. Exit code 3 is stronger than 1: a failed run with an error gives 3.

| what happens | exit code | with | on the terminal | case of `--junit` |
|---|---|---|---|---|
| an `expect` or `wait` fails, or a `put` or `take` cannot be done | 1 | `--scenario` | `error: expected` | `step 1` fails |
| an `expect`, `wait`, `put` or `take` is not reached before the end | 1 | `--scenario` | `was not reached` | `step 2` fails |
| a requirement is violated | 1 | any options | `requirement violated` | `requirement: apart` fails |
| a finding, notes included, that plant.json does not ignore | 1 | `--fail-on-findings` | `findings: conflicting operations (1)` | `findings` fails |
| no PLC exchanges anything through a link, except `loop:` | 1 | `--scenario`, `--junit` or `--fail-on-findings` | `no PLC: modbus-tcp-server` | `no PLC` fails |
| a lost link freezes the plant until `--until` ends the run | 1 | `--scenario`, `--junit` or `--fail-on-findings` | `error: plant time waited` | `plant time` fails |
| the PLC's clock has not counted | 1 | `--scenario`, `--junit` or `--fail-on-findings` | `has not counted` | `plant time` fails |
| a cycle breaks a rule of the guard, or a signal ends the run before all cycles are checked | 1 | `--rt-check` | `cycles were not checked` | `rt-check` fails |
| a link that goes to the PLC never has a connection | 3 | any options | `never had a connection` | `run` is an error |
| an option, the symbol list, plant.json, the scenario or a snapshot is wrong | 2 | any options | `error: ` | `run` is an error |
| a file cannot be written, a port is in use, a permission is missing | 3 | any options | `error: cannot write` | `run` is an error |
| a second signal, or a blocked output after a signal, ends the process; it is killed | 3, or that of the signal | any options | nothing, if it is killed | `run` is an error |

Findings are also in the file of `--findings`, and counted in that of `--stats`. Results of an earlier run never survive a run that fails: these three
files are removed at the start. A run that fails before its first cycle leaves no file of findings and of statistics, and a JUnit file with its error.
Only a file that may be an input, because an option names it by mistake, is left as it is.

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
      "`check` runs with text and JSON output, `model` with every `--format`. `good` is exit code 0, `findings` 1, "
      "`refused` 2, with the errors that\n"
      "`check` finds. `diff` compares each input with a list without a fault, in both orders, and with itself: "
      "plants that differ are\n`findings`.\n\n" +
      table(trials, Input::Kind::list) +
      "\n## Plant descriptions\n\nEach with a small symbol list without a fault.\n\n" +
      table(trials, Input::Kind::plant) + "\n## Scenarios\n\n" + table(trials, Input::Kind::scenario) +
      "\n## Wrong files, wrong arguments\n\n| what | exit code | message |\n|---|---|---|\n";
  for (const auto& [misuse, outcome] : trials.misuses) {
    const std::size_t bar = outcome.cell.find(" | ");
    text += fmt::format("| {} | {} | {} |\n", escaped(misuse.what), outcome.cell.substr(0, bar),
                        escaped(outcome.cell.substr(bar + 3)));
  }
  return text;
}

}  // namespace symplant::hostile

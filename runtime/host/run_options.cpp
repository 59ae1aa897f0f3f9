// The options of `symplant run` and of every generated plant.
#include "symplant/host/run_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <string_view>
#include <system_error>

#include "symplant/tables/duration.hpp"

namespace symplant::host {
namespace {

// Far below the limit of 64-bit nanoseconds, so that deadlines cannot overflow.
constexpr tables::Time kLongestCycle = 3600 * tables::kSecond;
constexpr int kHighestPriority = 99;
constexpr std::int64_t kMostCatchUp = 1'000'000;
constexpr std::uint64_t kSmallestLimit = 1024;
constexpr tables::Time kLatestEnd = 876'000 * (3600 * tables::kSecond);

tables::Time duration(const std::string& text, const char* option) {
  const auto time = tables::parse_duration(text);
  if (!time) {
    throw CLI::ValidationError(
        option, "`" + text + "` is not a duration: write a number and ns, us, ms, s, min or h, such as 500ms");
  }
  return *time;
}

/// Parses the whole text as a number from `least` on, without a sign.
std::uint64_t whole_number(const std::string& text, std::uint64_t least, const char* option) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && read == end && number >= least) return number;
  throw CLI::ValidationError(
      option, "`" + text + "` is not a whole number from " + std::to_string(least) + " to 18446744073709551615");
}

void read_clock(const std::string& text, RunOptions& options) {
  using enum RunOptions::Clock;
  constexpr std::string_view kPlc = "plc:";
  if (text.starts_with(kPlc) && text.size() > kPlc.size()) {
    const std::size_t at = text.rfind('@');
    if (at != std::string::npos) {
      options.plc_unit = duration(text.substr(at + 1), "--clock");
      if (*options.plc_unit == 0 || *options.plc_unit > tables::kSecond) {
        throw CLI::ValidationError(
            "--clock", "`" + text.substr(at + 1) + "` is not the unit of a clock: write a time above 0 and at most 1s");
      }
    }
    options.plc_clock = text.substr(kPlc.size(), at == std::string::npos ? at : at - kPlc.size());
    options.clock = plc;
    return;
  }
  if (text != "virtual" && text != "real") {
    throw CLI::ValidationError("--clock", "`" + text + "` is not a clock: write virtual, real or plc:SYMBOL");
  }
  options.clock = text == "real" ? real_time : virtual_time;
}

void add_programs(CLI::App& app, RunOptions& options) {
  app.add_option("--program", options.programs,
                 "run this PLC program in lock step with the plant: a shared library with the interface "
                 "symplant/program.h; with several controllers name one: PLC1=FILE. Replaces the plant's own programs")
      ->type_name("[CONTROLLER=]FILE")
      ->allow_extra_args(false);
  const auto time_option = [&app](const char* name, std::optional<tables::Time>& time, const char* text) {
    app.add_option_function<std::string>(
           name,
           [name, &time](const std::string& given) {
             time = duration(given, name);
             if (*time == 0 || *time > kLongestCycle) {
               throw CLI::ValidationError(name, "`" + given + "` is out of range: write a time above 0 and at most 1h");
             }
           },
           text)
        ->type_name("T");
  };
  time_option("--scan", options.scan,
              "the time from one scan of a program to the next (default: the program's, else 10ms)");
  time_option("--scan-delay", options.scan_delay,
              "the time from a scan until the plant samples its outputs, at most that of --scan (default: as --scan)");
}

void add_files(CLI::App& app, RunOptions& options) {
  app.add_option("--scenario", options.scenario, "play this scenario and check its expectations")->type_name("FILE");
  CLI::Option* const fault =
      app.add_option("--fault", options.fault,
                     "start this malfunction, such as `SYMBOL stuck on`; a campaign names those that it tries")
          ->type_name("NAME")
          ->check(
              [](const std::string& name) { return name.empty() ? "give the name of a malfunction" : std::string(); });
  app.add_option_function<std::string>(
         "--fault-at", [&options](const std::string& text) { options.fault_at = duration(text, "--fault-at"); },
         "when the malfunction of --fault starts (default: 0s)")
      ->type_name("T")
      ->needs(fault);
  app.add_option("--replay", options.replay, "repeat the run that this trace recorded, in virtual time")
      ->type_name("FILE");
  app.add_option("--trace", options.trace, "write every change of every I/O symbol to this file, as JSON lines")
      ->type_name("FILE");
  app.add_option("--vcd", options.vcd, "write symbols and states to this file, for GTKWave and other wave viewers")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--trace-limit",
         [&options](const std::string& text) {
           const auto size = parse_size(text);
           if (!size) {
             throw CLI::ValidationError("--trace-limit", "`" + text + "` is not a size: write bytes, or 500k, 10M, 1G");
           }
           if (*size < kSmallestLimit) {
             throw CLI::ValidationError(
                 "--trace-limit",
                 "`" + text + "` is too small, since each file begins with a header: write 1k or more");
           }
           options.trace_limit = *size;
         },
         "rename a trace or VCD file of this size to FILE.1 and start a new one; 1k or more (default: no limit)")
      ->type_name("SIZE");
  app.add_option("--findings", options.findings, "write all findings to this file, as JSON lines")->type_name("FILE");
  app.add_option("--junit", options.junit,
                 "report expectations, requirements, and whether a PLC connected, to this file, as JUnit XML")
      ->type_name("FILE");
  app.add_option("--stats", options.stats,
                 "write statistics of the run to this file, as JSON; a FILE that ends with .csv gets the utilization "
                 "of devices, tracks and places as a table")
      ->type_name("FILE");
  app.add_option("--save", options.save, "write the state of the plant at the end to this file, for --resume")
      ->type_name("FILE");
  app.add_option("--resume", options.resume, "start from a state that --save or the panel wrote")->type_name("FILE");
}

/// The options of the panel; given at all, there is one.
panel::PanelOptions& panel_of(RunOptions& options) {
  if (!options.panel) options.panel.emplace();
  return *options.panel;
}

void add_panel(CLI::App& app, RunOptions& options) {
  add_address_options(app, options, "show and operate the plant");
  app.add_flag_callback(
      "--panel-view", [&options] { panel_of(options).view_only = true; }, "the panel only shows: no acts");
  app.add_flag_callback(
      "--panel-trainee", [&options] { panel_of(options).trainees = true; },
      "print three links: for a trainer, for trainees, and for viewers");
  app.add_option_function<std::string>(
         "--panel-files", [&options](const std::string& folder) { panel_of(options).files = folder; },
         "the panel saves snapshots and sessions in this folder")
      ->type_name("DIR");
  app.add_option_function<std::string>(
         "--backtrack",
         [&options](const std::string& text) { panel_of(options).backtrack = duration(text, "--backtrack"); },
         "the panel keeps a state of the plant each time so much plant time has passed; 0s: none (default: 60s)")
      ->type_name("T");
  app.add_option("--exercise", options.exercises, "a scenario that the panel offers as an exercise; may be repeated")
      ->type_name("FILE");
}

void add_real_time(CLI::App& app, RunOptions& options) {
  app.add_option_function<std::string>(
         "--on-loss",
         [&options](const std::string& text) {
           if (text != "hold" && text != "zero") {
             throw CLI::ValidationError("--on-loss", "`" + text + "` is not a policy: write hold or zero");
           }
           options.on_loss = text == "hold" ? link::OnLoss::hold : link::OnLoss::zero;
         },
         "what operations do while their link is lost, except symbols with their own policy (default: the plant's "
         "`links`, else hold)")
      ->type_name("hold|zero");
  app.add_flag("--arm", options.arm,
               "with a link that goes to the PLC: write events also to a PLC that cannot be identified");
  app.add_option_function<std::string>(
         "--late",
         [&options](const std::string& text) {
           const auto most = parse_late(text);
           if (!most) {
             throw CLI::ValidationError(
                 "--late", "`" + text + "` is not a policy: write catch-up, catch-up:N (N up to 1000000) or slip");
           }
           options.max_catch_up = *most;
           options.late_given = true;
         },
         "in real time, after missed deadlines: run up to N cycles at once, one after the other, or let plant time "
         "slip "
         "(default: catch-up:10)")
      ->type_name("catch-up[:N]|slip");
  app.add_option_function<int>(
         "--priority",
         [&options](int priority) {
           if (priority < 1 || priority > kHighestPriority) {
             throw CLI::ValidationError(
                 "--priority", "`" + std::to_string(priority) + "` is not a priority: write 1 (low) to 99 (high)");
           }
           options.real_time.priority = priority;
         },
         "in real time: run the cycle before all ordinary programs (SCHED_FIFO)")
      ->type_name("1..99");
  app.add_option_function<int>(
         "--cpu",
         [&options](int cpu) {
           if (cpu < 0) {
             throw CLI::ValidationError(
                 "--cpu", "`" + std::to_string(cpu) + "` is not a processor: write its number, counted from 0");
           }
           options.real_time.cpu = cpu;
         },
         "in real time: keep the cycle on this processor, counted from 0")
      ->type_name("N");
  app.add_flag("--lock-memory", options.real_time.lock_memory, "in real time: keep the memory of the program in RAM");
  app.add_flag("--stay-awake", options.real_time.stay_awake,
               "in real time: keep processors out of deep idle states, from which they wake late; costs power");
  app.add_option_function<std::string>(
         "--spin", [&options](const std::string& text) { options.spin = duration(text, "--spin"); },
         "in real time: busy-wait for this long before each cycle, to start it within microseconds; costs CPU time "
         "(default: 0s)")
      ->type_name("T");
}

}  // namespace

void add_address_options(CLI::App& app, RunOptions& options, const std::string& purpose) {
  app.add_option_function<std::vector<std::string>>(
         "--panel",
         [&options](const std::vector<std::string>& texts) {
           panel::PanelOptions& panel = panel_of(options);
           if (texts.empty() || texts.front().empty()) return;
           const std::string& text = texts.front();
           if (text.find_first_not_of("0123456789") != std::string::npos && text.find(':') == std::string::npos) {
             throw CLI::ValidationError("--panel",
                                        "`" + text + "` is not HOST:PORT or PORT; write the plant before `--panel`");
           }
           panel.address = text;
         },
         purpose + " in a browser, at this address (default: 127.0.0.1:8137); prints the link")
      ->type_name("[[HOST:]PORT]")
      ->expected(0, 1);
  app.add_option_function<std::string>(
         "--panel-token", [&options](const std::string& file) { panel_of(options).token_file = file; },
         "the panel's token is the first word of this file; with --panel-trainee, the trainee's and the viewer's come "
         "next (default: "
         "another one for each start)")
      ->type_name("FILE");
}

void add_run_options(CLI::App& app, RunOptions& options) {
  app.add_option_function<std::string>(
         "--clock", [&options](const std::string& text) { read_clock(text, options); },
         "virtual: as fast as possible; real: in step with the wall clock; plc:SYMBOL: in step with a counter of the "
         "PLC, in ms or, with plc:SYMBOL@100us, in another unit (default: as in the plant's `links`, else real with a "
         "link other than loop:)")
      ->type_name("virtual|real|plc:SYMBOL");
  app.add_option_function<std::string>(
         "--until",
         [&options](const std::string& text) {
           options.until = duration(text, "--until");
           if (*options.until > kLatestEnd) {
             throw CLI::ValidationError("--until", "`" + text + "` is too late: write at most 876000h (100 years)");
           }
         },
         "end at this plant time, after its events; also after waiting for a PLC for the rest of this time, but at "
         "least 5 s; not "
         "with --rt-check")
      ->type_name("T");
  app.add_option_function<std::string>(
         "--cycle",
         [&options](const std::string& text) {
           options.cycle = duration(text, "--cycle");
           options.cycle_given = true;
           if (options.cycle == 0 || options.cycle > kLongestCycle) {
             throw CLI::ValidationError("--cycle",
                                        "`" + text + "` is not a cycle: write a time above 0 and at most 1h");
           }
         },
         "in real time: length of a cycle, from one exchange with the PLC to the next (default: 10ms)")
      ->type_name("T");
  add_real_time(app, options);
  app.add_option(
         "--link", options.links,
         "exchange I/O with a PLC: modbus-tcp-server://HOST:PORT (the PLC connects to the plant), "
         "modbus-tcp://HOST:PORT?events=coils:800 or slmp://HOST:PORT?family=q (the plant connects to the PLC), or "
         "loop:; with several controllers name one: PLC1=URL. Replaces the plant's own links")
      ->type_name("[CONTROLLER=]URL");
  add_programs(app, options);
  add_files(app, options);
  add_panel(app, options);
  app.add_option_function<std::string>(
         "--seed",
         [&options](const std::string& text) {
           options.seed = whole_number(text, 0, "--seed");
           options.seed_given = true;
         },
         "seed of random times (default: 0, with `--replay` that of the trace)")
      ->type_name("N");
  app.add_option_function<std::string>(
         "--rt-check", [&options](const std::string& text) { options.rt_check = whole_number(text, 1, "--rt-check"); },
         "run N cycles under a guard that finds heap, locks, system calls and page faults in them, then end; exit "
         "code 1 if any")
      ->type_name("N");
  app.add_option(
         "--why", options.why,
         "at the end explain why this device, symbol, requirement, track, place, transfer, work or source is as "
         "it is, and what it waits for; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_flag("--fail-on-findings", options.fail_on_findings,
               "any finding gives exit code 1, notes included, not only failed expectations and violated requirements");
}

RunOptions result_files_of(const CLI::App& app) {
  const auto file = [&](const char* name) {
    const CLI::Option* const option = app.get_option_no_throw(name);
    return option == nullptr || option->results().empty() ? std::string() : option->results().back();
  };
  RunOptions options;
  options.junit = file("--junit");
  options.findings = file("--findings");
  options.stats = file("--stats");
  return options;
}

std::optional<std::int64_t> parse_late(const std::string& text) {
  constexpr std::string_view kCatchUp = "catch-up";
  if (text == "slip") return 0;
  if (text == kCatchUp) return RunOptions{}.max_catch_up;
  if (text.rfind(std::string(kCatchUp) + ":", 0) != 0) return std::nullopt;
  const std::string_view number = std::string_view(text).substr(kCatchUp.size() + 1);
  std::int64_t most = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), most);
  if (error != std::errc() || end != number.data() + number.size() || most < 0 || most > kMostCatchUp) {
    return std::nullopt;
  }
  return most;
}

std::optional<std::uint64_t> parse_size(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [unit, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || number == 0 || end - unit > 1) return std::nullopt;
  constexpr std::string_view kUnits = "kMG";
  const std::size_t index = unit == end ? 0 : kUnits.find(*unit) + 1;
  if (unit != end && index == 0) return std::nullopt;
  if (number > (~std::uint64_t{0} >> (10 * index))) return std::nullopt;
  return number << (10 * index);
}

}  // namespace symplant::host

// The stand-in PLC of the demo: input image, program, output image, once a scan.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>

#include "io.hpp"
#include "options.hpp"
#include "program.hpp"

namespace {

using Clock = std::chrono::steady_clock;

enum ExitCode { kGood = 0, kNotCompleted = 1, kBadUsage = 2, kNoConnection = 3 };

volatile std::sig_atomic_t stop_asked = 0;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

int not_completed(const excell::Program& program, const std::string& why) {
  std::fprintf(stderr, "controller: cycle %u not completed: %s\n", program.cycles() + 1, why.c_str());
  return kNotCompleted;
}

/// Scans until all cycles are done, a signal arrives, or a step waits for too long.
int run(excell::Io& io, const excell::Options& options) {
  excell::Program program;
  excell::Inputs in;
  const auto begin = Clock::now();
  auto next_scan = begin;
  auto last_scan = begin;
  while (stop_asked == 0) {
    if (!io.read(in))
      return not_completed(program, "the plant no longer answers (" + io.error() + "); " + program.step());

    const auto now = Clock::now();
    const unsigned cycles_before = program.cycles();
    const excell::Outputs out =
        program.scan(in, std::chrono::duration_cast<excell::Program::Duration>(now - last_scan));
    last_scan = now;
    if (program.cycles() != cycles_before) {
      std::printf("controller: %9.3f s  cycle %u completed\n", seconds_since(begin), program.cycles());
      std::fflush(stdout);
      if (program.cycles() == options.cycles) {
        io.write({});  // leave the cell with all commands off
        return kGood;
      }
    }

    if (!io.write(out))
      return not_completed(program, "the plant no longer answers (" + io.error() + "); " + program.step());
    if (program.waiting() > options.step_timeout) return not_completed(program, program.step());

    // The scan is fixed: a late one is not made up for.
    next_scan = std::max(next_scan + options.scan, Clock::now() - options.scan);
    std::this_thread::sleep_until(next_scan);
  }
  io.write({});
  return kGood;
}

}  // namespace

int main(int argc, char** argv) {
  std::string error;
  const auto options = excell::parse_options(argc, argv, error);
  if (!options) {
    std::fprintf(stderr, "controller: %s\n%s", error.c_str(), excell::kUsage);
    return kBadUsage;
  }
  if (options->help) {
    std::fputs(excell::kUsage, stdout);
    return kGood;
  }
  std::signal(SIGINT, [](int) { stop_asked = 1; });
  std::signal(SIGTERM, [](int) { stop_asked = 1; });
  std::signal(SIGPIPE, SIG_IGN);  // if the plant ends, the next call reports an error

  excell::Io io(options->host, options->port, options->connect_timeout);
  if (!io.connected()) {
    std::fprintf(stderr, "controller: no connection to %s:%s within %lld ms (%s)\n", options->host.c_str(),
                 options->port.c_str(), static_cast<long long>(options->connect_timeout.count()), io.error().c_str());
    return kNoConnection;
  }
  return run(io, *options);
}

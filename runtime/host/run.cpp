// Runs a plant.
#include "symplant/host/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <ostream>
#include <thread>

#include "symplant/core/digest.hpp"
#include "symplant/core/owned_plant.hpp"
#include "symplant/exec/cycle.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/summary.hpp"
#include "symplant/link/link.hpp"
#include "symplant/trace/trace_file.hpp"

namespace symplant::host {
namespace {

using core::Time;

/// Where virtual time without `--until` ends at the latest.
constexpr Time kLongest = 3600 * core::kSecond;
constexpr std::size_t kRingCapacity = std::size_t{1} << 16;

// A handler can only reach what is global.
std::atomic<bool> stop_requested{false};

void request_stop(int) { stop_requested.store(true); }

void catch_signals() {
  stop_requested.store(false);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

std::string seconds(Time time) { return fmt::format("{} s", static_cast<double>(time) / 1e9); }

/// The trace of a run: recorder and file; nothing where none was asked for.
class Tracing {
 public:
  Tracing(const core::PlantTables& tables, const RunOptions& options)
      : tables_(tables),
        options_(options),
        recorder_(tables, options.trace.empty() ? 0 : std::max(kRingCapacity, 2 * tables.symbols.size())) {}

  /// Opens the file; what was recorded before goes into it, too.
  void open(std::uint64_t model_hash) {
    if (options_.trace.empty()) return;
    file_ = std::make_unique<trace::TraceFile>(options_.trace, tables_, model_hash, options_.seed);
  }

  void attach(const core::Plant& plant) { recorder_.attach(plant); }
  core::Observer* observer() { return options_.trace.empty() ? nullptr : &recorder_; }
  std::string error() const { return file_ ? file_->error() : std::string(); }
  std::uint64_t lost() const { return recorder_.lost(); }

  void drain() {
    if (file_) recorder_.drain([&](const trace::Change& change) { file_->write(change); });
  }
  void finish() {
    drain();
    if (file_) file_->flush();
  }

  /// In real time: a thread writes the file, so that the cycle never waits for a disk.
  void start_thread() {
    if (!file_) return;
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        drain();
        file_->flush();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  void stop_thread() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
  }

 private:
  const core::PlantTables& tables_;
  const RunOptions& options_;
  trace::Recorder recorder_;
  std::unique_ptr<trace::TraceFile> file_;
  std::jthread thread_;
};

void run_virtual(core::Plant& plant, const RunOptions& options, Tracing& tracing, std::ostream& out) {
  const Time end = options.until.value_or(kLongest);
  while (!stop_requested.load(std::memory_order_relaxed)) {
    const Time due = plant.next_due();
    if (due > end) {
      const bool nothing_left = due == core::kNever;
      if (options.until || !nothing_left) plant.advance_to(end, tracing.observer());
      tracing.drain();
      if (options.until) {
        out << fmt::format("ended at {}, as asked\n", seconds(end));
      } else if (nothing_left) {
        out << fmt::format("ended at {}: nothing more is due; --link lets a PLC move it\n", seconds(plant.now()));
      } else {
        out << fmt::format("ended at {} of plant time: the plant would go on for ever; --until says how long\n",
                           seconds(end));
      }
      return;
    }
    plant.advance_to(due, tracing.observer());
    tracing.drain();
  }
  out << fmt::format("ended at {} by a signal\n", seconds(plant.now()));
}

void run_real(core::Plant& plant, const RunOptions& options, std::vector<std::unique_ptr<link::Link>>& links,
              Tracing& tracing, std::ostream& out) {
  std::vector<exec::Exchange*> exchanges;
  for (const auto& link : links) {
    exchanges.push_back(link.get());
    out << fmt::format("link {}\n", link->url());
  }
  out << fmt::format("running in real time, a cycle of {} ms{}\n", static_cast<double>(options.cycle) / 1e6,
                     options.until ? fmt::format(", until {}", seconds(*options.until)) : "; Ctrl-C ends it");
  out.flush();
  tracing.start_thread();
  exec::MonotonicClock clock;
  exec::CycleOptions cycle;
  cycle.cycle = options.cycle;
  cycle.until = options.until.value_or(core::kNever);
  const exec::CycleStatistics done =
      exec::run_cycles(plant, exchanges, cycle, clock, tracing.observer(), stop_requested);
  tracing.stop_thread();

  out << fmt::format("ended at {}{}: {} cycles, {} overruns, {} lost, latest start {} us late\n", seconds(plant.now()),
                     stop_requested.load() ? " by a signal" : "", done.cycles, done.overruns, seconds(done.slipped),
                     done.max_lateness / 1000);
  for (const auto& link : links) {
    const link::LinkStatus status = link->status();
    out << fmt::format("link {}: {} requests, {} exceptions, {} writes to gaps\n", link->url(), status.requests,
                       status.exceptions, status.writes_to_gaps);
  }
}

}  // namespace

int run(const core::PlantTables& tables, const RunOptions& options, std::ostream& out, std::ostream& err,
        const std::vector<std::string>& more) {
  const bool linked =
      std::any_of(options.links.begin(), options.links.end(), [](const auto& l) { return l != "loop:"; });
  if (linked && options.clock == RunOptions::Clock::virtual_time) {
    err << "error: virtual time with a link to a PLC makes no sense, since the PLC's time is real: leave `--clock "
           "virtual` "
           "away\n";
    return kBadInput;
  }
  const bool real = linked || options.clock == RunOptions::Clock::real_time;
  const std::uint64_t hash = core::model_hash(tables);
  catch_signals();

  // The plant stands where it starts before anybody is answered.
  core::OwnedPlant plant(tables);
  Tracing tracing(tables, options);
  tracing.attach(plant);
  plant.advance_to(0, tracing.observer());

  std::vector<std::unique_ptr<link::Link>> links;
  for (const std::string& url : options.links) {
    auto opened = link::open_link(url, tables, &plant);
    if (const auto* error = std::get_if<link::LinkError>(&opened)) {
      err << "error: " << error->message << "\n";
      return error->kind == link::LinkError::Kind::usage ? kBadInput : kEnvironment;
    }
    links.push_back(std::get<std::unique_ptr<link::Link>>(std::move(opened)));
  }
  tracing.open(hash);
  if (!tracing.error().empty()) {
    err << "error: " << tracing.error() << "\n";
    return kEnvironment;
  }
  out << summary(tables, hash, more);
  if (real) {
    run_real(plant, options, links, tracing, out);
  } else {
    run_virtual(plant, options, tracing, out);
  }
  tracing.finish();
  if (!tracing.error().empty()) err << "warning: " << tracing.error() << "\n";
  if (tracing.lost() != 0)
    err << fmt::format("warning: {} changes are missing in the trace: the disk was too slow\n", tracing.lost());
  return kGood;
}

}  // namespace symplant::host

// The files that a run writes while the plant runs.
#include "symplant/host/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stop_token>

namespace symplant::host {
namespace {

constexpr std::size_t kRingCapacity = std::size_t{1} << 16;

}  // namespace

Outputs::Outputs(const core::PlantTables& tables, const RunOptions& options)
    : tables_(tables),
      options_(options),
      recorder_(tables, options.trace.empty() ? 0 : std::max(kRingCapacity, 2 * tables.symbols.size())) {}

bool Outputs::open(std::uint64_t model_hash, std::ostream& err) {
  if (options_.trace.empty()) return true;
  trace_ = std::make_unique<trace::TraceFile>(options_.trace, tables_, model_hash, options_.seed);
  if (trace_->error().empty()) return true;
  err << "error: " << trace_->error() << "\n";
  return false;
}

void Outputs::drain() {
  if (trace_) recorder_.drain([&](const trace::Change& change) { trace_->write(change); });
}

void Outputs::start_thread() {
  if (!trace_) return;
  thread_ = std::jthread([this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      drain();
      trace_->flush();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
}

void Outputs::stop_thread() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void Outputs::finish(std::ostream& err) {
  if (!trace_) return;
  drain();
  trace_->flush();
  if (!trace_->error().empty()) err << "warning: " << trace_->error() << "\n";
  if (recorder_.lost() != 0) {
    err << fmt::format("warning: {} changes are missing in the trace: the disk was too slow\n", recorder_.lost());
  }
}

}  // namespace symplant::host

// Reports the losses of a link, as findings and to the behaviors of its devices.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "symplant/exec/exchange.hpp"
#include "symplant/host/links.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::host {

/// An Exchange between the cycle and a link. Its references must outlive it. Used by the thread of the cycle. O(1),
/// except for a cycle in which the state of the link changes: it costs a call for each device of its controller with a
/// behavior.
class WatchedLink final : public exec::Exchange {
 public:
  /// `place`: index of the link in the run, for its findings.
  WatchedLink(const OpenLink& link, std::uint32_t place, plant::Plant& plant, trace::Recorder& recorder);

  void read_operations(plant::Plant& plant, tables::Time now) noexcept override;
  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override {
    link_.write_events(plant, status);
  }
  void leave() noexcept override { link_.leave(); }
  exec::LinkState state() const noexcept override { return link_.state(); }
  bool freezes_plant() const noexcept override { return link_.freezes_plant(); }

 private:
  void report(plant::Plant& plant) const noexcept;

  link::Link& link_;
  std::uint32_t controller_;
  std::uint32_t place_;
  std::vector<std::uint32_t> behaviours_;  ///< in PlantTables::behaviour_units: devices whose operations it carries
  trace::Recorder& recorder_;
  exec::LinkState before_;
};

/// The links of a run, for the cycle.
class WatchedLinks {
 public:
  /// At once, reports links that are not live yet to the behaviors of the plant, and passes the events that links show
  /// on request to the plant (Plant::show_on_request()).
  WatchedLinks(const Links& links, plant::Plant& plant, trace::Recorder& recorder);

  std::span<exec::Exchange* const> exchanges() const noexcept { return exchanges_; }

 private:
  std::deque<WatchedLink> links_;
  std::vector<exec::Exchange*> exchanges_;
};

}  // namespace symplant::host

// Reports the losses of a link.
#include "symplant/host/watched_link.hpp"

#include "symplant/tables/lists.hpp"

namespace symplant::host {

using exec::LinkState;

namespace {

/// Indexes in PlantTables::behaviour_units of the devices with an operation of the controller.
std::vector<std::uint32_t> behaviours_of(std::uint32_t controller, const tables::PlantTables& tables) {
  std::vector<bool> carried(tables.units.size());
  for (std::uint32_t symbol = 0; symbol < tables.symbols.size(); ++symbol) {
    const tables::SymbolRow& row = tables.symbols[symbol];
    if (row.unit == tables::kNone || row.direction() != tables::Direction::operation) continue;
    if (controller == link::kAllControllers || tables::controller_of(tables, symbol) == controller) {
      carried[row.unit] = true;
    }
  }
  std::vector<std::uint32_t> behaviours;
  for (std::uint32_t place = 0; place < tables.behaviour_units.size(); ++place) {
    if (carried[tables.behaviour_units[place].unit]) behaviours.push_back(place);
  }
  return behaviours;
}

/// The events that links show to a PLC on request, as Plant::events().
std::vector<std::uint64_t> events_on_request(const Links& links, const tables::PlantTables& tables) {
  std::vector<std::uint64_t> events(tables.event_bits / 64);
  for (const OpenLink& open : links) {
    for (const std::uint32_t symbol : open.link->events_on_request()) {
      const std::uint32_t bit = tables.symbols[symbol].index;
      events[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
  }
  return events;
}

}  // namespace

WatchedLink::WatchedLink(const OpenLink& link, std::uint32_t place, plant::Plant& plant, trace::Recorder& recorder)
    : link_(*link.link),
      controller_(link.choice.controller),
      place_(place),
      behaviours_(behaviours_of(link.choice.controller, plant.tables())),
      recorder_(recorder),
      before_(link_.state()) {
  if (before_ != LinkState::live) report(plant);
}

void WatchedLink::report(plant::Plant& plant) const noexcept {
  const bool well = before_ == LinkState::live;
  if (!behaviours_.empty()) recorder_.begin_act(plant.now());
  for (const std::uint32_t behaviour : behaviours_) {
    recorder_.act(plant.now(), trace::kQualityNote, std::uint64_t{behaviour} * 2 + (well ? 1 : 0));
    plant.set_quality(behaviour, well);
  }
}

void WatchedLink::read_operations(plant::Plant& plant, tables::Time now) noexcept {
  link_.cut(plant.is_cut(controller_));
  link_.read_operations(plant, now);
  while (const std::optional<link::LinkFinding> found = link_.take_finding()) {
    recorder_.raise(plant.now(), found->kind, found->symbol == tables::kNone ? place_ : found->symbol, found->value);
  }
  const LinkState state = link_.state();
  if (state == before_) return;
  if (state == LinkState::lost) recorder_.raise(plant.now(), tables::FindingKind::link_lost, place_);
  if (before_ == LinkState::lost) recorder_.raise(plant.now(), tables::FindingKind::link_back, place_);
  before_ = state;
  report(plant);
}

WatchedLinks::WatchedLinks(const Links& links, plant::Plant& plant, trace::Recorder& recorder) {
  plant.show_on_request(events_on_request(links, plant.tables()));
  for (const OpenLink& open : links) {
    links_.emplace_back(open, static_cast<std::uint32_t>(links_.size()), plant, recorder);
    exchanges_.push_back(&links_.back());
  }
}

}  // namespace symplant::host

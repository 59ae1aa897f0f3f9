// What the devices of a plant do, as their operations and events show it.
#include "observe/observer_impl.hpp"

#include <algorithm>

namespace symplant::observe {
namespace {

using model::Unit;
using Shown = Positions::Shown;

}  // namespace

Observer::Impl::Impl(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution)
    : plant_(plant),
      grace_(2 * resolution),
      values_(plant.symbols.size(), 0),
      known_(plant.symbols.size(), false),
      dependents_(dependents_of(plant)),
      disabled_by_(plant.units.size()) {
  units_.reserve(plant.units.size());
  for (const Unit& unit : plant.units) units_.push_back({Positions(plant, unit, recorded)});
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    for (std::uint32_t s = 0; s < plant.units[u].disables.size(); ++s) {
      for (const std::uint32_t other : plant.units[u].disables[s]) disabled_by_[other].emplace_back(u, s);
    }
  }
  view_.value = [this](std::uint32_t symbol) {
    if (own_ != kNone && plant_.symbols[symbol].unit == own_) {
      if (const auto own = own_level(symbol)) return own;
    }
    return known_[symbol] ? std::optional(values_[symbol]) : std::nullopt;
  };
  view_.settled = [this](std::uint32_t unit, std::uint32_t state) -> std::optional<bool> {
    const Followed& followed = units_[unit];
    if (followed.state == kNone || followed.contradicts) return std::nullopt;
    if (unit == own_) return own_state_ == state;
    if (followed.positions.misleads()) return std::nullopt;
    if (followed.moving || followed.positions.is_lit(followed.state)) {
      return !followed.moving && followed.state == state;
    }
    if (followed.unsure) return followed.positions.is_lit(state) ? std::optional(false) : std::nullopt;
    if (followed.state != state) return false;
    return is_surely_settled(unit) && followed.next.to == kNone ? std::optional(true) : std::nullopt;
  };
  view_.moving = [this](std::uint32_t unit) -> std::optional<bool> {
    const Followed& followed = units_[unit];
    if (unit == own_) return false;
    if (followed.positions.misleads()) return std::nullopt;
    // While it is in a state without an event nothing shows whether it moves.
    if (followed.state == kNone || followed.contradicts) return std::nullopt;
    if (!followed.moving && !followed.positions.is_lit(followed.state)) return std::nullopt;
    return followed.moving;
  };
}

void Observer::Impl::set(std::uint32_t symbol, double value) {
  if (known_[symbol] && values_[symbol] == value) return;
  known_[symbol] = true;
  values_[symbol] = value;
  if (plant_.symbols[symbol].unit != kNone) queue(plant_.symbols[symbol].unit);
  for (const std::uint32_t unit : dependents_.of_symbol[symbol]) queue(unit);
}

std::span<const Step> Observer::Impl::close(Time time) {
  steps_.clear();
  now_ = time;
  ++visit_;
  if (begun_ && time - begun_at_ < grace_ / 2) forget();  // the first image is read in several parts
  if (!begun_) {
    begun_at_ = begun_at_ == kUnknown ? time : begun_at_;
    begin();
    return steps_;
  }
  // Units on which others depend come first, if they do not depend on each other. A change that has no cause yet may
  // have one in what another unit does at the same time: it waits for that.
  std::vector<std::uint32_t> later;
  std::vector<std::uint32_t> waiting;
  while (!queue_.empty() || !later.empty() || !waiting.empty()) {
    const bool last_resort = queue_.empty() && later.empty();
    std::vector<std::uint32_t>& from = !queue_.empty() ? queue_ : !later.empty() ? later : waiting;
    const std::uint32_t unit = from.back();
    from.pop_back();
    if (&from == &queue_ && depends_on_queued(unit)) {
      later.push_back(unit);
      continue;
    }
    units_[unit].queued = false;
    if (!follow(unit, last_resort)) waiting.push_back(unit);
  }
  return steps_;
}

void Observer::Impl::forget() {
  begun_ = false;
  for (Followed& followed : units_) followed = {std::move(followed.positions)};
  queue_.clear();
}

View Observer::Impl::view(std::uint32_t unit) const {
  const Followed& followed = units_[unit];
  return {followed.state, followed.moving,        followed.contradicts, followed.stopped_since != kUnknown,
          followed.since, followed.stopped_since, followed.next};
}

void Observer::Impl::queue(std::uint32_t unit) {
  if (units_[unit].queued || !begun_) return;
  units_[unit].queued = true;
  queue_.push_back(unit);
}

bool Observer::Impl::depends_on_queued(std::uint32_t unit) const {
  const std::vector<std::uint32_t>& others = dependents_.read_by[unit];
  return std::any_of(others.begin(), others.end(), [this](std::uint32_t other) { return units_[other].queued; });
}

void Observer::Impl::queue_dependents(std::uint32_t unit) {
  for (const std::uint32_t other : dependents_.of_unit[unit]) queue(other);
}

std::optional<double> Observer::Impl::own_level(std::uint32_t symbol) const {
  const Unit& unit = plant_.units[own_];
  const auto event = std::find(unit.events.begin(), unit.events.end(), symbol);
  if (event == unit.events.end() || own_state_ == kNone) return std::nullopt;
  const std::uint64_t bit = std::uint64_t{1} << (event - unit.events.begin());
  const auto on = units_[own_].positions.level(own_state_, bit);
  if (!on) return std::nullopt;
  return *on != plant_.symbols[symbol].inverted ? 1 : 0;
}

Levels Observer::Impl::levels(const std::vector<std::uint32_t>& symbols) const {
  Levels levels;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (!known_[symbols[i]]) continue;
    const std::uint64_t bit = std::uint64_t{1} << i;
    levels.known |= bit;
    if ((values_[symbols[i]] != 0) != plant_.symbols[symbols[i]].inverted) levels.on |= bit;
  }
  return levels;
}

void Observer::Impl::begin() {
  begun_ = true;
  for (std::uint32_t u = 0; u < units_.size(); ++u) {
    Followed& followed = units_[u];
    followed.queued = false;
    if (!followed.positions.shows_anything()) continue;
    const auto shown = followed.positions.at(levels(plant_.units[u].events).on, kNone);
    followed.state = shown.shown == Shown::state  ? shown.state
                     : shown.shown == Shown::dark ? followed.positions.dark_state()
                                                  : kNone;
    followed.causes.enter(plant_.units[u], followed.state, kUnknown);
  }
  queue_.clear();
  for (std::uint32_t u = 0; u < units_.size(); ++u) update_causes(u);
}

Observer::Observer(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution)
    : impl_(std::make_unique<Impl>(plant, recorded, resolution)) {}
Observer::~Observer() = default;

void Observer::set(std::uint32_t symbol, double value) { impl_->set(symbol, value); }
std::span<const Step> Observer::close(Time time) { return impl_->close(time); }
void Observer::forget() { impl_->forget_all(); }
View Observer::view(std::uint32_t unit) const { return impl_->view(unit); }
double Observer::value(std::uint32_t symbol) const { return impl_->value(symbol); }

}  // namespace symplant::observe

// Which states of a unit its events can show.
#include "observe/positions.hpp"

#include <algorithm>
#include <bit>

namespace symplant::observe {

using model::kNone;

namespace {

/// Events on the address of `event`, itself included.
std::uint64_t on_address_of(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event) {
  const auto leader = [&](std::uint32_t symbol) {
    return plant.symbols[symbol].leader == kNone ? symbol : plant.symbols[symbol].leader;
  };
  std::uint64_t same = 0;
  for (std::size_t e = 0; e < unit.events.size(); ++e) {
    if (leader(unit.events[e]) == leader(unit.events[event])) same |= std::uint64_t{1} << e;
  }
  return same;
}

}  // namespace

Positions::Positions(const model::PlantModel& plant, const model::Unit& unit, const std::vector<bool>& recorded) {
  std::uint64_t known = 0;
  for (std::size_t e = 0; e < unit.events.size(); ++e) {
    const std::uint32_t symbol = unit.events[e];
    if (recorded[symbol] && plant.symbols[symbol].type == tables::DataType::boolean) known |= std::uint64_t{1} << e;
  }
  std::uint64_t of_states = 0;
  for (const model::State& state : unit.states) {
    if (state.event != kNone) of_states |= std::uint64_t{1} << state.event;
  }
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    Signature signature{of_states, 0};
    if (unit.states[s].event != kNone) {
      const std::uint64_t same = on_address_of(plant, unit, unit.states[s].event);
      signature.mask &= ~same;  // its level follows from that one
      signature.mask |= std::uint64_t{1} << unit.states[s].event;
      signature.bits |= std::uint64_t{1} << unit.states[s].event;
    }
    if (!unit.outputs.empty()) {
      for (const auto& [event, on] : unit.outputs[s].enter) {
        const std::uint64_t bit = std::uint64_t{1} << event;
        signature.mask |= bit;
        signature.bits = on ? signature.bits | bit : signature.bits & ~bit;
      }
    }
    Signature left = signature;
    if (unit.states[s].event != kNone) left.bits &= ~on_address_of(plant, unit, unit.states[s].event);
    if (!unit.outputs.empty()) {
      for (const auto& [event, on] : unit.outputs[s].leave) {
        const std::uint64_t bit = std::uint64_t{1} << event;
        left.mask |= bit;
        left.bits = on ? left.bits | bit : left.bits & ~bit;
      }
    }
    signatures_.push_back({signature.mask & known, signature.bits & known});
    signature = signatures_.back();
    left_.push_back({left.mask & known, left.bits & known});
    shown_ |= signature.bits;
  }
  for (std::uint32_t from = 0; from < unit.states.size(); ++from) {
    for (std::uint32_t to = 0; to < unit.states.size(); ++to) misleads_ = misleads_ || shows_at_leaving(from, to);
  }
  // Without an event that is on it can move between two states with events, or be in a state without one.
  const auto lit = [this](std::uint32_t s) { return is_lit(s); };
  std::uint32_t dark = kNone;
  bool several = false;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (lit(s)) continue;
    several = dark != kNone;
    dark = s;
  }
  const bool passes = std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& t) {
    return t.from != kNone && lit(t.from) && lit(t.to);
  });
  if (!several && !passes && shown_ != 0) dark_state_ = dark;
}

bool Positions::shows_at_leaving(std::uint32_t from, std::uint32_t to) const {
  const Signature& left = left_[from];
  const Signature& state = signatures_[to];
  const std::uint64_t both = left.mask & state.mask;
  return is_lit(to) && (left.bits & both) == (state.bits & both);  // what leaving does not switch may be on
}

Positions::Result Positions::at(std::uint64_t levels, std::uint32_t preferred) const {
  if (preferred != kNone && is_lit(preferred) && fits(preferred, levels)) return {Shown::state, preferred};
  Result result;
  for (std::uint32_t s = 0; s < signatures_.size(); ++s) {
    if (!is_lit(s) || !fits(s, levels)) continue;
    if (result.state != kNone) return {Shown::unclear, kNone};
    result = {Shown::state, s};
  }
  if (result.state != kNone) return result;
  const bool fits_dark = std::any_of(signatures_.begin(), signatures_.end(), [&](const Signature& signature) {
    return signature.bits == 0 && (levels & signature.mask) == 0;
  });
  if (fits_dark || (levels & shown_) == 0) return {};
  return {std::popcount(levels & shown_) > 1 ? Shown::contradiction : Shown::dark, kNone};
}

}  // namespace symplant::observe

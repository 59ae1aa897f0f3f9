// The fields of each row, in the order of its declaration: the digest and the rows of generated code are made of these
// lists.
//
// fields(row, visit) calls `visit` with each field: a number, a bool, an enumerator, a nested row, or one of the types
// below that say what a number means. UnitRow and SymbolRow, of which the digest leaves out a field or has another
// order, and the rows of types are not here.
#pragma once

#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The index of a row, or kNone.
struct Index {
  std::uint32_t value;
};
/// The index of a track or place, or kOut.
struct Location {
  std::uint32_t value;
};
/// A position on a track, or kWhole.
struct Position {
  std::int64_t value;
};
/// A bit pattern.
struct Bits {
  std::uint64_t value;
};
/// The number that a symbol has on a link.
struct Word {
  std::uint64_t value;
};
/// A state of a unit, kMovingState or kNoState.
struct UnitPosition {
  std::uint8_t value;
};
/// A number of parts, or kAnyNumber.
struct Count {
  std::uint64_t value;
};
/// A last field that is left out if it is 0.
struct Optional {
  Time value;
};
struct OptionalNumber {
  double value;
};
/// A last field that is left out if it is kNone.
struct OptionalIndex {
  std::uint32_t value;
};

template <class Visit>
constexpr void fields(const TransitionNumbers& row, Visit&& visit) {
  for (const TransitionNumber& number : kTransitionNumbers) visit(row.*number.member);
}
template <class Visit>
constexpr void fields(const Transition& row, Visit&& visit) {
  visit(row.from), visit(row.to), visit(row.on), visit(row.once), visit(row.when), visit(row.timed), visit(row.dt);
  visit(row.during), fields(row.numbers, visit);
}
template <class Visit>
constexpr void fields(const EventMasks& row, Visit&& visit) {
  visit(row.on), visit(row.off);
}
template <class Visit>
constexpr void fields(const TransitionTimes& row, Visit&& visit) {
  visit(row.after), visit(row.takes);
}
template <class Visit>
constexpr void fields(const RandomTime& row, Visit&& visit) {
  visit(row.kind), visit(row.a), visit(row.b);
}
template <class Visit>
constexpr void fields(const InitialValue& row, Visit&& visit) {
  visit(row.symbol), visit(Word{row.value});
}
template <class Visit>
constexpr void fields(const SharedAddress& row, Visit&& visit) {
  visit(row.symbol), visit(row.leader);
}
template <class Visit>
constexpr void fields(const DisableRow& row, Visit&& visit) {
  visit(row.by), visit(row.unit), visit(row.state);
}
template <class Visit>
constexpr void fields(const ConditionRow& row, Visit&& visit) {
  visit(Bits{row.truth}), visit(row.reader), visit(row.reader_input), visit(row.reader_kind);
}
template <class Visit>
constexpr void fields(const ConditionedUnit& row, Visit&& visit) {
  visit(row.unit), visit(row.first_condition);
}
template <class Visit>
constexpr void fields(const UnitWatch& row, Visit&& visit) {
  visit(row.unit), visit(row.condition), visit(UnitPosition{row.state}), visit(row.input);
}
template <class Visit>
constexpr void fields(const BitWatch& row, Visit&& visit) {
  visit(row.bit), visit(row.condition), visit(row.input);
}
template <class Visit>
constexpr void fields(const ValueWatch& row, Visit&& visit) {
  visit(Bits{row.operand}), visit(row.slot), visit(row.condition), visit(row.input);
  visit(row.comparison), visit(row.kind);
}
template <class Visit>
constexpr void fields(const RequirementRow& row, Visit&& visit) {
  visit(row.kind), visit(row.condition), visit(row.expected), visit(row.within), visit(Optional{row.earliest});
}
template <class Visit>
constexpr void fields(const FollowRow& row, Visit&& visit) {
  visit(row.symbol), visit(row.condition), visit(OptionalIndex{row.off});
}
template <class Visit>
constexpr void fields(const OverrunRow& row, Visit&& visit) {
  visit(row.unit), visit(row.after);
}
template <class Visit>
constexpr void fields(const BehaviourUnit& row, Visit&& visit) {
  visit(row.unit), visit(row.name), visit(row.first_input), visit(row.input_count);
  visit(row.first_value), visit(row.value_count);
}

template <class Visit>
constexpr void fields(const Rows& row, Visit&& visit) {
  visit(row.first), visit(row.count);
}
template <class Visit>
constexpr void fields(const PartLocation& row, Visit&& visit) {
  visit(Location{row.location}), visit(Position{row.at});
}
template <class Visit>
constexpr void fields(const KindRow& row, Visit&& visit) {
  visit(row.length), visit(row.code), visit(OptionalNumber{row.weight});
}
template <class Visit>
constexpr void fields(const TrackRow& row, Visit&& visit) {
  visit(row.length), visit(row.gap), visit(row.drives), visit(row.stops), visit(row.sensors), visit(row.ends);
}
template <class Visit>
constexpr void fields(const DriveRow& row, Visit&& visit) {
  visit(row.until), visit(Index{row.forward}), visit(Index{row.backward}), visit(Index{row.symbol}), visit(row.speed);
  visit(OptionalIndex{row.output});
}
template <class Visit>
constexpr void fields(const StopRow& row, Visit&& visit) {
  visit(row.at), visit(row.condition);
}
template <class Visit>
constexpr void fields(const SensorRow& row, Visit&& visit) {
  visit(row.symbol), visit(row.location), visit(row.at), visit(row.kinds), visit(row.reads);
}
template <class Visit>
constexpr void fields(const EndRow& row, Visit&& visit) {
  visit(Location{row.to}), visit(Index{row.condition});
}
template <class Visit>
constexpr void fields(const PlaceRow& row, Visit&& visit) {
  visit(row.holds), visit(row.sensors);
}
template <class Visit>
constexpr void fields(const TransferRow& row, Visit&& visit) {
  visit(row.from), visit(row.to), visit(Index{row.condition}), visit(row.once);
}
template <class Visit>
constexpr void fields(const WorkRow& row, Visit&& visit) {
  visit(row.at), visit(row.condition), visit(row.from), visit(row.to);
}
template <class Visit>
constexpr void fields(const SourceRow& row, Visit&& visit) {
  visit(row.to), visit(row.kinds), visit(row.first), visit(row.every), visit(Count{row.count});
  visit(Index{row.condition});
}
template <class Visit>
constexpr void fields(const PartCounterRow& row, Visit&& visit) {
  visit(row.location), visit(Index{row.kind});
}
template <class Visit>
constexpr void fields(const MalfunctionRow& row, Visit&& visit) {
  visit(row.effects), visit(Index{row.condition}), visit(row.during), visit(row.chance), visit(row.lasts);
  visit(row.after), visit(Index{row.next}), visit(Index{row.unless});
}
template <class Visit>
constexpr void fields(const EffectRow& row, Visit&& visit) {
  visit(row.kind), visit(row.of), visit(row.tracks), visit(row.factor), visit(Index{row.subject}), visit(row.every);
  visit(row.shows), visit(row.gain), visit(row.offset), visit(row.drift);
}
template <class Visit>
constexpr void fields(const MalfunctionUnit& row, Visit&& visit) {
  visit(row.unit), visit(UnitPosition{row.state});
}
template <class Visit>
constexpr void fields(const MalfunctionForce& row, Visit&& visit) {
  visit(row.symbol), visit(Bits{row.value}), visit(row.holds);
}
template <class Visit>
constexpr void fields(const MalfunctionSet& row, Visit&& visit) {
  visit(row.value), visit(row.number);
}
template <class Visit>
constexpr void fields(const ValueRow& row, Visit&& visit) {
  visit(row.kind), visit(row.start), visit(row.min), visit(row.max), visit(row.step), visit(row.trace);
  visit(row.output), visit(row.formula), visit(row.formulas), visit(row.factor), visit(row.ti), visit(row.td);
  visit(row.steps), visit(row.unit), visit(row.numbers), visit(row.states), visit(row.outputs), visit(row.direct);
  visit(row.changes);
}
template <class Visit>
constexpr void fields(const ChangeRow& row, Visit&& visit) {
  visit(row.condition), visit(row.formula);
}
template <class Visit>
constexpr void fields(const SignalRow& row, Visit&& visit) {
  visit(row.symbol), visit(row.formula), visit(row.every), visit(row.scaled), visit(row.a), visit(row.b);
  visit(row.c), visit(row.d), visit(row.noise), visit(row.low), visit(row.high);
}
template <class Visit>
constexpr void fields(const FormulaRow& row, Visit&& visit) {
  visit(row.steps), visit(row.inputs);
}
template <class Visit>
constexpr void fields(const FormulaStep& row, Visit&& visit) {
  visit(row.op), visit(row.of), visit(row.number);
}
template <class Visit>
constexpr void fields(const FormulaInput& row, Visit&& visit) {
  visit(row.kind), visit(row.number), visit(row.of);
}
template <class Visit>
constexpr void fields(const Operand& row, Visit&& visit) {
  visit(row.kind), visit(row.type), visit(row.of), visit(row.number);
}
template <class Visit>
constexpr void fields(const ComparisonRow& row, Visit&& visit) {
  visit(row.left), visit(row.right), visit(row.tolerance), visit(row.condition), visit(row.input);
  visit(row.comparison);
}

}  // namespace symplant::tables

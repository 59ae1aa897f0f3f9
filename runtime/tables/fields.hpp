// The fields of each row, in the order of its declaration: the digest, the rows of generated code and files of tables
// are made of these lists.
//
// fields(row, visit) calls `visit` with each field: a number, a bool, an enumerator, a nested row, or one of the types
// below that say what a number means. A row that is not const gives its fields to be changed. UnitRow and SymbolRow, of
// which the digest leaves out a field or has another order, and the rows of types are not here.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// `Row` or `const Row`.
template <class Given, class Row>
concept RowOf = std::same_as<std::remove_const_t<Given>, Row>;

/// The index of a row, or kNone.
template <class Number>
struct Index {
  using Field = Number;
  Number& value;
};
template <class Number>
Index(Number&) -> Index<Number>;
/// The index of a track or place, or kOut.
template <class Number>
struct Location {
  using Field = Number;
  Number& value;
};
template <class Number>
Location(Number&) -> Location<Number>;
/// A position on a track, or kWhole.
template <class Number>
struct Position {
  using Field = Number;
  Number& value;
};
template <class Number>
Position(Number&) -> Position<Number>;
/// A bit pattern.
template <class Number>
struct Bits {
  using Field = Number;
  Number& value;
};
template <class Number>
Bits(Number&) -> Bits<Number>;
/// The number that a symbol has on a link.
template <class Number>
struct Word {
  using Field = Number;
  Number& value;
};
template <class Number>
Word(Number&) -> Word<Number>;
/// A state of a unit, kMovingState or kNoState.
template <class Number>
struct UnitPosition {
  using Field = Number;
  Number& value;
};
template <class Number>
UnitPosition(Number&) -> UnitPosition<Number>;
/// A number of parts, or kAnyNumber.
template <class Number>
struct Count {
  using Field = Number;
  Number& value;
};
template <class Number>
Count(Number&) -> Count<Number>;
/// A last field that is left out if it is 0.
template <class Number>
struct Optional {
  using Field = Number;
  Number& value;
};
template <class Number>
Optional(Number&) -> Optional<Number>;
template <class Number>
struct OptionalNumber {
  using Field = Number;
  Number& value;
};
template <class Number>
OptionalNumber(Number&) -> OptionalNumber<Number>;
/// A last field that is left out if it is kNone.
template <class Number>
struct OptionalIndex {
  using Field = Number;
  Number& value;
};
template <class Number>
OptionalIndex(Number&) -> OptionalIndex<Number>;

/// One of the types above.
template <class Type>
concept Meant = requires {
  typename Type::Field;
};

template <RowOf<TransitionNumbers> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  for (const TransitionNumber& number : kTransitionNumbers) visit(row.*number.member);
}
template <RowOf<Transition> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.from), visit(row.to), visit(row.on), visit(row.once), visit(row.when), visit(row.timed), visit(row.dt);
  visit(row.during), fields(row.numbers, visit);
}
template <RowOf<EventMasks> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.on), visit(row.off);
}
template <RowOf<TransitionTimes> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.after), visit(row.takes);
}
template <RowOf<RandomTime> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.a), visit(row.b);
}
template <RowOf<InitialValue> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(Word{row.value});
}
template <RowOf<SharedAddress> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(row.leader);
}
template <RowOf<DisableRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.by), visit(row.unit), visit(row.state);
}
template <RowOf<ConditionRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(Bits{row.truth}), visit(row.reader), visit(row.reader_input), visit(row.reader_kind);
}
template <RowOf<ConditionedUnit> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.unit), visit(row.first_condition);
}
template <RowOf<UnitWatch> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.unit), visit(row.condition), visit(UnitPosition{row.state}), visit(row.input);
}
template <RowOf<BitWatch> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.bit), visit(row.condition), visit(row.input);
}
template <RowOf<ValueWatch> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(Bits{row.operand}), visit(row.slot), visit(row.condition), visit(row.input);
  visit(row.comparison), visit(row.kind);
}
template <RowOf<RequirementRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.condition), visit(row.expected), visit(row.within), visit(Optional{row.earliest});
}
template <RowOf<FollowRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(row.condition), visit(OptionalIndex{row.off});
}
template <RowOf<OverrunRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.unit), visit(row.after);
}
template <RowOf<BehaviourUnit> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.unit), visit(row.name), visit(row.first_input), visit(row.input_count);
  visit(row.first_value), visit(row.value_count);
}

template <RowOf<Rows> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.first), visit(row.count);
}
template <RowOf<PartLocation> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(Location{row.location}), visit(Position{row.at});
}
template <RowOf<KindRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.length), visit(row.code), visit(OptionalNumber{row.weight});
}
template <RowOf<TrackRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.length), visit(row.gap), visit(row.drives), visit(row.stops), visit(row.sensors), visit(row.ends);
}
template <RowOf<DriveRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.until), visit(Index{row.forward}), visit(Index{row.backward}), visit(Index{row.symbol}), visit(row.speed);
  visit(OptionalIndex{row.output});
}
template <RowOf<StopRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.at), visit(row.condition);
}
template <RowOf<SensorRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(row.location), visit(row.at), visit(row.kinds), visit(row.reads);
}
template <RowOf<EndRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(Location{row.to}), visit(Index{row.condition});
}
template <RowOf<PlaceRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.holds), visit(row.sensors);
}
template <RowOf<TransferRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.from), visit(row.to), visit(Index{row.condition}), visit(row.once);
}
template <RowOf<WorkRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.at), visit(row.condition), visit(row.from), visit(row.to);
}
template <RowOf<SourceRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.to), visit(row.kinds), visit(row.first), visit(row.every), visit(Count{row.count});
  visit(Index{row.condition});
}
template <RowOf<PartCounterRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.location), visit(Index{row.kind});
}
template <RowOf<MalfunctionRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.effects), visit(Index{row.condition}), visit(row.during), visit(row.chance), visit(row.lasts);
  visit(row.after), visit(Index{row.next}), visit(Index{row.unless});
}
template <RowOf<EffectRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.of), visit(row.tracks), visit(row.factor), visit(Index{row.subject}), visit(row.every);
  visit(row.shows), visit(row.gain), visit(row.offset), visit(row.drift);
}
template <RowOf<MalfunctionUnit> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.unit), visit(UnitPosition{row.state});
}
template <RowOf<MalfunctionForce> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(Bits{row.value}), visit(row.holds);
}
template <RowOf<MalfunctionSet> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.value), visit(row.number);
}
template <RowOf<ValueRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.start), visit(row.min), visit(row.max), visit(row.step), visit(row.trace);
  visit(row.output), visit(row.formula), visit(row.formulas), visit(row.factor), visit(row.ti), visit(row.td);
  visit(row.steps), visit(row.unit), visit(row.numbers), visit(row.states), visit(row.outputs), visit(row.direct);
  visit(row.changes);
}
template <RowOf<ChangeRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.condition), visit(row.formula);
}
template <RowOf<SignalRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.symbol), visit(row.formula), visit(row.every), visit(row.scaled), visit(row.a), visit(row.b);
  visit(row.c), visit(row.d), visit(row.noise), visit(row.low), visit(row.high);
}
template <RowOf<FormulaRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.steps), visit(row.inputs);
}
template <RowOf<FormulaStep> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.op), visit(row.of), visit(row.number);
}
template <RowOf<FormulaInput> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.number), visit(row.of);
}
template <RowOf<Operand> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.kind), visit(row.type), visit(row.of), visit(row.number);
}
template <RowOf<ComparisonRow> Row, class Visit>
constexpr void fields(Row& row, Visit&& visit) {
  visit(row.left), visit(row.right), visit(row.tolerance), visit(row.condition), visit(row.input);
  visit(row.comparison);
}

}  // namespace symplant::tables

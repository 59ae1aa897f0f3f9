// One plant in a co-simulation.
#include "symplant/fmi/instance.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "symplant/condition/type_info.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::fmi {
namespace {

using Kind = Variable::Kind;
using tables::NumberKind;

constexpr double kSecond = static_cast<double>(tables::kSecond);
constexpr std::size_t kWordBits = 64;
constexpr double kLongest = 9e9;          ///< s: plant time is 64 bits of ns
constexpr double kLeastTolerance = 1e-6;  ///< s, of the time at which a step begins
constexpr double kUnits = 16;             ///< in the last place of the time
constexpr double kTolerance = 1e-9;       ///< of plant time, since importers add up their steps

std::string text(double number) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.15g", number);
  return digits.data();
}

bool is_bool(const tables::SymbolRow& symbol) noexcept { return symbol.type() == tables::DataType::boolean; }

/// The least and the greatest whole number of a type, as doubles: the upper one is exact up to 53 bits, else one more.
std::pair<double, double> range_of(const condition::TypeInfo& type) noexcept {
  if (type.kind == NumberKind::signed_integer) {
    const double half = std::ldexp(1.0, type.bits - 1);
    return {-half, half - 1};
  }
  return {0, std::ldexp(1.0, type.bits) - 1};
}

/// A number as a slot has it; false if the type does not have it.
bool to_slot(tables::DataType data_type, double number, std::uint64_t& slot) noexcept {
  const condition::TypeInfo& type = condition::info_of(data_type);
  if (type.kind == NumberKind::real) {
    if (type.bits == 32 && std::isfinite(number)) {
      if (std::abs(number) > static_cast<double>(FLT_MAX)) return false;
      number = static_cast<double>(static_cast<float>(number));
    }
    slot = std::bit_cast<std::uint64_t>(number);
    return true;
  }
  const auto [least, greatest] = range_of(type);
  const bool in_range = number >= least && (type.bits == 64 ? number < greatest : number <= greatest);
  if (!in_range || number != std::trunc(number)) return false;
  slot =
      number < 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(number)) : static_cast<std::uint64_t>(number);
  return true;
}

/// The distance from a number to the next greater double.
double unit_in_last_place(double number) noexcept {
  return std::nextafter(std::abs(number), std::numeric_limits<double>::infinity()) - std::abs(number);
}

Fault not_settable(const Variable& variable) {
  return "`" + variable.name + "` cannot be set: it is neither an input nor a parameter";
}

Fault out_of_range(const Variable& variable, const std::string& number, const std::string& of) {
  return number + " is out of range for `" + variable.name + "`" + of;
}

std::size_t settable_count(const Variables& variables) {
  const auto all = variables.all();
  const auto end = std::find_if_not(all.begin(), all.end(), [](const Variable& v) { return is_settable(v.kind); });
  return static_cast<std::size_t>(end - all.begin());
}

}  // namespace

Instance::Instance(const PlantModel& model)
    : model_(model),
      plant_(model.tables, model.behaviours),
      observer_(plant_),
      symbol_of_event_(model.tables.event_bits, tables::kNone),
      set_(settable_count(model.variables)),
      early_(set_.size() / kWordBits + 1),
      leads_(model.tables.symbols.size()) {
  for (const tables::SharedAddress& shared : model.tables.shared_addresses) leads_[shared.leader] = true;
  for (std::uint32_t s = 0; s < model.tables.symbols.size(); ++s) {
    const tables::SymbolRow& symbol = model.tables.symbols[s];
    if (is_bool(symbol) && symbol.direction() == tables::Direction::event) symbol_of_event_[symbol.index] = s;
  }
  reset();
}

void Instance::reset() {
  std::fill(early_.begin(), early_.end(), 0);
  start_ = 0;
  stop_ = std::numeric_limits<double>::infinity();
  begun_ = false;
  std::fill(set_.begin(), set_.end(), 0);
  restart();
  for (std::uint32_t v = 0; v < set_.size(); ++v) set_[v] = initial(at(v));
}

/// The plant at time 0, with the seed that was set.
void Instance::restart() {
  plant_.reset(set_.front());
  plant_.show();
  observer_.violations = 0;
  observer_.shown.restart(plant_);
}

void Instance::begin() {
  restart();
  for (std::uint32_t v = 0; v < set_.size(); ++v) {
    if ((early_[v / kWordBits] >> v % kWordBits & 1) != 0) apply(at(v), set_[v]);
  }
  std::fill(early_.begin(), early_.end(), 0);
  begun_ = true;
}

Fault Instance::begin_at(double start, double stop) {
  if (!std::isfinite(start)) return "the start time " + text(start) + " is not a number of seconds";
  if (!(stop >= start)) return "the stop time " + text(stop) + " is before the start time " + text(start);
  start_ = start;
  stop_ = stop;
  return {};
}

/// What a settable variable shows before it was set.
std::uint64_t Instance::initial(const Variable& variable) const noexcept {
  switch (variable.kind) {
    case Kind::operation:
      return sampled(variable.of);
    case Kind::undriven_event:
      return event(variable.of);
    case Kind::parameter:
      return std::bit_cast<std::uint64_t>(plant_.output(model_.tables.values.rows[variable.of].output));
    default:
      return 0;
  }
}

/// An operation as the plant sampled it last.
std::uint64_t Instance::sampled(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = model_.tables.symbols[symbol];
  return is_bool(row) ? plant_.operation(row.index) : plant_.operation_value(row.index);
}

std::uint64_t Instance::event(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = model_.tables.symbols[symbol];
  return is_bool(row) ? observer_.shown.shows(row.index) : plant_.event_value(row.index);
}

/// A variable's value; of a symbol as in its slot, of another real one the bits of a double.
std::uint64_t Instance::value(std::uint32_t variable) const noexcept {
  const Variable& of = at(variable);
  switch (of.kind) {
    case Kind::seed:
    case Kind::operation:
    case Kind::undriven_event:
    case Kind::malfunction:
    case Kind::parameter:
      return set_[variable];
    case Kind::other_operation:
      return sampled(of.of);
    case Kind::event:
      return event(of.of);
    case Kind::state:
      return std::uint64_t{plant_.unit(of.of).state} + 1;
    case Kind::moving:
      return plant_.unit(of.of).moving;
    case Kind::parts:
      return plant_.parts(of.of);
    case Kind::output:
      return std::bit_cast<std::uint64_t>(plant_.output(of.of));
    case Kind::active:
      return plant_.malfunction(of.of).active;
    case Kind::short_pulses:
      return observer_.shown.short_pulses();
    case Kind::violations:
      return observer_.violations;
  }
  return 0;
}

double Instance::real(std::uint32_t variable) const {
  const Variable& of = at(variable);
  const bool of_symbol = of.kind != Kind::output && of.kind != Kind::parameter;
  const NumberKind kind = of_symbol ? condition::info_of(model_.tables.symbols[of.of].type()).kind : NumberKind::real;
  return tables::number_of(kind, value(variable));
}

/// Counts stay at the largest number.
std::int32_t Instance::integer(std::uint32_t variable) const {
  const auto number = static_cast<std::int64_t>(value(variable));
  return static_cast<std::int32_t>(std::min<std::int64_t>(number, std::numeric_limits<std::int32_t>::max()));
}

Fault Instance::set_real(std::uint32_t variable, double number) {
  const Variable& of = at(variable);
  if (!is_settable(of.kind)) return not_settable(of);
  if (of.kind == Kind::parameter) {
    const tables::ValueRow& row = model_.tables.values.rows[of.of];
    if (!std::isfinite(number) || number < row.min || number > row.max) {
      return out_of_range(of, text(number), ", " + text(row.min) + " to " + text(row.max));
    }
    return set(variable, std::bit_cast<std::uint64_t>(number));
  }
  return set_symbol(variable, number);
}

Fault Instance::set_integer(std::uint32_t variable, std::int32_t number) {
  const Variable& of = at(variable);
  if (!is_settable(of.kind)) return not_settable(of);
  if (of.type == BaseType::boolean) return set(variable, number != 0);
  if (of.kind != Kind::seed) return set_symbol(variable, number);
  if (begun_) return "`seed` is fixed: set it before the end of the initialization";
  if (number < 0) return out_of_range(of, std::to_string(number), ": set a number from 0");
  return set(variable, static_cast<std::uint64_t>(number));
}

/// Sets a numeric symbol.
Fault Instance::set_symbol(std::uint32_t variable, double number) {
  const Variable& of = at(variable);
  const tables::DataType type = model_.tables.symbols[of.of].type();
  std::uint64_t slot = 0;
  if (to_slot(type, number, slot)) return set(variable, slot);
  return out_of_range(of, text(number), ", which is " + std::string(condition::info_of(type).name));
}

Fault Instance::set(std::uint32_t variable, std::uint64_t value) {
  if (at(variable).kind == Kind::malfunction && value == set_[variable]) return {};
  if (Fault fault = apply(at(variable), value); !fault.empty()) return fault;
  set_[variable] = value;
  if (!begun_) early_[variable / kWordBits] |= std::uint64_t{1} << variable % kWordBits;
  return {};
}

Fault Instance::apply(const Variable& variable, std::uint64_t value) {
  switch (variable.kind) {
    case Kind::operation:
      write_operation(variable.of, value);
      return {};
    case Kind::undriven_event:
      plant_.set_input(variable.of, value);
      return {};
    case Kind::parameter:
      plant_.set_value(variable.of, std::bit_cast<double>(value));
      return {};
    case Kind::malfunction:
      if (value == 0) return plant_.stop_malfunction(variable.of), Fault();
      if (plant_.start_malfunction(variable.of)) return {};
      return "`" + variable.name + "` cannot start: " + std::to_string(tables::kMostOrdinaryMalfunctions) +
             " malfunctions of devices and symbols are active, which is the most";
    default:
      return {};
  }
}

/// All operations on its address.
void Instance::write_operation(std::uint32_t symbol, std::uint64_t value) noexcept {
  const auto write = [&](std::uint32_t of) {
    const tables::SymbolRow& row = model_.tables.symbols[of];
    is_bool(row) ? plant_.set_operation(row.index, value != 0) : plant_.set_operation_value(row.index, value);
  };
  write(symbol);
  if (!leads_[symbol]) return;
  for (const tables::SharedAddress& shared : model_.tables.shared_addresses) {
    if (shared.leader == symbol) write(shared.symbol);
  }
}

/// Whether it is `duration` after the last one or the time of the experiment that is exact, depends on the importer:
/// the last end counts unless its error grows beyond that of the time.
tables::Time Instance::end_of_step(double time, double duration) const noexcept {
  const auto by_time = static_cast<tables::Time>(std::llround((time - start_ + duration) * kSecond));
  const auto by_duration = plant_.now() + static_cast<tables::Time>(std::llround(duration * kSecond));
  const double error = std::max(1.0, 2 * unit_in_last_place(time + duration) * kSecond);
  return std::abs(static_cast<double>(by_time - by_duration)) <= error ? by_duration : by_time;
}

Fault Instance::step(double time, double duration) {
  const double end = time - start_ + duration;
  if (!(duration >= 0)) return "a step cannot take " + text(duration) + " s";
  if (!(end < kLongest)) return "the step ends " + text(end) + " s after the start; plant time is at most 9e9 s";
  double tolerance = std::max({kLeastTolerance, kTolerance * (time - start_), kUnits * unit_in_last_place(time)});
  if (duration > 0) tolerance = std::min(tolerance, duration / 2);
  if (!(std::abs(time - this->time()) <= tolerance)) {
    return "the step begins at " + text(time) + " s, but the last one ended at " + text(this->time()) + " s";
  }
  if (time + duration > stop_ + tolerance) {
    return "the step ends at " + text(time + duration) + " s, after the stop time " + text(stop_) + " s";
  }
  observer_.shown.begin(plant_);
  plant_.advance_to(plant_.now(), &observer_);
  if (duration > 0) plant_.advance_to(end_of_step(time, duration), &observer_);
  observer_.shown.end(plant_);
  return {};
}

double Instance::time() const noexcept { return start_ + static_cast<double>(plant_.now()) / kSecond; }

std::vector<std::uint32_t> Instance::held_events() const {
  std::vector<std::uint32_t> symbols = observer_.shown.held(plant_);
  for (std::uint32_t& event : symbols) event = symbol_of_event_[event];
  return symbols;
}

InstanceState Instance::save() const {
  const auto block = plant_.save();
  InstanceState state{{block.begin(), block.end()}, observer_.shown.save()};
  state.numbers.insert(state.numbers.end(), set_.begin(), set_.end());
  state.numbers.insert(state.numbers.end(), early_.begin(), early_.end());
  for (const std::uint64_t number : {std::bit_cast<std::uint64_t>(start_), std::bit_cast<std::uint64_t>(stop_),
                                     std::uint64_t{begun_}, observer_.violations}) {
    state.numbers.push_back(number);
  }
  return state;
}

bool Instance::restore(const InstanceState& state) {
  constexpr std::size_t kLast = 4;
  const std::size_t shown = observer_.shown.save().size();
  const auto& numbers = state.numbers;
  if (numbers.size() != shown + set_.size() + early_.size() + kLast) return false;
  if (!plant_.restore(state.plant)) return false;
  const auto set = numbers.begin() + static_cast<std::ptrdiff_t>(shown);
  const auto early = set + static_cast<std::ptrdiff_t>(set_.size());
  const auto last = early + static_cast<std::ptrdiff_t>(early_.size());
  observer_.shown.restore({numbers.begin(), set}, plant_);
  std::copy(set, early, set_.begin());
  std::copy(early, last, early_.begin());
  start_ = std::bit_cast<double>(last[0]);
  stop_ = std::bit_cast<double>(last[1]);
  begun_ = last[2] != 0;
  observer_.violations = last[3];
  return true;
}

}  // namespace symplant::fmi

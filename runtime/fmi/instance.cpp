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
constexpr double kLongest = 9e9;          ///< s: plant time is 64 bits of ns
constexpr double kLeastTolerance = 1e-6;  ///< s, of the time at which a step begins
constexpr double kTolerance = 1e-9;       ///< of the time, since importers add up their steps

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
      symbol_names_(tables::split_names(model.tables.symbol_names)),
      symbol_of_event_(model.tables.event_bits, tables::kNone),
      set_(settable_count(model.variables)) {
  for (std::uint32_t s = 0; s < model.tables.symbols.size(); ++s) {
    const tables::SymbolRow& symbol = model.tables.symbols[s];
    if (is_bool(symbol) && symbol.direction() == tables::Direction::event) symbol_of_event_[symbol.index] = s;
  }
  reset();
}

void Instance::reset() {
  early_.clear();
  start_ = 0;
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
  for (const std::uint32_t variable : early_) apply(at(variable), set_[variable]);
  early_.clear();
  begun_ = true;
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
    case Kind::parameter:
      return std::bit_cast<std::uint64_t>(plant_.output(model_.tables.values.rows[of.of].output));
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
  if (!is_settable(of.kind)) return "`" + of.name + "` cannot be set: it is neither an input nor a parameter";
  std::uint64_t slot = std::bit_cast<std::uint64_t>(number);
  if (of.kind == Kind::parameter) {
    if (!std::isfinite(number)) return "`" + of.name + "` cannot be " + text(number);
  } else if (const auto type = model_.tables.symbols[of.of].type(); !to_slot(type, number, slot)) {
    return "`" + of.name + "` is " + std::string(condition::info_of(type).name) + ", which does not have the number " +
           text(number);
  }
  return set(variable, slot);
}

Fault Instance::set_integer(std::uint32_t variable, std::int32_t number) {
  const Variable& of = at(variable);
  if (!is_settable(of.kind)) return "`" + of.name + "` cannot be set: it is neither an input nor a parameter";
  auto slot = static_cast<std::uint64_t>(std::int64_t{number});
  if (of.type == BaseType::boolean) {
    slot = number != 0;
  } else if (of.kind == Kind::seed) {
    if (begun_) return "`seed` is fixed: set it before the end of the initialization";
    if (number < 0) return "`seed` cannot be " + std::to_string(number) + ": set a number from 0";
  } else if (const auto type = model_.tables.symbols[of.of].type(); !to_slot(type, number, slot)) {
    return "`" + of.name + "` is " + std::string(condition::info_of(type).name) + ", which does not have the number " +
           std::to_string(number);
  }
  return set(variable, slot);
}

Fault Instance::set(std::uint32_t variable, std::uint64_t value) {
  if (Fault fault = apply(at(variable), value); !fault.empty()) return fault;
  set_[variable] = value;
  if (!begun_) {
    std::erase(early_, variable);
    early_.push_back(variable);
  }
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
  for (const tables::SharedAddress& shared : model_.tables.shared_addresses) {
    if (shared.leader == symbol) write(shared.symbol);
  }
}

Fault Instance::step(double time, double duration) {
  const double end = time - start_ + duration;
  if (!(duration >= 0)) return "a step cannot take " + text(duration) + " s";
  if (!(end < kLongest)) return "the step ends " + text(end) + " s after the start; plant time is at most 9e9 s";
  const double late = time - this->time();
  if (!(std::abs(late) <= std::max(kLeastTolerance, kTolerance * std::abs(time)))) {
    return "the step begins at " + text(time) + " s, but the last one ended at " + text(this->time()) + " s";
  }
  observer_.shown.begin(plant_);
  plant_.advance_to(plant_.now(), &observer_);
  if (duration > 0) plant_.advance_to(static_cast<tables::Time>(std::llround(end * kSecond)), &observer_);
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
  for (const std::uint64_t number : {std::uint64_t{early_.size()}, std::bit_cast<std::uint64_t>(start_),
                                     std::uint64_t{begun_}, observer_.violations}) {
    state.numbers.push_back(number);
  }
  return state;
}

bool Instance::restore(const InstanceState& state) {
  constexpr std::size_t kLast = 4;
  const std::size_t shown = observer_.shown.save().size();
  const auto& numbers = state.numbers;
  if (numbers.size() < shown + set_.size() + kLast) return false;
  const auto last = numbers.end() - kLast;
  if (static_cast<std::uint64_t>(last - numbers.begin()) != shown + set_.size() + last[0]) return false;
  if (!plant_.restore(state.plant)) return false;
  const auto set = numbers.begin() + static_cast<std::ptrdiff_t>(shown);
  const auto early = set + static_cast<std::ptrdiff_t>(set_.size());
  observer_.shown.restore({numbers.begin(), set}, plant_);
  std::copy(set, early, set_.begin());
  early_.assign(early, last);
  start_ = std::bit_cast<double>(last[1]);
  begun_ = last[2] != 0;
  observer_.violations = last[3];
  return true;
}

}  // namespace symplant::fmi

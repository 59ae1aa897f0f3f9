// Signals: numeric events that show formulas (docs/values.md, "Signals").
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "support/reference/malfunctions.hpp"
#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::DataType;
__extension__ using Wide = __int128;

/// How an integer type's numbers are kept.
struct IntegerType {
  bool is_signed = false;
  int bits = 0;  ///< 0: no integer

  Wide least() const { return is_signed ? -(Wide{1} << (bits - 1)) : Wide{0}; }
  Wide most() const { return (Wide{1} << (is_signed ? bits - 1 : bits)) - 1; }
};

IntegerType integer_type(DataType type) {
  switch (type) {
    case DataType::sint:
      return {true, 8};
    case DataType::int_:
      return {true, 16};
    case DataType::dint:
      return {true, 32};
    case DataType::lint:
      return {true, 64};
    case DataType::usint:
    case DataType::byte:
      return {false, 8};
    case DataType::uint:
    case DataType::word:
      return {false, 16};
    case DataType::udint:
    case DataType::dword:
      return {false, 32};
    case DataType::ulint:
    case DataType::lword:
      return {false, 64};
    default:
      return {};
  }
}

double within(double n, double low, double high) {
  if (n < low) n = low;
  if (n > high) n = high;
  return n;
}

std::uint64_t integer_of_signal(IntegerType type, const SignalRules& rules, double n) {
  n = within(n, static_cast<double>(type.least()), static_cast<double>(type.most()));
  n = within(n, rules.low, rules.high);
  // Half to even.
  auto whole = static_cast<Wide>(std::nearbyint(n));
  Wide low = type.least();
  Wide high = type.most();
  if (rules.low > static_cast<double>(low)) low = static_cast<Wide>(std::ceil(rules.low));
  if (rules.high < static_cast<double>(high)) high = static_cast<Wide>(std::floor(rules.high));
  if (whole < low) whole = low;
  if (whole > high) whole = high;
  return static_cast<std::uint64_t>(whole);
}

std::uint64_t real_of_signal(DataType type, const SignalRules& rules, double n) {
  const double most = type == DataType::real ? static_cast<double>(std::numeric_limits<float>::max())
                                             : std::numeric_limits<double>::max();
  n = within(n, -most, most);
  n = within(n, rules.low, rules.high);
  if (type == DataType::real) n = static_cast<double>(static_cast<float>(n));
  return std::bit_cast<std::uint64_t>(n == 0 ? 0.0 : n);
}

/// What a signal writes; empty: it keeps the last number.
std::optional<std::uint64_t> signal_number(const Rules& rules, World& world, std::size_t index, Counters& counters) {
  const SignalRules& its = rules.signals[index];
  double n = evaluate(its.of, {rules, world});
  if (its.scaled) n = its.c + (n - its.a) * (its.d - its.c) / (its.b - its.a);
  if (its.noise != 0) {
    const std::string name(rules.model->symbols[its.symbol].name());
    n = n + its.noise * draw_gauss(world.seed, name, world.signals[index].draws++);
  }
  n = distorted(rules, world, its.symbol, n, counters);
  if (std::isnan(n)) {
    ++counters[Counted::signal_kept];
    return {};
  }
  const DataType type = rules.model->symbols[its.symbol].type;
  const IntegerType integer = integer_type(type);
  return integer.bits == 0 ? real_of_signal(type, its, n) : integer_of_signal(integer, its, n);
}

}  // namespace

double as_double(DataType type, std::uint64_t value) {
  const IntegerType integer = integer_type(type);
  if (integer.bits == 0) return type == DataType::boolean ? static_cast<double>(value) : std::bit_cast<double>(value);
  return integer.is_signed ? static_cast<double>(static_cast<std::int64_t>(value)) : static_cast<double>(value);
}

std::optional<long double> as_integer(DataType type, std::uint64_t value) {
  const IntegerType integer = integer_type(type);
  if (integer.bits == 0) return {};
  return integer.is_signed ? static_cast<long double>(static_cast<std::int64_t>(value))
                           : static_cast<long double>(value);
}

double weight_at(const Rules& rules, const World& world, std::uint32_t location) {
  double sum = 0;
  for (const PartWorld& part : world.material.at(location)) {
    sum = sum + rules.model->description->material.kinds[part.kind].weight;
  }
  return sum;
}

bool writes_signal(const Rules& rules, std::uint32_t symbol) {
  return std::any_of(rules.signals.begin(), rules.signals.end(),
                     [&](const SignalRules& signal) { return signal.symbol == symbol; });
}

void write_signals(const Rules& rules, World& world, Counters& counters) {
  std::vector<std::pair<std::uint32_t, std::uint64_t>> numbers;
  for (std::size_t i = 0; i < rules.signals.size(); ++i) {
    if (!is_due(world, rules.signals[i].every)) continue;
    const auto number = signal_number(rules, world, i, counters);
    if (number) numbers.emplace_back(rules.signals[i].symbol, *number);
  }
  for (const auto& [symbol, number] : numbers) {
    if (world.symbols[symbol].value != number) ++counters[Counted::signal_changed];
    for (const std::uint32_t each : rules.together(symbol)) world.symbols[each].value = number;
  }
}

}  // namespace symplant::reference

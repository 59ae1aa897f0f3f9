// Computes and writes signals, after the values. Compiled without contraction of operations.
#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/value/values.hpp"

namespace symplant::engine {
namespace {

/// The least and the greatest number of a type.
struct Range {
  double low;
  double high;
};

Range range_of(tables::DataType type) noexcept {
  using tables::DataType;
  switch (type) {
    case DataType::boolean:
      return {0, 1};
    case DataType::sint:
      return {-128, 127};
    case DataType::int_:
      return {-32'768, 32'767};
    case DataType::dint:
      return {-2'147'483'648.0, 2'147'483'647.0};
    case DataType::lint:
      return {-9'223'372'036'854'775'808.0, 9'223'372'036'854'775'807.0};
    case DataType::usint:
    case DataType::byte:
      return {0, 255};
    case DataType::uint:
    case DataType::word:
      return {0, 65'535};
    case DataType::udint:
    case DataType::dword:
      return {0, 4'294'967'295.0};
    case DataType::ulint:
    case DataType::lword:
      return {0, 18'446'744'073'709'551'615.0};
    case DataType::real:
      return {-static_cast<double>(FLT_MAX), static_cast<double>(FLT_MAX)};
    case DataType::lreal:
      break;
  }
  return {-DBL_MAX, DBL_MAX};
}

/// A whole number as the 64 bits of a slot; the largest 64-bit numbers are not doubles.
std::uint64_t whole_bits(double number, tables::DataType type) noexcept {
  if (number >= 18'446'744'073'709'551'616.0) return ~std::uint64_t{0};
  if (type == tables::DataType::lint && number >= 9'223'372'036'854'775'808.0) return ~std::uint64_t{0} >> 1;
  if (number < 0) return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  return static_cast<std::uint64_t>(number);
}

}  // namespace

/// All signals are computed, then written.
void Values::compute_signals() noexcept {
  const std::uint32_t begin = index_.value_count;
  for_due(index_.signals, [this, begin](std::uint32_t rank) {
    const std::uint32_t signal = rank - begin;
    const tables::SignalRow& row = tables_->signals[signal];
    double n = evaluate(row.formula);
    if (row.scaled) n = row.c + (n - row.a) * (row.d - row.c) / (row.b - row.a);
    if (row.noise != 0) n += row.noise * normal(names_[rank], signal_draws_[signal]);
    drifts_[signal] = distort(signal, n) ? 1 : 0;
    const tables::SymbolRow& symbol = engine_.tables_.symbols[row.symbol];
    numbers_[signal] = std::isnan(n) ? engine_.event_values_.made[symbol.index] : shown(row, n);
  });
  for_due(index_.signals, [this, begin](std::uint32_t rank) {
    const std::uint32_t signal = rank - begin;
    const tables::SignalRow& row = tables_->signals[signal];
    engine_.make_event_value(engine_.tables_.symbols[row.symbol].index, numbers_[signal]);
    if (row.noise == 0 && index_.timed_signals[signal] == 0 && drifts_[signal] == 0) sleep(rank);
  });
}

/// What malfunctions make of the number of a signal; true if it changes with time.
bool Values::distort(std::uint32_t signal, double& number) const noexcept {
  bool drifts = false;
  engine_.malfunctions_.for_distortions(signal, [&](const tables::EffectRow& effect, tables::Time since) {
    number = number * effect.gain + effect.offset + effect.drift * (static_cast<double>(now() - since) / 1e9);
    drifts = drifts || effect.drift != 0;
  });
  return drifts;
}

/// The bits of a number in the slot of a signal's symbol.
std::uint64_t Values::shown(const tables::SignalRow& row, double number) const noexcept {
  const tables::DataType type = engine_.tables_.symbols[row.symbol].type();
  const Range range = range_of(type);
  const double low = std::max(row.low, range.low);
  const double high = std::min(row.high, range.high);
  number = limited(number, low, high);
  if (type == tables::DataType::lreal) return std::bit_cast<std::uint64_t>(number);
  if (type == tables::DataType::real) {
    return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(number)) + 0.0);  // never -0
  }
  number = limited(std::nearbyint(number), std::ceil(low), std::floor(high));
  return whole_bits(number, type);
}

}  // namespace symplant::engine

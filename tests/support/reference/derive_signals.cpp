// Which symbols signals write.
#include <stdexcept>

#include "support/reference/patterns.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// The entry of a symbol: its name, else the pattern with the most literal characters; kNone without one.
std::uint32_t signal_entry_of(const std::vector<description::GivenSignal>& entries, std::string_view symbol) {
  std::uint32_t best = kNone;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const std::string& name = entries[i].symbol;
    if (!is_pattern(name) && same_name(name, symbol)) return i;
    if (!is_pattern(name) || !fits(std::string(symbol), name)) continue;
    if (best == kNone || literals(name) > literals(entries[best].symbol)) best = i;
  }
  return best;
}

SignalRules signal_of(const Rules& rules, std::uint32_t symbol, const description::GivenSignal& given) {
  const model::Symbol& its = rules.model->symbols[symbol];
  std::string text = given.of;
  if (is_pattern(given.symbol)) {
    const model::SymbolReading& reading = its.reading;
    const std::vector<std::string> levels = {std::string(reading.line()), std::string(reading.process()),
                                             std::string(reading.device()), std::string(reading.device_path())};
    text = replace_braces(text, levels, shares(std::string(its.name()), given.symbol));
  }
  SignalRules signal;
  signal.symbol = symbol;
  signal.of = parse_formula(text);
  signal.every = given.every.value_or(rules.model->description->defaults.step);
  signal.scaled = given.from && given.to;
  if (signal.scaled) {
    signal.a = given.from->at(0);
    signal.b = given.from->at(1);
    signal.c = given.to->at(0);
    signal.d = given.to->at(1);
  }
  signal.noise = given.noise;
  if (given.limit) {
    signal.low = given.limit->at(0);
    signal.high = given.limit->at(1);
  }
  return signal;
}

}  // namespace

void derive_signal_symbols(Rules& rules) {
  const std::vector<description::GivenSignal>& entries = rules.model->description->signals;
  for (std::uint32_t i = 0; i < rules.model->symbols.size(); ++i) {
    if (rules.is_operation(i) || rules.is_bool(i)) continue;
    const std::uint32_t entry = signal_entry_of(entries, rules.model->symbols[i].name());
    if (entry == kNone) continue;
    try {
      rules.signals.push_back(signal_of(rules, i, entries[entry]));
    } catch (const std::runtime_error& error) {
      rules.fault = entries[entry].symbol + ": " + error.what();
    }
  }
}

}  // namespace symplant::reference

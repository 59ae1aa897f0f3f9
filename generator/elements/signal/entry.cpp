// Reads `signals` of a plant.json.
#include "elements/signal/entry.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "elements/signal/modules.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;
using Pair = std::array<double, 2>;

class SignalReader {
 public:
  SignalReader(const std::string& symbol, const Json& entry, ShapeFaults& faults)
      : entry_(entry), here_(Pointer("/signals") / std::string_view(symbol)), faults_(faults) {
    signal_.symbol = symbol;
  }

  GivenSignal read() {
    if (!entry_.is_object()) {
      signal_.of = formula_text(entry_);
      return std::move(signal_);
    }
    signal_.of = formula_member(entry_, "of");
    signal_.from = pair("from");
    signal_.to = pair("to");
    signal_.limit = pair("limit");
    read_module();
    const Json* noise = member(entry_, "noise");
    if (noise != nullptr && noise->is_number()) signal_.noise = noise->get<double>();
    read_every();
    check();
    return std::move(signal_);
  }

 private:
  std::optional<Pair> pair(std::string_view key) const {
    const Json* value = member(entry_, key);
    if (value == nullptr || !value->is_array() || value->size() != 2) return {};
    if (!(*value)[0].is_number() || !(*value)[1].is_number()) return {};
    return Pair{(*value)[0].get<double>(), (*value)[1].get<double>()};
  }

  /// `as` gives `to` and `limit`.
  void read_module() {
    const std::string* name = text_member(entry_, "as");
    if (name == nullptr) return;
    const AnalogModule* module = analog_module(*name);
    if (module == nullptr) {
      faults_.add(here_ / "as", "unknown analog module " + ticked(*name) + "; choose one of " + analog_module_names(),
                  FaultKind::unknown_name);
      signal_.from.reset();  // its other end is not known
      return;
    }
    for (const std::string_view key : {"to", "limit"}) {
      if (member(entry_, key) != nullptr) {
        faults_.add(here_ / key, "`as` gives " + ticked(key) + "; remove one of them", FaultKind::contradiction);
      }
    }
    signal_.to = module->to;
    signal_.limit = module->limit;
  }

  void read_every() {
    signal_.every = time_member(entry_, "every", here_, faults_);
    if (!signal_.every || *signal_.every >= 100 * tables::kMicrosecond) return;
    faults_.add(here_ / "every", "`every` is at least 100 us");
    signal_.every.reset();
  }

  void check() {
    if (signal_.from && !signal_.to) {
      faults_.add(here_ / "from", "`from` needs `to`, the numbers at its ends", FaultKind::contradiction);
    } else if (signal_.to && !signal_.from) {
      faults_.add(here_, "`to` and `as` need `from`, the numbers of the formula at both ends",
                  FaultKind::contradiction);
    } else if (signal_.from && (*signal_.from)[0] == (*signal_.from)[1]) {
      faults_.add(here_ / "from", "both ends of `from` are equal; write two different numbers",
                  FaultKind::contradiction);
    }
    if (signal_.limit && (*signal_.limit)[0] > (*signal_.limit)[1]) {
      faults_.add(here_ / "limit", "the first number of `limit` is above the second one; exchange them",
                  FaultKind::contradiction);
    }
  }

  const Json& entry_;
  const Pointer here_;
  ShapeFaults& faults_;
  GivenSignal signal_;
};

}  // namespace

std::vector<GivenSignal> signal_entries(const Json& object, ShapeFaults& faults) {
  std::vector<GivenSignal> signals;
  if (!object.is_object()) return signals;
  for (const auto& [symbol, entry] : object.items()) signals.push_back(SignalReader(symbol, entry, faults).read());
  return signals;
}

}  // namespace symplant::description

// A plant whose things are explained by name. Names of symbols and devices omit `L_P_`.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/described_plant.hpp"
#include "support/strings.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/why/explainer.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::test {

inline constexpr tables::Time kMs = tables::kMillisecond;

inline std::vector<Row> with_prefix(std::vector<std::string> names) {
  for (std::string& name : names) name.insert(0, "L_P_");
  return bits(names);
}

/// Times are in ms. The plant runs to time 0 at once.
class Asked {
 public:
  explicit Asked(const DescribedPlant& described, std::span<const engine::Behaviour> behaviours = {})
      : described_(described),
        names_(described.rows),
        history_(names_),
        recorder_(described.rows, 1 << 16),
        explainer(names_, behaviours),
        plant(described.rows, behaviours) {
    recorder_.attach(plant);
    to(0);
  }
  Asked& set(const std::string& name, std::uint64_t value = 1) {
    const tables::SymbolRow& row = described_.rows.symbols[symbol(name)];
    if (row.type() == tables::DataType::boolean) {
      plant.set_operation(row.index, value != 0);
    } else {
      plant.set_operation_value(row.index, value);
    }
    return *this;
  }
  Asked& force(const std::string& name, std::uint64_t value) {
    plant.force(symbol(name), value);
    history_.force(symbol(name), true, plant.now());
    return *this;
  }
  Asked& state(const std::string& device, const std::string& state) {
    plant.set_state(described_.unit("L_P_" + device), described_.state("L_P_" + device, state));
    return *this;
  }
  Asked& put(const std::string& location, std::int64_t millimeters, std::uint32_t kind = 0) {
    const std::int64_t at = millimeters < 0 ? tables::kWhole : millimeters * 1000;
    REQUIRE(plant.put({described_.location(location), at}, kind));
    return *this;
  }
  Asked& to(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs, &recorder_);
    recorder_.drain([this](const trace::Record& record) { history_.apply(record); });
    return *this;
  }
  /// Explained things by a name, with `L_P_` if there is no such name without: a line for each sentence.
  std::string why(const std::string& name, bool with_plant = true) const {
    return why(name, why::RecordedView(history_, plant.now(), with_plant ? &plant : nullptr));
  }
  std::string why(const std::string& name, const why::StateView& view) const {
    auto things = why::things_named(name, names_);
    if (things.empty()) things = why::things_named("L_P_" + name, names_);
    std::string text;
    for (const why::Reference& thing : things) {
      for (const std::string& line : why::lines_of(explainer.why(thing, view))) text += line + "\n";
    }
    return text;
  }
  const trace::PlantNames& names() const { return names_; }
  const trace::History& history() const { return history_; }

 private:
  std::uint32_t symbol(const std::string& name) const {
    const auto found = why::things_named(name, names_);
    return described_.symbol(found.empty() ? "L_P_" + name : name);
  }

  const DescribedPlant& described_;
  trace::PlantNames names_;
  trace::History history_;
  trace::Recorder recorder_;

 public:
  why::Explainer explainer;
  plant::OwnedPlant plant;
};

/// The cell of the paper, with a condition.
inline const std::vector<std::string> kCell = {"AGV_I_P1",   "AGV_I_P2",  "AGV_O_P1", "AGV_O_P2",
                                               "MC_I_IDLE1", "MC_I_RUN2", "MC_O_RUN2"};

}  // namespace symplant::test

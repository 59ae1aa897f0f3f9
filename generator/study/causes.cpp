// Which operations move what a signal shows.
#include "study/causes.hpp"

#include <algorithm>
#include <utility>

#include "elements/value/readers.hpp"

namespace symplant::study {
namespace {

using Read = model::Read;

/// The signal flow as a graph: values, then units, then symbols.
class Flow {
 public:
  explicit Flow(const model::PlantModel& plant)
      : plant_(plant),
        units_(static_cast<std::uint32_t>(plant.values.size())),
        symbols_(units_ + static_cast<std::uint32_t>(plant.units.size())),
        reads_(symbols_ + plant.symbols.size()),
        signals_(plant.signals.size()),
        seen_(reads_.size(), model::kNone) {
    for (const Read& read : model::reads_of(plant)) {
      const std::uint32_t node = node_of(read);
      if (node == model::kNone) continue;
      if (read.reader == Read::Reader::signal) signals_[read.by].push_back(node);
      if (read.reader == Read::Reader::value) reads_[read.by].push_back(node);
      if (read.reader == Read::Reader::unit) reads_[units_ + read.by].push_back(node);
      if (read.reader == Read::Reader::follow) reads_[symbols_ + plant.follows[read.by].symbol].push_back(node);
    }
    for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
      for (const std::uint32_t operation : plant.units[u].operations)
        reads_[units_ + u].push_back(symbols_ + operation);
      for (const std::uint32_t event : plant.units[u].events) reads_[symbols_ + event].push_back(units_ + u);
    }
    for (std::uint32_t s = 0; s < signals_.size(); ++s) reads_[symbols_ + plant.signals[s].row.symbol] = signals_[s];
  }

  std::vector<std::uint32_t> operations_of(std::uint32_t signal) {
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> open = signals_[signal];
    while (!open.empty()) {
      const std::uint32_t node = open.back();
      open.pop_back();
      if (std::exchange(seen_[node], signal) == signal) continue;
      open.insert(open.end(), reads_[node].begin(), reads_[node].end());
      if (node >= symbols_ && plant_.symbols[node - symbols_].direction == tables::Direction::operation) {
        found.push_back(node - symbols_);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::uint32_t node_of(const Read& read) const {
    switch (read.what) {
      case Read::What::value:
        return read.of;
      case Read::What::unit:
        return units_ + read.of;
      case Read::What::symbol:
        return symbols_ + read.of;
      case Read::What::location:
      case Read::What::time:
        break;
    }
    return model::kNone;
  }

  const model::PlantModel& plant_;
  std::uint32_t units_;
  std::uint32_t symbols_;
  std::vector<std::vector<std::uint32_t>> reads_;    ///< by node
  std::vector<std::vector<std::uint32_t>> signals_;  ///< by signal
  std::vector<std::uint32_t> seen_;                  ///< by node: the signal whose walk was there last
};

}  // namespace

std::vector<std::vector<std::uint32_t>> operations_of_signals(const model::PlantModel& plant) {
  Flow flow(plant);
  std::vector<std::vector<std::uint32_t>> operations(plant.signals.size());
  for (std::uint32_t s = 0; s < operations.size(); ++s) operations[s] = flow.operations_of(s);
  return operations;
}

}  // namespace symplant::study

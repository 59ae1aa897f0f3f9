// Walks the conditions of the material flow, of inputs that follow and of malfunctions, and the formulas of values.
#include "score/described_operations.hpp"

#include <optional>

namespace symplant::score {
namespace {

using condition::Atom;
using condition::Tree;

class ReadOperations {
 public:
  explicit ReadOperations(const model::PlantModel& plant) : plant_(plant), read_(plant.symbols.size()) {}

  std::vector<bool> run() {
    const model::Material& material = plant_.material;
    for (const model::Track& track : material.tracks) {
      for (const model::Drive& drive : track.drives) {
        add(drive.forward);
        add(drive.backward);
      }
      for (const model::Stop& stop : track.stops) add(stop.condition);
      for (const model::TrackEnd& end : track.ends) add(end.condition);
    }
    for (const model::Transfer& transfer : material.transfers) add(transfer.condition);
    for (const model::Work& work : material.work) add(work.condition);
    for (const model::Source& source : material.sources) add(source.condition);
    for (const model::Follow& follow : plant_.follows) {
      add(follow.condition);
      add(follow.off);
    }
    for (const model::Malfunction& malfunction : plant_.malfunctions) {
      add(malfunction.condition);
      add(malfunction.unless);
    }
    for (const model::Value& value : plant_.values) {
      for (const condition::Formula& formula : value.formulas) add(formula);
      for (const model::Change& change : value.changes) {
        add(change.when);
        add(change.to);
      }
    }
    for (const model::Signal& signal : plant_.signals) add(signal.formula);
    return std::move(read_);
  }

 private:
  void add(const condition::Formula& formula) {
    for (const condition::FormulaInput& input : formula.inputs) {
      if (input.kind == condition::FormulaInput::Kind::atom) add(input.atom);
    }
  }

  void add(const std::optional<Tree>& tree) {
    if (tree) add(*tree);
  }

  void add(const Tree& tree) {
    if (tree.kind == Tree::Kind::atom) add(tree.atom);
    for (const Tree& child : tree.children) add(child);
  }

  void add(const Atom& atom) {
    if (atom.kind == Atom::Kind::bit && plant_.symbols[atom.of].direction == tables::Direction::operation) {
      read_[atom.of] = true;
    }
    if (atom.kind != Atom::Kind::settled) return;
    const model::Unit& unit = plant_.units[atom.of];
    const std::uint32_t operation = unit.states[atom.state].operation;
    if (operation != model::kNone) read_[unit.operations[operation]] = true;
  }

  const model::PlantModel& plant_;
  std::vector<bool> read_;
};

}  // namespace

std::vector<bool> described_operations(const model::PlantModel& plant) { return ReadOperations(plant).run(); }

}  // namespace symplant::score

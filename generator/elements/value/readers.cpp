// What reads what in the signal flow of a plant.
#include "elements/value/readers.hpp"

#include <optional>

namespace symplant::model {
namespace {

using condition::Atom;
using condition::FormulaInput;
using condition::Quantity;
using condition::Tree;
using Reader = Read::Reader;
using What = Read::What;

class Collector {
 public:
  explicit Collector(const PlantModel& plant) : plant_(plant), value_of_(values_of_outputs(plant)) {}

  std::vector<Read> run() {
    for (std::uint32_t v = 0; v < plant_.values.size(); ++v) add(v, plant_.values[v]);
    for (std::uint32_t s = 0; s < plant_.signals.size(); ++s) {
      begin(Reader::signal, s);
      add(plant_.signals[s].formula);
    }
    for (std::uint32_t f = 0; f < plant_.follows.size(); ++f) {
      add(Reader::follow, f, plant_.follows[f].condition);
      add(Reader::follow, f, plant_.follows[f].off);
    }
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      begin(Reader::unit, u);
      for (const Tree& tree : plant_.units[u].conditions) add(tree);
      for (const Transition& transition : plant_.units[u].transitions) {
        for (const description::Duration* time : {&transition.after, &transition.takes}) {
          if (time->formula) add(plant_.time_formulas[static_cast<std::size_t>(time->a)]);
        }
      }
    }
    add_material();
    for (std::uint32_t r = 0; r < plant_.requirements.size(); ++r) {
      add(Reader::requirement, r, plant_.requirements[r].condition);
      add(plant_.requirements[r].expected);
    }
    for (std::uint32_t m = 0; m < plant_.malfunctions.size(); ++m) {
      add(Reader::malfunction, m, plant_.malfunctions[m].condition);
      add(Reader::malfunction, m, plant_.malfunctions[m].unless);
    }
    return std::move(reads_);
  }

 private:
  void begin(Reader reader, std::uint32_t by) {
    reader_ = reader;
    by_ = by;
  }

  void note(What what, std::uint32_t of, bool in_condition, std::string_view part = {}) {
    reads_.push_back({reader_, by_, what, of, part, in_condition});
  }

  void add(std::uint32_t index, const Value& value) {
    begin(Reader::value, index);
    if (value.row.kind == tables::ValueKind::position) {
      note(What::unit, value.row.unit, false);
    } else {
      for (const condition::Formula& formula : value.formulas) add(formula);
    }
    for (const Change& change : value.changes) {
      add(change.when);
      add(change.to);
    }
  }

  void add_material() {
    const Material& material = plant_.material;
    for (std::uint32_t t = 0; t < material.tracks.size(); ++t) {
      const Track& track = material.tracks[t];
      begin(Reader::track, t);
      for (const Drive& drive : track.drives) {
        if (drive.output != kNone) note(What::value, value_of_[drive.output], false);
        add(Reader::track, t, drive.forward);
        add(Reader::track, t, drive.backward);
      }
      for (const Stop& stop : track.stops) add(stop.condition);
      for (const TrackEnd& end : track.ends) add(Reader::track, t, end.condition);
    }
    for (std::uint32_t t = 0; t < material.transfers.size(); ++t) {
      add(Reader::transfer, t, material.transfers[t].condition);
    }
    for (std::uint32_t w = 0; w < material.work.size(); ++w) add(Reader::work, w, material.work[w].condition);
    for (std::uint32_t s = 0; s < material.sources.size(); ++s) add(Reader::source, s, material.sources[s].condition);
  }

  void add(Reader reader, std::uint32_t by, const Tree& tree) {
    begin(reader, by);
    add(tree);
  }
  void add(Reader reader, std::uint32_t by, const std::optional<Tree>& tree) {
    if (tree) add(reader, by, *tree);
  }

  void add(const Tree& tree) {
    if (tree.kind == Tree::Kind::atom) add(tree.atom, true);
    for (const Tree& child : tree.children) add(child);
  }

  void add(const Atom& atom, bool in_condition) {
    switch (atom.kind) {
      case Atom::Kind::settled:
        return note(What::unit, atom.of, in_condition, plant_.units[atom.of].states[atom.state].name);
      case Atom::Kind::moving:
        return note(What::unit, atom.of, in_condition, "moving");
      case Atom::Kind::bit:
      case Atom::Kind::number:
        return note(What::symbol, atom.of, in_condition);
      case Atom::Kind::parts:
        return note(What::location, atom.of, in_condition, kind_name(atom.part));
      case Atom::Kind::compare:
        add(atom.left);
        add(atom.right);
    }
  }

  void add(const Quantity& quantity) {
    switch (quantity.kind) {
      case Quantity::Kind::number:
        return;
      case Quantity::Kind::output:
        return note(What::value, value_of_[quantity.of], true);
      case Quantity::Kind::symbol:
        return note(What::symbol, quantity.of, true);
      case Quantity::Kind::parts:
        return note(What::location, quantity.of, true, "parts");
      case Quantity::Kind::weight:
        return note(What::location, quantity.of, true, "weight");
    }
  }

  void add(const condition::Formula& formula) {
    for (const FormulaInput& input : formula.inputs) {
      switch (input.kind) {
        case FormulaInput::Kind::output:
          note(What::value, value_of_[input.of], false);
          break;
        case FormulaInput::Kind::atom:
          add(input.atom, false);
          break;
        case FormulaInput::Kind::number:
          note(What::symbol, input.of, false);
          break;
        case FormulaInput::Kind::parts:
          note(What::location, input.of, false, kind_name(input.part));
          break;
        case FormulaInput::Kind::weight:
          note(What::location, input.of, false, "weight");
          break;
        case FormulaInput::Kind::time:
          note(What::time, 0, false);
      }
    }
  }

  std::string_view kind_name(std::uint32_t kind) const {
    return kind == kNone ? std::string_view("parts") : std::string_view(plant_.material.kinds[kind].name);
  }

  const PlantModel& plant_;
  const std::vector<std::uint32_t> value_of_;  ///< of each output
  std::vector<Read> reads_;
  Reader reader_{};
  std::uint32_t by_ = 0;
};

}  // namespace

std::vector<std::uint32_t> values_of_outputs(const PlantModel& plant) {
  std::vector<std::uint32_t> values;
  for (std::uint32_t v = 0; v < plant.values.size(); ++v) {
    values.resize(values.size() + plant.values[v].row.outputs, v);
  }
  return values;
}

std::vector<Read> reads_of(const PlantModel& plant) { return Collector(plant).run(); }

}  // namespace symplant::model

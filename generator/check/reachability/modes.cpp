// The combinations in which the atoms about one unit, bit or number can be true together.
#include "check/reachability/modes.hpp"

#include <algorithm>
#include <bit>

namespace symplant::check {
namespace {

using condition::Atom;

Modes unit_modes(const Thing& thing, const model::PlantModel& plant, const Possible& possible) {
  const std::size_t states = plant.units[thing.location].states.size();
  std::vector<bool> named(states);
  bool moving_named = false;
  Modes modes;
  modes.reserve(thing.atoms.size() + 1);
  for (std::size_t i = 0; i < thing.atoms.size(); ++i) {
    const Atom& atom = thing.atoms[i];
    const bool moving = atom.kind == Atom::Kind::moving;
    if (moving) {
      moving_named = true;
    } else {
      named[atom.state] = true;
    }
    if (moving ? !possible.moving(thing.location) : !possible.settled(thing.location, atom.state)) continue;
    modes.emplace_back(thing.atoms.size())[i] = true;
  }
  bool other = !moving_named && possible.moving(thing.location);
  for (std::uint32_t s = 0; s < states && !other; ++s) other = !named[s] && possible.settled(thing.location, s);
  if (other || modes.empty()) modes.emplace_back(thing.atoms.size());
  return modes;
}

bool less(const Atom& a, const Atom& b) {
  switch (a.number) {
    case tables::NumberKind::signed_integer:
      return static_cast<std::int64_t>(a.operand) < static_cast<std::int64_t>(b.operand);
    case tables::NumberKind::unsigned_integer:
      return a.operand < b.operand;
    case tables::NumberKind::real:
      break;
  }
  return std::bit_cast<double>(a.operand) < std::bit_cast<double>(b.operand);
}

bool meets(tables::Comparison comparison, std::size_t value, std::size_t operand) {
  switch (comparison) {
    case tables::Comparison::less:
      return value < operand;
    case tables::Comparison::less_equal:
      return value <= operand;
    case tables::Comparison::equal:
      return value == operand;
    case tables::Comparison::greater_equal:
      return value >= operand;
    case tables::Comparison::greater:
      break;
  }
  return value > operand;
}

/// The numbers that are compared with divide the line: index 2i + 1 is the i-th of them, the even indexes are between
/// them.
Modes number_modes(const Thing& thing) {
  std::vector<Atom> cuts = thing.atoms;
  std::sort(cuts.begin(), cuts.end(), less);
  const auto same = [](const Atom& a, const Atom& b) { return !less(a, b) && !less(b, a); };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  std::vector<std::size_t> operands;
  operands.reserve(thing.atoms.size());
  for (const Atom& atom : thing.atoms) {
    operands.push_back(
        static_cast<std::size_t>(std::lower_bound(cuts.begin(), cuts.end(), atom, less) - cuts.begin()) * 2 + 1);
  }
  const bool real = thing.atoms.front().number == tables::NumberKind::real;
  Modes modes;
  for (std::size_t value = 0; value <= cuts.size() * 2; ++value) {
    const bool between = value % 2 == 0 && value > 0 && value < cuts.size() * 2;
    // No integer lies between one and the next; as unsigned numbers the difference is right for signed ones, too.
    if (between && !real && cuts[value / 2].operand - cuts[value / 2 - 1].operand == 1) continue;
    std::vector<bool>& mode = modes.emplace_back();
    for (std::size_t i = 0; i < operands.size(); ++i) {
      mode.push_back(meets(thing.atoms[i].comparison, value, operands[i]));
    }
  }
  if (real) modes.emplace_back(thing.atoms.size());  // no number
  return modes;
}

/// `moving` is about a unit as `settled` is.
Atom::Kind kind_of(const Atom& atom) { return atom.kind == Atom::Kind::moving ? Atom::Kind::settled : atom.kind; }

}  // namespace

Thing Thing::of(const Atom& atom) { return {kind_of(atom), atom.of, atom.part, {}, {}}; }

bool Thing::has(const Atom& atom) const { return kind == kind_of(atom) && location == atom.of && part == atom.part; }

Modes modes_of(const Thing& thing, const model::PlantModel& plant, const Possible& possible) {
  if (thing.kind == Atom::Kind::bit) return {{false}, {true}};
  const bool number = thing.kind == Atom::Kind::number || thing.kind == Atom::Kind::parts;
  return number ? number_modes(thing) : unit_modes(thing, plant, possible);
}

}  // namespace symplant::check

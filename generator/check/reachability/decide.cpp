// Whether a condition can hold: parts without anything in common are examined one by one, others in all combinations.
#include "check/reachability/decide.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "check/reachability/modes.hpp"

namespace symplant::check {
namespace {

using condition::Atom;
using condition::Tree;

/// A tree whose atoms are indexes of things.
struct Node {
  Tree::Kind kind = Tree::Kind::constant;
  bool value = false;
  std::uint32_t thing = 0;
  std::uint32_t atom = 0;
  std::vector<Node> children;
  std::vector<std::uint32_t> things;  ///< all that it tests, ascending
};

Answer either(Answer a, Answer b) {
  if (a == Answer::yes || b == Answer::yes) return Answer::yes;
  return a == Answer::no && b == Answer::no ? Answer::no : Answer::unknown;
}

Answer both(Answer a, Answer b) {
  if (a == Answer::no || b == Answer::no) return Answer::no;
  return a == Answer::yes && b == Answer::yes ? Answer::yes : Answer::unknown;
}

class Decision {
 public:
  Decision(const Tree& tree, const model::PlantModel& plant, const Possible& possible) {
    root_ = node_of(tree);
    for (Thing& thing : things_) thing.modes = modes_of(thing, plant, possible);
    mode_.resize(things_.size());
  }

  Verdict verdict() { return verdict_of(root_); }

 private:
  Node node_of(const Tree& tree) {
    Node node;
    node.kind = tree.kind;
    node.value = tree.value;
    if (tree.kind == Tree::Kind::atom) {
      std::size_t t = 0;
      while (t < things_.size() && !things_[t].has(tree.atom)) ++t;
      if (t == things_.size()) things_.push_back(Thing::of(tree.atom));
      std::vector<Atom>& atoms = things_[t].atoms;
      const auto found = std::find(atoms.begin(), atoms.end(), tree.atom);
      node.thing = static_cast<std::uint32_t>(t);
      node.atom = static_cast<std::uint32_t>(found - atoms.begin());
      if (found == atoms.end()) atoms.push_back(tree.atom);
      node.things = {node.thing};
      return node;
    }
    node.children.reserve(tree.children.size());
    for (const Tree& child : tree.children) {
      node.children.push_back(node_of(child));
      const auto& more = node.children.back().things;
      node.things.insert(node.things.end(), more.begin(), more.end());
    }
    std::sort(node.things.begin(), node.things.end());
    node.things.erase(std::unique(node.things.begin(), node.things.end()), node.things.end());
    return node;
  }

  Verdict verdict_of(const Node& node) {
    switch (node.kind) {
      case Tree::Kind::constant:
        return node.value ? Verdict{Answer::yes, Answer::no} : Verdict{Answer::no, Answer::yes};
      case Tree::Kind::atom:
        return tried({&node}, true, node.things);
      case Tree::Kind::negation: {
        const Verdict inner = verdict_of(node.children.front());
        return {inner.fails, inner.holds};
      }
      case Tree::Kind::all:
      case Tree::Kind::any:
        break;
    }
    if (node.things.size() == 1 && worlds_of(node.things) <= kMostWorlds) return tried({&node}, true, node.things);
    const bool all = node.kind == Tree::Kind::all;
    Verdict whole = all ? Verdict{Answer::yes, Answer::no} : Verdict{Answer::no, Answer::yes};
    for (const auto& group : groups_of(node)) {
      const Verdict part = group.size() == 1 ? verdict_of(*group.front()) : together(group, all);
      whole = all ? Verdict{both(whole.holds, part.holds), either(whole.fails, part.fails)}
                  : Verdict{either(whole.holds, part.holds), both(whole.fails, part.fails)};
    }
    return whole;
  }

  /// Children that look at a thing in common, in one group; groups have nothing in common.
  std::vector<std::vector<const Node*>> groups_of(const Node& node) const {
    if (node.things.size() == 1) {
      std::vector<const Node*> all;
      for (const Node& child : node.children) all.push_back(&child);
      return {std::move(all)};
    }
    std::vector<std::size_t> leader(node.children.size());
    std::iota(leader.begin(), leader.end(), std::size_t{0});
    const auto find = [&](std::size_t child) {
      while (leader[child] != child) child = leader[child] = leader[leader[child]];
      return child;
    };
    std::vector<std::pair<std::uint32_t, std::size_t>> by_thing;
    for (std::size_t c = 0; c < node.children.size(); ++c) {
      for (const std::uint32_t thing : node.children[c].things) by_thing.emplace_back(thing, c);
    }
    std::sort(by_thing.begin(), by_thing.end());
    for (std::size_t i = 1; i < by_thing.size(); ++i) {
      if (by_thing[i].first == by_thing[i - 1].first) leader[find(by_thing[i].second)] = find(by_thing[i - 1].second);
    }
    std::vector<std::vector<const Node*>> groups(node.children.size());
    for (std::size_t c = 0; c < node.children.size(); ++c) groups[find(c)].push_back(&node.children[c]);
    std::erase_if(groups, [](const auto& group) { return group.empty(); });
    return groups;
  }

  /// Of children with things in common, joined by `and` (else `or`).
  Verdict together(const std::vector<const Node*>& group, bool all) {
    std::vector<std::uint32_t> things;
    for (const Node* child : group) things.insert(things.end(), child->things.begin(), child->things.end());
    std::sort(things.begin(), things.end());
    things.erase(std::unique(things.begin(), things.end()), things.end());
    if (worlds_of(things) <= kMostWorlds) return tried(group, all, things);
    return by_one_thing(group, all, things);
  }

  /// Too many things in common: just what children that look at one thing alone say together, and each child by itself.
  Verdict by_one_thing(const std::vector<const Node*>& group, bool all, const std::vector<std::uint32_t>& things) {
    Verdict result;
    const auto take = [&](const Verdict& part) {
      if (all && part.never()) result.holds = Answer::no, result.fails = Answer::yes;
      if (!all && part.always()) result.holds = Answer::yes, result.fails = Answer::no;
    };
    for (const Node* child : group) take(verdict_of(*child));
    for (const std::uint32_t thing : things) {
      std::vector<const Node*> alone;
      for (const Node* child : group) {
        if (child->things.size() == 1 && child->things.front() == thing) alone.push_back(child);
      }
      if (alone.size() > 1 && things_[thing].modes.size() <= kMostWorlds) take(tried(alone, all, {thing}));
    }
    return result;
  }

  std::size_t worlds_of(const std::vector<std::uint32_t>& things) const {
    std::size_t worlds = 1;
    for (const std::uint32_t thing : things) {
      worlds *= things_[thing].modes.size();
      if (worlds > kMostWorlds) return worlds;
    }
    return worlds;
  }

  /// In every combination of modes of the things, until both truths were seen.
  Verdict tried(const std::vector<const Node*>& group, bool all, const std::vector<std::uint32_t>& things) {
    Verdict result{Answer::no, Answer::no};
    for (const std::uint32_t thing : things) mode_[thing] = 0;
    for (;;) {
      const auto is_true = [&](const Node* child) { return truth(*child); };
      const bool held =
          all ? std::all_of(group.begin(), group.end(), is_true) : std::any_of(group.begin(), group.end(), is_true);
      (held ? result.holds : result.fails) = Answer::yes;
      if (result.holds == Answer::yes && result.fails == Answer::yes) return result;
      std::size_t t = 0;
      while (t < things.size() && ++mode_[things[t]] == things_[things[t]].modes.size()) mode_[things[t++]] = 0;
      if (t == things.size()) return result;
    }
  }

  bool truth(const Node& node) const {
    const auto is_true = [&](const Node& child) { return truth(child); };
    switch (node.kind) {
      case Tree::Kind::constant:
        return node.value;
      case Tree::Kind::atom:
        return things_[node.thing].modes[mode_[node.thing]][node.atom];
      case Tree::Kind::negation:
        return !truth(node.children.front());
      case Tree::Kind::all:
        return std::all_of(node.children.begin(), node.children.end(), is_true);
      case Tree::Kind::any:
        break;
    }
    return std::any_of(node.children.begin(), node.children.end(), is_true);
  }

  std::vector<Thing> things_;
  Node root_;
  std::vector<std::size_t> mode_;  // of each thing
};

constexpr std::size_t kFewAtoms = 8;

/// So many, or one more than kMostAtoms.
std::size_t atoms_of(const Tree& tree, std::size_t before = 0) {
  std::size_t count = before + (tree.kind == Tree::Kind::atom ? 1 : 0);
  for (const Tree& child : tree.children) {
    if (count <= kMostAtoms) count = atoms_of(child, count);
  }
  return count;
}

/// The atoms of a tree; false where there are more than a few, or constants among them.
bool few_atoms(const Tree& tree, std::array<const Atom*, kFewAtoms>& atoms, std::size_t& count) {
  if (tree.kind == Tree::Kind::constant || (tree.kind == Tree::Kind::atom && count == kFewAtoms)) return false;
  if (tree.kind == Tree::Kind::atom) atoms[count++] = &tree.atom;
  return std::all_of(tree.children.begin(), tree.children.end(),
                     [&](const Tree& child) { return few_atoms(child, atoms, count); });
}

bool may_be_either(const Atom& atom, const model::PlantModel& plant, const Possible& possible) {
  if (atom.kind == Atom::Kind::bit || atom.kind == Atom::Kind::number || atom.kind == Atom::Kind::parts) return true;
  const bool moving = possible.moving(atom.of);
  if (atom.kind == Atom::Kind::moving ? !moving : !possible.settled(atom.of, atom.state)) return false;
  if (atom.kind == Atom::Kind::settled && moving) return true;
  const auto states = static_cast<std::uint32_t>(plant.units[atom.of].states.size());
  for (std::uint32_t s = 0; s < states; ++s) {
    const bool itself = atom.kind == Atom::Kind::settled && s == atom.state;
    if (!itself && possible.settled(atom.of, s)) return true;
  }
  return false;
}

/// The most common kind of condition, examined without a store: a few atoms of different things, each of which may be
/// true and false. Such a condition may be both, too.
bool is_plainly_open(const Tree& tree, const model::PlantModel& plant, const Possible& possible) {
  std::array<const Atom*, kFewAtoms> atoms{};
  std::size_t count = 0;
  if (!few_atoms(tree, atoms, count)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Thing thing = Thing::of(*atoms[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (thing.has(*atoms[k])) return false;
    }
    if (!may_be_either(*atoms[i], plant, possible)) return false;
  }
  return true;
}

}  // namespace

Verdict decide(const condition::Tree& tree, const model::PlantModel& plant, const Possible& possible) {
  if (is_plainly_open(tree, plant, possible)) return {Answer::yes, Answer::yes};
  if (atoms_of(tree) > kMostAtoms) return {};
  return Decision(tree, plant, possible).verdict();
}

}  // namespace symplant::check

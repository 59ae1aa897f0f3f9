// Levels and circles of an explanation, and causes by condition.
#include "symplant/why/walk.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace symplant::why {

Explanation Walk::thing(const Reference& thing) {
  if (path_.empty()) is_asked_ = true;
  switch (thing.kind) {
    case Reference::Kind::unit:
      return unit(thing.index);
    case Reference::Kind::symbol:
      return symbol(thing.index);
    case Reference::Kind::requirement:
      return requirement(thing.index);
    case Reference::Kind::location:
      return location(thing.index);
    case Reference::Kind::transfer:
      return transfer(thing.index);
    case Reference::Kind::work:
      return work(thing.index);
    case Reference::Kind::source:
      return source(thing.index);
    case Reference::Kind::part:
      break;
  }
  return {};
}

/// Whether a thing is explained elsewhere, which the sentence then says.
bool Walk::is_mentioned(const Reference& thing, Explanation& result) const {
  const auto begin = std::find(path_.begin(), path_.end(), thing);
  if (begin == path_.end()) {
    if (!done_.contains(thing)) return false;
    result.sentence += ", see above";
    return true;
  }
  const auto name = [this](const Reference& other) {
    return (other.kind == Reference::Kind::part ? "part " : "") + name_of(other, names_);
  };
  result.sentence += fmt::format("; a circle: {} waits for ", name(thing));
  for (auto next = begin + 1; next != path_.end(); ++next) {
    result.sentence += fmt::format("{}, which waits for ", name(*next));
  }
  result.sentence += path_.end() - begin == 1 ? "itself" : name(thing);
  return true;
}

void Walk::append(std::vector<Explanation>& list, std::vector<Explanation> more) {
  for (Explanation& explanation : more) list.push_back(std::move(explanation));
}

/// A single cause: one sentence with what it causes.
void Walk::absorb(Explanation& result, Explanation cause) {
  result.sentence.append(": ").append(cause.sentence);
  result.about.insert(result.about.end(), cause.about.begin(), cause.about.end());
  append(result.because, std::move(cause.because));
}

/// Why an atom is true or false.
Explanation Walk::atom(const condition::Atom& atom) {
  switch (atom.kind) {
    case condition::Atom::Kind::settled: {
      States goals;
      if (!holds(atom, view_)) goals.set(atom.state);
      return unit(atom.of, goals);
    }
    case condition::Atom::Kind::moving:
      return unit(atom.of);
    case condition::Atom::Kind::bit:
    case condition::Atom::Kind::number:
      return symbol(atom.of);
    case condition::Atom::Kind::parts:
      break;
  }
  return location(atom.of);
}

std::vector<Explanation> Walk::causes_of(const condition::Tree& changes) {
  return causes(atoms_of(changes), [this](const condition::Atom& each) { return atom(each); });
}

bool Walk::add_need(Explanation& result, std::string_view before, const Network& network) {
  if (holds(network, view_)) return false;
  const condition::Tree changes = changes_of(network, view_);
  result.sentence += before;
  if (changes.kind == condition::Tree::Kind::constant) {
    result.sentence += " can never hold";
    return true;
  }
  result.sentence += " needs " + condition_text(changes, names_);
  append(result.because, causes_of(changes));
  return true;
}

}  // namespace symplant::why

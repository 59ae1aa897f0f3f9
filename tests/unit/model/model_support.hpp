// Shared parts of the tests of the model: units as short texts.
#pragma once

#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {

inline const model::Unit* find_unit(const model::PlantModel& plant, std::string_view path) {
  for (const model::Unit& unit : plant.units) {
    if (unit.path == path) return &unit;
  }
  return nullptr;
}

inline const model::Unit& unit_of(const Analysed& analysed, std::string_view path = "L_P_D") {
  const model::Unit* unit = find_unit(analysed.model(), path);
  INFO("unit " << path);
  REQUIRE(unit != nullptr);
  return *unit;
}

/// What the derivation noticed about the only unit.
inline const model::UnitEvidence& unit_evidence(const Analysed& analysed) { return analysed.evidence().units.at(0); }

inline const model::Symbol& symbol_of(const Analysed& analysed, std::string_view name) {
  for (const model::Symbol& symbol : analysed.model().symbols) {
    if (symbol.name() == name) return symbol;
  }
  FAIL("no symbol " << name);
  return analysed.model().symbols.front();
}

inline bool has_symbol(const Analysed& analysed, std::string_view name) {
  for (const model::Symbol& symbol : analysed.model().symbols) {
    if (symbol.name() == name) return true;
  }
  return false;
}

inline std::size_t internal(const Analysed& analysed, model::InternalReason reason) {
  return analysed.model().internal[static_cast<std::size_t>(reason)];
}

/// S: "IDLE1 RUN2".
inline std::string states_text(const model::Unit& unit) {
  std::string text;
  for (const model::State& state : unit.states) text += (text.empty() ? "" : " ") + state.name;
  return text;
}

/// All transitions in their order: "P1-O_P2>P2 P2>P1", the automatic ones without an operation.
inline std::string transitions_text(const Analysed& analysed, const model::Unit& unit) {
  std::string text;
  for (const model::Transition& t : unit.transitions) {
    if (!text.empty()) text += " ";
    text += unit.states[t.from].name;
    if (t.on != model::kNone) {
      text += "-O_" + std::string(analysed.model().symbols[unit.operations[t.on]].reading.task());
    }
    text += ">" + unit.states[t.to].name;
  }
  return text;
}

inline std::string initial_text(const model::Unit& unit) { return unit.states[unit.initial].name; }

inline bool springs(const model::Unit& unit) { return unit.actuation == tables::Actuation::spring; }

inline std::string rest_text(const model::Unit& unit) {
  return unit.rest == model::kNone ? "none" : unit.states[unit.rest].name;
}

/// The one finding of a rule.
inline const diag::Diagnostic& finding_of(const Analysed& analysed, std::string_view slug) {
  INFO("fired: " << analysed.fired());
  REQUIRE(analysed.count(slug) == 1);
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    if (finding.rule->slug == slug) return finding;
  }
  throw 0;
}

/// The underlined text.
inline std::string index_text(const diag::Diagnostic& finding) {
  const text::Span span = finding.location.span;
  return std::string(finding.location.source->text().substr(span.begin, span.end - span.begin));
}

}  // namespace symplant::test

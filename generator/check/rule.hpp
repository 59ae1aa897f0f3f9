// A rule, and what its function uses to look at a plant and to report.
#pragma once

#include <fmt/core.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "description/faults.hpp"
#include "diag/diagnostic.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

using diag::Rank;
using Kind = diag::Subject::Kind;
using model::kNone;
using model::PlantModel;
using model::State;
using model::Symbol;
using model::Transition;
using model::Unit;
using tables::Direction;
struct Find;

/// The plants that a rule applies to. `named`: plants with a list whose names follow the naming rule. `levels`: of
/// these, plants whose names have levels that begin with line, process and device, and whose devices are one unit each.
enum class For : std::uint8_t { all, named, levels };

struct Rule : diag::RuleInfo {
  using OfPlant = void (*)(const Find& find);
  using OfSymbol = void (*)(const Find& find, const Symbol& symbol);
  using OfUnit = void (*)(const Find& find, const Unit& unit);
  /// Adds a finding for each root cause. Called once, or for each symbol or unit. Null if other code reports the
  /// findings of the rule.
  using Check = std::variant<std::nullptr_t, OfPlant, OfSymbol, OfUnit>;

  constexpr Rule(std::string_view new_id, std::string_view name, diag::Severity level, Check function,
                 std::string_view line, std::string_view meaning, std::string_view loss = {},
                 std::string_view remedy = {}, Rank cause = Rank::last, For lists = For::all,
                 diag::Effect on_plant = diag::Effect::no_plant)
      : RuleInfo{new_id, name, level, line, meaning, cause, loss, remedy, on_plant}, check(function), plants(lists) {}

  Check check;
  For plants;
};

inline constexpr auto kNote = diag::Severity::note;
inline constexpr auto kWarning = diag::Severity::warning;
inline constexpr auto kError = diag::Severity::error;

/// A finding that is being written. say() adds it.
struct Finding {
  /// Adds another location that belongs to the finding.
  Finding& see(diag::Location location, std::string text);
  Finding& see(const read::ListRow& row, std::string_view cell, std::string text);
  Finding& see(const Symbol& symbol, std::string text) { return see(*symbol.row, symbol.name(), std::move(text)); }
  // Adds a subject that the finding is about, that it explains, or that explains it.
  Finding& also(Kind kind, std::string_view name);
  Finding& explains(Kind kind, std::string_view name);
  Finding& follows(Kind kind, std::string_view name);
  /// The finding explains why the device of this path lacks a symbol of this name.
  Finding& lacks(std::string_view name, std::string_view path);
  /// Proposes another name for a symbol; `safe` if the list itself proves it.
  Finding& rename(const Symbol& symbol, std::string to, bool safe = false);

  template <class... Args>
  void say(fmt::format_string<Args...> text, Args&&... args) {
    as.message = fmt::format(text, std::forward<Args>(args)...);
    diagnostics.add(std::move(as));
  }

  const PlantModel& plant;
  diag::Diagnostics& diagnostics;
  diag::Diagnostic as;
};

/// What a rule looks at: the plant, and what several rules need to know of it, made once. at() begins a finding.
struct Find {
  Finding at(diag::Location location, diag::Subjects subjects = {}) const;
  /// A finding at a cell of a row. It is about the symbol of the row, or about the row if the model has no symbol for
  /// it. O(log symbols).
  Finding at(const read::ListRow& row, std::string_view cell) const;
  Finding at(const Symbol& symbol, std::string_view cell) const;
  Finding at(const Symbol& symbol) const { return at(symbol, symbol.name()); }

  const model::UnitEvidence& evidence_of(const Unit& unit) const {
    return evidence.units[static_cast<std::size_t>(&unit - units.data())];
  }

  const Rule& rule;
  const PlantModel& plant;
  const std::vector<Symbol>& symbols;
  const std::vector<Unit>& units;
  const model::Evidence& evidence;
  const std::vector<bool>& named_otherwise;  ///< for each list: SP208 or SP415 reports all its names at once
  diag::Diagnostics& diagnostics;
};

/// A symbol and its device, as the user can name them in the settings.
diag::Subjects about(const Symbol& symbol);
/// The location of a cell: the cell itself, or the whole row if the file has the cell in another form (escaped).
diag::Location location_of(const PlantModel& plant, const read::ListRow& row, std::string_view cell);
/// In the plant description. `fallback` is used until it is resolved, or if there is no file.
diag::Location location_of(const description::Pointer& pointer, diag::Location fallback = {});

/// The name that the built-in rule gives the symbol of a device for a task and a direction.
std::string symbol_name(std::string_view path, Direction direction, std::string_view task);
/// A device's name with `#` for each run of digits, in capitals: devices of one class have the same class name.
std::string class_name(std::string_view device);
constexpr Direction other_side(Direction direction) {
  return direction == Direction::operation ? Direction::event : Direction::operation;
}

// The rules of each file in rules/.
std::span<const Rule> address_rules();
std::span<const Rule> description_rules();
std::span<const Rule> device_rules();
std::span<const Rule> feedback_rules();
std::span<const Rule> name_rules();
std::span<const Rule> row_rules();
std::span<const Rule> spelling_rules();
std::span<const Rule> text_rules();
std::span<const Rule> value_rules();
std::span<const Rule> convention_rules();

/// Whether a unit only reports a state and nothing leads to it, because the state has no operation.
bool is_left_alone(const Unit& unit, std::uint32_t state);
/// For each list of the plant: whether its names follow another rule than the plant's. O(symbols).
std::vector<bool> lists_named_otherwise(const PlantModel& plant);

/// Whether the plant has symbols, and no device, part or condition drives one of them (SP415).
bool nothing_is_driven(const PlantModel& plant);

}  // namespace symplant::check

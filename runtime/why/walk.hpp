// Builds one explanation, from a thing to the causes of its state.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/explanation.hpp"
#include "symplant/why/needs.hpp"
#include "symplant/why/next_states.hpp"
#include "symplant/why/plant_index.hpp"
#include "symplant/why/state_view.hpp"

namespace symplant::why {

inline constexpr std::size_t kMostLevels = 6;
inline constexpr std::size_t kMostCauses = 12;  ///< of one sentence

/// `1400 mm`.
std::string millimeters(std::int64_t micrometers);

class Walk {
 public:
  Walk(const PlantIndex& index, const trace::PlantNames& names, std::span<const engine::Behaviour> behaviours,
       const StateView& view)
      : index_(index), tables_(index.tables), names_(names), behaviours_(behaviours), view_(view) {}

  Explanation thing(const Reference& thing);
  /// What keeps a condition from the opposite truth: a cause for each part that must change.
  std::vector<Explanation> causes_of(const condition::Tree& changes);
  Explanation violation(std::uint32_t requirement);

 private:
  /// A reason why a settled unit stays.
  struct Reason {
    enum class Kind : std::uint8_t {
      exit,       ///< transition `of` does not fire
      no_effect,  ///< no transition on operation `of` starts from the state
      hold,       ///< operation `of` keeps a spring from its rest state
      here,       ///< operation `of` leads to the state
    };
    Kind kind;
    std::uint32_t of;
  };
  /// What a part on a track does, and what is in front of it.
  struct Place {
    std::uint32_t track;
    std::size_t index;  ///< among the parts, from the front
    const std::vector<PartState>& parts;
  };

  // Levels and circles (walk.cpp).
  class Level;
  bool is_deepest() const { return depth_ + 1 >= kMostLevels; }
  bool is_mentioned(const Reference& thing, Explanation& result) const;
  /// A cause for each item; none on the deepest level.
  template <class Items, class Make>
  std::vector<Explanation> causes(const Items& items, Make make) {
    std::vector<Explanation> made;
    if (is_deepest()) return made;
    ++depth_;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i == kMostCauses) {
        made.push_back({"and " + std::to_string(items.size() - i) + " more"});
        break;
      }
      made.push_back(make(items[i]));
    }
    --depth_;
    return made;
  }
  /// Adds the causes of an explanation. The sentence of a single cause becomes a part of the result's sentence.
  template <class Items, class Make>
  void add_causes(Explanation& result, const Items& items, std::string_view summary, Make make) {
    if (items.size() == 1) {
      absorb(result, make(items.front()));
    } else if (!items.empty()) {
      if (!summary.empty()) result.sentence.append(": ").append(summary);
      append(result.because, causes(items, make));
    }
  }
  static void absorb(Explanation& result, Explanation cause);
  static void append(std::vector<Explanation>& list, std::vector<Explanation> more);
  Explanation atom(const condition::Atom& atom);
  Explanation led(const condition::Atom& atom);
  /// "`when` needs A and B", with their causes. False, without a change, if the condition holds.
  bool add_need(Explanation& result, std::string_view before, const Network& network);

  // Words (walk.cpp).
  bool commands(std::uint32_t operation) const;
  std::string operation_head(std::uint32_t operation, std::string_view to = {}) const;
  std::string_view level_words(std::uint32_t operation, bool on) const;
  std::string forcing_words(std::uint32_t symbol) const;
  std::string operation_words(std::uint32_t operation, std::string_view to = {}) const;
  std::string last_words(std::uint32_t operation) const;
  std::vector<std::uint32_t> risen_operations(std::uint32_t unit) const;
  std::string led_words(std::uint32_t unit) const;
  std::string unit_head(std::uint32_t unit) const;
  std::string symbol_head(std::uint32_t symbol) const;
  std::string location_head(std::uint32_t location) const;
  std::string place_words(const tables::PartLocation& at) const;
  std::vector<std::uint32_t> disablers(std::uint32_t unit) const;

  // Units (walk_unit.cpp).
  Explanation unit(std::uint32_t unit, const States& goals = {});
  Explanation led_unit(std::uint32_t unit);
  void add_forced(std::uint32_t unit, Explanation& result);
  void add_last_command(std::uint32_t unit, Explanation& result) const;
  void add_behaviour(std::uint32_t unit, Explanation& result) const;
  void add_move(std::uint32_t unit, const plant::UnitView& now, Explanation& result);
  void add_stop(std::uint32_t unit, const plant::UnitView& now, Explanation& result);
  void add_stay(std::uint32_t unit, std::uint8_t here, const States& goals, Explanation& result);
  bool add_conflict(std::uint32_t unit, std::uint8_t here, Explanation& result) const;
  Explanation reason(std::uint32_t unit, std::uint8_t here, const Reason& reason);
  Explanation exit(std::uint32_t unit, std::uint16_t transition);
  std::string after_words(std::uint32_t unit, std::uint16_t transition) const;
  bool is_ready(std::uint32_t unit, std::uint16_t transition) const;
  bool leads_to(std::uint32_t unit, std::uint8_t operation, std::uint8_t state) const;
  const tables::TypeRow& type_of(std::uint32_t unit) const { return tables_.types[tables_.units[unit].type]; }
  std::string state_list(std::uint32_t unit, const States& states) const;

  // Symbols and requirements (walk_symbol.cpp).
  Explanation symbol(std::uint32_t symbol);
  void add_operation(std::uint32_t symbol, Explanation& result);
  Explanation moved_unit(std::uint32_t operation, std::uint32_t unit);
  void add_event_of_unit(std::uint32_t symbol, std::uint32_t unit, Explanation& result);
  void add_sensor(std::uint32_t symbol, Explanation& result);
  bool add_switch(const tables::FollowRow& row, const Network& on, Explanation& result);
  void add_follow(std::uint32_t symbol, Explanation& result);
  void add_signal(std::uint32_t symbol, Explanation& result);
  Explanation reader(const SymbolReader& reader) const;
  Explanation requirement(std::uint32_t requirement);

  // Parts (walk_part.cpp).
  Explanation value(std::uint32_t output) const;
  Explanation location(std::uint32_t location);
  std::vector<Reference> feeders_of(std::uint32_t location) const;
  std::vector<Reference> takers_of(const Place& place) const;
  Explanation part(const Place& place);
  void add_halt(const Place& place, Explanation& result);
  int direction_of_drive(std::uint32_t drive) const;
  void add_drive(std::uint32_t drive, Explanation& result);
  void add_end(const Place& place, Explanation& result);
  Explanation transfer(std::uint32_t transfer);
  Explanation work(std::uint32_t work);
  Explanation source(std::uint32_t source);

  // Values (walk_value.cpp).
  Explanation asked_value(std::uint32_t output);
  std::string formula_of(const tables::ValueRow& row) const;

  const PlantIndex& index_;
  const tables::PlantTables& tables_;
  const trace::PlantNames& names_;
  std::span<const engine::Behaviour> behaviours_;
  const StateView& view_;
  std::size_t depth_ = 0;        ///< of the current sentence; 0 is the first one
  std::vector<Reference> path_;  ///< from the first thing to the current one
  std::set<Reference> done_;     ///< explained before, or now
  bool is_asked_ = false;  ///< it explains a thing, not a condition: adds the last command, or what an operation moves
};

/// Keeps a thing on the path during its lifetime.
class Walk::Level {
 public:
  Level(Walk& walk, const Reference& thing) : walk_(walk) {
    walk.path_.push_back(thing);
    walk.done_.insert(thing);
  }
  ~Level() { walk_.path_.pop_back(); }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  Walk& walk_;
};

}  // namespace symplant::why

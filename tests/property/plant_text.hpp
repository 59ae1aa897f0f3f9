// A plant and what is done to it, as plain values: by names, so that parts can be taken away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "description/description.hpp"
#include "model/plant_model.hpp"

namespace symplant::property {

/// A row of a symbol list.
struct Row {
  std::string name;
  std::string address;  ///< an IEC one; empty: none
  std::string type;
  std::string initial;

  friend bool operator==(const Row&, const Row&) = default;
};

struct PlantText {
  std::string name = "drawn";
  std::vector<Row> rows;
  description::Description description;
  std::size_t second_list = 0;  ///< the row with which a second list begins; 0 or beyond the last: there is one list
  std::string second_controller = {};  ///< whose list that is; empty: the one of the first

  bool two_lists() const { return second_list > 0 && second_list < rows.size(); }
};

/// One thing done to a running plant. What names something that the plant lacks does nothing.
struct Action {
  enum class Kind : std::uint8_t {
    reset,           ///< `value` the seed, `time` the cycle
    set,             ///< an operation, by its symbol's name, to `value`
    set_input,       ///< likewise
    force,           ///< likewise
    release,         ///< by the symbol's name
    set_state,       ///< a unit, by its path, to the state at the place `value`
    set_quality,     ///< of the link: well where `value` is not 0
    advance,         ///< to `time` from now
    advance_to_due,  ///< to when something is due; a second from now where nothing is
    advance_before,  ///< to `time` from now, its instant still to run
    save,
    restore,  ///< the save `value` (from 0, modulo how many there are), into another plant where `time` is not 0
  };
  Kind kind = Kind::advance;
  std::string what = {};
  std::uint64_t value = 0;
  tables::Time time = 0;
};

struct Case {
  PlantText plant;
  std::vector<Action> actions;
};

/// The model of a plant's list and description. Whoever wants to run it asks runnable() first.
model::PlantModel build(const PlantText& text);

/// Whether a plant may be run: no fault of its description, no address that two units move, and what the test's own
/// behaviours count on is there.
bool runnable(const model::PlantModel& plant);

/// The rows from `begin` to before `end` as a GX IEC Developer export has them.
std::string list_text(const PlantText& text, std::size_t begin, std::size_t end);
/// All of them.
std::string list_text(const PlantText& text);

}  // namespace symplant::property

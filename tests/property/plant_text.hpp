// A plant and its actions as plain values: by names, so that parts can be removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "description/description.hpp"
#include "model/derived.hpp"

namespace symplant::property {

/// A row of a symbol list.
struct Row {
  std::string name;
  std::string address;  ///< IEC; empty: no address
  std::string type;
  std::string initial;

  friend bool operator==(const Row&, const Row&) = default;
};

struct PlantText {
  std::string name = "drawn";
  std::vector<Row> rows;
  description::Description description;
  std::size_t second_list = 0;         ///< first row of a second list; 0 or after the last row: there is one list
  std::string naming = {};             ///< the naming rule (cell_plant.hpp); empty: the built-in one
  std::string second_controller = {};  ///< the controller of the second list; empty: that of the first

  bool two_lists() const { return second_list > 0 && second_list < rows.size(); }
};

/// One action on a running plant. An action that names something the plant lacks has no effect.
struct Action {
  enum class Kind : std::uint8_t {
    reset,           ///< `value` the seed, `time` the cycle
    set,             ///< an operation, by its symbol's name, to `value`
    set_input,       ///< as `set`
    force,           ///< as `set`
    release,         ///< by the symbol's name
    set_state,       ///< a unit, by its path, to the state with index `value`
    set_quality,     ///< of the link: good if `value` is not 0
    advance,         ///< to `time` from now
    advance_to_due,  ///< to the next due time; by a second if nothing is due
    advance_before,  ///< by `time`, with its instant still pending
    save,
    restore,    ///< the save `value` (from 0, modulo the number of saves), into another plant if `time` is not 0
    put,        ///< a part of kind `value`, at a location: TRACK, TRACK@um or PLACE
    take,       ///< a part from a location
    further,    ///< after `time`, one more instant without a change: writes the symbol's own value if `value` is 0,
                ///< releases it if not; it is not forced
    run,        ///< advance to `time` from now, over up to `value` instants
    start,      ///< a malfunction (malfunction_names.hpp): by a scenario if `value` is 0, else by hand
    stop,       ///< as `start`
    set_value,  ///< of the plant's values, by its name, to the double with the bits `value`
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

/// The model of a plant's list and description. Check runnable() before running it.
model::Derived build(const PlantText& text);

/// Whether each track has a drive for every position: only the last one has no `until`.
bool drives_are_complete(const model::PlantModel& plant);

/// Whether a plant may run: its description is valid, no address is driven by two units, and the test's own
/// behaviors have what they need.
bool runnable(const model::Derived& derived);

/// The rows from `begin` to before `end` in the format of GX IEC Developer.
std::string list_text(const PlantText& text, std::size_t begin, std::size_t end);
/// All rows.
std::string list_text(const PlantText& text);

}  // namespace symplant::property

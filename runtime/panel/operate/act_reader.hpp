// Reads what a client of the panel asks for.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/operate/order.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// One act of a request (docs/panel-interface.md).
struct Act {
  enum class Kind : std::uint8_t {
    step,  ///< acts on the plant, as a step of a scenario
    run,
    freeze,
    step_cycle,
    step_change,
    speed,
    reset,
    snapshot,
    save,
    restore,
    forget,
    exercise,
    end_exercise,
    session,
    count_again,  ///< of utilization
    join,
    message,
    camera,
    acknowledge,
    shelve,
    unshelve,
    silence,
  };
  Kind kind = Kind::step;
  scenario::Step step;
  bool releases_all = false;        ///< of a step: all forces, of which there may be none
  std::string name;                 ///< of a snapshot, exercise, session or camera; the text of a message
  double speed = 1;                 ///< 0: as fast as possible
  std::vector<std::string> alarms;  ///< to acknowledge (empty: all), to shelve or to unshelve
  tables::Time shelved_for = 0;     ///< plant time
};

/// The answer to an act that is the trainer's.
inline constexpr const char* kOnlyTrainer = "only the trainer can do this";

struct ReadActs {
  std::vector<Act> acts;
  std::string error;              ///< empty: all of them can be read
  bool is_form = false;           ///< the error is one of the form (400), not of the content (422)
  bool is_of_trainer = false;     ///< the error is that the role may not do it (403)
  std::int64_t until = kNoLimit;  ///< by act_clock(): the acts must not be done after this time
};

/// Reads the bodies of requests. Not thread-safe. Construction is O(plant), read() O(body).
class ActReader {
 public:
  /// `carried` as for read_scenario(). All must outlive it.
  ActReader(const trace::PlantNames& names, const std::vector<bool>& carried, const trace::History& history);
  ~ActReader();

  /// Acts on malfunctions and forces are read for a trainer only: errors about them name what there is.
  ReadActs read(std::string_view body, Role role);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::panel

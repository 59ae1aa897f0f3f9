// The panel of a run: shows and operates the plant in a browser.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/exec/exchange.hpp"
#include "symplant/exec/stepper.hpp"
#include "symplant/link/link.hpp"
#include "symplant/panel/alarm/alarm_act.hpp"
#include "symplant/panel/operate/exercises.hpp"
#include "symplant/panel/options.hpp"
#include "symplant/panel/picture/describe.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/panel/stepping.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/panel/web/guard.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/utilization.hpp"
#include "symplant/why/explainer.hpp"

namespace symplant::panel {

/// The plant of a run, for its panel. All must outlive it.
struct PanelPlant {
  const trace::PlantNames& names;
  plant::Plant& plant;
  trace::Recorder& recorder;  ///< with motions
  trace::History& history;
  trace::Utilization& utilization;
  const why::Explainer& explainer;
  std::span<const engine::Behaviour> behaviours;
  const std::vector<bool>& carried;    ///< as for read_scenario()
  const scenario::Scenario* scenario;  ///< played from the start; null: none
  scenario::Player* player;            ///< plays `scenario`; null without one
  scenario::ProgramControl* programs;  ///< the PLC programs of the run; null: none
  std::string scenario_name;
  std::vector<ExerciseFile> exercises;
  std::vector<LinkName> links;
  View view;
  std::uint64_t seed = 0;
  tables::Time cycle = 0;     ///< as for Plant::reset()
  bool with_plc = false;      ///< a link goes to a PLC
  bool by_plc_clock = false;  ///< plant time follows a PLC's clock
  bool paced = false;         ///< the run asks speed()
  std::string resumed;        ///< the name of the snapshot with which the run began; empty: none
  PanelLog log;               ///< gets errors of symplant that requests caused; from several threads
};

/// The plant was set to another state, which the history now has.
struct Jump {
  std::string_view what;  ///< `reset` or `restored`
  std::string name;       ///< of the snapshot
  tables::Time time;
};

/// Serves from construction to destruction. Each group of functions names the thread that may call it.
class Panel {
 public:
  /// Opens the port and begins to serve. An error is of kind usage or environment.
  static std::variant<std::unique_ptr<Panel>, link::LinkError> open(const PanelOptions& options, PanelPlant plant);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  /// The link to the page, with the token of a role.
  std::string link(Role role = Role::trainer) const;
  /// Whether there are links for trainees and viewers, too.
  bool has_trainees() const;

  // --- for the thread of the plant
  /// Advances the plant instead of Plant::advance_to(), and does what clients ask for.
  exec::Stepper& stepper();
  /// The time of the next step of the scenario that is played.
  tables::Time next_step() const noexcept;
  /// How many times as fast as the clock plant time is to run; 0: as fast as possible.
  double speed() const noexcept;
  /// The step that is being done.
  Stepping stepping() const noexcept;

  // --- for the thread that drains the recorder: all calls for one batch of records while it holds the lock
  std::unique_lock<std::mutex> lock();
  void before(const trace::Record& record);  ///< before History::apply()
  void after(const trace::Record& record);   ///< after it
  std::optional<Jump> note(const trace::Record& record);
  /// The acts on the plant since the last call, as JSON objects, for the trace.
  std::vector<std::string> take_acts();
  /// The acts on alarms since the last call, which have no record, for the trace.
  std::vector<AlarmAct> take_alarm_acts();
  void finding(const trace::FoundThing& found, const std::string& words);

  /// Sets the function that gives the keys `links` and `cycle` of the stream, as JSON members. The panel's thread calls
  /// it about once a second, until set_status() replaces it. Null: there are no such keys.
  void set_status(std::function<std::string()> status);
  /// Sets the function that gives the states of the links, as trace::PlantNames counts them, for explanations. The
  /// thread that drains the recorder calls it. Null: all links are live.
  void set_links(std::function<std::vector<exec::LinkState>()> states);

  // --- when no other thread drains or runs the plant
  bool frozen() const;
  const scenario::Scenario* playing() const;  ///< null: none; valid as long as the panel

 private:
  struct Parts;
  explicit Panel(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::panel

// The state of a panel: what its clients see, and what they asked for.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "symplant/exec/exchange.hpp"
#include "symplant/panel/alarm/alarm_act.hpp"
#include "symplant/panel/alarm/alarm_list.hpp"
#include "symplant/panel/alarm/alarm_sources.hpp"
#include "symplant/panel/answer.hpp"
#include "symplant/panel/operate/act_reader.hpp"
#include "symplant/panel/operate/allowed.hpp"
#include "symplant/panel/operate/exercises.hpp"
#include "symplant/panel/operate/operator.hpp"
#include "symplant/panel/operate/played.hpp"
#include "symplant/panel/operate/refusals.hpp"
#include "symplant/panel/operate/session.hpp"
#include "symplant/panel/operate/snapshots.hpp"
#include "symplant/panel/picture/chart.hpp"
#include "symplant/panel/picture/picture.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/panel/scene/scene.hpp"
#include "symplant/panel/training/messages.hpp"
#include "symplant/panel/training/training.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/utilization.hpp"
#include "symplant/why/explainer.hpp"

namespace symplant::panel {

/// The answer to an act whose time limit passed before the plant carried it out.
inline constexpr const char* kTooLateText = "it came too late, and was not done; try again";

/// The plant was set to another state, which the history now has.
struct SetBack {
  std::string_view what;  ///< `reset` or `restored`
  std::string name;       ///< of the snapshot
  tables::Time time;
};

/// Not thread-safe: each caller holds a mutex. Two threads use it: the one that drains the recorder, and the panel's.
class Desk {
 public:
  struct Setup {
    const trace::PlantNames& names;
    plant::Plant& plant;  ///< read before the run only
    trace::Recorder& recorder;
    trace::History& history;
    trace::Utilization& utilization;
    const why::Explainer& explainer;
    std::span<const engine::Behaviour> behaviours;
    const std::vector<bool>& carried;
    std::vector<ExerciseFile> exercises;
    const scenario::Scenario* scenario;  ///< that is played from the start; may be null
    scenario::Player* player;            ///< plays `scenario`; may be null
    scenario::ProgramControl* programs;  ///< the PLC programs; may be null
    std::string scenario_name;
    std::string folder;  ///< for files; empty: none
    std::uint64_t seed;
    tables::Time cycle;
    bool with_plc;        ///< a link goes to a PLC: plant time is real time
    bool by_plc_clock;    ///< plant time follows a PLC's clock: it cannot be set back
    bool paced;           ///< the speed can be changed
    bool acts;            ///< clients may act
    std::string resumed;  ///< the name of the snapshot with which the run began; empty: none
    View view;
    Scene& scene;
  };

  explicit Desk(Setup setup);
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  Operator& plant_operator() { return operator_; }
  const Operator& plant_operator() const { return operator_; }
  /// How many times as fast as the clock plant time runs; 0: as fast as possible. For any thread.
  double speed() const { return speed_.load(std::memory_order_relaxed); }
  bool acts() const { return setup_.acts; }

  // --- for the thread that drains the recorder, for each record in their order
  void before(const trace::Record& record);  ///< before History::apply()
  void after(const trace::Record& record);   ///< after it; not for notes
  /// For a note. Returns the change if the plant was set to another state.
  std::optional<SetBack> note(const trace::Record& record);
  /// The acts by hand on the plant since the last call, as JSON objects.
  std::vector<std::string> take_acts() { return std::exchange(new_acts_, {}); }
  /// The acts on alarms since the last call, which have no record.
  std::vector<AlarmAct> take_alarm_acts() { return std::exchange(new_alarm_acts_, {}); }
  void finding(const trace::FoundThing& found, const std::string& words);

  // --- for the thread of the panel
  void request(std::string_view body, const Sender& sender, Answered answered);
  /// What request() would refuse now.
  Answer check(std::string_view body, const Sender& sender);
  void why(std::string_view name, const Sender& sender, Answered answered);
  std::string chart(const ChartWish& wish) const { return chart_.text(wish, operator_.now()); }
  /// What devices, tracks and places did until now.
  std::string utilization(Role role) const;
  std::string utilization_of(std::uint32_t unit, Role role) const;
  std::string utilization_table(Role role) const;  ///< as comma-separated values
  /// The keys of the description that the desk knows.
  void put_description(std::string& json, Role role) const;
  /// The data of the event `picture`, as a role sees it.
  std::string picture(Role role);
  /// Before changes(): takes what has come since.
  void look_at_changes();
  /// The data of the event `changes` since forget_changes(), as a role sees it; empty if there is nothing new.
  std::string changes(Role role);
  void forget_changes();
  /// Whether the plant was set to another state since the last call: then the stream needs the picture again.
  bool begun_again() { return std::exchange(begun_again_, false); }
  /// The beginning of an event that has only the time, without the brace at its end.
  std::string beat() const;
  /// Keeps a backtrack if one is due; `every` 0: never. Asks for the outputs of values. To be called about once a
  /// second.
  void look_at_time(tables::Time every);
  /// The session as a file of this kind: `scenario`, `start` (the snapshot with which it begins), `session` or `junit`.
  Answer session_file(std::string_view kind);
  /// What the trainees did: the table of GET /api/v1/training.csv, or of reactions.csv.
  const Training& training() const { return training_; }
  /// Sets what gives the states of the run's links, for explanations. Null: all are live.
  void set_links(std::function<std::vector<exec::LinkState>()> states) { link_states_ = std::move(states); }
  /// Logs that a client saved the layout.
  void layout_saved(const Sender& sender);
  /// The scenario that the plant plays; null: none. It lives as long as the desk, or until another one is played.
  const scenario::Scenario* playing() const { return playing_; }
  /// Real speed, for the clock of the stream.
  void note_real_speed(double speed) { real_speed_ = speed; }
  /// The run ends: answers every request that waits.
  void end();
  bool has_ended() const { return ended_; }

 private:
  enum class Purpose : std::uint8_t { act, control, snapshot, save, backtrack, why, restore, play };
  /// A request whose orders are not all done.
  struct Group {
    Answered answered;
    std::size_t waiting = 0;
    tables::Time time = 0;
    std::int64_t until = kNoLimit;  ///< by act_clock(), of its acts on the plant
    std::string body;
    std::string error;
    Sender sender = {};
  };
  struct Pending {
    Purpose purpose;
    Order order;
    std::string name;
    std::vector<scenario::Step> steps;
    std::shared_ptr<KeptState> state;
    std::shared_ptr<Group> group;
    std::shared_ptr<Exercise> exercise;
    std::unique_ptr<scenario::Player> player;
    tables::Time asked = 0;  ///< plant time at which a restore was asked for
  };
  struct Found {
    tables::Time time;
    std::string json;                ///< its members without `n`
    std::string shown;               ///< the same for roles that do not see malfunctions; empty: these do not see it
    std::uint64_t shown_number = 0;  ///< among those that they see, from 0
    std::uint32_t requirement;       ///< that is violated, or kNone
    std::string step;                ///< the step of a scenario that failed, and why; empty: none
    std::string text;
  };

  /// The error if the acts cannot be read or are not possible; nothing if they are.
  std::optional<Answer> refused(const ReadActs& read, const Sender& sender);
  std::string refusal(const std::vector<Act>& acts);
  std::string refusal(const Act& act);
  void carry_out(std::vector<Act> acts, const std::shared_ptr<Group>& group);
  void order(const Act& act, const std::shared_ptr<Group>& group);
  void at_once(const Act& act, const std::shared_ptr<Group>& group);
  Answered counted(const Sender& sender, Answered answered);
  void on_alarms(const Act& act, const std::string& members);
  std::string alarm_refusal(const Act& act) const;
  void offer(Pending pending);
  void offer_copy(Purpose purpose, std::string name, const std::shared_ptr<Group>& group);
  void offer_restore(std::shared_ptr<KeptState> state, std::string name, const std::shared_ptr<Group>& group);
  void offer_exercise(const std::string& name, const std::shared_ptr<Group>& group);
  void finish(const std::shared_ptr<Group>& group);
  std::optional<SetBack> done(Pending& pending, const trace::Record& note);
  std::optional<SetBack> carried_out(Pending& pending, const trace::Record& note);
  void acted(const Pending& pending, const trace::Record& note);
  void play(Pending& pending, tables::Time time);
  std::optional<SetBack> set_back(const Pending& pending, tables::Time time);
  void go_back_to(const Pending& pending);
  void copied(Pending& pending, tables::Time time);
  std::string explain(const std::string& name, tables::Time time, Role role);
  std::string words_without_malfunctions(const trace::FoundThing& found);
  void allow();
  void log(tables::Time time, std::uint64_t turn, std::string_view by, const std::string& members, bool is_step,
           const std::string& name = {});
  void step_noted(const trace::Record& record);
  void step_failed(std::size_t step, tables::Time time);
  /// `shown`: the text for roles that do not see malfunctions; empty: they do not see the finding.
  void add_finding(Found found, std::string_view kind, std::string_view of, std::string_view severity,
                   const std::string& shown);
  bool is_exercise() const { return exercise_ != nullptr && &exercise_->scenario() == playing_; }
  /// The plant was set back to the time `after`: removes later findings.
  void forget_findings(tables::Time after);
  plant::OwnedPlant& shadow();
  const ExerciseFile* exercise_file(std::string_view name) const;
  void take_outputs();
  void put_clock(std::string& json) const;
  void put_findings(std::string& json, std::uint64_t from, Role role) const;
  void put_requirements(std::string& json, bool all) const;
  std::string save_session(const std::string& name);
  std::string session_json() const;
  std::string session_junit() const;

  Setup setup_;
  Operator operator_;
  Picture picture_;
  Chart chart_;
  AlarmList alarms_;
  AlarmSources alarm_sources_;
  ActReader reader_;
  Snapshots snapshots_;
  Session session_;
  Training training_;
  Messages messages_;
  Allowed allowed_;
  std::optional<plant::OwnedPlant> shadow_;  ///< a plant into which copies of the state are restored
  std::size_t block_ = 0;                    ///< the size of a state
  std::map<std::uint32_t, Pending> pending_;
  std::uint32_t next_id_ = 1;
  std::atomic<double> speed_{1};
  double real_speed_ = 1;
  std::function<std::vector<exec::LinkState>()> link_states_;

  std::vector<std::string> new_acts_;
  std::vector<AlarmAct> new_alarm_acts_;
  std::deque<Found> findings_;
  std::uint64_t first_finding_ = 0;
  std::uint64_t shown_findings_ = 0;  ///< how many the other roles have seen
  struct Violation {
    std::uint64_t count = 0;
    tables::Time first = 0;
    tables::Time since = 0;  ///< the last one
    bool changed = false;

    void note(tables::Time time) {
      if (count++ == 0) first = time;
      since = time;
    }
  };
  std::vector<Violation> violations_;
  std::shared_ptr<Exercise> exercise_;        ///< the exercise that is played, or was played last
  std::unique_ptr<scenario::Player> player_;  ///< the player of `exercise_`
  const scenario::Scenario* playing_;         ///< for the notes of steps
  Played played_;                             ///< the progress of `playing_`, if it is not an exercise
  const scenario::Player* asked_player_;      ///< the player after all orders so far; null: none
  std::uint64_t play_;                        ///< the number of what `asked_player_` plays; 0: none
  std::uint64_t plays_ = 1;
  tables::Time last_change_ = -1;  ///< of the plant, since it was last set back
  std::uint64_t step_turn_ = 0;    ///< the turn of the step in the next note
  Refusals refusals_;              ///< those of the step or order in the next note

  std::uint64_t revision_ = 0;
  std::uint64_t sent_findings_ = 0;
  std::uint64_t sent_acts_ = 0;
  std::uint64_t sent_snapshots_ = 0;
  std::uint64_t sent_exercise_ = 0;
  std::uint64_t sent_allowed_ = 0;
  std::uint64_t sent_played_ = 0;
  std::uint64_t sent_training_ = 0;
  std::uint64_t sent_messages_ = 0;
  std::uint64_t sent_layout_ = 0;
  std::uint64_t sent_camera_ = 0;
  const Exercise* sent_of_ = nullptr;
  std::string sent_clock_;
  tables::Time last_backtrack_ = 0;
  bool begun_again_ = false;
  bool ended_ = false;
};

}  // namespace symplant::panel

// The station, its program, and the recorder.
#include "property/recordings/station.hpp"

#include <cstddef>
#include <memory>
#include <utility>

#include "lower/lower.hpp"
#include "property/dice.hpp"
#include "property/plant_text.hpp"
#include "property/recordings/recorder.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::property {
namespace {

using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

constexpr Time kReading = 50 * kMillisecond;
constexpr Time kProgramScan = 10 * kMillisecond;
constexpr Time kDwell = 300 * kMillisecond;  ///< between two steps
constexpr Time kStepTimeout = 8 * kSecond;   ///< then the operator goes on by hand
const std::string kPrefix = "L_P_";

struct ProgramStep {
  std::string on;   ///< an operation; empty: none
  std::string off;  ///< an operation; empty: none
  std::string event;
  bool level = true;
};

const std::vector<ProgramStep> kSteps = {{"CL_O_CLOSED", "CL_O_OPEN", "CL_I_CLOSED"},
                                         {"MO_O_RUN", "", "MO_I_RUN"},
                                         {"DR_O_DOWN", "", "DR_I_DOWN"},
                                         {"DR_O_UP", "DR_O_DOWN", "DR_I_UP"},
                                         {"", "DR_O_UP", "DR_I_UP"},
                                         {"", "MO_O_RUN", "MO_I_RUN", false},
                                         {"CL_O_OPEN", "CL_O_CLOSED", "CL_I_OPEN"},
                                         {"PU_O_ADV", "", "PU_I_ADV"},
                                         {"", "PU_O_ADV", "PU_I_RET"},
                                         {"BE_O_END", "BE_O_HOME", "BE_I_END"},
                                         {"BE_O_HOME", "BE_O_END", "BE_I_HOME"}};

void give_times(model::PlantModel& plant) {
  const std::pair<const char*, Time> takes[] = {{"L_P_CL", 800 * kMillisecond},
                                                {"L_P_DR", 1500 * kMillisecond},
                                                {"L_P_MO", 150 * kMillisecond},
                                                {"L_P_PU", 600 * kMillisecond},
                                                {"L_P_BE", 3 * kSecond}};
  for (model::Unit& unit : plant.units) {
    for (const auto& [path, mean] : takes) {
      if (unit.path != path) continue;
      unit.travel = mean;
      for (model::Transition& transition : unit.transitions) {
        transition.takes = {description::Duration::Kind::uniform, mean - mean / 20, mean + mean / 20};
      }
    }
  }
}

class StationRun {
 public:
  StationRun(std::uint64_t seed, int cycles, const Defect& defect)
      : dice_(seed * 2 + 0x57A7'1011),
        defect_(defect),
        cycles_(cycles),
        described_(station()),
        real_([] {
          model::PlantModel plant = station();
          give_times(plant);
          return plant;
        }()),
        lowered_(lower::lower(real_)),
        tables_(lowered_.tables()),
        memory_(
            std::make_unique<std::max_align_t[]>(plant::Plant::memory_size(tables_) / sizeof(std::max_align_t) + 1)),
        plant_(tables_, std::span(reinterpret_cast<std::byte*>(memory_.get()), plant::Plant::memory_size(tables_))),
        recorder_(described_, kReading),
        levels_(described_.symbols.size(), false),
        real_levels_(described_.symbols.size(), false) {
    plant_.reset(seed, 0);
    scene_.since.resize(described_.symbols.size(), 0);
  }

  LabelledRecording run() {
    LabelledRecording labelled;
    Time read = 0;
    const Time phase = static_cast<Time>(dice_.below(kProgramScan));
    plant_.advance_to(0);
    look();
    for (Time now = phase; scene_.cycle < cycles_; now += kProgramScan) {
      plant_.advance_to(now);
      scene_.now = now;
      look();
      for (; read <= now; read += kReading) note(read);
      if (!active(defect_.stopped)) scan(now, labelled);
      for (std::uint32_t s = 0; s < levels_.size(); ++s) drive(s);
      plant_.advance_to(now);
    }
    labelled.recording = recorder_.finish(scene_.now + shift());
    return labelled;
  }

 private:
  bool is_defective() const { return defect_.in(scene_.cycle); }
  bool active(const std::function<bool(const Scene&)>& when) const { return when && is_defective() && when(scene_); }
  Time shift() const { return scene_.cycle >= cycles_ / 3 ? defect_.jump : 0; }
  std::string name_of(std::uint32_t s) const {
    return std::string(described_.symbols[s].name()).substr(kPrefix.size());
  }
  bool is_operation(std::uint32_t s) const { return described_.symbols[s].direction == tables::Direction::operation; }

  std::uint32_t symbol(const std::string& name) const {
    for (std::uint32_t s = 0; s < levels_.size(); ++s) {
      if (name_of(s) == name) return s;
    }
    return tables::kNone;
  }

  /// The events as program and recording see them.
  void look() {
    const bool frozen = active(defect_.frozen);
    for (std::uint32_t s = 0; s < levels_.size(); ++s) {
      if (is_operation(s)) continue;
      const bool level = plant_.event(tables_.symbols[s].index);
      if (level != real_levels_[s]) scene_.since[s] = scene_.now;
      real_levels_[s] = level;
      if (frozen) continue;
      levels_[s] = defect_.event && is_defective() ? defect_.event(scene_, name_of(s), level) : level;
    }
  }

  void note(Time time) {
    if (active(defect_.unread)) {
      if (gap_begin_ < 0) gap_begin_ = time;
      return;
    }
    if (gap_begin_ >= 0) recorder_.gap(gap_begin_, time - gap_begin_);
    gap_begin_ = -1;
    for (std::uint32_t s = 0; s < levels_.size(); ++s) recorder_.note(time + shift(), s, levels_[s] ? 1 : 0);
  }

  void drive(std::uint32_t s) {
    if (!is_operation(s)) return;
    bool level = levels_[s];
    if (level != real_levels_[s]) scene_.since[s] = scene_.now;
    real_levels_[s] = level;
    if (defect_.operation && is_defective()) level = defect_.operation(scene_, name_of(s), level);
    plant_.set_operation(tables_.symbols[s].index, level);
  }

  void scan(Time now, LabelledRecording& labelled) {
    if (now < pause_until_) return;
    if (!begun_) {
      begun_ = true;
      step_ = 0;
      scene_.begin = now;
      begin_step(now);
      return;
    }
    const ProgramStep& step = kSteps[step_];
    if (!waited_ && levels_[symbol(step.event)] != static_cast<char>(step.level) && now < step_began_ + kStepTimeout)
      return;
    if (!waited_) {  // so long that each end is read
      waited_ = true;
      pause_until_ = now + kDwell;
      return;
    }
    if (++step_ < kSteps.size()) {
      begin_step(now);
      return;
    }
    labelled.cycles.push_back({scene_.begin + shift(), now + shift(), is_defective()});
    ++scene_.cycle;
    begun_ = false;
    pause_until_ = now + kSecond + static_cast<Time>(dice_.below(500)) * kMillisecond;
  }

  void begin_step(Time now) {
    step_began_ = now;
    waited_ = false;
    const ProgramStep& step = kSteps[step_];
    if (!step.off.empty()) levels_[symbol(step.off)] = false;
    if (!step.on.empty()) levels_[symbol(step.on)] = true;
  }

  Dice dice_;
  const Defect& defect_;
  const int cycles_;
  const model::PlantModel described_;
  const model::PlantModel real_;
  const lower::EngineTables lowered_;
  const tables::PlantTables tables_;
  std::unique_ptr<std::max_align_t[]> memory_;
  plant::Plant plant_;
  Recorder recorder_;
  Scene scene_;
  std::vector<char> levels_;  ///< as program and recording see them
  std::vector<char> real_levels_;
  bool begun_ = false;
  bool waited_ = false;
  std::size_t step_ = 0;
  Time step_began_ = 0;
  Time pause_until_ = 2 * kSecond;
  Time gap_begin_ = -1;
};

}  // namespace

model::PlantModel station() {
  PlantText text;
  text.name = "station";
  int inputs = 0;
  int outputs = 0;
  for (const char* const name :
       {"CL_O_OPEN", "CL_O_CLOSED", "CL_I_OPEN", "CL_I_CLOSED", "DR_O_UP", "DR_O_DOWN", "DR_I_UP", "DR_I_DOWN",
        "MO_O_RUN", "MO_I_RUN", "PU_O_ADV", "PU_I_ADV", "PU_I_RET", "BE_O_HOME", "BE_O_END", "BE_I_HOME", "BE_I_END"}) {
    const std::string task = name;
    const bool operation = task.find("_O_") != std::string::npos;
    text.rows.push_back(
        {kPrefix + task, operation ? "%QX" + std::to_string(outputs++) : "%IX" + std::to_string(inputs++), "BOOL", ""});
  }
  const auto add = [&](const char* path, const char* initial, std::optional<tables::Actuation> actuation) {
    description::DeviceDescription device;
    device.path = path;
    device.initial = initial;
    device.actuation = actuation;
    text.description.devices.push_back(std::move(device));
  };
  add("L_P_CL", "OPEN", tables::Actuation::bistable);
  add("L_P_DR", "UP", tables::Actuation::held);
  add("L_P_BE", "HOME", tables::Actuation::bistable);
  return build(text).plant;
}

LabelledRecording record_station(std::uint64_t seed, int cycles, const Defect& defect) {
  return StationRun(seed, cycles, defect).run();
}

}  // namespace symplant::property

// A finer model of the harbour crane. It reads the trace of a test and writes what a recorder would have read of a
// crane with inertia, slip, friction and wind that gets the same operations. It is no part of the plant.
//
// usage: finer TRACE MILLISECONDS [--same]
//   MILLISECONDS: how often the recorder reads; --same: it reads the crane of the trace, not the finer one
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr std::int64_t kStepNs = 1'000'000;
constexpr double kStep = 0.001;  // s
constexpr double kGravity = 9.81;
constexpr double kPi = 3.14159265358979323846;
constexpr double kGrab = 5000;         // kg; this and the next two as in the plant
constexpr double kTip = 45;            // m: the height of the boom's tip
constexpr double kSwayDamping = 0.05;  // 1/s
constexpr double kWindOnLoad = 12;     // m2
constexpr double kWindOnBoom = 40;     // m2
constexpr double kSheaves = 0.04;      // of the load's weight, lost in the sheaves
constexpr double kLuffLift = 0.03;     // of the load's weight: luffing does not keep it level exactly
constexpr double kCharging = 2.15;     // s: the converters charge
constexpr double kContactor = 0.06;    // s: it drops

/// One motion, in m and N; slewing in rad, N m and kg m2.
struct Motion {
  double fastest;   // the speed at 16384
  double mass;      // that moves without a load
  double rated;     // force of the motor
  double slip;      // at the rated force, as a share of the fastest speed
  double friction;  // of the bearings
  double filter;    // s: the converter smooths its set value
  double brake;     // force of the closed brake
  double opens;     // s: the whole stroke of the brake
  double closes;    // s
  double reference = 0;
  double speed = 0;
  double stroke = 0;  // of the brake: 0 closed, 1 open

  bool is_closed() const { return stroke < 0.1; }
  bool is_open() const { return stroke > 0.9; }

  /// `outside`: a force that pushes in the direction of positive speed; `drag`: one against any motion.
  void accelerate(double load, double outside, double drag) {
    const double stiffness = rated / (slip * fastest);
    const double drive = std::clamp(stiffness * (reference - speed), -1.6 * rated, 1.6 * rated);
    const double pushed = speed + (drive + outside) / (mass + load) * kStep;
    // The brake slips where its shoes are less than half open. Friction slows down, and holds at standstill.
    const double resistance = friction + drag + std::clamp(1 - 2 * stroke, 0.0, 1.0) * brake;
    const double lost = resistance / (mass + load) * kStep;
    speed = std::abs(pushed) <= lost ? 0 : pushed - std::copysign(lost, pushed);
  }
};

/// What the PLC and the world do.
struct Inputs {
  std::array<double, 3> speeds{};  // hoist, slew, luff
  std::array<bool, 3> release{};
  bool power = false;
  double load = 0;  // kg
  double wind = 0;  // m/s
};

struct FinerCrane {
  double height = 0;  // m
  double angle = 0;   // rad
  double radius = 0;  // m
  double force = 0;   // in the rope, t
  double gust = 0;    // m/s
  bool powered = false;
  Motion hoist{1.5, 65000, 450000, 0.02, 6000, 0.10, 900000, 0.40, 0.25};
  Motion slew{8 * kPi / 180, 6.0e6, 700000, 0.03, 60000, 0.20, 900000, 0.35, 0.25};
  Motion luff{1, 90000, 250000, 0.02, 12000, 0.20, 300000, 0.35, 0.25};

  void step(double time, const Inputs& inputs) {
    on_for_ = inputs.power ? on_for_ + kStep : 0;
    off_for_ = inputs.power ? 0 : off_for_ + kStep;
    powered = powered ? off_for_ < kContactor : on_for_ >= kCharging;
    for (std::size_t i = 0; i < 3; ++i) {
      Motion& motion = *std::array{&hoist, &slew, &luff}[i];
      const bool opens = inputs.release[i] && powered;
      motion.stroke = std::clamp(motion.stroke + (opens ? kStep / motion.opens : -kStep / motion.closes), 0.0, 1.0);
      const double wanted = motion.is_closed() ? 0 : motion.fastest * inputs.speeds[i] / 16384;
      motion.reference += (wanted - motion.reference) * kStep / motion.filter;
    }
    const double weight = inputs.load * kGravity;
    gust = inputs.wind * (1 + 0.12 * std::sin(2 * kPi * time / 3.7) + 0.08 * std::sin(2 * kPi * time / 11.3 + 1) +
                          0.05 * std::sin(2 * kPi * time / 1.9 + 2));
    const double pressure = 0.6 * gust * gust;  // N/m2
    const double rope = std::max(kTip - height, 5.0);
    const double pull = (inputs.load + kGrab) * kGravity * sway_ / rope;  // the swinging load pulls at the tip
    const double hoisted = hoist.speed;
    const double slewed = slew.speed;
    hoist.accelerate(inputs.load, -weight, kSheaves * weight);
    slew.accelerate(0, pull * radius + pressure * kWindOnBoom * std::sin(angle) * radius / 2, 0);
    luff.accelerate(inputs.load, kLuffLift * weight + pressure * kWindOnBoom * std::cos(angle) / 2, 0);
    force = inputs.load / 1000 * (1 + (hoist.speed - hoisted) / kStep / kGravity);
    sway_speed_ += (pressure * kWindOnLoad / (inputs.load + kGrab) - kGravity / rope * sway_ -
                    kSwayDamping * sway_speed_ - radius * (slew.speed - slewed) / kStep) *
                   kStep;
    sway_ += sway_speed_ * kStep;
    height = std::clamp(height + hoist.speed * kStep, 0.0, 36.0);
    angle += slew.speed * kStep;
    radius = std::clamp(radius + luff.speed * kStep, 11.0, 40.0);
  }

 private:
  double on_for_ = 0;
  double off_for_ = 1;
  double sway_ = 0;  // m
  double sway_speed_ = 0;
};

/// A line of a trace: a symbol and its value as JSON, or a value of the plant and its number.
struct Line {
  std::int64_t time;
  std::string name;
  std::string value;
};

std::string after(const std::string& text, const std::string& key, const char* ends) {
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + key.size();
  return text.substr(begin, text.find_first_of(ends, begin) - begin);
}

std::vector<Line> read_trace(std::istream& file) {
  std::vector<Line> lines;
  for (std::string text; std::getline(file, text);) {
    const std::string time = after(text, "{\"t\":", ",}");
    const std::string symbol = after(text, "\"symbol\":\"", "\"");
    if (time.empty()) continue;
    if (!symbol.empty()) {
      lines.push_back({std::stoll(time), symbol, after(text, "\"value\":", ",}")});
    } else if (text.find("\"is\":") != std::string::npos) {
      lines.push_back({std::stoll(time), after(text, "\"value\":\"", "\""), after(text, "\"is\":", ",}")});
    }
  }
  return lines;
}

class Recorder {
 public:
  Recorder(std::int64_t every, bool same) : every_(every), same_(same) {}

  void run(const std::vector<Line>& lines) {
    std::cout << "{\"symplant-trace\":1,\"plant\":\"harbour_crane\",\"recorded\":true,\"every\":" << every_ << "}\n";
    for (const char* const name : kEvents) symbols_[std::string("PORT_C1_") + name] = "false";
    std::size_t next = 0;
    const std::int64_t end = lines.empty() ? 0 : lines.back().time;
    for (std::int64_t time = 0; time <= end; time += kStepNs) {
      for (; next < lines.size() && lines[next].time <= time; ++next) take(lines[next]);
      if (time == 0) begin();
      if (time > 0) crane_.step(static_cast<double>(time) / 1e9, inputs_);
      if (time % every_ == 0) read(time);
    }
  }

 private:
  static constexpr std::array kEvents{
      "POWER_I_ON",          "HOISTBRAKE_I_OPEN",  "HOISTBRAKE_I_CLOSED", "SLEWBRAKE_I_OPEN", "SLEWBRAKE_I_CLOSED",
      "LUFFBRAKE_I_OPEN",    "LUFFBRAKE_I_CLOSED", "HOISTLIMIT_I_TOP",    "LUFFLIMIT_I_IN",   "LUFFLIMIT_I_OUT",
      "HOISTLIMIT_I_BOTTOM", "START_I_PRESSED",    "ESTOP_I_PRESSED",     "POWER_O_ON",       "HOISTBRAKE_O_OPEN",
      "SLEWBRAKE_O_OPEN",    "LUFFBRAKE_O_OPEN",   "OVERLOAD_O_ON",       "STORM_O_ON"};

  void take(const Line& line) {
    if (line.name.rfind("PORT_C1_", 0) == 0) {
      symbols_[line.name] = line.value;
      const std::string name = line.name.substr(8);
      const bool on = line.value == "true";
      constexpr std::array kMotions{"HOIST", "SLEW", "LUFF"};
      for (std::size_t i = 0; i < 3; ++i) {
        if (name == std::string(kMotions[i]) + "_O_SPEED") inputs_.speeds[i] = std::stod(line.value);
        if (name == std::string(kMotions[i]) + "BRAKE_O_OPEN") inputs_.release[i] = on;
      }
      if (name == "POWER_O_ON") inputs_.power = on;
    }
    if (line.name == "load") inputs_.load = 1000 * std::stod(line.value);
    if (line.name == "wind") inputs_.wind = std::stod(line.value);
  }

  double number(const std::string& name) const {
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? 0 : std::stod(found->second);
  }

  void begin() {
    for (const char* const name : {"HOIST_O_SPEED", "SLEW_O_SPEED", "LUFF_O_SPEED", "MODE_O_NUMBER", "LEVER_I_HOIST",
                                   "LEVER_I_SLEW", "LEVER_I_LUFF", "SLEW_I_ANGLE"}) {
      symbols_.emplace(std::string("PORT_C1_") + name, "0");
    }
    crane_.height = number("PORT_C1_HOIST_I_HEIGHT") / 100;
    crane_.angle = number("PORT_C1_SLEW_I_ANGLE") / 10 * kPi / 180;
    crane_.radius = number("PORT_C1_LUFF_I_RADIUS") / 100;
  }

  void set(const char* name, bool on) { symbols_[std::string("PORT_C1_") + name] = on ? "true" : "false"; }
  void set(const char* name, double value) {
    symbols_[std::string("PORT_C1_") + name] = std::to_string(static_cast<long>(value));
  }

  void brake(const Motion& motion, const char* open, const char* closed) {
    set(open, motion.is_open());
    set(closed, motion.is_closed());
  }

  /// A reading of the finer crane, as its sensors show it.
  void show() {
    set("POWER_I_ON", crane_.powered);
    brake(crane_.hoist, "HOISTBRAKE_I_OPEN", "HOISTBRAKE_I_CLOSED");
    brake(crane_.slew, "SLEWBRAKE_I_OPEN", "SLEWBRAKE_I_CLOSED");
    brake(crane_.luff, "LUFFBRAKE_I_OPEN", "LUFFBRAKE_I_CLOSED");
    set("HOISTLIMIT_I_TOP", crane_.height >= 35);
    set("HOISTLIMIT_I_BOTTOM", crane_.height <= 0.5);
    set("LUFFLIMIT_I_IN", crane_.radius <= 11.5);
    set("LUFFLIMIT_I_OUT", crane_.radius >= 39.5);
    set("HOIST_I_HEIGHT", std::floor(100 * crane_.height + 0.5));
    const double tenths = std::floor(crane_.angle * 1800 / kPi);
    set("SLEW_I_ANGLE", tenths - 3600 * std::floor(tenths / 3600));
    set("LUFF_I_RADIUS", std::floor(100 * crane_.radius + 0.5));
    set("ROPE_I_FORCE", std::floor(10 * crane_.force + noise() + 0.5));
    set("WIND_I_SPEED", std::floor(10 * crane_.gust + 3 * noise() + 0.5));
  }

  /// Normally distributed, and the same with each library.
  double noise() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random_()) / 4294967296.0;
    return sum;
  }

  void read(std::int64_t time) {
    if (!same_) show();
    for (const auto& [name, value] : symbols_) {
      std::string& before = recorded_[name];
      if (before == value) continue;
      before = value;
      std::cout << "{\"t\":" << time << ",\"symbol\":\"" << name << "\",\"value\":" << value << "}\n";
    }
  }

  std::int64_t every_;
  bool same_;
  FinerCrane crane_;
  Inputs inputs_;
  std::map<std::string, std::string> symbols_;
  std::map<std::string, std::string> recorded_;
  std::mt19937 random_;
};

}  // namespace

int main(int count, char** arguments) {
  const bool same = count == 4 && std::string(arguments[3]) == "--same";
  const long every = count > 2 ? std::strtol(arguments[2], nullptr, 10) : 0;
  if ((count != 3 && !same) || every <= 0) {
    std::cerr << "usage: finer TRACE MILLISECONDS [--same]\n";
    return 2;
  }
  std::ifstream file(arguments[1]);
  if (!file) {
    std::cerr << "cannot read the trace " << arguments[1] << "\n";
    return 2;
  }
  Recorder(every * kStepNs, same).run(read_trace(file));
}

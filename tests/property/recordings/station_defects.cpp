// What can go wrong at the station.
#include "property/recordings/station.hpp"

namespace symplant::property {
namespace {

using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

// Symbols of station(), in its order.
enum : std::size_t { kClampOpen = 2, kClampClosed = 3, kDrillUp = 6, kDrillDown = 7, kPusherOut = 11, kBeltEnd = 16 };

using Event = std::function<bool(const Scene&, const std::string&, bool)>;
using When = std::function<bool(const Scene&)>;

/// A symbol has this level, whatever its real one.
Event stuck(const std::string& symbol, bool at) {
  return [=](const Scene&, const std::string& name, bool level) { return name == symbol ? at : level; };
}

/// A symbol comes on later, by a time that may depend on the cycle.
Event delayed(const std::string& symbol, std::size_t index, std::function<Time(int cycle)> by) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    return name == symbol && level ? scene.now >= scene.since[index] + by(scene.cycle) : level;
  };
}

std::function<Time(int)> always(Time time) {
  return [=](int) { return time; };
}

/// A symbol takes the level of another one: by its last real change, since a level is not given here.
Event off_later(const std::string& symbol, std::size_t index, Time by) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    return name == symbol && !level && scene.since[index] > 0 ? scene.now < scene.since[index] + by : level;
  };
}

/// On before its time: `after` the other end went off.
Event early(const std::string& symbol, std::size_t other, std::size_t own, Time after) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    const bool left = scene.since[other] > scene.since[own];
    return name == symbol && !level && left ? scene.now >= scene.since[other] + after : level;
  };
}

/// Off for 100 ms in every 400 ms.
Event loose(const std::string& symbol) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    return level && (name != symbol || scene.now % (400 * kMillisecond) >= 100 * kMillisecond);
  };
}

/// Inverts a symbol for 100 ms, once a second.
Event noise(const std::string& symbol) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    return name == symbol && scene.now % kSecond < 100 * kMillisecond ? !level : level;
  };
}

Event inverted(const std::string& symbol) {
  return [=](const Scene&, const std::string& name, bool level) { return name == symbol ? !level : level; };
}

Event lost(const std::string& symbol, Time from, Time to) {
  return [=](const Scene& scene, const std::string& name, bool level) {
    const Time in = scene.now - scene.begin;
    return level && (name != symbol || in < from || in > to);
  };
}

When between(Time from, Time to) {
  return [=](const Scene& scene) { return scene.now >= scene.begin + from && scene.now < scene.begin + to; };
}

}  // namespace

std::vector<Defect> station_defects() {
  std::vector<Defect> all;
  const auto event = [&](const char* name, const char* device, Event see) {
    Defect defect{name, device};
    defect.event = std::move(see);
    all.push_back(std::move(defect));
    return &all.back();
  };
  const auto operation = [&](const char* name, const char* device, Event get) {
    Defect defect{name, device};
    defect.operation = std::move(get);
    all.push_back(std::move(defect));
  };
  const auto link = [&](const char* name, When Defect::*member, When when) {
    Defect defect{name, ""};
    defect.*member = std::move(when);
    all.push_back(std::move(defect));
  };
  event("blocked sensor", "CL", stuck("CL_I_CLOSED", false));
  link("communication error", &Defect::frozen, between(kSecond / 2, 4 * kSecond));
  event("worn belt, 8 % slower", "BE", delayed("BE_I_END", kBeltEnd, always(240 * kMillisecond)));
  event("worn belt, 30 % slower", "BE", delayed("BE_I_END", kBeltEnd, always(900 * kMillisecond)));
  event("worn belt, 1 % slower each cycle", "BE",
        delayed("BE_I_END", kBeltEnd, [](int cycle) { return cycle * 30 * kMillisecond; }));
  event("sensor stays on", "CL", stuck("CL_I_OPEN", true));
  event("loose contact", "CL", loose("CL_I_CLOSED"));
  event("late by 40 %", "DR", delayed("DR_I_DOWN", kDrillDown, always(600 * kMillisecond)));
  event("early by half", "DR", early("DR_I_DOWN", kDrillUp, kDrillDown, 750 * kMillisecond));
  event("slow return, 40 %", "DR", delayed("DR_I_UP", kDrillUp, always(600 * kMillisecond)));
  event("sensor goes off 0.8 s late", "CL", off_later("CL_I_OPEN", kClampOpen, 800 * kMillisecond));
  event("inverted sensor", "PU", inverted("PU_I_ADV"));
  event("noise pulses", "PU", noise("PU_I_ADV"));
  event("sensor lost for 2 s at rest", "BE", lost("BE_I_HOME", kSecond, 3 * kSecond));
  event("feedback of the motor missing", "MO", stuck("MO_I_RUN", false));
  event("feedback of the motor stays on", "MO", stuck("MO_I_RUN", true));
  event("both ends at once for 1 s", "DR", off_later("DR_I_UP", kDrillUp, 2500 * kMillisecond));
  operation("device does not move", "DR", stuck("DR_O_DOWN", false));
  operation("reversed wiring", "BE", [](const Scene& scene, const std::string& name, bool level) {
    const bool end = scene.since[14] > scene.since[13];
    return name == "BE_O_HOME" ? end : name == "BE_O_END" ? !end : level;
  });
  operation("drive lost after 1 s", "DR", [](const Scene& scene, const std::string& name, bool level) {
    return level && (name != "DR_O_DOWN" || scene.now < scene.since[5] + kSecond);
  });
  operation("valve sticks for 1.5 s", "CL", [](const Scene& scene, const std::string& name, bool level) {
    return level && (name != "CL_O_CLOSED" || scene.now >= scene.since[1] + 1500 * kMillisecond);
  });
  all.back().in = [](int cycle) { return cycle % 3 == 0; };
  operation("one cycle without the pusher", "PU", stuck("PU_O_ADV", false));
  all.back().in = [](int cycle) { return cycle == 15; };
  operation("pusher moves without a command", "PU", [](const Scene& scene, const std::string& name, bool level) {
    return level || (name == "PU_O_ADV" && between(kSecond / 2, 2 * kSecond)(scene));
  });
  link("program stops for 20 s", &Defect::stopped, between(kSecond / 2, 20 * kSecond));
  link("nothing read for 2 s", &Defect::unread, between(kSecond, 3 * kSecond));
  Defect jump{"recorder's clock jumps by 5 s", ""};
  jump.jump = 5 * kSecond;
  jump.in = [](int cycle) { return cycle == 10; };
  all.push_back(std::move(jump));
  return all;
}

}  // namespace symplant::property

// Behaviors that use only what a View shows; time enters through wake-ups only.
#include "property/behaviours.hpp"

#include <algorithm>
#include <cstdint>

#include "symplant/tables/names.hpp"

namespace symplant::property {
namespace {

using tables::kMillisecond;
using tables::Time;

/// Custom durations: some drawn, some computed from what it sees.
template <class View>
struct Timing {
  static constexpr std::uint32_t kMemory = 0;
  static Time takes(View& view, std::uint16_t transition) noexcept {
    if (transition == 0xFFFF) return 30 * kMillisecond;
    if (transition % 4 == 3) return static_cast<Time>(view.draw() % 3) * 10 * kMillisecond;
    const Time by_state = view.moving() ? 5 * kMillisecond : view.state() == 0 ? 0 : kMillisecond;
    return (transition % 3) * 10 * kMillisecond + (view.input(0) ? 20 * kMillisecond : by_state);
  }
  static Time after(View& view, std::uint16_t transition) noexcept {
    if (!view.quality()) return 50 * kMillisecond;
    if (view.operation(0)) return 0;
    return (transition % 2 + 1) * 10 * kMillisecond;
  }
  static constexpr auto kWanted = nullptr;
  static constexpr auto kEntered = nullptr;
  static constexpr auto kLeft = nullptr;
  static constexpr auto kWoken = nullptr;
  static constexpr auto kStarted = nullptr;
  static constexpr auto kTakes = &takes;
  static constexpr auto kAfter = &after;
};

/// Counts its transitions and requests a state after every third.
template <class View>
struct Counting {
  struct Memory {
    std::uint32_t entered;
    std::uint32_t left;
  };
  static constexpr std::uint32_t kMemory = sizeof(Memory);
  static std::uint8_t wanted(View& view) noexcept {
    const auto& memory = view.template memory<Memory>();
    if (!view.quality()) return tables::kNoState;
    if (view.input(0)) return view.state();
    return memory.entered % 3 == 2 ? static_cast<std::uint8_t>(memory.entered % 2) : tables::kNoState;
  }
  static void entered(View& view, std::uint8_t state) noexcept {
    ++view.template memory<Memory>().entered;
    if (state == 0) view.set_event(0, view.operation(0));
  }
  static void left(View& view, std::uint8_t) noexcept {
    auto& memory = view.template memory<Memory>();
    ++memory.left;
    view.set_value(0, memory.left);
    view.set_value(1, memory.entered);
  }
  static constexpr auto kTakes = nullptr;
  static constexpr auto kAfter = nullptr;
  static constexpr auto kWanted = &wanted;
  static constexpr auto kEntered = &entered;
  static constexpr auto kLeft = &left;
  static constexpr auto kWoken = nullptr;
  static constexpr auto kStarted = nullptr;
};

/// Wakes repeatedly after it has moved; its random draws decide what it writes and wants.
template <class View>
struct Waking {
  struct Memory {
    std::uint64_t woken;
    std::uint64_t wish;
  };
  static constexpr std::uint32_t kMemory = sizeof(Memory);
  static std::uint8_t wanted(View& view) noexcept {
    const std::uint64_t wish = view.template memory<Memory>().wish;
    return wish == 0 ? tables::kNoState : static_cast<std::uint8_t>(wish % 2);
  }
  static void entered(View& view, std::uint8_t) noexcept { view.wake_at(view.now() + 20 * kMillisecond); }
  static void left(View& view, std::uint8_t) noexcept {
    view.wake_at(view.now() + (view.input(0) ? 10 : 50) * kMillisecond);
  }
  static void woken(View& view) noexcept {
    auto& memory = view.template memory<Memory>();
    ++memory.woken;
    const std::uint64_t drawn = view.draw();
    memory.wish = drawn % 4 == 0 ? 1 + (drawn >> 8) % 2 : 0;
    view.set_event(0, !view.event(0));
    view.set_value(memory.woken % 2 == 0 ? 0 : 1, (drawn >> 16) % 8 + view.value(0) % 8);
    if (memory.woken % 16 == 5) return;  // asleep until it moves
    view.wake_at(memory.woken % 16 == 9 ? view.now() - 1 : view.now() + 20 * kMillisecond);
  }
  static constexpr auto kTakes = nullptr;
  static constexpr auto kAfter = nullptr;
  static constexpr auto kWanted = &wanted;
  static constexpr auto kEntered = &entered;
  static constexpr auto kLeft = &left;
  /// Asks for its first wake-up and leaves a mark, so that a device without a transition also wakes.
  static void started(View& view) noexcept {
    view.template memory<Memory>().wish = view.state() == 0 ? 0 : 1;
    view.set_event(0, view.draw() % 2 == 0);
    view.set_value(0, 3);
    view.wake_at(view.draw() % 4 == 0 ? 0 : 70 * kMillisecond);
  }
  static constexpr auto kWoken = &woken;
  static constexpr auto kStarted = &started;
};

template <class Behaviour, class Code>
Behaviour behaviour_of() {
  Behaviour made;
  made.memory_size = Code::kMemory;
  made.takes = Code::kTakes;
  made.after = Code::kAfter;
  made.wanted = Code::kWanted;
  made.entered = Code::kEntered;
  made.left = Code::kLeft;
  made.woken = Code::kWoken;
  made.started = Code::kStarted;
  return made;
}

/// In the order of behaviour_names().
template <class Behaviour, class View>
std::vector<Behaviour> all_behaviours() {
  return {behaviour_of<Behaviour, Timing<View>>(), behaviour_of<Behaviour, Counting<View>>(),
          behaviour_of<Behaviour, Waking<View>>()};
}

/// Index in behaviour_names(); its size if the name is unknown.
std::size_t location_of(std::string_view name) {
  const auto& names = behaviour_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name.substr(0, name.find('_'))) -
                                  names.begin());
}

}  // namespace

const std::vector<std::string>& behaviour_names() {
  static const std::vector<std::string> names = {"Timing", "Counting", "Waking"};
  return names;
}

bool is_behaviour(std::string_view name) { return location_of(name) < behaviour_names().size(); }

std::vector<engine::Behaviour> engine_behaviours(const tables::PlantTables& tables) {
  const auto all = all_behaviours<engine::Behaviour, engine::BehaviourView>();
  std::vector<engine::Behaviour> wanted;
  for (const std::string_view name : tables::split_names(tables.behaviour_names)) {
    wanted.push_back(is_behaviour(name) ? all[location_of(name)] : engine::Behaviour{});
  }
  return wanted;
}

std::map<std::string, reference::Behaviour> reference_behaviours(const tables::PlantTables& tables) {
  const auto all = all_behaviours<reference::Behaviour, reference::View>();
  std::map<std::string, reference::Behaviour> by_name;
  for (const std::string_view name : tables::split_names(tables.behaviour_names)) {
    if (is_behaviour(name)) by_name.emplace(name, all[location_of(name)]);
  }
  return by_name;
}

}  // namespace symplant::property

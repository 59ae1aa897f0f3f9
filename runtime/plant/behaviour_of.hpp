// Adapts the user's class to the engine; the functions that it defines are found at compile time.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "symplant/engine/behaviour.hpp"
#include "symplant/plant/behaviour_memory.hpp"
#include "symplant/plant/device_view.hpp"
#include "symplant/tables/hooks.hpp"
#include "symplant/tables/row_of.hpp"

namespace symplant::plant {
namespace detail {

/// `named`: whether a class has any member of that name, also a private or overloaded one (together with Rival's member
/// the name is then ambiguous); `right`: whether it is one function of the required type.
#define SYMPLANT_BEHAVIOUR_MEMBER(NAME)                          \
  struct Member_##NAME {                                         \
    struct Rival {                                               \
      int NAME; /* NOLINT */                                     \
    };                                                           \
    template <class Class>                                       \
    struct Both : Class, Rival {};                               \
    template <class Class>                                       \
    static constexpr bool named = !requires {                    \
      &Both<Class>::NAME;                                        \
    };                                                           \
    template <class Class, class Function>                       \
    static constexpr bool right = requires {                     \
      requires std::is_same_v<decltype(&Class::NAME), Function>; \
    };                                                           \
  };
SYMPLANT_BEHAVIOUR_MEMBER(hooks)
SYMPLANT_BEHAVIOUR_MEMBER(started)
SYMPLANT_BEHAVIOUR_MEMBER(takes)
SYMPLANT_BEHAVIOUR_MEMBER(after)
SYMPLANT_BEHAVIOUR_MEMBER(wanted)
SYMPLANT_BEHAVIOUR_MEMBER(entered)
SYMPLANT_BEHAVIOUR_MEMBER(left)
SYMPLANT_BEHAVIOUR_MEMBER(woken)
#undef SYMPLANT_BEHAVIOUR_MEMBER

struct MemoryRival {
  using Memory = char;
};
template <class Class>
struct MemoryBoth : Class, MemoryRival {};
template <class Class>
inline constexpr bool kNamesMemory = !requires {
  typename MemoryBoth<Class>::Memory;
};
template <class Class>
inline constexpr bool kHasMemory = requires {
  typename Class::Memory;
};

template <class Class>
inline constexpr bool kListsHooks = requires {
  Class::hooks::lists(tables::Hook::woken);
};

/// Whether a class defines any function of a behavior.
template <class Class>
inline constexpr bool kHasHook =
    Member_started::named<Class> || Member_takes::named<Class> || Member_after::named<Class> ||
    Member_wanted::named<Class> || Member_entered::named<Class> || Member_left::named<Class> ||
    Member_woken::named<Class>;

#define SYMPLANT_CHECK_HOOK(NAME, DECLARATION)                                                     \
  static_assert(!Class::hooks::lists(tables::Hook::NAME) || Member_##NAME::template named<Class>,  \
                "`hooks` lists `" #NAME "`, but the class does not define it: write `" DECLARATION \
                "`, or remove it from `hooks`");                                                   \
  static_assert(Class::hooks::lists(tables::Hook::NAME) || !Member_##NAME::template named<Class>,  \
                "the class defines `" #NAME "`, but `hooks` does not list it: add `Hook::" #NAME "`")

/// The functions that a class lists are those that it defines.
template <class Class>
constexpr void check_hooks() noexcept {
  static_assert(!Member_hooks::named<Class> || kListsHooks<Class>,
                "`hooks` must be a public type: `using hooks = Hooks<Hook::entered, Hook::woken>;`");
  if constexpr (kListsHooks<Class>) {
    SYMPLANT_CHECK_HOOK(started, "static void started(View& view) noexcept");
    SYMPLANT_CHECK_HOOK(takes, "static Time takes(Look& look, Transition transition) noexcept");
    SYMPLANT_CHECK_HOOK(after, "static Time after(Look& look, Transition transition) noexcept");
    SYMPLANT_CHECK_HOOK(wanted, "static std::optional<State> wanted(const Look& look) noexcept");
    SYMPLANT_CHECK_HOOK(entered, "static void entered(View& view, State state) noexcept");
    SYMPLANT_CHECK_HOOK(left, "static void left(View& view, State state) noexcept");
    SYMPLANT_CHECK_HOOK(woken, "static void woken(View& view) noexcept");
  }
}
#undef SYMPLANT_CHECK_HOOK

template <class Class>
constexpr std::uint32_t memory_size_of() noexcept {
  static_assert(!kNamesMemory<Class> || kHasMemory<Class>, "`Memory` must be a public type: `struct Memory { ... };`");
  if constexpr (kHasMemory<Class>) {
    check_behaviour_memory<typename Class::Memory>();
    return (sizeof(typename Class::Memory) + 7) / 8 * 8;
  }
  return 0;
}

template <class Class, class Device>
constexpr void add_times(engine::Behaviour& behaviour) noexcept {
  using Look = DeviceLook<Device>;
  using Transition = DeviceTransition<Device>;
  using Function = tables::Time (*)(Look&, Transition) noexcept;
  if constexpr (Member_takes::named<Class>) {
    static_assert(Member_takes::right<Class, Function>,
                  "declare `static Time takes(Look& look, Transition transition) noexcept` once, as a public member");
    if constexpr (Member_takes::right<Class, Function>) {
      behaviour.takes = [](engine::BehaviourView& view, std::uint16_t transition) noexcept -> tables::Time {
        Look look(view);
        return Class::takes(look, Transition(view, transition));
      };
    }
  }
  if constexpr (Member_after::named<Class>) {
    static_assert(Member_after::right<Class, Function>,
                  "declare `static Time after(Look& look, Transition transition) noexcept` once, as a public member");
    if constexpr (Member_after::right<Class, Function>) {
      behaviour.after = [](engine::BehaviourView& view, std::uint16_t transition) noexcept -> tables::Time {
        Look look(view);
        return Class::after(look, Transition(view, transition));
      };
    }
  }
}

template <class Class, class Device>
constexpr void add_wanted(engine::Behaviour& behaviour) noexcept {
  using Look = DeviceLook<Device>;
  using State = typename Device::State;
  if constexpr (Member_wanted::named<Class>) {
    constexpr bool kRight = Member_wanted::right<Class, std::optional<State> (*)(const Look&) noexcept>;
    static_assert(kRight,
                  "declare `static std::optional<State> wanted(const Look& look) noexcept` once, as a public member");
    if constexpr (kRight) {
      behaviour.wanted = [](engine::BehaviourView& view) noexcept -> std::uint8_t {
        const Look look(view);
        const std::optional<State> state = Class::wanted(look);
        return state ? static_cast<std::uint8_t>(*state) : tables::kNoState;
      };
    }
  }
}

template <class Class, class Device>
constexpr void add_reported(engine::Behaviour& behaviour) noexcept {
  using View = DeviceView<Device>;
  using State = typename Device::State;
  using Function = void (*)(View&, State) noexcept;
  if constexpr (Member_entered::named<Class>) {
    static_assert(Member_entered::right<Class, Function>,
                  "declare `static void entered(View& view, State state) noexcept` once, as a public member");
    if constexpr (Member_entered::right<Class, Function>) {
      behaviour.entered = [](engine::BehaviourView& raw, std::uint8_t state) noexcept {
        View view(raw);
        Class::entered(view, static_cast<State>(state));
      };
    }
  }
  if constexpr (Member_left::named<Class>) {
    static_assert(Member_left::right<Class, Function>,
                  "declare `static void left(View& view, State state) noexcept` once, as a public member");
    if constexpr (Member_left::right<Class, Function>) {
      behaviour.left = [](engine::BehaviourView& raw, std::uint8_t state) noexcept {
        View view(raw);
        Class::left(view, static_cast<State>(state));
      };
    }
  }
  if constexpr (Member_started::named<Class>) {
    constexpr bool kRight = Member_started::right<Class, void (*)(View&) noexcept>;
    static_assert(kRight, "declare `static void started(View& view) noexcept` once, as a public member");
    if constexpr (kRight) {
      behaviour.started = [](engine::BehaviourView& raw) noexcept {
        View view(raw);
        Class::started(view);
      };
    }
  }
  if constexpr (Member_woken::named<Class>) {
    constexpr bool kRight = Member_woken::right<Class, void (*)(View&) noexcept>;
    static_assert(kRight, "declare `static void woken(View& view) noexcept` once, as a public member");
    if constexpr (kRight) {
      behaviour.woken = [](engine::BehaviourView& raw) noexcept {
        View view(raw);
        Class::woken(view);
      };
    }
  }
}

template <class Class, class Device>
constexpr engine::Behaviour made_of() noexcept {
  static_assert(!std::is_final_v<Class>, "remove `final`: the functions of the class are found by deriving from it");
  static_assert(
      std::is_empty_v<Class>,
      "a behavior's class must have no data members; put its state in `Memory` and make its functions static");
  engine::Behaviour behaviour;
  behaviour.replaces = tables::replaced_in<Class, Device>();
  behaviour.memory_size = memory_size_of<Class>();
  if constexpr (std::is_base_of_v<Device, Class> && !std::is_final_v<Class>) {
    check_hooks<Class>();
    add_times<Class, Device>(behaviour);
    add_wanted<Class, Device>(behaviour);
    add_reported<Class, Device>(behaviour);
  }
  return behaviour;
}

/// Whether a behavior changes anything of its devices.
template <class Class, class Device>
constexpr bool does_something() noexcept {
  if constexpr (!std::is_base_of_v<Device, Class> || std::is_final_v<Class>) {
    return true;  // an error, which made_of() reports
  } else {
    return kHasHook<Class> || tables::replaced_in<Class, Device>() != 0;
  }
}

}  // namespace detail

/// `Class`, which the user derived from the generated class `Device`, in the form that the engine calls. Each function
/// that it defines of started, takes, after, wanted, entered, left and woken replaces the model's rule (d_ext, d_int,
/// l_enter and l_leave are those of tables::row_of). A function of one of these names with another signature, one that
/// `hooks` lists and the class lacks, and a Memory that cannot be saved, do not compile.
template <class Class, class Device>
constexpr engine::Behaviour behaviour_of() noexcept requires(detail::does_something<Class, Device>()) {
  return detail::made_of<Class, Device>();
}

/// The same for a class that defines none of these functions: a warning, since its devices follow the model alone.
template <class Class, class Device>
[[deprecated(
    "this behavior defines none of started, takes, after, wanted, entered, left and woken, so that its devices follow "
    "the model's rules alone: define one, or check the spelling of what it defines")]] constexpr engine::Behaviour
behaviour_of() noexcept requires(!detail::does_something<Class, Device>()) {
  return detail::made_of<Class, Device>();
}

}  // namespace symplant::plant

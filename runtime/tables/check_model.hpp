// Rejects at compile time, with messages, classes from which no row can be built.
#pragma once

#include <cstdint>
#include <type_traits>

#include "symplant/tables/io_model.hpp"

namespace symplant::tables::detail {

template <class Class>
concept ConstexprModel = requires {
  typename std::bool_constant<(Class::d_ext(typename Class::State{}, typename Class::Operation{}),
                               Class::d_int(typename Class::State{}), Class::l_enter(typename Class::State{}),
                               Class::l_leave(typename Class::State{}), true)>;
};

template <class Class>
concept HasSpringReturn = requires {
  Class::spring_return(typename Class::State{});
};

template <class Class, class Base>
constexpr bool same_spring_return() noexcept {
  if constexpr (HasSpringReturn<Base>) return &Class::spring_return == &Base::spring_return;
  return false;
}

/// Rejects, with messages, a derived class that is not a model of its base's states, operations, events and guards.
template <class Class, class Base>
constexpr bool check_model() noexcept {
  static_assert(std::is_base_of_v<Base, Class>, "a behavior must derive from the generated class of its devices");
  static_assert(std::is_same_v<typename Class::State, typename Base::State> &&
                    std::is_same_v<typename Class::Operation, typename Base::Operation> &&
                    std::is_same_v<typename Class::Event, typename Base::Event> &&
                    std::is_same_v<typename Class::Guard, typename Base::Guard>,
                "a derived class has the State, Operation, Event and Guard of its base: remove its own");
  static_assert(&Class::kI == &Base::kI && &Class::kO == &Base::kO && &Class::kS == &Base::kS &&
                    &Class::kTargets == &Base::kTargets && &Class::kRest == &Base::kRest &&
                    &Class::kActuation == &Base::kActuation,
                "a derived class may replace d_ext, d_int, l_enter and l_leave; states, rest and actuation are in the "
                "plant's description");
  static_assert(std::is_same_v<decltype(&Class::d_ext), decltype(&Base::d_ext)>,
                "declare `static constexpr Moves d_ext(State a, Operation x) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::d_int), decltype(&Base::d_int)>,
                "declare `static constexpr Moves d_int(State b) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::l_enter), decltype(&Base::l_enter)>,
                "declare `static constexpr Events l_enter(State x) noexcept` once, as a public member");
  static_assert(std::is_same_v<decltype(&Class::l_leave), decltype(&Base::l_leave)>,
                "declare `static constexpr Events l_leave(State x) noexcept` once, as a public member");
  static_assert(&Class::l_disable == &Base::l_disable,
                "l_disable cannot be replaced: which devices disable which is in the plant's description (`disables`)");
  if constexpr (requires { Base::dt_without_command; }) {
    static_assert(&Class::dt_without_command == &Base::dt_without_command,
                  "dt_without_command cannot be replaced: it is the `travel` of the plant's description");
  }
  if constexpr (HasSpringReturn<Base> || HasSpringReturn<Class>) {
    static_assert(same_spring_return<Class, Base>(),
                  "spring_return cannot be replaced: it is a transition of the plant's description");
  }
  static_assert(ConstexprModel<Class>,
                "d_ext, d_int, l_enter and l_leave are called while compiling: declare them `constexpr`, and see other "
                "errors about them");
  return ConstexprModel<Class>;
}

}  // namespace symplant::tables::detail

// The roles of the panel's clients.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace symplant::panel {

/// What a client may see and do.
enum class Role : std::uint8_t {
  viewer,   ///< sees what a trainee sees, and does nothing
  trainee,  ///< operates what the exercise allows; sees no malfunction, and nothing that is for the trainer
  trainer,  ///< sees and does everything
};
inline constexpr std::size_t kRoles = 3;

constexpr std::string_view role_name(Role role) {
  constexpr std::array<std::string_view, kRoles> kNames{"viewer", "trainee", "trainer"};
  return kNames[static_cast<std::size_t>(role)];
}

/// The sender of a request.
struct Sender {
  Role role = Role::viewer;
  std::string name = {};  ///< UTF-8, as the client gives it; empty: it gave none
};

/// Whether a role sees malfunctions, and what is for the trainer.
constexpr bool sees_all(Role role) { return role == Role::trainer; }

}  // namespace symplant::panel

// Ready naming rules: the files in profiles/.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace symplant::naming {

struct Profile {
  std::string_view name;
  std::string_view (*text)();  ///< of a naming.json; its first line is a comment that describes it

  /// The description in the first line of the text.
  std::string_view summary() const;
};

/// All profiles, by name.
std::span<const Profile> profiles();

/// The profile of a name, with or without `@`; null for an unknown one.
const Profile* find_profile(std::string_view name);

/// For a message: that no profile has this name, and the nearest name.
std::string no_such_profile(std::string_view name);

}  // namespace symplant::naming

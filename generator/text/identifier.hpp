// From names to C++ identifiers: the one place where a user's text becomes one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace symplant::text {

/// An identifier holds at most so many characters of its name; a longer one is cut and ends in a hash of the whole.
inline constexpr std::size_t kMaxIdentifierBody = 100;

/// A legal C++ identifier of letters, digits and `_` that reads like `utf8_name`. Every other character is written as
/// its code point between `_` (`Spare(5)` is `Spare_u0028_5_u0029`). Never a leading digit (`n` goes before it), a
/// leading or a double `_`. Keywords, alternative tokens and well-known macros (errno, NULL, I, linux ...) get a `_`
/// behind. An empty name is `unnamed`. Different names may still meet: see IdentifierScope. O(name).
std::string identifier(std::string_view utf8_name);

/// The same behind `prefix`, which must be an identifier's beginning: then nothing needs to be mended in front, and no
/// keyword can arise (`k` and `class` is `kclass`).
std::string identifier(std::string_view utf8_name, std::string_view prefix);

/// Whether a name reads as it is behind a prefix: ASCII letters and digits, single `_` between them, not too long.
bool is_plain_identifier(std::string_view name);

/// The constant or enumerator of a name: `kRUN2`, in the user's own spelling.
std::string enumerator(std::string_view utf8_name);

/// Makes identifiers unique within one scope, regardless of ASCII case, in the order of asking: `RUN`, `run_2`,
/// `Run_3`.
class IdentifierScope {
 public:
  IdentifierScope() = default;
  /// `reserved` names are taken from the start.
  explicit IdentifierScope(std::span<const std::string_view> reserved);

  /// Amortised O(name).
  std::string unique(std::string_view utf8_name, std::string_view prefix = {});

 private:
  /// By lower case: the next number to try where the same is asked for again.
  std::unordered_map<std::string, std::size_t> next_;
};

}  // namespace symplant::text

// Converts names to C++ identifiers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace symplant::text {

/// The most characters of a name in an identifier; a longer name is cut and ends in a hash of the whole.
inline constexpr std::size_t kMaxIdentifierBody = 100;

/// A legal C++ identifier of letters, digits and `_` that reads like `utf8_name`. Every other character is written as
/// its code point between `_` (`Spare(5)` is `Spare_u0028_5_u0029`). Never a leading digit (`n` is put before it), a
/// leading or a double `_`. Keywords, alternative tokens and well-known macros (errno, NULL, I, linux ...) get a `_`
/// at the end. An empty name is `unnamed`. Different names may give one identifier: see IdentifierScope. O(name).
std::string identifier(std::string_view utf8_name);

/// An identifier that begins with `prefix`, which must be the beginning of an identifier. After it, a leading digit and
/// keywords need no change (`k` and `class` is `kclass`).
std::string identifier(std::string_view utf8_name, std::string_view prefix);

/// Whether a name needs no change after a prefix: ASCII letters and digits, single `_` between them, not too long.
bool is_plain_identifier(std::string_view name);

/// Whether identifier() returns the name unchanged. Needs no memory.
bool is_identifier(std::string_view name);

/// The constant or enumerator of a name: `kRUN2`, in the user's spelling.
std::string enumerator(std::string_view utf8_name);

/// Makes identifiers unique within one scope, regardless of ASCII case, in the order of the calls: `RUN`, `run_2`,
/// `Run_3`.
class IdentifierScope {
 public:
  IdentifierScope() = default;
  /// `reserved` names are taken from the start.
  explicit IdentifierScope(std::span<const std::string_view> reserved);

  /// Amortized O(name).
  std::string unique(std::string_view utf8_name, std::string_view prefix = {});

 private:
  /// By name in lower case: the next number to try for the same name.
  std::unordered_map<std::string, std::size_t> next_;
};

}  // namespace symplant::text

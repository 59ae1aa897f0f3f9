// The identity of a finding from one run to the next, independent of the rows around it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// Gives each finding a fingerprint: 16 hexadecimal digits from its rule, its file and the symbols and devices that it
/// is about (if the finding joins many, their shape), then `:1`, `:2` ... for findings equal in these. Moved rows and a
/// new wording of the message do not change it. For a finding about no symbol the message (without the numbers outside
/// back-ticks) and the text at its location are used instead.
class Fingerprints {
 public:
  /// `file` is a path that does not depend on the current folder. O(names).
  std::string next(const Diagnostic& finding, std::string_view file);

 private:
  std::unordered_map<std::uint64_t, std::size_t> seen_;
};

}  // namespace symplant::diag

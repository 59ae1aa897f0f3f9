// A finding's identity from one run to the next, whatever becomes of the rows around it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// Gives each finding a fingerprint: 16 hexadecimal digits of its rule, file and the symbols and devices that it is
/// about, then `:1`, `:2` ... for those that are alike in these. It stays when rows move, and with any other wording of
/// the message. A finding about no symbol goes by its message (less the numbers outside back-ticks) and the text at its
/// place instead.
class Fingerprints {
 public:
  /// `file` names the finding's file from wherever the tool is run. O(names).
  std::string next(const Diagnostic& finding, std::string_view file);

 private:
  std::unordered_map<std::uint64_t, std::size_t> seen_;
};

}  // namespace symplant::diag

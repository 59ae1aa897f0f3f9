// What the doctor found of a link.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"

namespace symplant::link::doctor {

enum class Result : std::uint8_t {
  good,
  warning,  ///< works, but see the text
  bad,
  skipped,  ///< not tested, since an earlier step failed or it was not asked for
};

/// A step of the examination.
struct Step {
  std::string name;  ///< "connection"
  Result result = Result::good;
  std::string text;  ///< what was found, and what to do
};

/// A symbol of the link's controller.
struct Point {
  std::uint32_t symbol = 0;
  std::string address;  ///< in the PLC or on the link; empty if it is not linked
  Result result = Result::good;
  std::optional<std::uint64_t> value;  ///< as in the plant's images; BOOL: 0 or 1
  std::string text;                    ///< empty if there is nothing to say
};

struct Report {
  std::string url;
  std::vector<Step> steps;
  std::vector<Point> points;  ///< in the order of the symbol lists
  bool reached = false;       ///< the PLC answered or sent a request
};

/// What was found, or why nothing could be.
using Examined = std::variant<Report, LinkError>;

}  // namespace symplant::link::doctor

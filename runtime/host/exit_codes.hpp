// Exit codes of the tool and of every plant.
#pragma once

namespace symplant::host {

inline constexpr int kGood = 0;
inline constexpr int kFindings = 1;     ///< findings, or a failed expectation
inline constexpr int kBadInput = 2;     ///< bad input or usage
inline constexpr int kEnvironment = 3;  ///< a port in use, no permission

}  // namespace symplant::host

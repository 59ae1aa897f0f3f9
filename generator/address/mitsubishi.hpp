// The two notations of Mitsubishi's tools: MIT addresses (X1F) and IEC addresses (%IX31).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "address/address.hpp"

namespace symplant::address {

/// X1F is %IX31, Y10 %QX16, M100 %MX0.100, B35F %MX1.863, D100 %MW0.100, W35F %MW1.863: the number of the IEC address
/// is decimal, and in memory a class precedes it. Nothing for devices whose class is not certain.
std::optional<std::string> iec_of_melsec(std::string_view text, Radix radix);

/// The reverse; %MD0.100 (a double word) is D100. Nothing for byte.bit (%IX0.1) and words of inputs, which Mitsubishi's
/// notation does not have.
std::optional<std::string> melsec_of_iec(std::string_view text, Radix radix);

}  // namespace symplant::address

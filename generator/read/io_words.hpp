// What the user says about a shared area: `--cio inputs=0-99,outputs=100-199`.
#pragma once

#include <string>
#include <string_view>

#include "address/notation.hpp"
#include "base/result.hpp"

namespace symplant::read {

/// Reads "inputs=0-99,outputs=100-199,inputs=3300". The error is a message for the user.
base::Result<address::IoRanges, std::string> io_words_of(std::string_view text);

}  // namespace symplant::read

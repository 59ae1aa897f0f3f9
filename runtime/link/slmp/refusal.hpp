// Packs a request that a MELSEC PLC refused into a tables::Refusal.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/link/client/retry.hpp"
#include "symplant/link/slmp/device.hpp"
#include "symplant/link/slmp/plan.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link::slmp {

struct RefusedRequest {
  bool writing = false;
  Access access = Access::batch;
  Device first;  ///< a bit device, or a word
};

/// The function has the access in its low 4 bits, 10H for writing, and 80H if X and Y are counted in octal. The
/// address has the number of the first device in its low 24 bits, and above them the device's code.
tables::Refusal refusal_of(const RefusedRequest& request, Family family, std::uint16_t end_code);

/// "reading words from X10 on: end code C059 (...): ..."; what it says and what to do.
std::string refusal_text(const tables::Refusal& refusal);

/// How an end code other than 0 answers a request: busy or refused.
client::Answer answer_of(std::uint16_t end_code) noexcept;

}  // namespace symplant::link::slmp

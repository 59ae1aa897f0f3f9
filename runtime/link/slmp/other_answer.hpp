// Explains an answer to a request of an SLMP link that is not a reply in the link's framing.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "symplant/link/slmp/framing.hpp"

namespace symplant::link::slmp {

/// "it answers in ASCII: set `code=ascii`"; what the bytes look like and what to do. There is at least one byte.
std::string other_answer(std::span<const std::uint8_t> bytes, const Framing& framing);

}  // namespace symplant::link::slmp

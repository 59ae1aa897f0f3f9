// Status codes of OPC UA in plain words.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/link/client/retry.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link::opc_ua {

/// A status code as the protocol has it; its highest 16 bits name it.
using Status = std::uint32_t;

/// Whether a value with this status is not to be used.
constexpr bool is_bad(Status status) noexcept { return (status >> 30) >= 2; }

/// "BadNodeIdUnknown (80340000, the server has no such node): check ...": the meaning and what to do, as far as known.
std::string status_text(Status status);

/// The same without what to do.
std::string status_meaning(Status status);

/// How a bad status of a node answers a request: busy or refused.
client::Answer answer_of(Status status) noexcept;

/// A bad status in the answer to a request to read or to write.
tables::Refusal refusal_of(bool writing, Status status) noexcept;

/// "reading: BadNodeIdUnknown (...): ..."; for the trace, so no name of a symbol is in it.
std::string refusal_text(const tables::Refusal& refusal);

}  // namespace symplant::link::opc_ua

// Requests for any number of nodes, as few as a server allows; only for .cpp files of this folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/opc_ua/client_connection.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/status_text.hpp"

namespace symplant::link::opc_ua {

/// Whether a server finds a request too large.
bool is_too_large(UA_StatusCode status) noexcept;

/// Sends `count` operations in requests of at most `limit` (0: one request). `send(first, count, result)` sends one
/// request. If the server finds it too large, `limit` is halved from then on. `result`: of the last request.
template <class Send>
client::Fault in_batches(std::size_t count, std::uint32_t& limit, UA_StatusCode& result, Send send) {
  for (std::size_t first = 0; first < count;) {
    const std::size_t most = limit == 0 ? count : limit;
    const std::size_t now = std::min(most, count - first);
    if (client::Fault fault = send(first, now, result)) return fault;
    if (is_too_large(result) && now > 1) {
      limit = static_cast<std::uint32_t>(now / 2);
      continue;
    }
    if (is_bad(result)) break;
    first += now;
  }
  return {};
}

/// Gets the values of one request, from item `first` on. It may move them.
using TakeValues = std::function<void(std::size_t first, std::span<UA_DataValue> values)>;

/// Reads attributes by in_batches(). Another number of values than requested is a fault.
client::Fault read_attributes(ClientConnection& connection, std::span<const UA_ReadValueId> items, std::uint32_t& limit,
                              UA_StatusCode& result, const TakeValues& take);

}  // namespace symplant::link::opc_ua

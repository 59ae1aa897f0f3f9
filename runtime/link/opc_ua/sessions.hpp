// What the clients of the server do, by its diagnostics.
#pragma once

#include <open62541/server.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/opc_ua/open62541.hpp"

namespace symplant::link::opc_ua {

/// The sessions of a server, from look to look. For the server's thread.
class Sessions {
 public:
  using Clock = std::chrono::steady_clock;

  /// A session may be closed for another client after this time without a request: longer than any keep-alive interval.
  static constexpr auto kAbandoned = std::chrono::seconds(60);

  /// What has happened since the last look.
  struct Look {
    std::size_t open = 0;        ///< sessions, now
    std::uint64_t requests = 0;  ///< of sessions that are still open
    std::uint64_t refused = 0;   ///< sessions, as there were as many as allowed
    bool live = false;           ///< a client with a subscription gave a sign of life
  };

  /// A client with a subscription lives for as long as it may be silent: the server answers each of its publish
  /// requests after the interval of keep-alives at the latest, and a client that lives then sends another one. If there
  /// are as many sessions as allowed, the one that has been silent longest is closed, unless all have been heard within
  /// kAbandoned. O(sessions^2 + sessions x subscriptions).
  Look look(UA_Server* server, Clock::time_point now);

 private:
  struct Session {
    OwnedNodeId id;
    std::uint32_t requests = 0;  ///< so far
    Clock::time_point heard;
  };

  Session updated(const UA_SessionDiagnosticsDataType& session, Clock::time_point now);
  void close_silent(UA_Server* server, Clock::time_point now) const;

  std::vector<Session> sessions_;
  std::uint64_t rejected_ = 0;  ///< as the server counts them, whatever the reason
};

}  // namespace symplant::link::opc_ua

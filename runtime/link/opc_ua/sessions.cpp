// What the clients of the server do, by its diagnostics.
#include "symplant/link/opc_ua/sessions.hpp"

#include <algorithm>
#include <utility>

namespace symplant::link::opc_ua {

namespace {

using Clock = Sessions::Clock;

/// An array of the server's diagnostics.
class Diagnostics {
 public:
  Diagnostics(UA_Server* server, std::uint32_t node) {
    UA_Server_readValue(server, UA_NODEID_NUMERIC(0, node), value_.get());
  }
  template <class T>
  std::span<const T> of(std::size_t type) const noexcept {
    if (value_->type != &UA_TYPES[type]) return {};
    return {static_cast<const T*>(value_->data), value_->arrayLength};
  }

 private:
  OwnedVariant value_;
};

/// The shortest interval of keep-alives of the session's subscriptions; zero without a subscription.
Clock::duration keep_alive_of(const UA_NodeId& session, std::span<const UA_SubscriptionDiagnosticsDataType> all) {
  Clock::duration shortest{};
  for (const UA_SubscriptionDiagnosticsDataType& one : all) {
    if (!UA_NodeId_equal(&one.sessionId, &session)) continue;
    const std::chrono::duration<double, std::milli> interval(one.publishingInterval * one.maxKeepAliveCount);
    const auto silence = std::chrono::ceil<Clock::duration>(interval);
    if (shortest == Clock::duration{} || silence < shortest) shortest = silence;
  }
  return shortest;
}

}  // namespace

Sessions::Look Sessions::look(UA_Server* server, Clock::time_point now) {
  const Diagnostics sessions(server,
                             UA_NS0ID_SERVER_SERVERDIAGNOSTICS_SESSIONSDIAGNOSTICSSUMMARY_SESSIONDIAGNOSTICSARRAY);
  const Diagnostics subscriptions(server, UA_NS0ID_SERVER_SERVERDIAGNOSTICS_SUBSCRIPTIONDIAGNOSTICSARRAY);
  const auto of_subscriptions =
      subscriptions.of<UA_SubscriptionDiagnosticsDataType>(UA_TYPES_SUBSCRIPTIONDIAGNOSTICSDATATYPE);
  Look look;
  std::vector<Session> there;
  for (const auto& one : sessions.of<UA_SessionDiagnosticsDataType>(UA_TYPES_SESSIONDIAGNOSTICSDATATYPE)) {
    Session session = updated(one, now);
    look.requests += one.totalRequestCount.totalCount - session.requests;
    session.requests = one.totalRequestCount.totalCount;
    const Clock::duration keep_alive = keep_alive_of(one.sessionId, of_subscriptions);
    if (keep_alive != Clock::duration{} && now - session.heard <= keep_alive) look.live = true;
    there.push_back(std::move(session));
  }
  sessions_ = std::move(there);
  look.open = sessions_.size();
  const bool full = look.open >= UA_Server_getConfig(server)->maxSessions;
  // The server counts a refused login and a request of a session that is no more as rejected sessions, too.
  const std::uint64_t rejected = UA_Server_getStatistics(server).ss.rejectedSessionCount;
  const std::uint64_t more = rejected - std::exchange(rejected_, rejected);
  if (!full) return look;
  look.refused = more;
  close_silent(server, now);
  return look;
}

/// The session as the last look left it, with the time of its last request.
Sessions::Session Sessions::updated(const UA_SessionDiagnosticsDataType& session, Clock::time_point now) {
  const auto same = [&](const Session& known) { return UA_NodeId_equal(known.id.get(), &session.sessionId); };
  Session result;
  if (const auto known = std::find_if(sessions_.begin(), sessions_.end(), same); known != sessions_.end()) {
    result = std::move(*known);
    if (session.totalRequestCount.totalCount != result.requests) result.heard = now;
  } else {
    UA_NodeId_copy(&session.sessionId, result.id.get());
    result.heard = now;
  }
  return result;
}

void Sessions::close_silent(UA_Server* server, Clock::time_point now) const {
  const auto silent = std::min_element(sessions_.begin(), sessions_.end(),
                                       [](const auto& a, const auto& b) { return a.heard < b.heard; });
  if (silent == sessions_.end() || now - silent->heard <= kAbandoned) return;
  UA_Server_closeSession(server, silent->id.get());
}

}  // namespace symplant::link::opc_ua

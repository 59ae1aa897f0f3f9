// What the connections of the server share: their list, the places of streams, and the bytes that wait.
#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <list>
#include <memory>

#include "symplant/panel/web/client.hpp"
#include "symplant/panel/web/content.hpp"
#include "symplant/panel/web/guard.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel::web {

/// Counts the streams. Half of the places are for clients with the token, so that others cannot keep them out.
class StreamPlaces {
 public:
  static constexpr std::size_t kMost = 8;
  static constexpr std::size_t kMostWithoutToken = 4;

  bool is_full(bool has_token) const { return all_ >= kMost || (!has_token && without_token_ >= kMostWithoutToken); }
  void take(bool has_token) {
    ++all_;
    if (!has_token) ++without_token_;
  }
  void leave(bool has_token) {
    --all_;
    if (!has_token) --without_token_;
  }
  bool empty() const { return all_ == 0; }

 private:
  std::size_t all_ = 0;
  std::size_t without_token_ = 0;
};

/// Used by the server's thread only.
class Shared {
 public:
  Shared(Routes& all_routes, Source& plant, Guard& net, int seconds)
      : routes(all_routes), source(plant), guard(net), patience(seconds) {}

  /// The event `picture` as it is now; made once for all clients that need one at the same time. Throws what the source
  /// throws.
  Bytes picture();
  /// To be called after each change of the source.
  void forget_picture() { picture_ = nullptr; }
  /// Sends an event to all streams.
  void broadcast(const Bytes& event);
  /// Sends all streams a comment that is larger than the usual buffers of a client: one that does not read it is closed
  /// after `patience`. Does nothing for `patience` after the last one.
  void probe(Clock::time_point now);
  /// Closes the connection that is idle for longest, else the one that takes its answer most slowly; false if there is
  /// none. A connection whose answer began within the last second is not closed.
  bool close_one(Clock::time_point now);
  /// Makes room for an answer of `bytes` bytes that exceeds Outgoing::kMost: closes the connections that take their
  /// answers most slowly, until at least as many bytes no longer wait. False if no further connection can be closed.
  bool relieve(std::size_t bytes, Clock::time_point now);

  boost::asio::io_context context;
  Routes& routes;
  Source& source;
  Guard& guard;
  const std::chrono::seconds patience;
  std::list<std::shared_ptr<Client>> connections;  ///< the connection that is idle for longest comes first
  StreamPlaces places;
  Outgoing outgoing;

 private:
  std::shared_ptr<Client> slowest(Clock::time_point now) const;

  Bytes picture_;
  Clock::time_point next_probe_{};
};

}  // namespace symplant::panel::web

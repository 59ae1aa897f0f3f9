// What the connections of the server share: their list, the places of streams, and the bytes that wait.
#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>

#include "symplant/panel/web/client.hpp"
#include "symplant/panel/web/content.hpp"
#include "symplant/panel/web/guard.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel::web {

/// Counts the streams. Half of the places are for clients with a token, and one of these for a trainer, so that others
/// cannot keep them out.
class StreamPlaces {
 public:
  static constexpr std::size_t kMost = 8;
  static constexpr std::size_t kMostWithoutToken = 4;
  enum class Kind : std::uint8_t { without_token, with_token, trainer };

  bool is_full(Kind kind) const {
    const std::size_t without = of(Kind::without_token);
    const std::size_t others = without + of(Kind::with_token);
    return others + of(Kind::trainer) >= kMost || (kind != Kind::trainer && others >= kMost - 1) ||
           (kind == Kind::without_token && without >= kMostWithoutToken);
  }
  void take(Kind kind) { ++counts_[static_cast<std::size_t>(kind)]; }
  void leave(Kind kind) { --counts_[static_cast<std::size_t>(kind)]; }
  bool empty() const { return counts_ == std::array<std::size_t, 3>{}; }

 private:
  std::size_t of(Kind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

  std::array<std::size_t, 3> counts_{};
};

/// Used by the server's thread only.
class Shared {
 public:
  Shared(Routes& all_routes, Source& plant, Guard& net, int seconds)
      : routes(all_routes), source(plant), guard(net), patience(seconds) {}

  /// The event `picture` as it is now, with or without what only a trainer sees; made once for all clients that need
  /// one at the same time. Throws what the source throws.
  Bytes picture(bool all);
  /// To be called after each change of the source.
  void forget_pictures() { pictures_ = {}; }
  /// Sends an event to all streams.
  void broadcast(const Bytes& event) { broadcast(event, event); }
  /// Sends `all` to the streams that see all, and `shown` to the others. Null: nothing.
  void broadcast(const Bytes& all, const Bytes& shown);
  /// Whether a stream does not see all.
  bool has_others() const;
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

  std::array<Bytes, 2> pictures_;  ///< by whether it has all
  Clock::time_point next_probe_{};
};

}  // namespace symplant::panel::web

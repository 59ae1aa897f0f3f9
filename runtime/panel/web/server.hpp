// The web server of the panel: HTTP/1.1 and server-sent events, on a separate thread.
#pragma once

#include <functional>
#include <memory>

#include "symplant/link/net/listener.hpp"
#include "symplant/panel/web/guard.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel {

/// Serves from construction to destruction. Limits: 64 connections (of more, the one that is idle for longest is
/// closed, else the slowest one), 8 streams, 4 of them without the token, `patience` s for a request to arrive and for
/// a client to acknowledge some of what it is sent, 8 KiB of header, 64 KiB of body, Outgoing::kMost bytes that wait.
class Server {
 public:
  /// `routes`, `source` and `guard` must outlive it. The source is used by the server's thread only, apart from answers
  /// that come later. What it throws is logged by the guard, and the request gets the status 500. `each_second` is
  /// called about once a second by this thread.
  Server(link::net::Listener listener, Routes& routes, Source& source, Guard& guard, int patience,
         std::function<void()> each_second);
  ~Server();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::panel

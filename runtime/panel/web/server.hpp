// The web server of the panel: HTTP/1.1 and server-sent events, on a separate thread.
#pragma once

#include <memory>

#include "symplant/link/net/listener.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel {

/// Serves from construction to destruction. Limits: 64 connections (of more, the one that is idle for longest is
/// closed), 8 streams, `patience` s for a request to arrive and for an answer or event to be read, 8 KiB of header,
/// 64 KiB of body.
class Server {
 public:
  /// `routes` and `source` must outlive it. The source is used by the server's thread only, apart from answers that
  /// come later. `each_second` is called about once a second by this thread.
  Server(link::net::Listener listener, Routes& routes, Source& source, int patience, std::function<void()> each_second);
  ~Server();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::panel

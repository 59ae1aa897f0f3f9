// Limits of the system on sockets: what to do after a failed accept(), how many clients are possible.
#pragma once

#include <cstddef>

namespace symplant::link::net {

/// What a server does after accept() failed.
enum class AfterAccept {
  again,     ///< accept the next: only this client failed
  serve,     ///< serve the others: no client waits
  give_way,  ///< close a client: this process has no descriptor left
  pause,     ///< wait: the system has no descriptor or memory left; closing a client may not help
};

/// Whether the error of an accept() means this client only.
bool concerns_client(int error) noexcept;

/// By last_error() of accept_client(). A network error comes from the client's side and affects only that client.
AfterAccept after_accept(int error) noexcept;

/// Raises this process's soft limit of descriptors to limit_for(). Throws std::system_error if that is impossible; its
/// text says what to do.
void make_room_for(std::size_t clients);

}  // namespace symplant::link::net

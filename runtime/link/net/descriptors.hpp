// Limits of the system on sockets: what to do after a failed accept(), how many clients are possible.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <optional>

namespace symplant::link::net {

/// What a server does after accept() failed.
enum class AfterAccept {
  again,     ///< accept the next: only this client failed
  serve,     ///< serve the others: no client waits
  give_way,  ///< close a client: this process has no descriptor left
  pause,     ///< wait: the system has no descriptor or memory left; closing a client may not help
};

/// By the errno of accept(). A network error comes from the client's side and affects only that client.
AfterAccept after_accept(int error) noexcept;

/// The soft limit of descriptors raised by `clients`, at most to the hard limit; nothing if the hard limit is too small
/// for the clients and a few files.
std::optional<rlim_t> limit_for(rlimit limit, std::size_t clients) noexcept;

/// Raises this process's soft limit of descriptors to limit_for(). Throws std::system_error if that is impossible; its
/// text says what to do.
void make_room_for(std::size_t clients);

}  // namespace symplant::link::net

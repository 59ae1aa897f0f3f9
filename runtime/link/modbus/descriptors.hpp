// What the system allows of sockets: what follows when a client cannot be accepted, how many can be.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <optional>

namespace symplant::link::modbus {

/// What a server does after accept() failed.
enum class AfterAccept {
  again,     ///< this client is lost, the next may do
  serve,     ///< no client waits
  give_way,  ///< this process has no descriptor left: one of its own may help
  pause,     ///< the system has none left, nor memory: closing ours need not help
};

/// By the errno of accept(): faults of the network come from the client's side and concern it alone.
AfterAccept after_accept(int error) noexcept;

/// The limit of descriptors that has room for so many clients beside what the process had room for, as far as the hard
/// one allows; nothing where that leaves less than the clients and a few files need.
std::optional<rlim_t> limit_for(rlimit limit, std::size_t clients) noexcept;

/// Raises this process's soft limit of descriptors to limit_for(). Throws std::system_error where it cannot be had,
/// with a text that says what to do.
void make_room_for(std::size_t clients);

}  // namespace symplant::link::modbus

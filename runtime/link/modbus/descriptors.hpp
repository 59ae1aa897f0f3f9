// What the system allows of sockets: what follows when a client cannot be accepted.
#pragma once

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

}  // namespace symplant::link::modbus

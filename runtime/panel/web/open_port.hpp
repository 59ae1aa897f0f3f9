// Opens the port of a panel, and decides what its clients may do.
#pragma once

#include <variant>

#include "symplant/link/net/listener.hpp"
#include "symplant/panel/options.hpp"
#include "symplant/panel/web/access.hpp"

namespace symplant::panel {

struct OpenPort {
  link::net::Listener listener;
  Access access;
};

/// Errors are of kind usage (address, token file) or environment (port in use).
std::variant<OpenPort, link::LinkError> open_port(const PanelOptions& options);

}  // namespace symplant::panel

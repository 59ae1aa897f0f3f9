// Opens the port of a panel, and decides who may use it.
#pragma once

#include <variant>

#include "symplant/link/net/listener.hpp"
#include "symplant/panel/access.hpp"
#include "symplant/panel/options.hpp"

namespace symplant::panel {

struct OpenPort {
  link::net::Listener listener;
  Access access;
};

/// Errors are of kind usage (address, token file) or environment (port in use).
std::variant<OpenPort, link::LinkError> open_port(const PanelOptions& options);

}  // namespace symplant::panel

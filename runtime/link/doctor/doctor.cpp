// Examines a link against a live PLC.
#include "symplant/link/doctor/doctor.hpp"

#include <utility>

#include "symplant/link/choice.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/doctor/client_doctor.hpp"
#include "symplant/link/doctor/server_doctor.hpp"
#include "symplant/link/modbus/server_link.hpp"

namespace symplant::link::doctor {

std::variant<Report, LinkError> examine(const LinkChoice& link, const tables::PlantTables& tables,
                                        const Options& options) {
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  if (is_loop(link.url)) {
    return LinkError{LinkError::Kind::usage, "`loop:` has no PLC to examine: give the URL of a link to a PLC"};
  }
  if (is_client(link.url)) {
    auto parts = client_parts(link, tables);
    if (auto* error = std::get_if<LinkError>(&parts)) return std::move(*error);
    return examine_client(std::get<client::ClientParts>(std::move(parts)), tables, options);
  }
  auto address = modbus::server_address(link.url.substr(link.url.find(':') + 1));
  if (auto* error = std::get_if<LinkError>(&address)) return std::move(*error);
  return examine_modbus_server(std::get<net::HostPort>(address), link, tables, options);
}

}  // namespace symplant::link::doctor

// The table of the kinds of links.
#include "symplant/link/kinds.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>
#include <utility>

#include "symplant/link/client/client_link.hpp"
#include "symplant/link/doctor/client_doctor.hpp"
#include "symplant/link/loop_link.hpp"
#include "symplant/link/modbus/client_codec.hpp"
#include "symplant/link/modbus/client_link_parts.hpp"
#include "symplant/link/modbus/server_doctor.hpp"
#include "symplant/link/modbus/server_link.hpp"
#include "symplant/link/opc_ua/client_link_parts.hpp"
#include "symplant/link/opc_ua/client_settings.hpp"
#include "symplant/link/opc_ua/server_doctor.hpp"
#include "symplant/link/opc_ua/server_link.hpp"
#include "symplant/link/opc_ua/status_text.hpp"
#include "symplant/link/slmp/refusal.hpp"
#include "symplant/link/slmp/slmp_link.hpp"

namespace symplant::link {

namespace {

using Parts = decltype(Kind::parts);
using tables::PlantTables;

/// The members of a link that goes to the PLC, all of which need its parts.
template <Parts parts>
struct Client {
  static client::PartsResult parts_of(std::string_view rest, const LinkChoice& link, const PlantTables& tables) {
    try {
      return parts(rest, link, tables);
    } catch (const std::system_error& error) {
      return LinkError{LinkError::Kind::environment, std::string("cannot start the link: ") + error.what()};
    }
  }
  static std::variant<LinkMap, LinkError> map(std::string_view rest, const LinkChoice& link,
                                              const PlantTables& tables) {
    auto made = parts_of(rest, link, tables);
    if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
    return client::link_map(std::get<client::ClientParts>(std::move(made)));
  }
  static LinkResult open(std::string_view rest, const LinkChoice& link, const PlantTables& tables,
                         const plant::Plant* plant) {
    auto made = parts_of(rest, link, tables);
    if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
    return client::open_client_link(std::get<client::ClientParts>(std::move(made)), link.settings, tables, plant);
  }
  static doctor::Examined examine(std::string_view rest, const LinkChoice& link, const PlantTables& tables,
                                  const doctor::Options& options) {
    auto made = parts_of(rest, link, tables);
    if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
    return doctor::examine_client(std::get<client::ClientParts>(std::move(made)), tables, options);
  }
};

using ModbusClient = Client<modbus::client_link_parts>;
using OpcUaClient = Client<opc_ua::client_link_parts>;
using SlmpClient = Client<slmp::slmp_parts>;
using Side = tables::Refusal::Side;

constexpr std::array kKinds = {
    Kind{.scheme = "loop",
         .form = "`loop:`",
         .real = false,
         .numbered = false,
         .fault = loop_fault,
         .map = nullptr,
         .open = open_loop_link,
         .examine = nullptr,
         .parts = nullptr,
         .side = {},
         .refusal_text = nullptr},
    Kind{.scheme = "modbus-tcp-server",
         .form = "`modbus-tcp-server://HOST:PORT`",
         .real = true,
         .numbered = true,
         .fault = modbus::address_fault,
         .map = modbus::server_map,
         .open = modbus::open_server_link,
         .examine = modbus::examine_server,
         .parts = nullptr,
         .side = {},
         .refusal_text = nullptr},
    Kind{.scheme = "modbus-tcp",
         .form = "`modbus-tcp://HOST:PORT`",
         .real = true,
         .numbered = true,
         .fault = modbus::client_fault,
         .map = ModbusClient::map,
         .open = ModbusClient::open,
         .examine = ModbusClient::examine,
         .parts = ModbusClient::parts_of,
         .side = Side::modbus_client,
         .refusal_text = modbus::refusal_text},
    Kind{.scheme = "slmp",
         .form = "`slmp://HOST:PORT?family=q|l|iqr|fx5`",
         .real = true,
         .numbered = false,
         .fault = slmp::slmp_fault,
         .map = SlmpClient::map,
         .open = SlmpClient::open,
         .examine = SlmpClient::examine,
         .parts = SlmpClient::parts_of,
         .side = Side::slmp_client,
         .refusal_text = slmp::refusal_text},
    Kind{.scheme = "opc-ua-server",
         .form = "`opc-ua-server://HOST:PORT`",
         .real = true,
         .numbered = false,
         .fault = opc_ua::server_fault,
         .map = opc_ua::server_map,
         .open = opc_ua::open_server_link,
         .examine = opc_ua::examine_server,
         .parts = nullptr,
         .side = {},
         .refusal_text = nullptr},
    Kind{.scheme = "opc-ua",
         .form = "`opc-ua://HOST:PORT?nodes=TEMPLATE`",
         .real = true,
         .numbered = false,
         .fault = opc_ua::client_fault,
         .map = OpcUaClient::map,
         .open = OpcUaClient::open,
         .examine = OpcUaClient::examine,
         .parts = OpcUaClient::parts_of,
         .side = Side::opc_ua_client,
         .refusal_text = opc_ua::refusal_text},
};

}  // namespace

std::span<const Kind> kinds() noexcept { return kKinds; }

const Kind* kind_of(std::string_view url) noexcept {
  const std::size_t colon = url.find(':');
  if (colon == std::string_view::npos) return nullptr;
  const auto* const found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& kind) { return kind.scheme == url.substr(0, colon); });
  return found == kKinds.end() ? nullptr : found;
}

std::string_view rest_of(std::string_view url) noexcept { return url.substr(url.find(':') + 1); }

}  // namespace symplant::link

// Links by URL: the table of schemes.
#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "symplant/link/client/client_link.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/loop_link.hpp"
#include "symplant/link/modbus/client_link_parts.hpp"
#include "symplant/link/modbus/server_link.hpp"
#include "symplant/link/slmp/slmp_link.hpp"

namespace symplant::link {

namespace {

std::string loop_fault(std::string_view rest) {
  return rest.empty() ? std::string() : "`loop:` takes nothing after the colon";
}

LinkResult open_loop(std::string_view /*rest*/, const LinkChoice& link, const tables::PlantTables& tables,
                     const plant::Plant* /*plant*/) {
  return std::make_unique<LoopLink>(tables, link.controller);
}

using Open = LinkResult (*)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant);
using Parts = client::PartsResult (*)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);

/// The scheme of a URL, and the functions that check and open what follows its colon.
struct Scheme {
  std::string_view name;
  std::string_view form;
  std::string (*fault)(std::string_view rest);
  Open open;    ///< null for a client
  Parts parts;  ///< of a client
};

constexpr std::array kSchemes = {
    Scheme{"loop", "`loop:`", loop_fault, open_loop, nullptr},
    Scheme{"modbus-tcp-server", "`modbus-tcp-server://HOST:PORT`", modbus::address_fault, modbus::open_server_link,
           nullptr},
    Scheme{"modbus-tcp", "`modbus-tcp://HOST:PORT`", modbus::client_fault, nullptr, modbus::client_link_parts},
    Scheme{"slmp", "`slmp://HOST:PORT?family=q|l|iqr|fx5`", slmp::slmp_fault, nullptr, slmp::slmp_parts},
};

std::string known_forms() {
  std::string forms;
  for (const Scheme& scheme : kSchemes) {
    if (!forms.empty()) forms += ", ";
    forms += scheme.form;
  }
  return forms;
}

/// Null if no scheme has that name.
const Scheme* scheme_of(std::string_view url) {
  const std::size_t colon = url.find(':');
  if (colon == std::string_view::npos) return nullptr;
  const auto* const found =
      std::find_if(kSchemes.begin(), kSchemes.end(), [&](const Scheme& s) { return s.name == url.substr(0, colon); });
  return found == kSchemes.end() ? nullptr : found;
}

std::string_view behind_colon(std::string_view url) { return url.substr(url.find(':') + 1); }

}  // namespace

std::string url_fault(std::string_view url) {
  const Scheme* const scheme = scheme_of(url);
  if (scheme == nullptr) return "`" + std::string(url) + "` is not a link: give one of " + known_forms();
  return scheme->fault(behind_colon(url));
}

bool is_client(std::string_view url) {
  const Scheme* const scheme = scheme_of(url);
  return scheme != nullptr && scheme->parts != nullptr;
}

client::PartsResult client_parts(const LinkChoice& link, const tables::PlantTables& tables) {
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  try {
    return scheme_of(link.url)->parts(behind_colon(link.url), link, tables);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the link: ") + error.what()};
  }
}

LinkResult open_link(const LinkChoice& link, const tables::PlantTables& tables, const plant::Plant* plant) {
  if (is_client(link.url)) {
    auto parts = client_parts(link, tables);
    if (auto* error = std::get_if<LinkError>(&parts)) return std::move(*error);
    return client::open_client_link(std::get<client::ClientParts>(std::move(parts)), link.settings, tables, plant);
  }
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  return scheme_of(link.url)->open(behind_colon(link.url), link, tables, plant);
}

}  // namespace symplant::link

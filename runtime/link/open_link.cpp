// Links by URL.
#include <utility>

#include "symplant/link/client_parts.hpp"
#include "symplant/link/kinds.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/modbus/server_link.hpp"

namespace symplant::link {

std::string url_fault(std::string_view url) {
  if (const Kind* const kind = kind_of(url)) return kind->fault(rest_of(url));
  std::string forms;
  for (const Kind& kind : kinds()) forms.append(forms.empty() ? "" : ", ").append(kind.form);
  return "`" + std::string(url) + "` is not a link: give one of " + forms;
}

bool is_client(std::string_view url) {
  const Kind* const kind = kind_of(url);
  return kind != nullptr && kind->parts != nullptr;
}

client::PartsResult client_parts(const LinkChoice& link, const tables::PlantTables& tables) {
  // A URL of a link that only reads may have settings in which `fault` finds an error; the protocol reads them again.
  if (!link.settings.reads_only || !is_client(link.url)) {
    if (std::string fault = url_fault(link.url); !fault.empty()) {
      return LinkError{LinkError::Kind::usage, std::move(fault)};
    }
  }
  return kind_of(link.url)->parts(rest_of(link.url), link, tables);
}

std::variant<LinkMap, LinkError> map_of(const LinkChoice& link, const tables::PlantTables& tables) {
  const Kind* const kind = kind_of(link.url);
  if (kind == nullptr || kind->map == nullptr) return modbus::server_map({}, link, tables);
  if (std::string fault = kind->fault(rest_of(link.url)); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  return kind->map(rest_of(link.url), link, tables);
}

LinkResult open_link(const LinkChoice& link, const tables::PlantTables& tables, const plant::Plant* plant) {
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  return kind_of(link.url)->open(rest_of(link.url), link, tables, plant);
}

}  // namespace symplant::link

// Links by URL: the table of schemes.
#include "symplant/link/link.hpp"

#include <array>

#include "symplant/link/loop_link.hpp"
#include "symplant/link/modbus/server_link.hpp"

namespace symplant::link {

namespace {

LinkResult open_loop(std::string_view rest, const LinkChoice& link, const core::PlantTables& tables,
                     const core::Plant* /*plant*/) {
  if (!rest.empty()) return LinkError{LinkError::Kind::usage, "`loop:` takes nothing behind the colon"};
  return std::make_unique<LoopLink>(tables, link.controller);
}

/// How a URL begins, and who opens what stands behind its colon.
struct Scheme {
  std::string_view name;
  std::string_view form;
  LinkResult (*open)(std::string_view rest, const LinkChoice& link, const core::PlantTables& tables,
                     const core::Plant* plant);
};

constexpr std::array kSchemes = {
    Scheme{"loop", "`loop:`", open_loop},
    Scheme{"modbus-tcp-server", "`modbus-tcp-server://HOST:PORT`", modbus::open_server_link},
};

std::string known_forms() {
  std::string forms;
  for (const Scheme& scheme : kSchemes) {
    if (!forms.empty()) forms += ", ";
    forms += scheme.form;
  }
  return forms;
}

}  // namespace

LinkResult open_link(const LinkChoice& link, const core::PlantTables& tables, const core::Plant* plant) {
  const std::string_view url = link.url;
  const std::size_t colon = url.find(':');
  for (const Scheme& scheme : kSchemes) {
    if (colon == std::string_view::npos || url.substr(0, colon) != scheme.name) continue;
    return scheme.open(url.substr(colon + 1), link, tables, plant);
  }
  return LinkError{LinkError::Kind::usage, "`" + link.url + "` names no link: give one of " + known_forms()};
}

}  // namespace symplant::link

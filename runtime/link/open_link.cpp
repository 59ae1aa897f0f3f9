// Links by URL: the table of schemes.
#include <algorithm>
#include <array>
#include <utility>

#include "symplant/link/link.hpp"
#include "symplant/link/loop_link.hpp"
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

/// The scheme of a URL, and the functions that check and open what follows its colon.
struct Scheme {
  std::string_view name;
  std::string_view form;
  std::string (*fault)(std::string_view rest);
  LinkResult (*open)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                     const plant::Plant* plant);
};

constexpr std::array kSchemes = {
    Scheme{"loop", "`loop:`", loop_fault, open_loop},
    Scheme{"modbus-tcp-server", "`modbus-tcp-server://HOST:PORT`", modbus::address_fault, modbus::open_server_link},
    Scheme{"slmp", "`slmp://HOST:PORT?family=q|l|iqr|fx5`", slmp::slmp_fault, slmp::open_slmp_link},
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

LinkResult open_link(const LinkChoice& link, const tables::PlantTables& tables, const plant::Plant* plant) {
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  return scheme_of(link.url)->open(behind_colon(link.url), link, tables, plant);
}

}  // namespace symplant::link

// The table of the kinds of links.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/doctor/options.hpp"
#include "symplant/link/doctor/report.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::link {

/// A kind of link: a row for each folder of this layer that has one. `rest` is a URL after its scheme and colon. All
/// functions except `fault` need a `rest` in which `fault` finds nothing.
struct Kind {
  std::string_view scheme;
  std::string_view form;  ///< of its URLs, for messages
  bool real;              ///< exchanges with a PLC, in real time; otherwise it carries all symbols by name
  bool numbered;          ///< an entry of `map` in plant.json gives a symbol its address by `number`

  /// Reads the settings in a URL: why it is invalid on any machine; empty if it is valid.
  std::string (*fault)(std::string_view rest);
  /// Where the symbols are; null if it carries them by name.
  std::variant<LinkMap, LinkError> (*map)(std::string_view rest, const LinkChoice& link,
                                          const tables::PlantTables& tables);
  /// As open_link().
  LinkResult (*open)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                     const plant::Plant* plant);
  /// Examines it; null if there is nothing to examine.
  doctor::Examined (*examine)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                              const doctor::Options& options);

  // Of a link that goes to the PLC; otherwise null.

  client::PartsResult (*parts)(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables);
  tables::Refusal::Side side;
  std::string (*refusal_text)(const tables::Refusal& refusal);  ///< of this side
};

std::span<const Kind> kinds() noexcept;

/// The kind of a URL; null if no kind has its scheme. O(kinds).
const Kind* kind_of(std::string_view url) noexcept;

/// What comes after the scheme and the colon of a URL.
std::string_view rest_of(std::string_view url) noexcept;

}  // namespace symplant::link

// Assigns links to the controllers whose symbols they carry.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// A link as the user requests it.
struct LinkRequest {
  std::string controller;  ///< empty: not named
  std::string url;
};

/// Splits `PLC1=URL` or `URL`: the text before a `=` names the controller if the `=` comes before the first colon.
LinkRequest parse_request(std::string_view text);

/// Whether the URL is `loop:`. On the command line `loop:` is a PLC that writes nothing; all other links are real.
bool is_loop(std::string_view url);

/// Whether only one link can have this URL: that of a server with a port other than 0 (0: any free port).
bool has_fixed_port(std::string_view url);

/// A controller as messages name it: "controller `PLC1`", "the controller without a name".
std::string controller_text(const tables::PlantTables& tables, std::uint32_t controller);

/// Assigns each request the controller whose symbols it carries. A request without a controller gets the plant's only
/// controller, else the controller without a name; `loop:` then carries the symbols of all. Errors: an unknown
/// controller, no controller where the choice is ambiguous, two links to PLCs for one controller (both would write its
/// operations), two links with one URL whose port is not 0. Names of controllers compare without regard to the case of
/// ASCII letters.
std::variant<std::vector<LinkChoice>, LinkError> choose_links(const tables::PlantTables& tables,
                                                              std::span<const LinkRequest> requests);

}  // namespace symplant::link

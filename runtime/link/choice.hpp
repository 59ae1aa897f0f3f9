// Which link carries whose symbols.
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

/// A link as it is asked for.
struct LinkRequest {
  std::string controller;  ///< empty: none is named
  std::string url;
};

/// Takes `PLC1=URL` or `URL` apart: what stands before a `=` that comes before the first colon names the controller.
LinkRequest parse_request(std::string_view text);

/// `loop:` on the command line is a PLC that writes nothing; every other link is a real one.
bool is_loop(std::string_view url);

/// Whether two links cannot both have this URL: a server's, with a port that is not 0, which is any that is free.
bool has_fixed_port(std::string_view url);

/// A controller as messages name it: "controller `PLC1`", "the controller without a name".
std::string controller_text(const tables::PlantTables& tables, std::uint32_t controller);

/// Says for each request whose symbols it carries. Where none is named it is the plant's one controller, or else the
/// one without a name; `loop:` then carries those of all. Refused: a controller that the plant has not, none named
/// where that leaves it open, two links to PLCs of one controller (each would write its operations), two links of one
/// URL with a port that is not 0. Controllers compare without regard to the case of ASCII letters.
std::variant<std::vector<LinkChoice>, LinkError> choose_links(const tables::PlantTables& tables,
                                                              std::span<const LinkRequest> requests);

}  // namespace symplant::link

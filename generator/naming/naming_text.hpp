// Writes a naming rule as the text of a naming.json.
#pragma once

#include <string>
#include <string_view>

#include "name/naming.hpp"

namespace symplant::naming {

/// JSON that read_naming() reads back as the same rule; each rule and each archetype is on a line. `links_file` is
/// written for `links`; if it is empty, the links are rows.
std::string naming_text(const name::Naming& naming, std::string_view links_file = {});

}  // namespace symplant::naming

// SP213 name-too-long: a name is longer than its engineering tool accepts.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "check/rules.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNameTooLongPage =
    R"(A symbol's name has more characters than the engineering tool of its list accepts: 32 in GX IEC Developer, 40 in
Logix Designer, 128 in TIA Portal. Lists that were written by hand or by a script have such names.

**What the model loses.** Nothing here. But an import into the engineering tool refuses the name or cuts it, and then the names
of the plant and of the program differ.

**How to fix it.** Shorten the name.
)";

struct Limit {
  std::string_view tool;  ///< the beginning of SymbolTable::title
  std::size_t characters;
};
constexpr std::array kLimits{Limit{"GX IEC Developer", 32}, Limit{"Logix Designer", 40}, Limit{"TIA Portal", 128}};

/// Null if the tool has no limit that is known.
const Limit* limit_of(const read::SymbolTable& table) {
  const auto found = std::find_if(kLimits.begin(), kLimits.end(), [&](const Limit& limit) {
    return table.title.substr(0, limit.tool.size()) == limit.tool;
  });
  return found == kLimits.end() ? nullptr : &*found;
}

void check_name_too_long(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    const Limit* limit = limit_of(*plant.lists[symbol.list].table);
    // A part of a structure or array has a longer path than its tag.
    const bool is_part = symbol.name().find_first_of(".[") != std::string_view::npos;
    if (limit == nullptr || is_part || symbol.name().size() <= limit->characters) continue;
    const std::size_t length = text::count_code_points(symbol.name());
    if (length <= limit->characters) continue;
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` has {} characters, and {} accepts {}; shorten it", symbol.name(), length,
                                limit->tool, limit->characters),
                    location_of(plant, symbol));
  }
}

}  // namespace

const Rule kNameTooLong{{"SP213", "name-too-long", diag::Severity::warning,
                         "a name is longer than its engineering tool accepts", kNameTooLongPage},
                        check_name_too_long};

}  // namespace symplant::check

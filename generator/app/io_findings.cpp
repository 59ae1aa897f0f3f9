// Findings about patterns of rows that are I/O.
#include "app/io_findings.hpp"

#include <utility>
#include <vector>

#include "description/description_rules.hpp"
#include "description/faults.hpp"

namespace symplant::app {

void add_io_findings(const name::IoRows& io, const std::shared_ptr<const description::PlantSource>& source,
                     diag::Diagnostics& diagnostics) {
  using description::FaultKind;
  std::vector<description::DescriptionFault> located;
  const auto add = [&](const name::IoRows::Pattern& pattern, std::string message, FaultKind kind) {
    if (pattern.pointer.empty()) {
      diagnostics.add(description::rule_of(kind), std::move(message), {});
    } else {
      located.push_back({pattern.pointer, std::move(message), 0, kind});
    }
  };
  for (const name::IoRows::Pattern& pattern : io.patterns()) {
    const std::string text = description::ticked(pattern.text);
    if (pattern.matched == 0) {
      add(pattern,
          text +
              " matches no row whose address is internal or missing; correct it, or remove it if the rows are I/O by "
              "their address",
          FaultKind::matches_nothing);
    } else if (!pattern.also.empty()) {
      add(pattern,
          text + " matches " + description::ticked(pattern.also) +
              ", which is also given the other direction; make one of the patterns narrower",
          FaultKind::contradiction);
    }
  }
  if (!located.empty()) description::add_findings(*source, located, diagnostics);
}

}  // namespace symplant::app

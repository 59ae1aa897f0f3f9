// Findings about the URLs of a plant's links.
#include "map/url_findings.hpp"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/description_rules.hpp"
#include "description/faults.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/link.hpp"

namespace symplant::map {

void add_url_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  const std::vector<description::LinkDescription>& links = plant.description->links;
  std::vector<description::DescriptionFault> faults;
  std::set<std::string_view> ports;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::string& url = links[i].url;
    if (url.empty()) continue;  // reported as a fault of its form
    const std::string pointer = (description::Pointer("/links") / i / "url").text();
    if (std::string fault = link::url_fault(url); !fault.empty()) {
      faults.push_back({pointer, std::move(fault), 0, description::FaultKind::shape});
    } else if (link::has_fixed_port(url) && !ports.insert(url).second) {
      faults.push_back({pointer, "another link already has this port: give each link a different port", 0,
                        description::FaultKind::contradiction});
    }
  }
  description::add_findings(*plant.description_source, faults, diagnostics);
}

}  // namespace symplant::map

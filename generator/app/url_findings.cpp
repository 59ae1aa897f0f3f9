// What is wrong with the URLs of a plant's links.
#include "app/url_findings.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "model/description_rules.hpp"
#include "model/faults.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/link.hpp"

namespace symplant::app {

void add_url_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  const std::vector<model::LinkDescription>& links = plant.description->links;
  std::vector<model::DescriptionFault> faults;
  for (auto link = links.begin(); link != links.end(); ++link) {
    if (link->url.empty()) continue;  // its form is at fault
    const auto place = static_cast<std::size_t>(link - links.begin());
    const std::string pointer = (model::Pointer("/links") / place / "url").text();
    if (std::string fault = link::url_fault(link->url); !fault.empty()) {
      faults.push_back({pointer, std::move(fault), 0, model::FaultKind::shape});
    } else if (std::any_of(links.begin(), link,
                           [&](const auto& other) { return link::share_port(other.url, link->url); })) {
      faults.push_back({pointer, "another link has this port already: give each a port of its own", 0,
                        model::FaultKind::contradiction});
    }
  }
  model::add_findings(plant.description_source, faults, diagnostics);
}

}  // namespace symplant::app

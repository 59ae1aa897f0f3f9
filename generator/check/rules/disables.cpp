// Rules: devices that disable others.
#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

using Edges = std::vector<std::vector<std::uint32_t>>;

Edges disables_of(const model::PlantModel& plant) {
  Edges edges(plant.units.size());
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    std::vector<std::uint32_t>& to = edges[u];
    for (const auto& disabled : plant.units[u].disables) to.insert(to.end(), disabled.begin(), disabled.end());
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
  }
  return edges;
}

/// A strongly connected part of several units.
struct Entangled {
  std::uint32_t first;
  std::size_t units;
};

std::vector<Entangled> entangled_units(const Edges& edges) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(edges.size());
  for (std::size_t from = 0; from < edges.size(); ++from) {
    for (const std::uint32_t to : edges[from]) boost::add_edge(from, to, graph);
  }
  std::vector<std::size_t> part_of(edges.size());
  const std::size_t parts = boost::strong_components(
      graph, boost::make_iterator_property_map(part_of.begin(), boost::get(boost::vertex_index, graph)));
  std::vector<std::size_t> units_in(parts);
  for (const std::size_t part : part_of) ++units_in[part];
  std::vector<Entangled> entangled;
  for (std::uint32_t unit = 0; unit < edges.size(); ++unit) {
    std::size_t& units = units_in[part_of[unit]];
    if (units > 1) entangled.push_back({unit, units});
    units = 0;  // reported
  }
  return entangled;
}

/// A shortest circle through `start`, from it on, within one strongly connected part.
std::vector<std::uint32_t> circle_through(std::uint32_t start, const Edges& edges) {
  std::unordered_map<std::uint32_t, std::uint32_t> before;
  std::deque<std::uint32_t> open{start};
  while (!open.empty()) {
    const std::uint32_t at = open.front();
    open.pop_front();
    for (const std::uint32_t to : edges[at]) {
      if (to == start) {
        std::vector<std::uint32_t> circle;
        for (std::uint32_t u = at; u != start; u = before[u]) circle.push_back(u);
        circle.push_back(start);
        std::reverse(circle.begin(), circle.end());
        return circle;
      }
      if (before.try_emplace(to, at).second) open.push_back(to);
    }
  }
  return {};  // never: it is in a part of several
}

/// Which state of `by` disables `unit`, and where that is said.
struct Step {
  std::string state;
  diag::Location location;
};

Step step_of(const model::PlantModel& plant, std::uint32_t by, std::uint32_t unit) {
  const model::Unit& from = plant.units[by];
  for (std::uint32_t s = 0; s < from.disables.size(); ++s) {
    const auto& disabled = from.disables[s];
    if (!std::binary_search(disabled.begin(), disabled.end(), unit)) continue;
    std::string written = from.states[s].name;
    for (const description::GivenDisables& given : from.described->disables) {
      if (text::equal_ignoring_case(given.state, written)) written = given.state;
    }
    return {from.states[s].name,
            described_location(plant, from,
                               description::key_pointer(*from.described, description::DeviceKey::disables) / written)};
  }
  return {};  // never: there is an edge
}

void check_cycle_of_disables(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (!is_described(subject)) return;
  const Edges edges = disables_of(plant);
  for (const Entangled& part : entangled_units(edges)) {
    const std::vector<std::uint32_t> circle = circle_through(part.first, edges);
    std::string text;
    std::vector<diag::Related> others;
    diag::Subjects subjects;
    diag::Location location;
    for (std::size_t i = 0; i < circle.size(); ++i) {
      const std::uint32_t next = circle[(i + 1) % circle.size()];
      const model::Unit& unit = plant.units[circle[i]];
      Step step = step_of(plant, circle[i], next);
      subjects.about.push_back(device(unit.path));
      text += fmt::format("{}`{}` in `{}` disables `{}`", i == 0 ? "" : ", ", unit.path, step.state,
                          plant.units[next].path);
      if (i == 0) {
        location = std::move(step.location);
      } else {
        others.push_back(
            {std::move(step.location), fmt::format("`{}` disables `{}` here", unit.path, plant.units[next].path)});
      }
    }
    const std::size_t more = part.units - circle.size();
    diagnostics.add(rule.info, std::move(subjects),
                    fmt::format("{}: once all are in these states, none can leave{}; remove one of these", text,
                                more == 0 ? "" : fmt::format(" ({} more devices are in cycles with them)", more)),
                    std::move(location), std::move(others));
  }
}

}  // namespace

const Rule kCycleOfDisables{
    {"SP613", "cycle-of-disables", diag::Severity::warning, "devices disable each other in a cycle",
     R"(A state of device A disables device B, and a state of B disables A, or the cycle is longer. A disabled device still disables
others while it is in its state.

**What the model loses.** Once all of them are in these states, none can leave: the plant is stuck until reset, or until a
scenario or a person moves one of them. It is enough that two devices enter their states in the same instant.

**How to fix it.** Let one device disable the other only in states in which the other cannot disable it, or use a condition
(`when`) on the transition instead of `disables`.
)"},
    check_cycle_of_disables};

}  // namespace symplant::check

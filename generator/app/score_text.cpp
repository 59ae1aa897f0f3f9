// The score of a plant, for people.
#include "app/score_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "diag/visible_text.hpp"
#include "score/levels.hpp"
#include "score/questions.hpp"
#include "score/shapes.hpp"

namespace symplant::app {
namespace {

using name::Account;
using score::Shape;

constexpr std::size_t kMostStations = 20;
constexpr std::size_t kMostShapes = 5;
constexpr std::size_t kMostShapesVerbose = 20;

/// `one` or `several`, by the count.
std::string_view number(std::size_t count, std::string_view one, std::string_view several) {
  return count == 1 ? one : several;
}

std::string_view reason(Account account, bool one) {
  switch (account) {
    case Account::no_rule:
      return one ? "matches no rule" : "match no rule";
    case Account::no_direction:
      return one ? "has no direction" : "have no direction";
    case Account::no_operation:
      return one ? "has no operation" : "have no operation";
    case Account::no_event:
      return one ? "has no event" : "have no event";
    case Account::task_taken:
      return one ? "has the task of another symbol" : "have the tasks of other symbols";
    case Account::unit_too_large:
      return one ? "is in a device with too many symbols" : "are in devices with too many symbols";
    case Account::named_internal:
      return one ? "is neither operation nor event by name" : "are neither operations nor events by name";
    case Account::role_none:
      return one ? "has the role `none`" : "have the role `none`";
    default:
      return "";
  }
}

/// "S10_I_ROB_READY"; of a symbol that is known by its comment "X1A0: ROB READY".
std::string example_of(const model::PlantModel& plant, const Shape& shape) {
  const model::Symbol& first = plant.symbols[shape.first];
  const std::string text(score::known_text(plant, first, score::reads_comments_only(plant)));
  return diag::visible(text == first.name() ? text : fmt::format("{}: {}", first.name(), text));
}

/// "  and 3 more stations, ...", if some are left out.
std::string rest_of(std::size_t count, std::string_view one, std::string_view several, std::string_view of_them) {
  return count == 0 ? "" : fmt::format("  and {} more {}{}\n", count, number(count, one, several), of_them);
}

std::string stations_text(const model::PlantModel& plant, const score::PlantScore& score) {
  std::vector<score::Part> stations = score::parts_of(plant, score, score::Level::station);
  if (stations.size() < 2) return "";
  std::stable_sort(stations.begin(), stations.end(), [](const score::Part& a, const score::Part& b) {
    return a.counts.left_over() > b.counts.left_over();
  });
  std::string text =
      fmt::format("  {:<24} {:>8} {:>8} {:>14} {:>10}\n", "station", "symbols", "paired", "accounted for", "left over");
  for (std::size_t i = 0; i < std::min(stations.size(), kMostStations); ++i) {
    const score::Counts& counts = stations[i].counts;
    const std::string name = stations[i].path();
    text += fmt::format("  {:<24} {:>8} {:>6} % {:>12} % {:>10}\n", name.empty() ? "(none)" : diag::visible(name),
                        counts.counted(), percent_of(counts.paired(), counts.counted()),
                        percent_of(counts.accounted(), counts.counted()), counts.left_over());
  }
  return text + rest_of(stations.size() - std::min(stations.size(), kMostStations), "station", "stations", "");
}

std::string left_over_text(const model::PlantModel& plant, const score::PlantScore& score, std::size_t most) {
  const std::vector<Shape> shapes = score::left_over_shapes(plant, score);
  if (shapes.empty()) return "";
  std::string text = "  left over, the most frequent shapes first; # is a number:\n";
  std::size_t left = score.total.left_over();
  const std::size_t shown = std::min(shapes.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    const Shape& shape = shapes[i];
    left -= shape.count;
    text += fmt::format("  {:>6} {} like {} {} ({})\n", shape.count, number(shape.count, "symbol", "symbols"),
                        diag::visible(shape.text), reason(shape.account, shape.count == 1), example_of(plant, shape));
  }
  return text + rest_of(left, "symbol", "symbols", fmt::format(" of {} shapes", shapes.size() - shown));
}

std::string questions_text(const model::PlantModel& plant, const score::PlantScore& score) {
  const score::Questions questions = score::questions_of(plant, score);
  if (questions.shapes.empty()) return "";
  std::string text = "  a PLC often waits for these before it starts; make them constant:\n";
  std::size_t left = 0;
  for (std::size_t i = 0; i < questions.shapes.size(); ++i) {
    const Shape& shape = questions.shapes[i];
    if (i >= kMostShapesVerbose) {
      left += shape.count;
    } else {
      text += fmt::format("  {:>6} like {} ({})\n", shape.count, diag::visible(shape.text), example_of(plant, shape));
    }
  }
  text += rest_of(left, "event", "events", "");
  if (plant.levels() != nullptr)
    return text + "  give those that are on in a healthy plant the initial value TRUE in the list\n";
  return text + "  to do so, put this first in `rest` of naming.json, and keep only the correct words:\n    " +
         questions.rule() + "\n";
}

}  // namespace

std::size_t percent_of(std::size_t count, std::size_t of) { return of == 0 ? 0 : (count * 100 + of / 2) / of; }

std::string_view reason_text(Account account) { return reason(account, false); }

std::string score_text(const score::Counts& counts) {
  const std::size_t all = counts.counted();
  std::string text =
      fmt::format("of {} BOOL I/O {} {} ({} %) paired, {} ({} %) accounted for: {} constant, {} operator, {} data", all,
                  number(all, "symbol", "symbols"), counts.paired(), percent_of(counts.paired(), all),
                  counts.accounted(), percent_of(counts.accounted(), all), counts.of(Account::constant),
                  counts.of(Account::operator_panel), counts.of(Account::data));
  if (counts.of(Account::interlock) != 0) {
    text += fmt::format(", {} {}", counts.of(Account::interlock),
                        number(counts.of(Account::interlock), "interlock", "interlocks"));
  }
  if (counts.of(Account::senses_parts) != 0)
    text += fmt::format(", {} {}", counts.of(Account::senses_parts),
                        number(counts.of(Account::senses_parts), "sensor of parts", "sensors of parts"));
  if (counts.of(Account::follows) != 0) text += fmt::format(", {} by `follow`", counts.of(Account::follows));
  if (counts.of(Account::condition) != 0)
    text += fmt::format(", {} read by `material`, `values`, `follow` or `malfunctions`", counts.of(Account::condition));
  return text;
}

std::string score_details(const model::PlantModel& plant, const score::PlantScore& score, bool verbose) {
  if (!verbose) return plant.levels() != nullptr ? "" : left_over_text(plant, score, kMostShapes);
  return stations_text(plant, score) + left_over_text(plant, score, kMostShapesVerbose) + questions_text(plant, score);
}

}  // namespace symplant::app

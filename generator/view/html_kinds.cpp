// The structures and layouts that devices share in the data of the page.
#include "view/html_kinds.hpp"

#include <utility>

#include "base/text_source.hpp"
#include "diag/visible_text.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using diag::visible;
using model::kNone;

int place_or_none(std::uint32_t position) { return position == kNone ? -1 : static_cast<int>(position); }

/// A layout as arrays of numbers, which the page draws unchanged.
void write_layout(const LayoutKey& key, JsonWriter& json) {
  const Layout layout = lay_out(key);
  json.begin_object();
  json.member("width", layout.width);
  json.member("height", layout.height);
  json.key("box");
  json.row(layout.box_width, layout.box_height);
  json.key("states");
  json.array(layout.states, [&](const Point& state) { json.row(state.x, state.y); });
  json.key("arrows");
  json.begin_array();
  for (std::size_t i = 0; i < layout.arrows.size(); ++i) {
    const ArrowPosition& arrow = layout.arrows[i];
    json.row(arrow.begin.x, arrow.begin.y, arrow.control.x, arrow.control.y, arrow.end.x, arrow.end.y, arrow.label.x,
             arrow.label.y, key.arrows[i].columns * kLetterWidth);
  }
  json.end_array();
  json.end_object();
}

class KindWriter {
 public:
  KindWriter(const model::Unit& unit, const model::PlantModel& plant, JsonWriter& json)
      : unit_(unit), plant_(plant), json_(json) {}

  void write(const Chart& chart, std::size_t layout) {
    json_.begin_object();
    json_.member("actuation", description::actuation_name(unit_.actuation));
    json_.member("rest", place_or_none(unit_.rest));
    json_.key("inferences");
    json_.array(inferences(unit_), [&](std::string_view sentence) { json_.value(sentence); });
    json_.key("states");
    json_.array(chart.states, [&](const ChartState& state) { json_.row(visible(state.name), visible(state.symbols)); });
    write_tasks("operations", unit_.operations);
    write_tasks("events", unit_.events);
    write_edges(chart);
    write_transitions("internal", false);
    write_transitions("external", true);
    write_outputs("enter", true);
    write_outputs("leave", false);
    json_.member("layout", layout);
    json_.end_object();
  }

 private:
  void write_tasks(std::string_view key, const std::vector<std::uint32_t>& symbols) {
    json_.key(key);
    json_.array(symbols, [&](std::uint32_t symbol) { json_.value(visible(plant_.symbols[symbol].reading.task())); });
  }

  void write_edges(const Chart& chart) {
    json_.key("edges");
    json_.array(chart.edges, [&](const ChartEdge& edge) {
      json_.begin_array();
      json_.value(edge.from == kEveryOther ? -1 : static_cast<int>(edge.from));
      json_.value(edge.to);
      json_.value(edge.automatic ? 1 : 0);
      json_.array(edge.label, [&](const std::string& line) { json_.value(visible(line)); });
      json_.end_array();
    });
  }

  void write_transitions(std::string_view key, bool commanded) {
    const auto write = [&](const model::Transition& t) {
      if ((t.on != kNone) != commanded) return;
      const TransitionText transition = transition_text(t, unit_, plant_);
      json_.row(t.from, t.to, visible(transition.on), t.when == kNone ? 0 : t.when + 1, transition.after,
                transition.takes, t.once ? 1 : 0, origin_text(t.origin), t.during == kNone ? 0 : t.during + 1,
                transition.numbers);
    };
    json_.key(key);
    json_.begin_array();
    for (const model::Transition& transition : unit_.transitions) write(transition);
    for (const model::Transition& transition : spring_returns(unit_)) write(transition);
    json_.end_array();
  }

  void write_outputs(std::string_view key, bool entering) {
    json_.key(key);
    json_.begin_array();
    for (std::uint32_t s = 0; s < unit_.states.size(); ++s) {
      json_.array(switched(unit_, s, entering),
                  [&](const auto& output) { json_.row(output.first, output.second ? 1 : 0); });
    }
    json_.end_array();
  }

  const model::Unit& unit_;
  const model::PlantModel& plant_;
  JsonWriter& json_;
};

}  // namespace

std::uint32_t PageKinds::of(const model::Unit& unit) {
  const Chart chart = chart_of(unit, plant_, Conditions::by_number);
  const std::size_t layout = layout_of(chart);
  std::string text = base::text_of([&](base::TextSink& sink) {
    JsonWriter json(sink, JsonWriter::Form::compact);
    KindWriter(unit, plant_, json).write(chart, layout);
    json.finish();
  });
  const auto [position, added] = positions_.try_emplace(std::move(text), static_cast<std::uint32_t>(texts_.size()));
  if (added) texts_.push_back(position->first);
  return position->second;
}

void PageKinds::write(JsonWriter& json) const {
  json.key("layouts");
  json.array(layouts_, [&](const LayoutKey* key) { write_layout(*key, json); });
  json.key("kinds");
  json.array(texts_, [&](std::string_view text) { json.literal(text); });
}

std::size_t PageKinds::layout_of(const Chart& chart) {
  const auto [position, added] = layout_positions_.try_emplace(layout_key(chart), layouts_.size());
  if (added) layouts_.push_back(&position->first);
  return position->second;
}

}  // namespace symplant::view

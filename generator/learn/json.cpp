// What was learned, as JSON for programs.
#include <string>
#include <utility>

#include "learn/formats.hpp"
#include "learn/pairs_formats.hpp"
#include "learn/proposal.hpp"
#include "learn/words.hpp"
#include "view/duration_json.hpp"
#include "view/json_writer.hpp"

namespace symplant::learn {
namespace {

class JsonForm {
 public:
  JsonForm(const Learned& learned, base::TextSink& sink)
      : learned_(learned), plant_(*learned.plant), json_(sink, view::JsonWriter::Form::indented) {}

  void write() {
    json_.begin_object();
    json_.member("symplant-learn", kJsonVersion);
    json_.key("recordings");
    json_.array(learned_.sources, [&](const Source& source) {
      json_.begin_object();
      json_.member("file", source.name);
      json_.member("end", source.length);
      json_.member("resolution", source.resolution);
      json_.end_object();
    });
    json_.member("moves", learned_.moves);
    json_.member("moves_not_used", learned_.unused);
    json_.key("not_used");
    json_.array(learned_.unused_moves, [&](const UnusedMoves& moves) {
      json_.begin_object();
      json_.member("device", plant_.units[moves.unit].path);
      json_.member("moves", moves.all());
      json_.member("uncaused", moves.uncaused);
      json_.member("turned", moves.turned);
      if (moves.reason != UnusedReason::few) json_.member("reason", reason_name(moves.reason));
      json_.end_object();
    });
    json_.key("times");
    json_.array(time_rows(learned_), [&](const TimeRow& row) { write_time(row); });
    json_.key("not_seen");
    write_not_seen();
    json_.key("pairs");
    write_pairs(learned_.pairs, plant_, json_);
    json_.end_object();
    json_.finish();
  }

 private:
  void write_time(const TimeRow& row) {
    const LearnedTime& time = *row.time;
    json_.begin_object();
    json_.member("name", row.group->name);
    json_.key("devices");
    json_.array(row.group->units, [&](std::uint32_t unit) { json_.value(plant_.units[unit].path); });
    if (!row.of.empty()) json_.member("transition", row.of);
    json_.member("time", row.kind);
    json_.key("learned");
    view::write_time(time.proposed, json_);
    json_.key("model");
    row.model.kind == description::Duration::Kind::fixed&& row.model.a == tables::kNever
        ? json_.value("never")
        : view::write_time(row.model, json_);
    json_.member("resolution", time.resolution);
    json_.member("n", time.statistics.count);
    json_.member("min", time.statistics.min);
    json_.member("median", time.statistics.median);
    json_.member("p95", time.statistics.p95);
    json_.member("max", time.statistics.max);
    write_groups(time);
    write_samples(time);
    json_.end_object();
  }

  void write_groups(const LearnedTime& time) {
    const Time digit = digit_of(time.resolution);
    json_.key("groups");
    json_.array(time.clusters.kept, [&](const Cluster& cluster) {
      json_.begin_object();
      json_.member("n", cluster.size());
      json_.member("min", rounded(time.samples[cluster.begin].duration, digit));
      json_.member("max", rounded(time.samples[cluster.end - 1].duration, digit));
      json_.end_object();
    });
    if (!time.explanation) return;
    const Explanation& explanation = *time.explanation;
    json_.key("explanation");
    json_.begin_object();
    if (explanation.unit != kNone) {
      json_.member("device", plant_.units[explanation.unit].path);
    } else {
      json_.member("location", explanation.location);
    }
    json_.key("group_of");
    json_.begin_object();
    for (const Explanation::Value& value : explanation.values) json_.member(value.name, value.group);
    json_.end_object();
    json_.member("explained", explanation.right);
    json_.member("of", explanation.moves);
    json_.member("others", explanation.others);
    json_.end_object();
  }

  /// All durations, each with the time of its cause, the recording and the device.
  void write_samples(const LearnedTime& time) {
    json_.key("outliers");
    json_.array(time.clusters.outliers, [&](std::size_t i) { json_.value(i); });
    json_.key("samples");
    json_.array(time.samples, [&](const Sample& sample) {
      json_.row(sample.duration, sample.at, sample.input, plant_.units[sample.unit].path);
    });
  }

  void write_not_seen() {
    const NotSeen& not_seen = learned_.not_seen;
    const auto names = [&](std::string_view key, const std::vector<std::uint32_t>& of, const auto& name) {
      json_.key(key);
      json_.array(of, [&](std::uint32_t index) { json_.value(name(index)); });
    };
    const auto symbol = [&](std::uint32_t index) { return plant_.symbols[index].name(); };
    json_.begin_object();
    names("devices", not_seen.devices, [&](std::uint32_t unit) { return plant_.units[unit].path; });
    json_.key("transitions");
    json_.array(not_seen.transitions, [&](const std::pair<std::uint32_t, std::uint32_t>& of) {
      json_.row(plant_.units[of.first].path, transition_name(plant_, of.first, of.second));
    });
    names("events", not_seen.events, symbol);
    names("not_recorded", not_seen.symbols, symbol);
    json_.key("unknown_names");
    json_.array(not_seen.names, [&](const UnknownName& unknown) {
      json_.begin_object();
      json_.member("name", unknown.name);
      json_.member("file", learned_.sources[unknown.input].name);
      if (!unknown.nearest.empty()) json_.member("nearest", unknown.nearest);
      json_.end_object();
    });
    json_.end_object();
  }

  const Learned& learned_;
  const model::PlantModel& plant_;
  view::JsonWriter json_;
};

}  // namespace

void write_json(const Learned& learned, base::TextSink& sink) { JsonForm(learned, sink).write(); }

}  // namespace symplant::learn

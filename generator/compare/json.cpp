// A comparison as JSON, for programs: every difference.
#include <algorithm>
#include <string>

#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "view/json_writer.hpp"

namespace symplant::compare {
namespace {

using Kind = Difference::Kind;

void write_value(view::JsonWriter& json, std::string_view key, const Difference& difference, double value) {
  if (difference.of->kind == Series::Kind::number) {
    json.member(key, value);
  } else {
    json.member(key, value != 0);
  }
}

void write_element(view::JsonWriter& json, const Series& series) {
  if (series.kind == Series::Kind::parts) {
    json.member("location", series.name);
    json.member("kind_of_part", series.part);
  } else {
    json.member("symbol", series.name);
  }
}

void write_difference(view::JsonWriter& json, const Difference& difference) {
  json.begin_object();
  std::string kind(kind_name(difference.kind));
  std::replace(kind.begin(), kind.end(), ' ', '_');
  json.member("kind", kind);
  json.member("t", difference.time);
  if (difference.of == nullptr) {
    json.member("changes", difference.changes);
  } else {
    write_element(json, *difference.of);
    if (difference.kind != Kind::unexpected) write_value(json, "expected", difference, difference.expected);
    if (difference.kind == Kind::unexpected || difference.kind == Kind::deviates) {
      write_value(json, "actual", difference, difference.actual);
    }
    if (difference.is_pulse) {
      json.member("pulse", difference.by);
    } else if (difference.by != 0) {
      json.member("by", difference.by);
    }
  }
  json.end_object();
}

void write_trace(view::JsonWriter& json, std::string_view key, const Recording& recorded) {
  json.key(key);
  json.begin_object();
  json.member("file", recorded.name);
  json.member("end", recorded.end);
  json.member("resolution", recorded.resolution);
  json.end_object();
}

}  // namespace

void write_json(const Comparison& comparison, base::TextSink& sink) {
  write_json(
      comparison, [](view::JsonWriter&) {}, sink);
}

void write_json(const Comparison& comparison, const std::function<void(view::JsonWriter&)>& more,
                base::TextSink& sink) {
  view::JsonWriter json(sink, view::JsonWriter::Form::indented);
  json.begin_object();
  json.member("symplant-compare", kJsonVersion);
  write_trace(json, "expected", *comparison.expected);
  write_trace(json, "actual", *comparison.actual);
  json.member("window", comparison.window);
  json.member("equal", comparison.differences.empty());
  json.member("elements", comparison.compared.size());
  json.member("changes", comparison.changes);
  json.key("differences");
  json.array(comparison.differences, [&](const Difference& difference) { write_difference(json, difference); });
  json.key("not_recorded");
  json.array(comparison.not_recorded, [&](const Series* series) { json.value(name_of(*series)); });
  more(json);
  json.end_object();
  json.finish();
}

}  // namespace symplant::compare

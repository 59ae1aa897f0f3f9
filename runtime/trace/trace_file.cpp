// Writes the trace to a file.
#include "symplant/trace/trace_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "symplant/tables/names.hpp"
#include "symplant/trace/malfunction_text.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::trace {

TraceFile::TraceFile(OutputFile file, const tables::PlantTables& tables, std::uint64_t model_hash, std::uint64_t seed,
                     tables::Time cycle, std::span<const PlantNames::Program> programs)
    : tables_(tables),
      plant_names_(tables),
      file_(std::move(file)),
      head_(fmt::format(R"({{"symplant-trace":1,"plant":{},"model_hash":"{:016x}","seed":{},"clock":"{}")",
                        json_string(tables.name), model_hash, seed, cycle == 0 ? "virtual" : "real")) {
  if (cycle != 0) head_ += fmt::format(R"(,"cycle":{})", cycle);
  add_programs(programs);
  begin();
}

TraceFile::TraceFile(OutputFile file, const tables::PlantTables& tables, std::uint64_t model_hash,
                     const RecordedFrom& from)
    : tables_(tables),
      plant_names_(tables),
      file_(std::move(file)),
      head_(fmt::format(
          R"({{"symplant-trace":1,"plant":{},"model_hash":"{:016x}","clock":"real","recorded":true,"link":{},"every":{},"utc":"{}")",
          json_string(tables.name), model_hash, json_string(from.link), from.every, from.utc)),
      recorded_(true),
      has_values_(tables.symbols.size()) {
  begin();
}

/// Prepares the texts of lines, and writes the header.
void TraceFile::begin() {
  const tables::PlantTables& tables = tables_;
  const auto texts = tables::split_names(tables.symbol_names);
  names_.reserve(tables.symbols.size());
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) {
    names_.push_back(",\"symbol\":" + json_string(texts[i]) + ",\"value\":");
  }
  const auto add = [](std::string_view blob, std::vector<std::string>& names) {
    for (const std::string_view name : tables::split_names(blob)) names.push_back(json_string(name));
  };
  add(tables.material.location_names, locations_);
  add(tables.material.kind_names, kinds_);
  for (std::uint32_t output = 0; output < tables.values.outputs; ++output) {
    outputs_.push_back(",\"value\":" + json_string(plant_names_.output(output)) + ",\"is\":");
  }
  file_.put(head_);
  file_.put("}\n");
}

/// `,"programs":[{"name":"cell","digest":"..","period":10000000,"delay":10000000,"writes":["Y0"]}]` in the header.
void TraceFile::add_programs(std::span<const PlantNames::Program> programs) {
  if (programs.empty()) return;
  head_ += ",\"programs\":[";
  for (const PlantNames::Program& program : programs) {
    head_ += fmt::format(R"({}{{"name":{},"digest":"{}","period":{},"delay":{},"writes":[)",
                         &program == programs.data() ? "" : ",", json_string(program.name), program.digest,
                         program.period, program.delay);
    bool first = true;
    for (std::uint32_t symbol = 0; symbol < program.written.size(); ++symbol) {
      if (!program.written[symbol]) continue;
      head_ += (first ? "" : ",") + json_string(plant_names_.symbol(symbol));
      first = false;
    }
    head_ += "]}";
  }
  head_ += "]";
}

void TraceFile::put_time(tables::Time time) {
  has_lines_ = true;
  if (time != last_time_) {
    last_time_ = time;
    time_ = "{\"t\":" + std::to_string(time);
  }
  if (instant_ != 0) {
    const std::uint64_t number = std::exchange(instant_, 0);
    if (time == instant_time_) file_.put(fmt::format("{},\"instant\":{}}}\n", time_, number));
  }
  file_.put(time_);
}

void TraceFile::instant(tables::Time time, std::uint64_t number) {
  instant_ = number;
  instant_time_ = time;
}

void TraceFile::put_part(const PartRecord& part) {
  put_time(part.time);
  file_.put(fmt::format(R"(,"part":{},"kind":{})", part.number, kinds_[part.kind]));
  const auto put_location = [this](std::string_view key, std::uint32_t location) {
    file_.put(fmt::format(R"(,"{}":{})", key, location == tables::kOut ? R"("out")" : locations_[location]));
  };
  if (!part.changed()) {
    if (!part.made()) put_location("from", part.from);
    put_location("to", part.to);
    if (part.to != tables::kOut && tables_.material.is_track(part.to)) file_.put(fmt::format(R"(,"x":{})", part.x));
  }
  if (part.by_hand) file_.put(R"(,"by":"hand")");
  file_.put("}\n");
}

void TraceFile::put_malfunction(const Record& record) {
  put_time(record.time);
  file_.put(fmt::format(R"(,"malfunction":{},"active":{},"by":"{}"}})",
                        json_string(plant_names_.malfunction(record.of)), record.more,
                        malfunction_by(static_cast<engine::MalfunctionChange::By>(record.value))));
  file_.put("\n");
}

void TraceFile::write(const Record& record) {
  if (!file_.is_open()) return;
  if (record.kind == Record::Kind::part) part_ = record;
  if (record.kind == Record::Kind::part_move) put_part(part_record(part_, record));
  if (record.kind == Record::Kind::malfunction) put_malfunction(record);
  if (record.kind == Record::Kind::value) {
    put_time(record.time);
    file_.put(outputs_[record.of]);
    file_.put(json_value(tables::DataType::lreal, record.value));
    file_.put("}\n");
  }
  if (record.kind != Record::Kind::change) return;
  if (recorded_) has_values_[record.of] = true;
  put_time(record.time);
  file_.put(names_[record.of]);
  const tables::DataType type = tables_.symbols[record.of].type();
  if (type == tables::DataType::boolean) {
    file_.put(record.value != 0 ? "true}\n" : "false}\n");
  } else {
    file_.put(json_value(type, record.value));
    file_.put("}\n");
  }
}

void TraceFile::part(tables::Time time, const History& history) {
  if (!file_.full() || !has_lines_) return;
  file_.begin_again();
  file_.put(head_);
  file_.put(fmt::format(R"(,"part":{},"t":{})", ++parts_, time));
  put_values(history);
  if (every_ != 0) interval(time, every_);
  has_lines_ = false;
}

void TraceFile::set_back(std::string_view what, std::string_view name, tables::Time time, const History& history) {
  if (!file_.is_open()) return;
  instant_ = 0;
  put_time(time);
  file_.put(fmt::format(R"(,"{}":{})", what, json_string(name)));
  put_values(history);
}

void TraceFile::act(tables::Time time, std::string_view json, std::string_view by) {
  if (!file_.is_open()) return;
  put_time(time);
  file_.put(fmt::format(R"(,"act":{},"by":"{}"}})"
                        "\n",
                        json, by));
}

void TraceFile::quality(tables::Time time, std::string_view device, bool well) {
  if (!file_.is_open()) return;
  put_time(time);
  file_.put(fmt::format(",\"quality\":{{{}:{}}}}}\n", json_string(device), well));
}

void TraceFile::gap(tables::Time time, tables::Time length) {
  if (!file_.is_open()) return;
  put_time(time);
  file_.put(fmt::format(",\"gap\":{}}}\n", length));
}

void TraceFile::interval(tables::Time time, tables::Time every) {
  if (!file_.is_open()) return;
  every_ = every;
  put_time(time);
  file_.put(fmt::format(",\"every\":{}}}\n", every));
}

void TraceFile::end(tables::Time time, tables::Time every) {
  if (!file_.is_open()) return;
  put_time(time);
  file_.put(every == 0 ? ",\"end\":true}\n" : fmt::format(",\"end\":true,\"every\":{}}}\n", every));
}

void TraceFile::lost(tables::Time time, std::uint64_t changes) {
  if (!file_.is_open()) return;
  put_time(time);
  file_.put(fmt::format(",\"lost\":{}}}\n", changes));
}

/// The last keys of a line: all values that are not off or 0, and the active malfunctions.
void TraceFile::put_values(const History& history) {
  file_.put(",\"values\":{");
  bool first = true;
  for (std::uint32_t i = 0; i < tables_.symbols.size(); ++i) {
    if (recorded_ ? !has_values_[i] : history.value(i) == 0) continue;
    const std::string& name = names_[i];  // ,"symbol":"NAME","value":
    constexpr std::size_t kBefore = sizeof(",\"symbol\":") - 1;
    constexpr std::size_t kBehind = sizeof(",\"value\":") - 1;
    if (!first) file_.put(",");
    first = false;
    file_.put(std::string_view(name).substr(kBefore, name.size() - kBefore - kBehind));
    file_.put(":");
    file_.put(json_value(tables_.symbols[i].type(), history.value(i)));
  }
  file_.put("}");
  put_malfunctions(history);
  file_.put("}\n");
}

/// `,"malfunctions":[["eye blind","hand"]]`, unless none is active.
void TraceFile::put_malfunctions(const History& history) {
  if (history.malfunctions().empty()) return;
  file_.put(",\"malfunctions\":[");
  for (const History::Malfunction& one : history.malfunctions()) {
    if (&one != &history.malfunctions().front()) file_.put(",");
    file_.put(fmt::format(R"([{},"{}"])", json_string(plant_names_.malfunction(one.number)), malfunction_by(one.by)));
  }
  file_.put("]");
}

}  // namespace symplant::trace

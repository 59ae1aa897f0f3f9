// Writes the run as a VCD file.
#include "symplant/trace/vcd_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "symplant/trace/value_text.hpp"
#include "symplant/trace/value_traces.hpp"
#include "symplant/trace/vcd_header.hpp"

namespace symplant::trace {

VcdFile::VcdFile(OutputFile file, const PlantNames& names) : file_(std::move(file)), names_(names) {
  const std::size_t count = first_output(names.tables()) + names.tables().values.outputs;
  contents_.resize(names.tables().material.locations());
  identifiers_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) identifiers_.push_back(vcd_identifier(i) + "\n");
}

void VcdFile::put_time(tables::Time time) {
  if (time == last_time_) return;
  last_time_ = time;
  file_.put("#" + std::to_string(time) + "\n");
}

void VcdFile::put_symbol(std::uint32_t symbol, std::uint64_t value) {
  const tables::DataType type = names_.tables().symbols[symbol].type();
  if (type == tables::DataType::boolean) {
    file_.put(value != 0 ? "1" : "0");
  } else if (is_real(type)) {
    file_.put(fmt::format("r{:.17g} ", std::bit_cast<double>(value)));
  } else {
    const int bits = width(type);
    file_.put(fmt::format("b{:b} ", bits == 64 ? value : value & ((std::uint64_t{1} << bits) - 1)));
  }
  file_.put(identifiers_[symbol]);
}

void VcdFile::put_unit(std::uint32_t unit, const plant::UnitView& view) {
  file_.put("s");
  file_.put(vcd_string(names_.state(unit, view.state)));
  if (view.moving) {
    file_.put("->");
    file_.put(vcd_string(names_.state(unit, view.target)));
  }
  file_.put(" ");
  file_.put(identifiers_[names_.tables().symbols.size() + unit]);
}

/// Of a track the number of its parts, of a place their kinds.
void VcdFile::put_location(std::uint32_t location) {
  const tables::PlantTables& tables = names_.tables();
  if (tables.material.is_track(location)) {
    file_.put(fmt::format("b{:b} ", contents_[location].size()));
  } else {
    std::string text;
    for (const Content& part : contents_[location]) {
      text.append(text.empty() ? "" : ",").append(names_.part_kind(part.kind));
    }
    file_.put(fmt::format("s{} ", vcd_string(text.empty() ? "-" : text)));
  }
  file_.put(identifiers_[tables.symbols.size() + tables.units.size() + location]);
}

void VcdFile::move_part(const PartRecord& part) {
  const auto has_number = [&](const Content& other) { return other.number == part.number; };
  for (std::uint32_t location = 0; location < contents_.size(); ++location) {
    std::vector<Content>& parts = contents_[location];
    const auto found = std::find_if(parts.begin(), parts.end(), has_number);
    if (found == parts.end()) continue;
    if (part.changed()) {
      found->kind = part.kind;
    } else {
      parts.erase(found);
    }
    if (begun_) put_location(location);
  }
  if (part.changed() || part.to == tables::kOut) return;
  contents_[part.to].push_back({part.number, part.kind});
  if (begun_) put_location(part.to);
}

void VcdFile::put_malfunction(std::uint32_t malfunction, bool active) {
  file_.put(active ? "1" : "0");
  file_.put(identifiers_[first_malfunction(names_.tables()) + malfunction]);
}

void VcdFile::put_output(std::uint32_t output, double number) {
  file_.put(fmt::format("r{:.17g} ", number));
  file_.put(identifiers_[first_output(names_.tables()) + output]);
}

void VcdFile::begin(tables::Time time, const History& history) {
  if (begun_) return;
  begun_ = true;
  file_.put(vcd_header(names_));
  put_time(time);
  file_.put("$dumpvars\n");
  const tables::PlantTables& tables = names_.tables();
  for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) put_symbol(s, history.value(s));
  for (std::uint32_t u = 0; u < tables.units.size(); ++u) put_unit(u, history.unit(u));
  for (std::uint32_t location = 0; location < tables.material.locations(); ++location) put_location(location);
  std::vector<bool> active(tables.malfunctions.size());
  for (const History::Malfunction& one : history.malfunctions()) {
    if (one.number < active.size()) active[one.number] = true;
  }
  for (std::uint32_t m = 0; m < active.size(); ++m) put_malfunction(m, active[m]);
  const std::vector<tables::Time> traces = traces_of(tables.values);
  for (std::uint32_t output = 0; output < traces.size(); ++output) {
    if (traces[output] != 0) put_output(output, history.output(output));
  }
  file_.put("$end\n");
}

void VcdFile::write(const Record& record) {
  if (record.kind == Record::Kind::part) part_ = record;
  if (record.kind == Record::Kind::part_move) {
    if (begun_ && file_.is_open()) put_time(record.time);
    move_part(part_record(part_, record));
    has_lines_ = true;
    return;
  }
  if (!begun_ || !file_.is_open()) return;
  const bool written = record.kind == Record::Kind::malfunction && record.of < names_.tables().malfunctions.size();
  if (record.kind != Record::Kind::change && record.kind != Record::Kind::unit && record.kind != Record::Kind::value &&
      !written) {
    return;
  }
  has_lines_ = true;
  put_time(record.time);
  if (written) {
    put_malfunction(record.of, record.more);
  } else if (record.kind == Record::Kind::value) {
    put_output(record.of, std::bit_cast<double>(record.value));
  } else if (record.kind == Record::Kind::change) {
    put_symbol(record.of, record.value);
  } else {
    put_unit(record.of, unpack_unit(record.value));
  }
}

void VcdFile::part(tables::Time time, const History& history) {
  if (!begun_ || !has_lines_ || !file_.full()) return;
  file_.begin_again();
  begun_ = has_lines_ = false;
  last_time_ = -1;
  begin(time, history);
}

}  // namespace symplant::trace

// Images as a test gives them to a writer, and the file that it writes.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "record/writer.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

using record::Batch;
using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

inline constexpr std::uint32_t kO = 0;
inline constexpr std::uint32_t kI = 1;
inline constexpr std::uint32_t kN = 2;

/// An operation O, an event I and a number N.
inline SymbolList three_symbols() {
  SymbolList list;
  list.add("O", SymbolList::kOut, 0);
  list.add("I", SymbolList::kIn, 0);
  list.add("N", SymbolList::kIn, 0, tables::DataType::int_);
  return list;
}

/// A writer of a file. Images have one request; their times are in ms from 1 s.
class WriterBench {
 public:
  explicit WriterBench(record::What what = {}, std::uint64_t limit = trace::kNoLimit)
      : tables_(list_.tables()), names_(tables_) {
    what.link = "fake:";
    if (what.every == 0) what.every = 50 * kMillisecond;
    what.utc = [](Time time) { return "at " + std::to_string(time); };
    writer_.emplace(trace::OutputFile("recording", path(), limit), names_, std::move(what));
  }

  static Time at(std::int64_t ms) { return kSecond + ms * kMillisecond; }

  /// An image with these changes: symbol, value.
  void image(std::int64_t ms, const std::vector<std::pair<std::uint32_t, std::uint64_t>>& changes = {},
             bool after_loss = false) {
    Batch batch;
    batch.first = batch.last = at(ms);
    batch.after_loss = after_loss;
    for (const auto& change : changes) batch.lines.push_back({at(ms), change.second, change.first});
    writer_->take(batch);
  }
  /// Images every 50 ms without changes.
  void quiet(std::int64_t from_ms, std::int64_t to_ms) {
    for (std::int64_t ms = from_ms; ms <= to_ms; ms += 50) image(ms);
  }
  record::Trigger trigger(const std::string& text) const { return trigger_of(text, names_); }
  static record::Trigger trigger_of(const std::string& text, const trace::PlantNames& names) {
    auto read = record::read_trigger(text, names, {true, true, true});
    if (const auto* fault = std::get_if<std::string>(&read)) throw std::runtime_error(*fault);
    return std::get<record::Trigger>(std::move(read));
  }

  record::Writer& writer() { return *writer_; }
  std::string path() const { return folder_ / "r.jsonl"; }
  /// All lines after the header.
  std::vector<std::string> lines() const { return without_header(path()); }
  static std::vector<std::string> without_header(const std::string& path) {
    std::vector<std::string> lines;
    std::istringstream file(read_bytes(path));
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    if (!lines.empty()) lines.erase(lines.begin());
    return lines;
  }
  std::string header() const {
    const std::string text = read_bytes(path());
    return text.substr(0, text.find('\n'));
  }

 private:
  TemporaryFolder folder_;
  SymbolList list_ = three_symbols();
  tables::PlantTables tables_;
  trace::PlantNames names_;
  std::optional<record::Writer> writer_;
};

}  // namespace symplant::test

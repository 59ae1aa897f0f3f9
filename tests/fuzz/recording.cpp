// Any bytes as a recording: what is read is in order, has all its changes, and can be read again from what is written.
#include <sstream>
#include <vector>

#include "base/text_source.hpp"
#include "fuzz/target.hpp"
#include "recording/read.hpp"
#include "recording/write_json_lines.hpp"

namespace symplant::fuzz {
namespace {

recording::ReadRecording read(const std::string& bytes, const recording::ReadOptions& options) {
  std::istringstream file(bytes);
  return recording::read_recording(file, "fuzz", options);
}

void look_at(const recording::Recording& recording) {
  std::vector<std::size_t> next(recording.series.size(), 0);
  tables::Time last = 0;
  for (const std::uint32_t s : recording.order) {
    const auto& changes = recording.series.at(s).changes;
    require(next[s] < changes.size(), "the order has more changes than a series");
    const tables::Time time = changes[next[s]++].time;
    require(time >= last && time <= recording.end, "a time goes back, or is after the end");
    last = time;
  }
  for (std::size_t s = 0; s < next.size(); ++s) {
    require(next[s] == recording.series[s].changes.size(), "a change is not in the order");
    require(recording.index.at(recording.series[s].key()) == s, "a series is not in the index");
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const recording::ReadOptions& options :
       {recording::ReadOptions{}, recording::ReadOptions{"2", "ms", {{"X", "Y"}, {"A", "L_O_B"}}}}) {
    const recording::ReadRecording read = fuzz::read(bytes, options);
    fuzz::require(fuzz::is_utf8(read.error) || !fuzz::is_utf8(bytes), "an error of a text is no text");
    if (!read.error.empty() || read.recording.has_parts) continue;
    fuzz::look_at(read.recording);
    const auto lines = [&](base::TextSink& sink) { recording::write_json_lines(read.recording, sink); };
    const recording::ReadRecording again = fuzz::read(base::text_of(lines), {});
    fuzz::require(again.error.empty(), "what is written cannot be read");
    fuzz::require(again.recording.order.size() == read.recording.order.size(), "what is written has other changes");
  }
  return 0;
}

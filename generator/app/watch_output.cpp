// Shows the anomalies of a watched plant, and writes them to files.
#include "app/watch_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "app/options.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/words.hpp"
#include "watch/words.hpp"

namespace symplant::app {

using diag::visible;

bool WatchOutput::open(const std::vector<std::string>& inputs) {
  if (!files_.findings.empty()) {
    if (overwrites(context_, files_.findings, inputs)) return false;
    std::error_code unknown;  // an output that has no folder fails where it is written
    if (std::filesystem::weakly_canonical(files_.findings, unknown) ==
        std::filesystem::weakly_canonical(files_.junit, unknown)) {
      context_.err << "error: `" << visible(files_.junit) << "` is given for two outputs; name another file\n";
      context_.exit_code = host::kBadInput;
      return false;
    }
    findings_.emplace("findings", files_.findings);
    findings_->flush();
    if (!findings_->error().empty()) {
      context_.err << "error: " << visible(findings_->error()) << "\n";
      context_.exit_code = host::kEnvironment;
      return false;
    }
  }
  if (files_.junit.empty()) return true;
  const trace::TestCase unfinished{"readings", 0, {}, "the plant was not watched to the end"};
  const std::string junit = trace::junit_xml("symplant watch " + plant_.name, {&unfinished, 1}, 0);
  return write_result(context_, files_.junit, base::whole(junit), inputs);
}

void WatchOutput::begin(const std::string& name, watch::Time end, const std::vector<bool>& recorded) {
  const auto known = std::count(recorded.begin(), recorded.end(), true);
  std::string text = fmt::format("{}: ", name);
  is_recording_ = end != watch::kUnknown;
  if (is_recording_) text += trace::seconds(end) + ", ";
  text += fmt::format("{} of {} symbols, {}, margin {} %", known, recorded.size(),
                      margin_.resolution == 0 ? "exact times" : "resolution " + trace::seconds(margin_.resolution),
                      margin_.share * 100);
  context_.out << visible(text) << "\n";
  const std::string left_out = watch::not_watched(plant_, recorded);
  if (!left_out.empty()) context_.out << visible("not watched: " + left_out) << "\n";
}

void WatchOutput::add(const watch::Anomaly& anomaly) {
  tally_.add(plant_, anomaly, margin_.resolution);
  if (findings_) findings_->put(watch::json_line(plant_, anomaly, margin_.resolution) + "\n");
  Repeats& repeats = repeats_[{anomaly.unit, anomaly.kind, anomaly.move.from, anomaly.move.to}];
  if (repeats.count++ != 0) {
    repeats.last = anomaly.time;
    ++hidden_;
    return;
  }
  context_.out << visible((anomaly.is_first() ? "" : fmt::format("  follows from {}: ", anomaly.follows)) +
                          watch::sentence(plant_, anomaly, margin_.resolution))
               << "\n";
}

std::string WatchOutput::repeats_words(const RepeatedMove& move, const Repeats& repeats) const {
  const auto& [unit, kind, from, to] = move;
  watch::Anomaly of;
  of.unit = unit;
  const auto state = [&, u = unit](std::uint32_t s) {
    return s == watch::kNone ? std::string("?") : std::string(plant_.units[u].states[s].name);
  };
  std::string text = fmt::format("... {}", watch::name_of(plant_, of));
  if (unit != watch::kNone && from != watch::kNone) text += fmt::format(" from {} to {}", state(from), state(to));
  return text + fmt::format(": {} more {} until {}", repeats.count - 1, watch::kind_name(kind),
                            watch::seconds(repeats.last, margin_.resolution));
}

void WatchOutput::flush() {
  context_.out.flush();
  if (findings_) findings_->flush();
}

void WatchOutput::end(const watch::Counts& counts, watch::Time end, const std::vector<std::string>& inputs) {
  for (const auto& [move, repeats] : repeats_) {
    if (repeats.count > 1) context_.out << visible(repeats_words(move, repeats)) << "\n";
  }
  if (hidden_ != 0) context_.out << "of each device:\n";
  if (tally_.firsts() > 1 || hidden_ != 0) {
    for (const std::string& row : tally_.rows(plant_, margin_.resolution)) context_.out << "  " << visible(row) << "\n";
  }
  context_.out << visible(tally_.summary(counts)) << "\n";
  if (tally_.firsts() != 0) context_.exit_code = host::kFindings;
  const bool moved = std::any_of(counts.of_unit.begin(), counts.of_unit.end(), [](std::size_t n) { return n != 0; });
  if (is_recording_ && !moved && tally_.firsts() == 0) {
    context_.err << "error: nothing was judged: the recording shows no move of a device that is watched\n";
    context_.exit_code = host::kFindings;
  }
  if (findings_) {
    findings_->flush();
    if (!findings_->error().empty()) {
      context_.err << "error: " << visible(findings_->error()) << "\n";
      context_.exit_code = host::kEnvironment;
    }
  }
  if (!files_.junit.empty()) {
    write_result(context_, files_.junit, base::whole(tally_.junit(plant_, counts, end)), inputs);
  }
}

}  // namespace symplant::app

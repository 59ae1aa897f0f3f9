// Shows the anomalies of a watched plant, and writes them to files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/context.hpp"
#include "model/plant_model.hpp"
#include "symplant/trace/output_file.hpp"
#include "watch/report.hpp"

namespace symplant::app {

/// Files of results; empty: none.
struct WatchFiles {
  std::string findings;
  std::string junit;
};

class WatchOutput {
 public:
  /// Everything given must outlive it.
  WatchOutput(const model::PlantModel& plant, const watch::Margin& margin, const WatchFiles& files, Context& context)
      : plant_(plant), margin_(margin), files_(files), context_(context) {}

  /// Opens the findings file, and proves that the JUnit file can be written. False, with a message and the exit code,
  /// if not, or if one of them is one of `inputs`.
  bool open(const std::vector<std::string>& inputs);
  /// Shows what is watched. `end`: of the recording; kUnknown: it has none.
  void begin(const std::string& name, watch::Time end, const std::vector<bool>& recorded);
  /// Shows an anomaly, unless one of its kind and move was shown, and writes it.
  void add(const watch::Anomaly& anomaly);
  /// Passes everything on: a live watch is read at once.
  void flush();
  /// Shows the counts, writes the JUnit file and sets the exit code: a recording without moves is no success.
  void end(const watch::Counts& counts, watch::Time end, const std::vector<std::string>& inputs);

 private:
  /// Unit, kind, from, to.
  using RepeatedMove = std::tuple<std::uint32_t, watch::Anomaly::Kind, std::uint32_t, std::uint32_t>;
  struct Repeats {
    std::size_t count = 0;  ///< the first one included, which is shown
    watch::Time last = 0;
  };

  std::string repeats_words(const RepeatedMove& move, const Repeats& repeats) const;

  const model::PlantModel& plant_;
  const watch::Margin margin_;
  const WatchFiles& files_;
  Context& context_;
  watch::Tally tally_;
  std::optional<trace::OutputFile> findings_;
  std::map<RepeatedMove, Repeats> repeats_;
  std::size_t hidden_ = 0;
  bool is_recording_ = false;
};

}  // namespace symplant::app

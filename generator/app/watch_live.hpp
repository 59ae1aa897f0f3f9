// Watches a plant over a link that only reads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "app/watch_output.hpp"
#include "symplant/tables/time.hpp"
#include "watch/statistics.hpp"

namespace symplant::app {

/// What a live watch takes from the command line.
struct LiveOptions {
  std::vector<std::string> links;
  tables::Time every = 50 * tables::kMillisecond;
  std::optional<tables::Time> until;  ///< from the first image on; nothing: until a signal
  double margin = 0.2;
};

/// Shows anomalies as they happen, until a signal or `until`. Sets the exit code: 3 if no image was read.
void watch_live(const Compiled& compiled, const std::vector<watch::Statistic>& learned, const LiveOptions& options,
                const WatchFiles& files, const std::vector<std::string>& inputs, Context& context);

}  // namespace symplant::app

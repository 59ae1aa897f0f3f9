// Groups of durations.
#include "learn/clusters.hpp"

namespace symplant::learn {
namespace {

constexpr Time kGapTenths = 3;  ///< of the median
constexpr Time kGapResolutions = 5;
constexpr std::size_t kLeastPercent = 5;  ///< of all samples

std::vector<Cluster> divided(const std::vector<Sample>& samples, Time resolution) {
  std::vector<Cluster> all;
  const Time median = samples[samples.size() / 2].duration;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= samples.size(); ++i) {
    if (i < samples.size()) {
      const Time gap = samples[i].duration - samples[i - 1].duration;
      if (gap <= median / 10 * kGapTenths || gap < kGapResolutions * resolution) continue;
    }
    all.push_back({begin, i});
    begin = i;
  }
  return all;
}

}  // namespace

Clusters clusters_of(const std::vector<Sample>& samples, Time resolution) {
  Clusters clusters;
  if (samples.empty()) return clusters;
  for (const Cluster& cluster : divided(samples, resolution)) {
    if (cluster.size() > 1 && cluster.size() * 100 >= samples.size() * kLeastPercent) {
      clusters.kept.push_back(cluster);
      continue;
    }
    for (std::size_t i = cluster.begin; i < cluster.end; ++i) clusters.outliers.push_back(i);
  }
  if (clusters.kept.empty()) return {{{0, samples.size()}}, {}};
  return clusters;
}

std::vector<Time> kept_durations(const std::vector<Sample>& samples, const Clusters& clusters) {
  std::vector<Time> durations;
  durations.reserve(samples.size() - clusters.outliers.size());
  for (const Cluster& cluster : clusters.kept) {
    for (std::size_t i = cluster.begin; i < cluster.end; ++i) durations.push_back(samples[i].duration);
  }
  return durations;
}

}  // namespace symplant::learn

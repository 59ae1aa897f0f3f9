// Computes the quantiles of a histogram.
#include "symplant/exec/histogram.hpp"

#include <algorithm>

namespace symplant::exec {

Durations Histogram::durations() const noexcept {
  Durations result;
  for (const Counter& bucket : buckets_) result.count += bucket.value();
  const std::uint64_t longest = max_.value();
  result.max = static_cast<tables::Time>(longest);
  // The n-th duration, n rounded up; durations counted meanwhile can only make the result slightly too short.
  const auto nth = [&](std::uint64_t per_thousand) {
    return result.count / 1000 * per_thousand + (result.count % 1000 * per_thousand + 999) / 1000;
  };
  std::uint64_t counted = 0;
  const auto reach = [&](tables::Time& quantile, std::uint64_t n, std::size_t bucket, std::uint64_t before) {
    if (before < n && counted >= n) quantile = static_cast<tables::Time>(std::min(last_of(bucket), longest));
  };
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    const std::uint64_t before = counted;
    counted += buckets_[bucket].value();
    if (counted == before) continue;
    reach(result.p50, nth(500), bucket, before);
    reach(result.p99, nth(990), bucket, before);
    reach(result.p999, nth(999), bucket, before);
  }
  return result;
}

std::vector<Histogram::Octave> Histogram::by_octave() const {
  std::vector<Octave> octaves;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    const std::uint64_t count = buckets_[bucket].value();
    if (count == 0) continue;
    const std::uint64_t upper = std::bit_ceil(last_of(bucket) + 1);
    if (octaves.empty() || octaves.back().upper != upper) octaves.push_back({upper, 0});
    octaves.back().count += count;
  }
  return octaves;
}

}  // namespace symplant::exec

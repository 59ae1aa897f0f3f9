// Lowers times that may be random.
#include "lower/random_time.hpp"

#include <algorithm>

namespace symplant::lower {

tables::Time lower_time(const description::Duration& duration, EngineTables& tables) {
  using Kind = description::Duration::Kind;
  if (duration.kind == Kind::fixed) return duration.a;
  const auto kind =
      duration.kind == Kind::uniform ? tables::RandomTime::Kind::uniform : tables::RandomTime::Kind::normal;
  std::vector<tables::RandomTime>& times = tables.random_times;
  const auto equal = [&](const tables::RandomTime& time) {
    return time.kind == kind && time.a == duration.a && time.b == duration.b;
  };
  auto found = std::find_if(times.begin(), times.end(), equal);
  if (found == times.end()) found = times.insert(times.end(), {kind, duration.a, duration.b});
  return -1 - static_cast<tables::Time>(found - times.begin());
}

}  // namespace symplant::lower

// What a trace or a recording holds.
#include "recording/recording.hpp"

namespace symplant::recording {

const Series* Recording::find(const Series& same) const {
  const auto found = index.find(same.key());
  return found == index.end() ? nullptr : &series[found->second];
}

}  // namespace symplant::recording

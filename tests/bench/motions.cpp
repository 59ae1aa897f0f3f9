// Runs a closed loop for a given number of steps, so that callgrind can count instructions. The difference of two runs,
// divided by the difference of their motion counts, is the cost of a motion.
//
//   motions limit|grid|distinct|rich DEVICES STEPS
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "bench/loops.hpp"

namespace {

template <class Loop>
long long run(std::uint32_t devices, long steps) {
  Loop loop(devices);
  long long motions = 0;
  for (long i = 0; i < steps; ++i) motions += loop.step();
  return motions;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace symplant::bench;
  if (argc != 4) {
    std::fputs("usage: motions limit|grid|distinct|rich DEVICES STEPS\n", stderr);
    return 2;
  }
  const std::string_view load = argv[1];
  const auto devices = static_cast<std::uint32_t>(std::atol(argv[2]));
  const long steps = std::atol(argv[3]);
  const long long motions = load == "limit"  ? run<LimitGrid>(devices, steps)
                            : load == "grid" ? run<EngineGrid>(devices, steps)
                            : load == "rich" ? run<EngineRich>(devices, steps)
                                             : run<EngineDistinct>(devices, steps);
  std::printf("%lld motions\n", motions);
  return 0;
}

// Runs a closed loop for a given number of steps, so that callgrind can count instructions. The difference of two runs,
// divided by the difference of their motion counts, is the cost of a motion.
//
//   motions LOAD DEVICES STEPS
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "bench/loops.hpp"
#include "bench/track_plant.hpp"

namespace {

template <class Loop>
long long run(std::uint32_t devices, long steps) {
  Loop loop(devices);
  long long motions = 0;
  for (long i = 0; i < steps; ++i) motions += loop.step();
  return motions;
}

struct Load {
  std::string_view name;
  long long (*run)(std::uint32_t devices, long steps);
};

using namespace symplant::bench;
constexpr Load kLoads[] = {
    {"limit", run<LimitGrid>},           {"heap", run<HeapGrid>},           {"grid", run<EngineGrid>},
    {"observed", run<EngineObserved>},   {"types1", run<EngineTypes<1>>},   {"types10", run<EngineTypes<10>>},
    {"types100", run<EngineTypes<100>>}, {"distinct", run<EngineDistinct>}, {"rich", run<EngineRich>},
    {"guarded", run<EngineGuarded>},     {"while", run<EngineWhile>},       {"symbols", run<EngineSymbols>},
    {"inverted", run<EngineInverted>},   {"parts", run<EngineParts>},       {"parts_by_hand", run<HandParts>},
    {"queue", run<EngineQueue>},
};

}  // namespace

int main(int argc, char** argv) {
  for (const Load& load : kLoads) {
    if (argc != 4 || load.name != argv[1]) continue;
    const auto devices = static_cast<std::uint32_t>(std::atol(argv[2]));
    std::printf("%lld motions\n", load.run(devices, std::atol(argv[3])));
    return 0;
  }
  std::fputs("usage: motions LOAD DEVICES STEPS, where LOAD is", stderr);
  for (const Load& load : kLoads) std::fprintf(stderr, " %s", load.name.data());
  std::fputs("\n", stderr);
  return 2;
}

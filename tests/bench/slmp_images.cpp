// Images of bit points exchanged with a server on the loopback: the link's dialog compared with simpler clients.
#include <benchmark/benchmark.h>

#include <string>

#include "support/slmp_clients.hpp"

namespace symplant::bench {
namespace {

using namespace test;

template <class Client>
void exchange(benchmark::State& state, BitPlc& plc, Client& client) {
  std::size_t images = 0;
  std::size_t requests = 0;
  for (auto _ : state) {
    if (!client.exchange()) state.SkipWithError("a request failed");
    state.PauseTiming();
    requests += plc.plc().log().count();
    plc.plc().log().clear();
    ++images;
    state.ResumeTiming();
  }
  state.counters["requests"] = static_cast<double>(requests) / static_cast<double>(images);
  state.SetItemsProcessed(static_cast<std::int64_t>(images));
}

enum class ClientKind : std::uint8_t { planned, runs, points };

void run(benchmark::State& state, const SlmpFamily& family, std::uint32_t points, Spread spread, ClientKind kind) {
  const BitMap map(points, spread);
  BitPlc plc(family);
  if (kind == ClientKind::planned) {
    PlannedClient client(map, family, plc.plc().port());
    exchange(state, plc, client);
  } else {
    const BitSpans spans = kind == ClientKind::points ? point_spans(map) : run_spans(map, family);
    SpanClient client(spans, family, plc.plc().port());
    exchange(state, plc, client);
  }
}

const bool kImagesRegistered = [] {
  constexpr std::array kKinds = {std::pair{"planned", ClientKind::planned}, std::pair{"runs", ClientKind::runs},
                                 std::pair{"points", ClientKind::points}};
  for (const SlmpFamily& family : kSlmpFamilies) {
    for (const std::uint32_t points : {64U, 1'000U, 10'000U}) {
      for (const Spread spread : {Spread::dense, Spread::scattered}) {
        for (const auto& named : kKinds) {
          const std::string name = "images/" + std::string(family.name) + "/" + std::to_string(points) +
                                   (spread == Spread::dense ? "/dense/" : "/scattered/") + named.first;
          const ClientKind kind = named.second;
          benchmark::RegisterBenchmark(name.c_str(),
                                       [=](benchmark::State& state) { run(state, family, points, spread, kind); })
              ->UseRealTime()
              ->Unit(benchmark::kMicrosecond);
        }
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace symplant::bench

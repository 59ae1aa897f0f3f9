// An hour of 3,000 symbols: reading the recording, following its devices, learning their times.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "learn/learn.hpp"
#include "observe/play.hpp"
#include "property/plant_text.hpp"
#include "property/recordings/recorded_run.hpp"
#include "recording/read.hpp"

namespace symplant::bench {
namespace {

constexpr int kDevices = 750;  // of four symbols each
constexpr tables::Time kHour = 3600 * tables::kSecond;

/// Cylinders with two ends each, which random commands move: about as busy as a body shop.
model::PlantModel plant() {
  property::PlantText text;
  for (int i = 0; i < kDevices; ++i) {
    const std::string path = "L_P_C" + std::to_string(i);
    const std::string number = std::to_string(2 * i);
    const std::string next = std::to_string(2 * i + 1);
    text.rows.push_back({path + "_O_ADV", "%QX" + number, "BOOL", ""});
    text.rows.push_back({path + "_O_RET", "%QX" + next, "BOOL", ""});
    text.rows.push_back({path + "_I_ADV", "%IX" + number, "BOOL", ""});
    text.rows.push_back({path + "_I_RET", "%IX" + next, "BOOL", ""});
  }
  return property::build(text).plant;
}

struct Hour {
  model::PlantModel model = plant();
  std::string text;
  std::size_t changes = 0;

  Hour() {
    const auto run = property::record_run(model, {.seed = 1, .length = kHour, .every = 50 * tables::kMillisecond});
    changes = run.recording.order.size();
    text = "{\"symplant-trace\":1,\"recorded\":true,\"every\":50000000}\n";
    std::vector<std::size_t> next(run.recording.series.size(), 0);
    for (const std::uint32_t series : run.recording.order) {
      const recording::Series& of = run.recording.series[series];
      const recording::Series::Change& change = of.changes[next[series]++];
      text += "{\"t\":" + std::to_string(change.time) + ",\"symbol\":\"" + of.name +
              "\",\"value\":" + (change.value != 0 ? "true" : "false") + "}\n";
    }
  }

  recording::Recording read() const {
    std::istringstream file(text);
    return recording::read_recording(file, "hour").recording;
  }
};

const Hour& hour() {
  static const Hour made;
  return made;
}

void count(benchmark::State& state) { state.counters["changes"] = static_cast<double>(hour().changes); }

void read(benchmark::State& state) {
  hour();
  for (auto _ : state) benchmark::DoNotOptimize(hour().read());
  count(state);
}
BENCHMARK(read)->Unit(benchmark::kMillisecond);

void follow(benchmark::State& state) {
  const recording::Recording recording = hour().read();
  for (auto _ : state) {
    const observe::Matched matched = observe::match(hour().model, recording);
    benchmark::DoNotOptimize(observe::moves_of(hour().model, recording, matched));
  }
  count(state);
}
BENCHMARK(follow)->Unit(benchmark::kMillisecond);

void read_and_learn(benchmark::State& state) {
  for (auto _ : state) {
    recording::Recording recording = hour().read();
    observe::Matched matched = observe::match(hour().model, recording);
    std::vector<learn::Input> inputs;
    inputs.push_back({std::move(recording), std::move(matched)});
    benchmark::DoNotOptimize(learn::learn_times(hour().model, inputs));
  }
  count(state);
}
BENCHMARK(read_and_learn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace symplant::bench

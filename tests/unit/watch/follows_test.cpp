// Gaps, what follows from an anomaly, and drift.
#include <random>

#include "watch_support.hpp"

namespace symplant::test {
namespace {

constexpr const char* kReadEvery10 = R"(,"recorded":true,"cycle":10000000)";

recording::Recording with_gap(const std::string& changes, tables::Time begin_ms, tables::Time length_ms) {
  recording::Recording recording = recorded(trace_text(changes, kReadEvery10));
  recording.gaps.push_back({begin_ms * tables::kMillisecond, length_ms * tables::kMillisecond});
  return recording;
}

std::vector<std::string> kinds(const std::vector<watch::Anomaly>& all) {
  std::vector<std::string> names;
  for (const watch::Anomaly& one : all) names.emplace_back(watch::kind_name(one.kind));
  return names;
}

const std::string kAll = "0 L_P_CL_I_OPEN 1; 0 L_P_CL_I_CLOSED 0; 0 L_P_CL_O_OPEN 0; 0 L_P_CL_O_CLOSED 0; ";

TEST_CASE("Silence is one anomaly, and nothing follows from it") {
  const Watched plant(kClamp, kBistable);
  const std::string lost = kAll + "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; 30000 L_P_CL_I_CLOSED 1; 60000";
  CHECK(kinds(plant.anomalies(with_gap(lost, 1500, 28000))) == std::vector<std::string>{"silent"});
  CHECK(plant.anomalies(with_gap(lost, 1500, 28000)).front().time == 29500 * tables::kMillisecond);
}

TEST_CASE("Two images that are left out are no silence") {
  const Watched plant(kClamp, kBistable);
  CHECK(kinds(plant.anomalies(with_gap(kAll + "9000", 1500, 20))).empty());
  CHECK(kinds(plant.anomalies(with_gap(kAll + "9000", 1500, 30))) == std::vector<std::string>{"silent"});
}

TEST_CASE("What a device does that depends on one with an anomaly follows from that") {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_MC_I_IDLE1", "L_P_MC_I_RUN2"});
  const Watched plant(names, R"("devices": {"L_P_CL": {"actuation": "bistable"},
      "L_P_MC": {"initial": "IDLE1", "only": true, "transitions": [
        {"from": "IDLE1", "to": "RUN2", "automatic": true, "when": "L_P_CL.CLOSED", "takes": "1s"}]}})");
  // The sensor CLOSED of the clamp is dead. The machine sees the clamp, and starts.
  const std::string begin = "0 L_P_CL_I_OPEN 1; 0 L_P_MC_I_IDLE1 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; ";
  CHECK(plant.found(begin + "5000 L_P_MC_I_IDLE1 0; 6000 L_P_MC_I_RUN2 1; 9000") ==
        "missing L_P_CL OPEN->CLOSED at 4000\nunexpected L_P_MC IDLE1->? leaving at 5000 <1");
  CHECK(plant.found("0 L_P_CL_I_OPEN 1; 0 L_P_MC_I_IDLE1 1; 5000 L_P_MC_I_IDLE1 0; 6000 L_P_MC_I_RUN2 1; 9000") ==
        "unexpected L_P_MC IDLE1->? leaving at 5000");
}

/// Cycles of the clamp, which closes in `base` ms, with a spread of 10 %.
std::string cycles(int count, double base, unsigned seed) {
  std::mt19937 random(seed);
  std::string text = kAll;
  long now = 1000;
  const auto change = [&](const std::string& symbol, int value) {
    text += std::to_string(now / 10 * 10) + " L_P_CL_" + symbol + " " + std::to_string(value) + "; ";
  };
  for (int i = 0; i < count; ++i) {
    const double spread = 0.9 + 0.2 * static_cast<double>(random()) / 4294967295.0;
    change("O_CLOSED", 1);
    change("I_OPEN", 0);
    now += static_cast<long>(base * spread);
    change("I_CLOSED", 1);
    now += 100;
    change("O_CLOSED", 0);
    change("O_OPEN", 1);
    change("I_CLOSED", 0);
    now += 1000;
    change("I_OPEN", 1);
    now += 100;
    change("O_OPEN", 0);
    now += 100;
  }
  return text + std::to_string(now);
}

watch::Statistic learned(const Watched& plant, std::uint64_t n) {
  watch::Statistic statistic;
  const model::Unit& unit = plant.model().units.front();
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (unit.states[s].name == "OPEN") statistic.from = s;
    if (unit.states[s].name == "CLOSED") statistic.to = s;
  }
  statistic.n = n;
  statistic.mean = 1e9;
  statistic.deviation = 0.0577e9;
  return statistic;
}

TEST_CASE("Wear is found once, though every move is within its limits") {
  Watched plant(kClamp, kBistable);
  plant.learned.push_back(learned(plant, 400));
  CHECK(kinds(plant.anomalies(recorded(trace_text(cycles(400, 1000, 1), kReadEvery10)))).empty());
  const auto found = plant.anomalies(recorded(trace_text(cycles(200, 1090, 2), kReadEvery10)));
  CHECK(kinds(found) == std::vector<std::string>{"drift"});
  CHECK(kinds(plant.anomalies(recorded(trace_text(cycles(200, 1030, 2), kReadEvery10)))).empty());
}

TEST_CASE("With learned times a loose contact is unexpected, also where nothing was learned of the device") {
  Watched plant(kClamp, kBistable);
  plant.learned.push_back(learned(plant, 400));  // of OPEN->CLOSED only
  CHECK(plant.found("0 L_P_CL_I_OPEN 1; 1000 L_P_CL_I_OPEN 0; 1100 L_P_CL_I_OPEN 1; 3000") ==
        "unexpected L_P_CL OPEN->? leaving at 1000");
  CHECK(plant.found("0 L_P_CL_I_CLOSED 1; 1000 L_P_CL_I_CLOSED 0; 1100 L_P_CL_I_CLOSED 1; 3000") ==
        "unexpected L_P_CL CLOSED->? leaving at 1000");
}

TEST_CASE("With learned times, what was neither learned nor given is not late") {
  const std::string late =
      "0 L_P_CL_I_CLOSED 1; 1000 L_P_CL_O_OPEN 1; 1010 L_P_CL_I_CLOSED 0; 3500 L_P_CL_I_OPEN 1; 4000";
  Watched plant(kClamp, kBistable);
  CHECK(plant.found(late) == "late L_P_CL CLOSED->OPEN at 3500");
  plant.learned.push_back(learned(plant, 400));
  CHECK(plant.found(late) == "");
  Watched given(kClamp, R"("devices": {"L_P_CL": {"actuation": "bistable", "transitions": [
      {"from": "CLOSED", "to": "OPEN", "takes": "1s"}]}})");
  given.learned.push_back(learned(given, 400));
  CHECK(given.found(late) == "late L_P_CL CLOSED->OPEN at 3500");
}

TEST_CASE("A move that began when it is not known is not missing") {
  const Watched plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "bistable", "transitions": [
      {"from": "OPEN", "to": "CLOSED", "after": "1s", "takes": "1s"}]}})");
  CHECK(plant.found("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_OPEN 1; 200 L_P_CL_O_CLOSED 1; 300 L_P_CL_O_OPEN 0; 20000") == "");
}

TEST_CASE("A motor that is commanded again before it rests is not early, one that rested is") {
  const Watched plant({"L_P_M_I_RUN", "L_P_M_O_RUN"}, R"("name": "x")");
  const std::string first =
      "0 L_P_M_O_RUN 0; 1000 L_P_M_O_RUN 1; 2000 L_P_M_I_RUN 1; 5000 L_P_M_O_RUN 0; 5010 L_P_M_I_RUN 0; ";
  CHECK(plant.found(first + "6000 L_P_M_O_RUN 1; 6300 L_P_M_I_RUN 1; 9000") == "");
  CHECK(plant.found(first + "16000 L_P_M_O_RUN 1; 16300 L_P_M_I_RUN 1; 19000") == "early L_P_M NOT_RUN->RUN at 16300");
}

TEST_CASE("Drift needs at least 30 moves that were learned, and 30 new ones") {
  Watched plant(kClamp, kBistable);
  plant.learned.push_back(learned(plant, 29));
  const recording::Recording worn = recorded(trace_text(cycles(200, 1090, 2), kReadEvery10));
  CHECK(kinds(plant.anomalies(worn)).empty());
  plant.learned.front().n = 400;
  CHECK(kinds(plant.anomalies(recorded(trace_text(cycles(29, 1090, 2), kReadEvery10)))).empty());
}

TEST_CASE("The statistics of a learned file are read by device, states and operation") {
  const Watched plant(kClamp, kBistable);
  const auto read = [&](const std::string& text) {
    return watch::read_statistics(text, "learned.json", plant.model());
  };
  const auto full = read(R"({"symplant": 1, "learned": {"devices": {
    "L_P_CL": {"OPEN->CLOSED": {"takes": {"n": 412, "mean": "0.803s", "sd": "0.012s"}},
               "CLOSED->OPEN on OPEN": {"total": {"n": 40, "mean": "1s", "sd": "0s"}}, "OPEN->AWAY": 5},
    "L_P_OTHER": 5}}})");
  CHECK(full.error == "");
  REQUIRE(full.statistics.size() == 2);
  CHECK(full.statistics[1].on == model::kNone);
  CHECK(full.statistics[0].on != model::kNone);
  CHECK(full.statistics[1].n == 412);
  CHECK(full.statistics[1].mean == 803e6);
  CHECK(full.statistics[1].deviation == 12e6);
  CHECK(full.statistics[0].span == watch::Span::total);
  CHECK(read(R"({"symplant": 1, "times": {}})").statistics.empty());
  CHECK(contains(read(R"({"learned": 1})").error, "learned.json: `learned` has no statistics"));
  CHECK(contains(read(R"({"learned": {"devices": {"L_P_CL": {"OPEN->CLOSED": {"takes": {"n": 1}}}}}})").error,
                 "in `L_P_CL`, `OPEN->CLOSED`"));
  CHECK(contains(read("{\n\"learned\": }").error, "learned.json:2: "));
}

}  // namespace
}  // namespace symplant::test

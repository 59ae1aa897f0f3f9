// Times of devices from recordings.
#include <string>

#include "learn_support.hpp"

namespace symplant::test {
namespace {

const std::string kClampPrefix = "L_P_CL_";

std::string clamp_times(const std::vector<std::pair<int, int>>& moves, int delay = 0, const std::string& header = "",
                        const std::string& members = kBistable) {
  return LearnedFrom(kClamp, members, {bit_trace(clamp_moves(moves, delay), kClampPrefix, header)}).times();
}

TEST_CASE("Exact times are learned exactly") {
  CHECK(clamp_times({{812, 650}, {812, 650}, {812, 700}}) ==
        "L_P_CL OPEN->CLOSED takes 0.812 s (3: 812 812 812)\n"
        "L_P_CL CLOSED->OPEN takes 0.65 s to 0.7 s (3: 650 650 700)\n");
}

TEST_CASE("A delay of over 2 resolutions before leaving is after") {
  CHECK(clamp_times({{900, 900}, {900, 900}}, 150, kEvery50) ==
        "L_P_CL OPEN->CLOSED after 0.15 s (2: 150 150 150)\n"
        "L_P_CL OPEN->CLOSED takes 0.75 s (2: 750 750 750)\n"
        "L_P_CL CLOSED->OPEN after 0.15 s (2: 150 150 150)\n"
        "L_P_CL CLOSED->OPEN takes 0.75 s (2: 750 750 750)\n");
}

TEST_CASE("A delay of 2 resolutions counts with the travel time") {
  CHECK(clamp_times({{900, 900}, {900, 900}}, 100, kEvery50) ==
        "L_P_CL OPEN->CLOSED takes 0.9 s (2: 900 900 900)\n"
        "L_P_CL CLOSED->OPEN takes 0.9 s (2: 900 900 900)\n");
}

TEST_CASE("A delay of the model that reality does not show is reset") {
  const std::string members = R"("devices": {"L_P_CL": {"actuation": "bistable", "transitions": [
    {"from": "OPEN", "to": "CLOSED", "after": "3s"}]}})";
  const LearnedFrom from(kClamp, members, {bit_trace(clamp_moves({{900, 900}}), kClampPrefix)});
  CHECK(contains(learn::learned_file(from.learned), R"("OPEN->CLOSED": { "after": "0s", "takes": "0.9s" })"));
  CHECK(contains(learn::learned_file(from.learned), R"("CLOSED->OPEN": { "takes": "0.9s" })"));
}

TEST_CASE("The file is the same if the plant has the learned times already") {
  const std::string device = R"("devices": {"L_P_CL": {"actuation": "bistable", "transitions": [
    {"from": "OPEN", "to": "CLOSED", "after": "3s"}]}})";
  const std::vector<std::string> traces{bit_trace(clamp_moves({{900, 800}, {950, 810}}), kClampPrefix)};
  const std::string first = learn::learned_file(LearnedFrom(kClamp, device, traces).learned);
  const std::string times =
      R"(, "times": {"L_P_*": {"OPEN->CLOSED": {"after": "0s", "takes": {"min": "0.9s", "max": "0.95s"}},
    "CLOSED->OPEN": {"takes": {"min": "0.8s", "max": "0.81s"}}}})";
  CHECK(learn::learned_file(LearnedFrom(kClamp, device + times, traces).learned) == first);
}

TEST_CASE("Outliers are not used") {
  const LearnedFrom from(kClamp, kBistable,
                         {bit_trace(clamp_moves({{800, 600}, {800, 600}, {3200, 600}, {800, 600}}), kClampPrefix)});
  CHECK(from.times() ==
        "L_P_CL OPEN->CLOSED takes 0.8 s (3: 800 800 800)\n"
        "L_P_CL CLOSED->OPEN takes 0.6 s (4: 600 600 600)\n");
  const auto& time = *from.learned.groups[0].times.transitions[0].takes;
  REQUIRE(time.clusters.outliers.size() == 1);
  const learn::Sample& outlier = time.samples[time.clusters.outliers[0]];
  CHECK(outlier.duration == 3200 * kMilli);
  CHECK(outlier.at == 3300 * kMilli);
}

TEST_CASE("Recordings count together, with the coarsest resolution") {
  const LearnedFrom from(kClamp, kBistable,
                         {bit_trace(clamp_moves({{812, 600}}), kClampPrefix),
                          bit_trace(clamp_moves({{850, 600}}), kClampPrefix, kEvery50)});
  CHECK(contains(from.times(), "OPEN->CLOSED takes 0.83 s (2: 810 830 850)"));
  CHECK(contains(learn::learned_file(from.learned),
                 "      // 2 moves in line1.jsonl, line2.jsonl, resolution 0.05 s; few moves: others may differ\n"
                 "      \"OPEN->CLOSED\": { \"takes\": \"0.83s\" },\n"));
}

TEST_CASE("A spring's return has all of its time as travel time") {
  const std::vector<std::string> names = {"L_P_CL_O_ADV", "L_P_CL_I_ADV", "L_P_CL_I_RET"};
  const LearnedFrom from(names, R"("devices": {})",
                         {bit_trace("0 I_RET 1; 100 O_ADV 1; 100 I_RET 0; 700 I_ADV 1; 1000 O_ADV 0; 1200 I_ADV 0; "
                                    "1900 I_RET 1",
                                    kClampPrefix)});
  CHECK(from.times() ==
        "L_P_CL ADV->RET takes 0.9 s (1: 900 900 900)\n"
        "L_P_CL RET->ADV takes 0.6 s (1: 600 600 600)\n");
}

TEST_CASE("A spring's return that a command can do, too, is one transition with it") {
  const std::vector<std::string> names = {"L_P_CL_O_ADV", "L_P_CL_O_RET", "L_P_CL_I_ADV", "L_P_CL_I_RET"};
  const std::string spring = R"("devices": {"L_P_CL": {"actuation": "spring", "rest": "RET"}})";
  const LearnedFrom from(
      names, spring,
      {bit_trace("0 I_RET 1; 100 O_ADV 1; 100 I_RET 0; 700 I_ADV 1; 1000 O_ADV 0; 1000 I_ADV 0; "
                 "1900 I_RET 1; 2000 O_ADV 1; 2000 I_RET 0; 2600 I_ADV 1; 3000 O_ADV 0; 3000 O_RET 1; "
                 "3000 I_ADV 0; 3900 I_RET 1",
                 kClampPrefix)});
  CHECK(contains(from.times(), "L_P_CL ADV->RET takes 0.9 s (2: 900 900 900)\n"));
}

TEST_CASE("Moves from a state without an event that the device hardly reached are left out") {
  // It needs 2 s to open, and is commanded back after 1 s three times: then it shuts in half the time.
  const std::vector<std::string> names = {"L_P_G_I_SHUT", "L_P_G_O_SHUT"};
  std::string text = "0 O_SHUT 1; 0 I_SHUT 1";
  int now = 0;
  const auto open_for = [&](int rest, int shuts) {
    now += 1000;
    text += "; " + std::to_string(now) + " O_SHUT 0; " + std::to_string(now) + " I_SHUT 0";
    now += rest;
    text += "; " + std::to_string(now) + " O_SHUT 1";
    now += shuts;
    text += "; " + std::to_string(now) + " I_SHUT 1";
  };
  for (const int rest : {6000, 7000, 8000, 9000}) open_for(rest, 500);
  for (int i = 0; i < 3; ++i) open_for(1000, 250);
  const LearnedFrom from(names, R"("name": "x")", {bit_trace(text, "L_P_G_")});
  CHECK(contains(from.times(), "L_P_G NOT_SHUT->SHUT takes 0.5 s (4: 500 500 500)\n"));
}

TEST_CASE("A spring's return is not an automatic transition to the same state") {
  const std::vector<std::string> names = {"L_P_CL_O_ADV", "L_P_CL_I_ADV", "L_P_CL_I_RET"};
  const std::string spring = R"("devices": {"L_P_CL": {"actuation": "spring", "rest": "RET", "transitions": [
      {"from": "ADV", "to": "RET", "automatic": true, "after": "9s"}]}})";
  const LearnedFrom from(names, spring,
                         {bit_trace("0 I_RET 1; 100 O_ADV 1; 100 I_RET 0; 700 I_ADV 1; 1000 O_ADV 0; 1000 I_ADV 0; "
                                    "1900 I_RET 1",
                                    kClampPrefix)});
  CHECK(from.times() ==
        "L_P_CL ADV->RET takes 0.9 s (1: 900 900 900)\n"
        "L_P_CL RET->ADV takes 0.6 s (1: 600 600 600)\n");
}

TEST_CASE("The dwell of an automatic transition is after") {
  const std::vector<std::string> names = {"L_P_MC_O_RUN2", "L_P_MC_I_RUN2", "L_P_MC_I_IDLE1"};
  const LearnedFrom from(names, R"("devices": {})",
                         {bit_trace("0 I_IDLE1 1; 100 O_RUN2 1; 100 I_IDLE1 0; 600 I_RUN2 1; 700 O_RUN2 0; "
                                    "5600 I_RUN2 0; 5600 I_IDLE1 1",
                                    "L_P_MC_")});
  CHECK(from.times() ==
        "L_P_MC IDLE1->RUN2 takes 0.5 s (1: 500 500 500)\n"
        "L_P_MC RUN2->IDLE1 after 5 s (1: 5000 5000 5000)\n");
}

TEST_CASE("Of a state without an event only the delay before leaving the other one is learned") {
  const std::vector<std::string> names = {"L_P_CL_O_OPEN", "L_P_CL_O_CLOSED", "L_P_CL_I_CLOSED"};
  const LearnedFrom from(names, R"("devices": {"L_P_CL": {"actuation": "bistable", "initial": "OPEN"}})",
                         {bit_trace("0 O_OPEN 1; 100 O_OPEN 0; 100 O_CLOSED 1; 900 I_CLOSED 1; 1000 O_CLOSED 0; "
                                    "1000 O_OPEN 1; 1300 I_CLOSED 0",
                                    kClampPrefix)});
  CHECK(from.times() ==
        "L_P_CL OPEN->CLOSED takes 0.8 s (1: 800 800 800)\n"
        "L_P_CL CLOSED->OPEN after 0.3 s (1: 300 300 300)\n");
}

TEST_CASE("Time in which the model does not let a device move does not count") {
  const std::string held = R"("devices": {"L_P_CL": {"actuation": "held"}})";
  const LearnedFrom from(kClamp, held,
                         {bit_trace("0 I_OPEN 1; 100 O_CLOSED 1; 100 I_OPEN 0; 400 O_CLOSED 0; 900 O_CLOSED 1; "
                                    "1400 I_CLOSED 1; 1450 O_CLOSED 0; 2000 O_OPEN 1; 2000 I_CLOSED 0; "
                                    "2500 I_OPEN 1; 2600 O_OPEN 0",
                                    kClampPrefix)});
  CHECK(from.times() ==
        "L_P_CL OPEN->CLOSED takes 0.8 s (1: 800 800 800)\n"
        "L_P_CL CLOSED->OPEN takes 0.5 s (1: 500 500 500)\n"
        "L_P_CL overrun 0.2 s (2: 50 75 100)\n");
}

TEST_CASE("A command that ends before arrival, or not at all, is no overrun") {
  const std::string held = R"("devices": {"L_P_CL": {"actuation": "held"}})";
  const LearnedFrom from(kClamp, held,
                         {bit_trace("0 I_OPEN 1; 100 O_CLOSED 1; 100 I_OPEN 0; 850 O_CLOSED 0; 900 I_CLOSED 1; "
                                    "2000 O_OPEN 1; 2000 I_CLOSED 0; 2500 I_OPEN 1; 9000 O_CLOSED 1; 9100 O_CLOSED 0",
                                    kClampPrefix)});
  CHECK(!contains(from.times(), "overrun"));
}

TEST_CASE("A move that turns round, or without a cause, is not used") {
  const LearnedFrom from(kClamp, kBistable,
                         {bit_trace("0 I_OPEN 1; 100 O_CLOSED 1; 100 I_OPEN 0; 400 O_CLOSED 0; 400 O_OPEN 1; "
                                    "700 I_OPEN 1; 800 O_OPEN 0; 5000 I_OPEN 0; 5500 I_CLOSED 1",
                                    kClampPrefix)});
  CHECK(from.times() == "");
  CHECK(from.learned.moves == 0);
  CHECK(from.learned.unused == 1);
}

TEST_CASE("A move that was commanded back for a while is not used") {
  const LearnedFrom from(kClamp, kBistable,
                         {bit_trace("0 I_OPEN 1; 100 O_CLOSED 1; 100 I_OPEN 0; 400 O_CLOSED 0; 400 O_OPEN 1; "
                                    "600 O_OPEN 0; 600 O_CLOSED 1; 1500 I_CLOSED 1",
                                    kClampPrefix)});
  CHECK(from.times() == "");
  CHECK(from.learned.unused == 1);
}

TEST_CASE("Devices with equal times share an entry") {
  std::vector<std::string> names;
  for (const char* const device : {"L_S1_CL1_", "L_S1_CL2_", "L_S2_CL1_"}) {
    for (const char* const task : {"I_OPEN", "I_CLOSED", "O_OPEN", "O_CLOSED"})
      names.push_back(device + std::string(task));
  }
  const std::string members = R"("devices": {"L_*": {"actuation": "bistable"}})";
  const auto trace = [](const std::string& device, int time) {
    return bit_trace(clamp_moves({{time, 600}, {time, 600}}), device, kEvery50);
  };
  const LearnedFrom from(names, members, {trace("L_S1_CL1_", 800), trace("L_S1_CL2_", 820), trace("L_S2_CL1_", 900)});
  CHECK(from.times() ==
        "L_S1_CL? (2 devices) OPEN->CLOSED takes 0.81 s (4: 800 810 820)\n"
        "L_S1_CL? (2 devices) CLOSED->OPEN takes 0.6 s (4: 600 600 600)\n"
        "L_S2_CL1 OPEN->CLOSED takes 0.9 s (2: 900 900 900)\n"
        "L_S2_CL1 CLOSED->OPEN takes 0.6 s (2: 600 600 600)\n");
}

TEST_CASE("An operation names the transition if several lead to the same state") {
  const std::vector<std::string> names = {"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED",
                                          "L_P_CL_O_PUSH"};
  const std::string members = R"("devices": {"L_P_CL": {"transitions": [
    {"from": "OPEN", "to": "CLOSED", "on": "PUSH", "takes": "2s"}]}})";
  const LearnedFrom from(names, members, {bit_trace(clamp_moves({{800, 600}}), kClampPrefix)});
  CHECK(contains(from.times(), "L_P_CL OPEN->CLOSED on CLOSED takes 0.8 s"));
}

TEST_CASE("Devices, transitions, events, symbols and names that were not seen are listed") {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_CLB_I_OPEN", "L_P_CLB_I_CLOSED", "L_P_CLB_O_OPEN", "L_P_CLB_O_CLOSED",
                             "L_P_CLC_I_OPEN", "L_P_CLC_I_CLOSED", "L_P_CLC_O_OPEN", "L_P_CLC_O_CLOSED"});
  const std::string trace = bit_trace(
      "0 CL_I_OPEN 1; 0 CL_I_CLOSED 0; 0 CL_O_CLOSED 0; 7 CLB_I_OPEN 0; 7 CLB_I_CLOSED 1; 7 CLB_O_OPEN 0; "
      "7 CLB_OO_CLOSED 0; 100 CL_O_CLOSED 1; 100 CL_I_OPEN 0; 900 CL_I_CLOSED 1",
      "L_P_", kEvery50);
  const LearnedFrom from(names, R"("devices": {"L_*": {"actuation": "bistable"}})", {trace});
  const std::string text = base::text_of([&](base::TextSink& sink) { learn::write_text(from.learned, sink); });
  CHECK(contains(text,
                 "\ndevices that never moved (1): L_P_CLB\n"
                 "transitions never taken (1): L_P_CL CLOSED->OPEN\n"
                 "events that never changed (2): L_P_CLB_I_OPEN, L_P_CLB_I_CLOSED\n"
                 "symbols in no recording (6): "));
  CHECK(contains(text, "names in recordings that are no symbol (1): L_P_CLB_OO_CLOSED (similar: L_P_CLB_O_CLOSED)\n"));
}

/// The same trace with opposite bits of the operations.
std::string active_low(std::string changes) {
  for (std::size_t at = 0; (at = changes.find(" O_", at)) != std::string::npos; ++at) {
    char& bit = changes[changes.find(' ', at + 1) + 1];
    bit = bit == '1' ? '0' : '1';
  }
  return changes;
}

const std::vector<std::pair<int, int>> kTenMoves(5, {800, 600});

TEST_CASE("Moves without a cause whose operations have the other polarity are said to be of active-low outputs") {
  const std::string changes = active_low(clamp_moves(kTenMoves));
  const LearnedFrom wrong(kClamp, kBistable, {bit_trace(changes, "L_P_CL_", kEvery50)});
  REQUIRE(wrong.learned.unused_moves.size() == 1);
  CHECK(wrong.learned.unused_moves[0].all() == 10);
  CHECK(wrong.learned.unused_moves[0].reason == learn::UnusedReason::inverted);
  CHECK(learn::unused_warnings(wrong.learned) ==
        std::vector<std::string>{"10 of 10 moves of 1 device would have a cause if their operations were active-low: "
                                 "name these in `inverted` of plant.json (L_P_CL)"});
  const LearnedFrom right(kClamp, std::string(kBistable) + R"(, "inverted": ["*_O_*"])",
                          {bit_trace(changes, "L_P_CL_", kEvery50)});
  CHECK(right.learned.unused_moves.empty());
  CHECK(right.learned.moves == 10);
}

TEST_CASE("Moves without a cause have the reason that operations are not recorded, or none that is known") {
  std::string events = clamp_moves(kTenMoves);
  for (std::size_t at = 0; (at = events.find("O_", at)) != std::string::npos;) events.replace(at, 2, "X_");
  const LearnedFrom lost(kClamp, kBistable, {bit_trace(events, "L_P_CL_", kEvery50)});
  REQUIRE(lost.learned.unused_moves.size() == 1);
  CHECK(lost.learned.unused_moves[0].reason == learn::UnusedReason::not_recorded);
  CHECK(contains(learn::unused_warnings(lost.learned).at(0), "their operations are not recorded (L_P_CL)"));

  const LearnedFrom still(kClamp, kBistable, {bit_trace("0 O_OPEN 0; 0 O_CLOSED 0; " + events, "L_P_CL_", kEvery50)});
  REQUIRE(still.learned.unused_moves.size() == 1);
  CHECK(still.learned.unused_moves[0].uncaused == 10);
  CHECK(still.learned.unused_moves[0].reason == learn::UnusedReason::unknown);
  CHECK(learn::unused_warnings(still.learned).size() == 1);
}

TEST_CASE("A few moves by hand are no reason for a warning") {
  const LearnedFrom from(
      kClamp, kBistable,
      {bit_trace(clamp_moves(kTenMoves) + "; 9000 O_OPEN 0; 9500 I_OPEN 0; 9900 I_CLOSED 1", "L_P_CL_", kEvery50)});
  REQUIRE(from.learned.unused_moves.size() == 1);
  CHECK(from.learned.unused_moves[0].unused() == 1);
  CHECK(learn::unused_warnings(from.learned).empty());
}

}  // namespace
}  // namespace symplant::test

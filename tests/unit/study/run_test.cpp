// The run of a plant with the operations of a recording, and the state in which it begins.
#include "study/run.hpp"

#include <memory>
#include <string>

#include "study/causes.hpp"
#include "study/shown.hpp"
#include "study/study.hpp"
#include "study_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kClamp{"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED",
                                      "L_P_KEY_I_ON"};
constexpr const char* kSlowClamp = R"("defaults": {"travel": "2s"}, "devices": {"L_P_CL": {"actuation": "bistable"}})";

/// An axis with a speed in mm/s: 0 to 5000 mm, shown in 0.1 mm by an encoder that begins again at 65536, and in %.
std::vector<Row> axis_rows() {
  return {{"L_P_AX_O_SPEED", "", "INT", "0", "%QW0"},        {"L_P_AX_I_COUNT", "", "UINT", "0", "%IW0"},
          {"L_P_AX_I_PERCENT", "", "INT", "0", "%IW1"},      {"L_P_FAN_O_SPEED", "", "INT", "0", "%QW1"},
          {"L_P_BRK_O_OPEN", "", "BOOL", "FALSE", "%QX100"}, {"L_P_BRK_I_OPEN", "", "BOOL", "FALSE", "%IX100"}};
}
constexpr const char* kAxis = R"json(
  "devices": {"L_P_BRK": {"transitions": [{"from": "NOT_OPEN", "to": "OPEN", "takes": "100ms"}, {"from": "OPEN", "to": "NOT_OPEN", "takes": "100ms"}]}},
  "values": {
    "ax.speed": {"is": "if(L_P_BRK.OPEN, L_P_AX_O_SPEED, 0)"
}
, "ax.position" : {"start" : 100, "min" : 0, "max" : 5000, "integral" : "ax.speed"}, "ax.slow" : {
  "lag" : "ax.position", "time" : "1 s"
}
},
  "signals": {
    "L_P_AX_I_COUNT": "wrap(floor(10 * ax.position) + 2000, 0, 65536)",
    "L_P_AX_I_PERCENT": {"of": "ax.slow", "from": [0, 5000], "to": [0, 10000]}
  })json";

struct Ran {
  Ran(const DescribedPlant& plant, const std::string& changes,
      const std::string& more = ",\"recorded\":true,\"every\":10000000")
      : recording(recording_of(changes, more)),
        matched(observe::match(plant.compiled().plant, recording)),
        start(study::start_of(plant.compiled().plant, recording, matched)),
        run(study::run_with(plant.compiled().plant, plant.rows, recording, matched, start, "run")) {}

  recording::Recording recording;
  observe::Matched matched;
  study::Start start;
  recording::Recording run;
};

TEST_CASE("A run begins in the state that the recorded events show") {
  const DescribedPlant plant(bits(kClamp), kSlowClamp);
  const std::string first = "0 L_P_CL_O_OPEN off; 0 L_P_CL_O_CLOSED off; 0 L_P_KEY_I_ON on; ";
  const Ran closed(plant, first + "0 L_P_CL_I_OPEN off; 0 L_P_CL_I_CLOSED on; 1000 L_P_CL_O_OPEN on; 5000");
  REQUIRE(closed.start.states.size() == 1);
  CHECK(closed.start.states[0].second == plant.state("L_P_CL", "CLOSED"));
  CHECK(changes_of(closed.run, "L_P_CL_I_CLOSED") == "0 on, 1000 off");
  CHECK(changes_of(closed.run, "L_P_CL_I_OPEN") == "0 off, 3000 on");
  CHECK(changes_of(closed.run, "L_P_CL_O_OPEN") == "0 off, 1000 on");

  const Ran open(plant, first + "0 L_P_CL_I_OPEN on; 0 L_P_CL_I_CLOSED off; 1000 L_P_CL_O_CLOSED on; 5000");
  CHECK(open.start.states.empty());  // as in the model
  CHECK(changes_of(open.run, "L_P_CL_I_CLOSED") == "0 off, 3000 on");

  const Ran midway(plant, first + "0 L_P_CL_I_OPEN off; 0 L_P_CL_I_CLOSED off; 5000");
  CHECK(midway.start.unknown == 1);
  CHECK(changes_of(midway.run, "L_P_CL_I_OPEN") == "0 on");  // the model's initial state
}

TEST_CASE("The first lines of a recording may have different times, and its beginning need not be 0") {
  const DescribedPlant plant(bits(kClamp), kSlowClamp);
  const Ran ran(plant,
                "7000 L_P_CL_I_OPEN off; 7000 L_P_CL_I_CLOSED on; 7004 L_P_CL_O_OPEN off; 7004 L_P_CL_O_CLOSED on; "
                "8000 L_P_CL_O_CLOSED off; 8000 L_P_CL_O_OPEN on; 12000");
  CHECK(ran.start.begin == 7004 * tables::kMillisecond);
  CHECK(changes_of(ran.run, "L_P_CL_O_CLOSED") == "7004 on, 8000 off");
  CHECK(changes_of(ran.run, "L_P_CL_I_CLOSED") == "7004 on, 8000 off");
  CHECK(changes_of(ran.run, "L_P_CL_I_OPEN") == "7004 off, 10000 on");
  CHECK(ran.run.end == 12000 * tables::kMillisecond);
}

TEST_CASE("Events that the plant does not drive come from the recording") {
  const DescribedPlant plant(bits(kClamp), kSlowClamp);
  const Ran ran(plant, "0 L_P_KEY_I_ON on; 500 L_P_KEY_I_ON off; 600 L_P_CL_I_CLOSED on; 1000");
  CHECK(changes_of(ran.run, "L_P_KEY_I_ON") == "0 on, 500 off");
  CHECK(changes_of(ran.run, "L_P_CL_I_CLOSED") == "0 off");
}

TEST_CASE("An inverted event that the plant does not drive has the bit of the recording") {
  const DescribedPlant plant(bits(kClamp), R"("inverted": ["L_P_KEY_I_*"])");
  const Ran recorded(plant, "0 L_P_KEY_I_ON on; 500 L_P_KEY_I_ON off; 600 L_P_KEY_I_ON on; 1000");
  CHECK(changes_of(recorded.run, "L_P_KEY_I_ON") == "0 on, 500 off, 600 on");
  const Ran traced(plant, "0 L_P_KEY_I_ON on; 500 L_P_KEY_I_ON off; 1000", "");
  CHECK(changes_of(traced.run, "L_P_KEY_I_ON") == "0 on, 500 off");
  const Ran without_line(plant, "0 L_P_CL_I_OPEN on; 1000", "");
  CHECK(changes_of(without_line.run, "L_P_KEY_I_ON") == "");
}

TEST_CASE("Numeric operations and the numbers of signals begin as recorded") {
  const DescribedPlant plant(axis_rows(), kAxis);
  const std::string first =
      "0 L_P_BRK_I_OPEN on; 0 L_P_BRK_O_OPEN on; 0 L_P_AX_I_COUNT 7000; 0 L_P_AX_I_PERCENT 1000; 0 L_P_AX_O_SPEED 0; ";
  const Ran ran(plant, first + "1000 L_P_AX_O_SPEED -100; 2000 L_P_AX_O_SPEED 0; 6000");
  // 7000 is 500.05 mm: the number may be anywhere in its step.
  REQUIRE(ran.start.numbers.size() == 2);
  CHECK(ran.start.numbers[0].second == 500.05);
  CHECK(ran.start.numbers[1].second == 500);  // the lag; it is at rest
  const recording::Series* const count = ran.run.find({"L_P_AX_I_COUNT", recording::Series::Kind::number, {}, {}, {}});
  REQUIRE(count != nullptr);
  CHECK(count->changes.front().value == 7000);
  CHECK(count->changes.back().value == 6000);
  CHECK(count->changes.back().time <= 2010 * tables::kMillisecond);

  const Ran as_model(plant, "0 L_P_AX_I_COUNT 3000; 1000");
  CHECK(as_model.start.numbers.empty());  // the start of the model shows it
}

TEST_CASE("A trace of a plant begins with every symbol off") {
  const DescribedPlant plant(bits(kClamp), kSlowClamp);
  const Ran ran(plant, "0 L_P_CL_I_OPEN on; 1000 L_P_CL_O_CLOSED on; 1000 L_P_CL_I_OPEN off; 5000", "");
  CHECK(ran.start.states.empty());
  CHECK(changes_of(ran.run, "L_P_CL_I_CLOSED") == "3000 on");
}

TEST_CASE("A symbol that changes twice at one time is written twice") {
  const DescribedPlant plant(bits(kClamp), kSlowClamp);
  const Ran ran(plant, "0 L_P_CL_I_OPEN on; 1000 L_P_CL_O_CLOSED on; 1000 L_P_CL_O_CLOSED off; 5000", "");
  CHECK(changes_of(ran.run, "L_P_CL_O_CLOSED") == "1000 on, 1000 off");
  CHECK(changes_of(ran.run, "L_P_CL_I_CLOSED") == "3000 on");
}

TEST_CASE("The operations of a signal are those of its values and of the devices that these read") {
  const DescribedPlant plant(axis_rows(), kAxis);
  const auto operations = study::operations_of_signals(plant.compiled().plant);
  REQUIRE(operations.size() == 2);
  const std::vector<std::uint32_t> wanted{plant.symbol("L_P_AX_O_SPEED"), plant.symbol("L_P_BRK_O_OPEN")};
  CHECK(operations[0] == wanted);
  CHECK(operations[1] == wanted);
}

TEST_CASE("A signal that is a line of one value shows the value") {
  const DescribedPlant plant(axis_rows(), kAxis);
  const auto& signals = plant.compiled().plant.signals;
  const auto count = study::line_of(signals[0]);
  REQUIRE(count);
  CHECK(count->factor == 10);
  CHECK(count->offset == 1999.5);
  CHECK(study::period_of(signals[0]) == 65536);
  const auto percent = study::line_of(signals[1]);
  REQUIRE(percent);
  CHECK(percent->output_for(1000) == 500);
  CHECK(study::period_of(signals[1]) == 0);

  const auto line = [](const std::string& formula) {
    const DescribedPlant one(
        axis_rows(),
        R"("values": {"a": {"start": 1}, "b": {"start": 1}}, "signals": {"L_P_AX_I_COUNT": ")" + formula + "\"}");
    return study::line_of(one.compiled().plant.signals[0]).has_value();
  };
  CHECK(line("2 - (a + 1) / 4"));
  CHECK(line("2 * a + a"));
  for (const char* const none :
       {"a + b", "a * a", "1 / (a + 1)", "sqrt(a)", "max(a, 2)", "a - a", "3", "L_P_AX_O_SPEED"}) {
    INFO(none);
    CHECK_FALSE(line(none));
  }
}

TEST_CASE("A study compares what is chosen, and names what is no symbol") {
  const DescribedPlant plant(axis_rows(), kAxis);
  const recording::Recording recording = recording_of(
      "0 L_P_BRK_I_OPEN off; 0 L_P_BRK_O_OPEN off; 0 L_P_AX_I_COUNT 3000; 0 L_P_AX_O_SPEED 0; 0 L_P_FAN_O_SPEEDD 1; "
      "1000 L_P_BRK_O_OPEN on; 1200 L_P_BRK_I_OPEN on; 1200 L_P_AX_O_SPEED 1000; 1400 L_P_AX_I_COUNT 5000; "
      "1600 L_P_AX_I_COUNT 7000; 1600 L_P_AX_O_SPEED 0; 4000",
      ",\"recorded\":true,\"every\":100000000");
  const auto all = [&](bool with_brake) {
    return study::study(plant.compiled().plant, plant.rows, recording, "plant.json",
                        [&](std::string_view name) { return with_brake || name.find("BRK") == name.npos; });
  };
  const study::Study both = all(true);
  REQUIRE(both.rows.size() == 2);
  CHECK(both.rows[0].name == "L_P_AX_I_COUNT");
  CHECK(both.rows[1].name == "L_P_BRK NOT_OPEN -> OPEN");
  CHECK(both.rows[1].mean == 1);  // 100 ms, not 200, with a resolution of 100
  CHECK(both.total.count == 2);
  REQUIRE(both.unmatched.size() == 1);
  CHECK(both.unmatched[0] == "`L_P_FAN_O_SPEEDD` (did you mean `L_P_FAN_O_SPEED`?)");
  CHECK(all(false).rows.size() == 1);
}

}  // namespace
}  // namespace symplant::test

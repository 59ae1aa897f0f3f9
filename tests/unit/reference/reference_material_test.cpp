// Parts on tracks: movement, contacts, stops, sensors (docs/material.md, sections 2 and 4).
#include "material_bench.hpp"

namespace symplant::test {
namespace {

/// A track of 1 m that moves while L_P_M_O_RUN is on, at a speed in um/s.
void short_track(Flow& flow, std::int64_t speed) {
  flow.track("CV", 1000 * kMm).drives = {flow.drive(1000 * kMm, "M_O_RUN", "", speed)};
}

TEST_CASE("A part moves through two drives, and a sensor sees it") {
  Flow flow({"M_O_RUN", "R_O_RUN", "PE"});
  model::Track& track = flow.track("CV", 3000 * kMm);
  track.drives = {flow.drive(1500 * kMm, "M_O_RUN", "", 400 * kMm), flow.drive(3000 * kMm, "R_O_RUN", "", 200 * kMm)};
  track.sensors = {flow.sensor("PE", 300 * kMm)};
  flow.set("M_O_RUN", 1).set("R_O_RUN", 1);
  REQUIRE(flow.put("CV"));
  flow.run(0);
  CHECK(flow.parts() == "200000/400000");
  CHECK(flow.plant().next_due() == 250 * kMs);
  flow.run(3500 * kMs);
  CHECK(flow.lines() ==
        "t:0,symbol:L_P_M_O_RUN,value:true\n"
        "t:0,symbol:L_P_R_O_RUN,value:true\n"
        "t:0,part:1,kind:raw,to:CV,x:200000,by:hand\n"
        "t:250000000,symbol:L_P_PE,value:true\n"
        "t:750000001,symbol:L_P_PE,value:false\n");
  CHECK(flow.parts() == "1600000/200000");
  CHECK(flow.plant().next_due() == 10'500 * kMs);
  flow.run(20 * kS);
  CHECK(flow.parts() == "3000000/0");
  CHECK(flow.plant().next_due() == tables::kNever);
}

TEST_CASE("A part that overshoots the end is put exactly there") {
  Flow flow({"M_O_RUN"});
  short_track(flow, 300'000);
  flow.set("M_O_RUN", 1).put("CV");
  flow.run(0).run(2'666'666'666);  // 800 mm take 2.6666... s
  CHECK(flow.parts() == "999999+999800000/300000");
  CHECK(flow.plant().next_due() == 2'666'666'667);
  flow.run(2'666'666'667);
  CHECK(flow.parts() == "1000000/0");
  CHECK(flow.plant().save().material.tracks[0].parts[0].t0 == 2'666'666'667);
}

TEST_CASE("A queue forms at a stop with gaps between its parts, and moves again as one") {
  Flow flow({"M_O_RUN", "S_O_UP"});
  short_track(flow, 100 * kMm);
  flow.model.material.tracks[0].gap = 50 * kMm;
  flow.model.material.tracks[0].stops = {{800 * kMm, flow.when("S_O_UP")}};
  flow.set("M_O_RUN", 1).set("S_O_UP", 1);
  REQUIRE(flow.put("CV", 400 * kMm));
  REQUIRE(flow.put("CV"));
  CHECK_FALSE(flow.put("CV"));
  flow.run(0);
  CHECK(flow.parts() == "500000/100000 200000/100000");
  CHECK(flow.plant().next_due() == 3 * kS);
  flow.run(3 * kS);
  CHECK(flow.parts() == "800000/0 500000/100000");
  CHECK(flow.plant().next_due() == 3500 * kMs);
  flow.run(4 * kS);
  CHECK(flow.parts() == "800000/0 550000/0");
  flow.set("S_O_UP", 0).run(5 * kS);
  CHECK(flow.parts() == "800000/100000 550000/100000");
  CHECK(flow.plant().counters[reference::Counted::queue_released] == 1);
  flow.run(6 * kS);
  CHECK(flow.parts() == "900000/100000 650000/100000");
}

TEST_CASE("A stop that rises under a part lets that part pass, and catches the next one") {
  Flow flow({"M_O_RUN", "S_O_UP"});
  short_track(flow, 100 * kMm);
  flow.model.material.tracks[0].stops = {{400 * kMm, flow.when("S_O_UP")}};
  flow.set("M_O_RUN", 1).put("CV", 300 * kMm);
  flow.run(0).set("S_O_UP", 1).run(1).run(10);
  CHECK(flow.parts() == "400000+1000000/100000");
  flow.put("CV");
  flow.run(9 * kS);
  CHECK(flow.parts() == "1000000/0 400000/0");
}

TEST_CASE("A stop that falls and rises while a part is exactly there holds it") {
  Flow flow({"M_O_RUN", "S_O_UP"});
  short_track(flow, 100 * kMm);
  flow.model.material.tracks[0].stops = {{400 * kMm, flow.when("S_O_UP")}};
  flow.set("M_O_RUN", 1).set("S_O_UP", 1).put("CV", 300 * kMm);
  flow.run(0);
  CHECK(flow.parts() == "400000/0");
  flow.set("S_O_UP", 0).run(0).set("S_O_UP", 1).run(0);
  CHECK(flow.parts() == "400000/0");
  flow.set("S_O_UP", 0).run(0).run(5);
  CHECK(flow.parts() == "400000+500000/100000");
}

TEST_CASE("Drives that face each other stop a part with its middle at their boundary") {
  Flow flow({"M_O_RUN", "R_O_REV"});
  model::Track& track = flow.track("CV", 2000 * kMm);
  track.drives = {flow.drive(1000 * kMm, "M_O_RUN", "", 300'000), flow.drive(2000 * kMm, "", "R_O_REV", 700'000)};
  flow.set("M_O_RUN", 1).set("R_O_REV", 1).put("CV");
  flow.put("CV", 1500 * kMm);
  flow.run(0).run(5 * kS);
  // The second part came from ahead and reached the boundary first.
  CHECK(flow.parts() == "1100000/0 900000/0");
  CHECK(flow.plant().counters[reference::Counted::facing_stopped] == 1);
  flow.set("M_O_RUN", 0).run(6 * kS).run(7 * kS);
  CHECK(flow.parts() == "1100000/0 900000/0");  // held by the one behind it, which no drive moves
  CHECK(flow.plant().take({0, 800 * kMm}));
  flow.run(7 * kS + 10);
  CHECK(flow.parts() == "1099999+999300000/0");  // its middle left the drive by 1 ns
}

TEST_CASE("A part moves backward to the start, and a part ahead of it touches it") {
  Flow flow({"M_O_REV"});
  flow.track("CV", 1000 * kMm).drives = {flow.drive(300 * kMm, "", "M_O_REV", 100 * kMm),
                                         flow.drive(1000 * kMm, "", "M_O_REV", 300 * kMm)};
  flow.put("CV", 250 * kMm);
  flow.put("CV", 800 * kMm);
  flow.set("M_O_REV", 1).run(0);
  CHECK(flow.parts() == "900000/-300000 350000/-100000");
  CHECK(flow.plant().next_due() == 1500 * kMs);  // the start; contact would be at 1.75 s
  flow.run(1500 * kMs);
  CHECK(flow.parts() == "450000/-300000 200000/0");
  CHECK(flow.plant().next_due() == 1'666'666'667);
  flow.run(2 * kS);
  CHECK(flow.parts() == "400000/0 200000/0");
  CHECK(flow.plant().counters[reference::Counted::part_touched_backward] == 1);
}

TEST_CASE("A numeric symbol gives the speed, and a force counts") {
  Flow flow({"M_O_RUN", "M_N_O_SPEED"});
  model::Track& track = flow.track("CV", 1000 * kMm);
  track.drives = {flow.drive(1000 * kMm, "M_O_RUN", "", 10 * kMm)};
  track.drives[0].symbol = flow.symbol("M_N_O_SPEED");
  flow.set("M_O_RUN", 1).put("CV");
  flow.run(0);
  CHECK(flow.parts() == "200000/0");
  flow.set("M_N_O_SPEED", 20).run(kS);
  CHECK(flow.parts() == "200000/200000");
  flow.plant().force(flow.symbol("M_N_O_SPEED"), 4'000'000'000);
  flow.run(kS);
  CHECK(flow.parts() == "200000/100000000");
}

TEST_CASE("Sensors read a code, a number, chosen kinds, or are inverted") {
  Flow flow({"M_O_RUN", "PE", "TALL", "A_N_CODE", "A_N_NUMBER"});
  flow.model.symbols[flow.symbol("PE")].inverted = true;
  short_track(flow, 100 * kMm);
  auto& sensors = flow.model.material.tracks[0].sensors;
  for (const char* name : {"PE", "TALL", "A_N_CODE", "A_N_NUMBER"}) sensors.push_back(flow.sensor(name, 500 * kMm));
  sensors[1].kinds = {1};
  sensors[2].reads = tables::SensorReads::code;
  sensors[3].reads = tables::SensorReads::number;
  CHECK_FALSE(flow.plant().set_input(flow.symbol("PE"), 0));
  flow.put("CV", 800 * kMm);
  flow.put("CV", 300 * kMm, 1);
  flow.run(0);
  CHECK(flow.lines() ==
        "t:0,symbol:L_P_PE,value:true\n"
        "t:0,part:1,kind:raw,to:CV,x:900000,by:hand\n"
        "t:0,part:2,kind:done,to:CV,x:400000,by:hand\n");
  flow.set("M_O_RUN", 1).run(5 * kS);
  CHECK(flow.lines() == "t:5000000000,symbol:L_P_M_O_RUN,value:true\n");
  flow.run(6 * kS);
  CHECK(flow.lines() ==
        "t:6000000000,symbol:L_P_PE,value:false\n"
        "t:6000000000,symbol:L_P_TALL,value:true\n"
        "t:6000000000,symbol:L_P_A_N_CODE,value:2\n"
        "t:6000000000,symbol:L_P_A_N_NUMBER,value:2\n");
  flow.run(9 * kS);
  CHECK(flow.lines() ==
        "t:8000000001,symbol:L_P_PE,value:true\n"
        "t:8000000001,symbol:L_P_TALL,value:false\n"
        "t:8000000001,symbol:L_P_A_N_CODE,value:0\n"
        "t:8000000001,symbol:L_P_A_N_NUMBER,value:0\n");
}

TEST_CASE("A sensor that reverses its drive freezes the track") {
  Flow flow({"PE"});
  model::Track& track = flow.track("CV", 1000 * kMm);
  track.drives = {flow.drive(1000 * kMm, "not PE", "PE", 100 * kMm)};
  track.sensors = {flow.sensor("PE", 300 * kMm)};
  flow.put("CV");
  flow.run(kS - 1);
  CHECK(flow.parts() == "299999+999900000/100000");
  flow.run(kS + 9'998);
  const std::size_t changes = flow.plant().instants().size();
  CHECK(changes == 10'000);  // the first one, and each nanosecond from 1 s on
  CHECK(flow.plant().next_due() == kS + 9'999);
  flow.lines();
  flow.run(2 * kS);
  CHECK(flow.lines() ==
        "t:1000009999,symbol:L_P_PE,value:false\n"
        "t:1000010000,symbol:L_P_PE,value:true\n"
        "t:1000010001,symbol:L_P_PE,value:false\n"
        "t:1000010001,finding:instantaneous loop,of:CV\n");
  CHECK(flow.parts() == "299999+999900000/0");
  CHECK(flow.plant().next_due() == tables::kNever);
}

}  // namespace
}  // namespace symplant::test

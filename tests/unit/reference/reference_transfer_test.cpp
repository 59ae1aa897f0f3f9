// Parts between locations: ends, transfers, work, sources, loops, by hand (docs/material.md, sections 3 and 5).
#include "material_bench.hpp"

namespace symplant::test {
namespace {

using reference::Counted;

/// CV, 1 m, ends at the place BOX.
void track_and_place(Flow& flow, std::uint32_t holds = 1) {
  flow.place("BOX", holds);
  model::Track& track = flow.track("CV", 1000 * kMm);
  track.drives = {flow.drive(1000 * kMm, "M_O_RUN", "", 100 * kMm)};
  track.ends = {{1, {}}};
}

TEST_CASE("A part leaves by the end of its track when there is room") {
  Flow flow({"M_O_RUN", "R_O_PICK"});
  track_and_place(flow);
  flow.transfer({1, -1}, {tables::kOut, -1}, "R_O_PICK");
  flow.put("CV", 900 * kMm);
  flow.put("CV", 700 * kMm);
  flow.set("M_O_RUN", 1).run(0);
  CHECK(flow.count("BOX") == 1);
  CHECK(flow.parts() == "800000/100000");
  flow.run(2 * kS).lines();
  CHECK(flow.parts() == "1000000/0");
  flow.set("R_O_PICK", 1).run(3 * kS);
  // The second part goes to the robot in the same instant.
  CHECK(flow.lines() ==
        "t:3000000000,symbol:L_P_R_O_PICK,value:true\n"
        "t:3000000000,part:1,kind:raw,from:BOX,to:out\n"
        "t:3000000000,part:2,kind:raw,from:CV,to:BOX\n"
        "t:3000000000,part:2,kind:raw,from:BOX,to:out\n");
  CHECK(flow.plant().save().material.gone[0] == 2);
}

TEST_CASE("The first end whose condition holds is the target, even if only another one has room") {
  Flow flow({"M_O_RUN", "G_O_LEFT"});
  track_and_place(flow);
  flow.place("OTHER");
  flow.model.material.tracks[0].ends = {{1, flow.when("G_O_LEFT")}, {2, {}}};
  flow.put("BOX");
  flow.put("CV", 900 * kMm);
  flow.set("M_O_RUN", 1).set("G_O_LEFT", 1).run(0).run(kS);
  CHECK(flow.count("CV") == 1);
  flow.set("G_O_LEFT", 0).run(2 * kS);
  CHECK(flow.count("OTHER") == 1);
}

TEST_CASE("A part arrives at a track by an end with its front at 0, when the part before it has left room") {
  Flow flow({"M_O_RUN"});
  model::Track& first = flow.track("CV1", 1000 * kMm);
  first.drives = {flow.drive(1000 * kMm, "M_O_RUN", "", 400 * kMm)};
  first.ends = {{1, {}}};
  flow.track("CV2", 1000 * kMm).drives = {flow.drive(1000 * kMm, "M_O_RUN", "", 300 * kMm)};
  flow.put("CV2", 50 * kMm);
  flow.put("CV1", 900 * kMm);
  flow.set("M_O_RUN", 1).run(0);
  CHECK(flow.parts(0) == "1000000/0");
  CHECK(flow.plant().next_due() == 166'666'667);  // its tail is then at 0
  flow.run(kS);
  CHECK(flow.parts(0) == "");
  CHECK(flow.parts(1) == "450000/300000 249999+999900000/300000");
}

TEST_CASE("A ring of one track needs no room for the part that moves") {
  Flow flow({"M_O_RUN"});
  model::Track& track = flow.track("CV", 200 * kMm);
  track.drives = {flow.drive(200 * kMm, "M_O_RUN", "", 100 * kMm)};
  track.ends = {{0, {}}};
  flow.put("CV");
  flow.set("M_O_RUN", 1).run(kS);
  CHECK(flow.parts() == "0/100000");
}

TEST_CASE("A transfer to a location without room is blocked, unless it has moved a part") {
  Flow flow({"M_O_RUN", "R_O_PICK", "R_O_DROP"});
  track_and_place(flow);
  flow.model.material.tracks[0].ends.clear();
  flow.transfer({0, 900 * kMm}, {1, -1}, "R_O_PICK");
  flow.put("CV", 900 * kMm);
  flow.put("CV", 700 * kMm);
  flow.set("R_O_PICK", 1).set("M_O_RUN", 1).run(0);
  CHECK(flow.count("BOX") == 1);
  flow.run(3 * kS);
  CHECK(flow.plant().counters[Counted::found_part_blocked] == 0);
  flow.set("R_O_PICK", 0).run(4 * kS).lines();
  flow.set("R_O_PICK", 1).run(5 * kS).run(6 * kS);
  CHECK(flow.lines() == "t:5000000000,symbol:L_P_R_O_PICK,value:true\nt:5000000000,finding:part blocked,of:T1\n");
  CHECK(flow.plant().take({1, -1}));
  flow.run(6 * kS);
  CHECK(flow.lines() ==
        "t:6000000000,part:1,kind:raw,from:BOX,to:out,by:hand\n"
        "t:6000000000,part:2,kind:raw,from:CV,to:BOX\n");
}

TEST_CASE("A transfer with `once` moves one part for each beginning of its condition") {
  Flow flow({"R_O_PICK"});
  flow.place("A", 9);
  flow.place("B", 9);
  flow.transfer({0, -1}, {1, -1}, "R_O_PICK").once = true;
  for (int i = 0; i < 3; ++i) flow.put("A");
  flow.set("R_O_PICK", 1).run(0).run(kS);
  CHECK(flow.count("B") == 1);
  flow.set("R_O_PICK", 0).run(2 * kS).set("R_O_PICK", 1).run(3 * kS);
  CHECK(flow.count("B") == 2);
}

TEST_CASE("Work changes the parts of one kind when its condition begins to hold") {
  Flow flow({"M_O_DONE"});
  flow.place("FIXTURE", 3);
  flow.model.material.work.push_back({"mill", {0, -1}, flow.when("M_O_DONE"), 0, 1, 0});
  flow.put("FIXTURE");
  flow.set("M_O_DONE", 1).run(0).lines();
  flow.put("FIXTURE");
  flow.run(kS).lines();
  flow.set("M_O_DONE", 0).run(2 * kS).set("M_O_DONE", 1).run(3 * kS);
  CHECK(flow.lines() ==
        "t:2000000000,symbol:L_P_M_O_DONE,value:false\n"
        "t:3000000000,symbol:L_P_M_O_DONE,value:true\n"
        "t:3000000000,part:2,kind:done\n");
}

TEST_CASE("A source makes its kinds in turn, waits for room, and ends with its count") {
  Flow flow({"M_O_RUN"});
  track_and_place(flow, 9);
  model::Source& source = flow.source({0, -1});
  source.kinds = {0, 1};
  source.every = description::Duration::fixed(kS);
  source.first = 500 * kMs;
  source.count = 3;
  flow.run(3 * kS);
  CHECK(flow.lines() == "t:500000000,part:1,kind:raw,to:CV,x:200000\n");
  flow.set("M_O_RUN", 1).run(4 * kS);
  CHECK(flow.plant().next_due() == 6 * kS);  // 200 mm further
  flow.run(30 * kS);
  CHECK(flow.plant().counters[Counted::source_waited] > 0);
  const auto& material = flow.plant().save().material;
  CHECK(material.made == std::vector<std::uint64_t>{2, 1});
  CHECK(material.sources[0].due == tables::kNever);
  CHECK(flow.count("BOX") == 3);
}

TEST_CASE("A source without `every` makes one part, or all of its count as there is room") {
  Flow flow({"M_O_RUN"});
  flow.place("A", 9);
  flow.place("B", 2);
  flow.source({0, -1});
  flow.source({1, -1}).count = 5;
  flow.model.material.sources[1].name = "other";
  flow.run(kS);
  CHECK(flow.count("A") == 1);
  CHECK(flow.count("B") == 2);
  CHECK(flow.plant().take({1, -1}));
  flow.run(kS);
  CHECK(flow.count("B") == 2);
  CHECK(flow.plant().save().material.sources[1].made == 3);
}

TEST_CASE("Transfers in a circle are frozen as an instantaneous loop") {
  Flow flow({"M_O_RUN"});
  flow.place("A");
  flow.place("B");
  flow.transfer({0, -1}, {1, -1});
  flow.transfer({1, -1}, {0, -1}, "M_O_RUN");
  flow.put("A");
  flow.run(0);
  CHECK(flow.count("B") == 1);
  flow.lines();
  flow.set("M_O_RUN", 1).run(kS);
  const auto& material = flow.plant().save().material;
  CHECK(material.transfers[0].frozen);
  CHECK(material.transfers[1].frozen);
  CHECK(flow.plant().instants().back().findings.size() == 2);
  CHECK(flow.plant().instants().back().findings[0].of == flow.model.units.size());
  CHECK(flow.lines().find("instantaneous loop,of:T1 T2") != std::string::npos);
}

TEST_CASE("Devices and symbols see parts in the round after they came") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 0, "L_P_A.P1")};
  Flow flow({"A_I_P1", "A_I_P2"}, said);
  flow.place("BOX", 3);
  flow.model.units[0].conditions = {flow.when("BOX.done and BOX.parts >= 2")};
  flow.put("BOX", tables::kWhole, 1);
  flow.run(0);
  CHECK(flow.plant().unit(0).state == 0);
  flow.put("BOX");
  flow.run(kS);
  CHECK(flow.plant().unit(0).state == 1);
}

TEST_CASE("A part by hand needs room, and taking needs a part") {
  Flow flow({"M_O_RUN"});
  track_and_place(flow);
  const std::uint64_t before = flow.plant().state_hash();
  CHECK_FALSE(flow.plant().take({0, -1}));
  CHECK_FALSE(flow.plant().take({1, -1}));
  CHECK(flow.plant().state_hash() == before);
  CHECK(flow.put("BOX"));
  CHECK_FALSE(flow.put("BOX"));
  CHECK(flow.put("CV", 1000 * kMm));
  CHECK(flow.parts() == "1000000/0");  // its front is limited to the length
  CHECK(flow.plant().take({0, -1}));
}

}  // namespace
}  // namespace symplant::test

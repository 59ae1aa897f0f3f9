// A plant that fills every table, with names that could break code.
#pragma once

#include "unit/lower/altered_model.hpp"

namespace symplant::test {

inline constexpr const char* kEverythingName = "everything";

/// The model and the description that it points to.
struct Everything {
  description::DeviceDescription described;
  model::PlantModel plant;
};

inline void add_units(model::PlantModel& plant, const description::DeviceDescription& described) {
  using description::Duration;
  using model::kNone;
  model::Unit& agv = plant.units[0];  // AGV: P1, P2
  agv.transitions[0].takes = {Duration::Kind::uniform, tables::kSecond, 2 * tables::kSecond};
  agv.transitions[1].once = true;
  agv.travel = 3 * tables::kSecond;

  model::Unit& machine = plant.units[1];  // MC: IDLE1, RUN2, BUSY3
  machine.states.pop_back();              // BUSY3 is only an event
  machine.initial = 0;
  machine.transitions = {
      {0, 1, 1, {}, Duration::fixed(tables::kSecond), model::Origin::given, false, false, 0},
      {1, 0, kNone, {Duration::Kind::normal, 500, 20}, {}, model::Origin::given, false, false, 1},
  };
  const std::uint32_t level = symbol_of(plant, "LEVEL");
  const std::uint32_t speed = symbol_of(plant, "SPEED");
  machine.conditions = {
      settled(0, 1) && !(moving(2) || bit(symbol_of(plant, "STOP?\?/"))),
      number(level, tables::Comparison::less, tables::NumberKind::signed_integer, static_cast<std::uint64_t>(-5)) ||
          number(speed, tables::Comparison::greater_equal, tables::NumberKind::real, 0x3FF8'0000'0000'0000)};
  machine.outputs = {{}, {{{2, true}}, {{2, false}}}};
  machine.disables = {{}, {0, 2}};

  model::Unit& stopper = plant.units[2];  // STOPPER: ADV, RET; a spring
  stopper.transitions.push_back({0, 1, kNone, {}, Duration::fixed(8), model::Origin::given, true});
  stopper.described = &described;
  stopper.values = {level, speed};
  Tree many{Tree::Kind::all, false, {}, {}};
  for (const std::uint32_t side : {0U, 1U}) {
    for (const std::uint32_t symbol : plant.units[side].operations) many.children.push_back(bit(symbol));
    for (const std::uint32_t symbol : plant.units[side].events) many.children.push_back(bit(symbol));
  }
  stopper.conditions = {many};
  stopper.input_names = {"part\n"};

  model::Unit& second = plant.units[3];  // AGV2: as AGV, but with another travel time
  second.transitions[1].once = true;
}

/// One of each kind, with all times and conditions.
inline void add_malfunctions(model::PlantModel& plant) {
  using description::Duration;
  using tables::MalfunctionKind;
  const auto add = [&](const char* name, MalfunctionKind kind) -> model::Malfunction& {
    model::Malfunction& malfunction = plant.malfunctions.emplace_back();
    malfunction.name = name;
    malfunction.effects.emplace_back().kind = kind;
    return malfunction;
  };
  model::Malfunction& slow = add("AGV's wheel*/ \"?\?/\\", MalfunctionKind::slower);
  slow.effects[0].units = {{0, tables::kNoState}, {3, tables::kNoState}};
  slow.effects[0].factor = 1'500;
  slow.condition = settled(0, 1) && bit(symbol_of(plant, "STOP?\?/"));
  slow.chance = Duration{Duration::Kind::normal, 600 * tables::kSecond, 5};
  slow.after = 20 * tables::kSecond;
  slow.next = 1;
  slow.unless = moving(1);
  model::Malfunction& stuck = add("int", MalfunctionKind::stuck);
  stuck.effects[0].units = {{0, 1}};
  stuck.lasts = Duration{Duration::Kind::uniform, 7, 9};
  add("eye blind {{x}}", MalfunctionKind::force).effects[0].forces = {
      {symbol_of(plant, "HALT\\"), 1, false},
      {symbol_of(plant, "LEVEL"), static_cast<std::uint64_t>(-3), false},
      {symbol_of(plant, "SPEED"), 0, true}};
  model::Malfunction& loose = add("1st", MalfunctionKind::flicker);
  loose.effects[0].subject = symbol_of(plant, "L_P_MC_I_RUN2");
  loose.effects[0].every = Duration{Duration::Kind::uniform, tables::kSecond, 5 * tables::kSecond};
  loose.effects[0].shows = 80;
  loose.effects.emplace_back().units = {{1, tables::kNoState}};
  loose.condition = moving(0);
  loose.during = true;
  add("\xC3\xBC 1", MalfunctionKind::lose).effects[0].subject = 0;
}

inline std::unique_ptr<const Everything> everything() {
  auto made = std::make_unique<Everything>();
  made->described.type = "class";
  made->described.behaviour = "MyStopper\\";
  Analysed analysed = analyse_text(list_text({{"L_P_AGV_O_P1", "Y1"},
                                              {"L_P_AGV_O_P2", "Y2"},
                                              {"L_P_AGV_I_P1", "X1"},
                                              {"L_P_AGV_I_P2", "X2"},
                                              {"L_P_MC_O_IDLE1", "Y3"},
                                              {"L_P_MC_O_RUN2", "Y4"},
                                              {"L_P_MC_I_IDLE1", "X3"},
                                              {"L_P_MC_I_RUN2", "X4"},
                                              {"L_P_MC_I_BUSY3", "X5", "BOOL", "TRUE"},
                                              {"L_P_STOPPER_O_ADV", "Y5"},
                                              {"L_P_STOPPER_I_ADV", "X6"},
                                              {"L_P_STOPPER_I_RET", "X7"},
                                              {"STOP?\?/", "X8"},
                                              {"HALT\\", "X8"},
                                              {"LEVEL", "", "INT", "-5", "%IW1"},
                                              {"SPEED", "", "REAL", "0", "%QD2"},
                                              {"L_P_AGV2_O_P1", "Y6"},
                                              {"L_P_AGV2_O_P2", "Y7"},
                                              {"L_P_AGV2_I_P1", "X9"},
                                              {"L_P_AGV2_I_P2", "XA"}}),
                                   {}, std::string(kEverythingName) + ".csv");
  REQUIRE(analysed.derived);
  made->plant = std::move(analysed.derived->plant);
  add_units(made->plant, made->described);
  made->plant.requirements = {
      {"never both\\\n\"}; //", tables::RequirementRow::Kind::never, settled(0, 1) && settled(1, 1), {}, 0},
      {"answers", tables::RequirementRow::Kind::expect, settled(0, 1), settled(1, 1), 5 * tables::kSecond}};
  add_malfunctions(made->plant);
  description::Description places = *made->plant.description;
  places.view = {{"L_P_MC", 3, 1, ""}, {"L_P_AGV2", -1, -1, "to \"move\"?\?/\\"}};
  places.scene.plan = R"({"devices":{"L_P_MC":{"group":"to \"move\"??/ 전진 // */","x":1.5,"y":-2}}})";
  places.scene.view3d = R"({"cameras":{"gate":{"from":[5,3,5],"to":[0,0,0]}},"model":"cell.glb"})";
  made->plant.description = std::make_shared<const description::Description>(std::move(places));
  return made;
}

}  // namespace symplant::test

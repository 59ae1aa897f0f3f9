// Every device of the body-shop line that can move completes a motion, out and back.
#include <algorithm>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "app_support.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant::test {
namespace {

app::Compiled body_shop() {
  base::DiskFileSystem files;
  diag::Diagnostics diagnostics;
  std::ostringstream err;
  app::Progress progress(err, false);
  auto compiled =
      app::compile({SYMPLANT_SOURCE_DIR "/examples/body-shop/plant.json", {}, {}}, files, progress, diagnostics);
  REQUIRE(compiled.has_value());
  return std::move(*compiled);
}

std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// Commands each device out of its current state, and counts the motions that arrive.
class Drive final : public engine::Observer {
 public:
  explicit Drive(const app::Compiled& line)
      : model_(line.plant), tables_(line.tables.tables()), plant_(tables_), motions_(model_.units.size()) {
    for (const model::Unit& unit : model_.units) settled_.push_back(unit.initial);
    plant_.advance_to(0, this);
  }

  void instant(const engine::Instant& instant) noexcept override {
    for (const std::uint32_t u : instant.units) {
      const plant::UnitView unit = plant_.unit(u);
      if (unit.moving || unit.state == settled_[u]) continue;
      settled_[u] = unit.state;
      ++motions_[u];
    }
  }

  /// Opens a contact, as by hand: from its current state to the other one.
  void open(const std::string& device) {
    const auto unit = std::find_if(model_.units.begin(), model_.units.end(),
                                   [&](const model::Unit& candidate) { return candidate.path == device; });
    REQUIRE(unit != model_.units.end());
    REQUIRE(unit->states.front().name.rfind("NOT_", 0) == 0);
    plant_.set_state(static_cast<std::uint32_t>(unit - model_.units.begin()), 0);
  }

  /// Gives each device the first command that leads away from its current state, clears all others, and waits a
  /// minute.
  void command_all() {
    for (std::uint32_t u = 0; u < model_.units.size(); ++u) {
      const model::Unit& unit = model_.units[u];
      std::uint32_t command = model::kNone;
      for (const model::Transition& transition : unit.transitions) {
        if (command == model::kNone && transition.from == settled_[u]) command = transition.on;
      }
      for (std::uint32_t location = 0; location < unit.operations.size(); ++location) {
        plant_.set_operation(tables_.units[u].operation_bit + location, location == command);
      }
    }
    plant_.advance_to(plant_.now(), this);  // the PLC wrote before the minute, not at its end
    plant_.advance_to(plant_.now() + 60 * tables::kSecond, this);
  }

  /// The devices that can move and have completed fewer motions, one per line.
  std::string behind(int motions) const {
    std::string names;
    for (std::uint32_t u = 0; u < model_.units.size(); ++u) {
      if (model_.units[u].moves() && motions_[u] < motions) names += std::string(model_.units[u].path) + "\n";
    }
    return names;
  }

 private:
  const model::PlantModel& model_;
  tables::PlantTables tables_;
  plant::OwnedPlant plant_;
  std::vector<std::uint32_t> settled_;
  std::vector<int> motions_;
};

}  // namespace

TEST_CASE("Every device of the body-shop line that can move completes two motions") {
  const app::Compiled line = body_shop();
  const auto can_move =
      std::count_if(line.plant.units.begin(), line.plant.units.end(), [](const model::Unit& u) { return u.moves(); });
  CHECK(can_move == 636);
  CHECK(line.plant.units.size() == 1076);
  Drive drive(line);
  CHECK(lines(drive.behind(1)) == can_move);
  drive.command_all();
  INFO("behind after one command:\n" << drive.behind(1));
  CHECK(drive.behind(1).empty());
  drive.command_all();
  INFO("behind after two commands:\n" << drive.behind(2));
  CHECK(drive.behind(2).empty());
}

TEST_CASE(
    "Without air, behind an open door and after an emergency stop the devices of a body-shop station do not move") {
  const app::Compiled line = body_shop();
  Drive drive(line);
  drive.open("BODY_ROOF10_AIR");
  drive.open("BODY_ROOF20_DOOR2");
  drive.open("BODY_MOVE10_ESTOP1");
  drive.command_all();
  CHECK(drive.behind(1) ==
        "BODY_ROOF10_PIN1\nBODY_ROOF10_PIN2\nBODY_ROOF10_CLAMP1\nBODY_ROOF10_CLAMP2\nBODY_ROOF10_CLAMP3\n"
        "BODY_ROOF10_CLAMP4\nBODY_ROOF10_GRIPPER1\nBODY_ROOF10_ROBOT1\nBODY_ROOF10_ROBOT2\nBODY_ROOF20_LIFTER1\nBODY_"
        "ROOF20_ROBOT1\nBODY_ROOF20_ROBOT2\n"
        "BODY_MOVE10_SHUTTLE1\nBODY_MOVE10_CONVEYOR1\nBODY_MOVE10_LIFTER1\nBODY_MOVE10_DRIVE1\nBODY_MOVE10_DRIVE2\n");
}

}  // namespace symplant::test

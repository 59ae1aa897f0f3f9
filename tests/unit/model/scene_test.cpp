// The shapes of devices in the plan, and the names in `plan` and `view3d`.
#include "description_support.hpp"
#include "elements/scene/resolve.hpp"
#include "model/plan_shapes.hpp"

namespace symplant::test {
namespace {

std::string shapes(const std::vector<std::string>& names, description::Description description = {}) {
  const Analysed list = analyse_described(bits(names), description);
  std::string text;
  for (const tables::Shape shape : model::plan_shapes(list.model())) {
    text.append(text.empty() ? "" : " ").append(tables::shape_name(shape));
  }
  return text;
}

TEST_CASE("The last known word of a device's name gives its shape") {
  CHECK(shapes({"L_P_CLAMP1_O_CLOSE", "L_P_RBT1_O_GO", "L_P_CLAMPSENSOR_I_ON", "L_P_ButtonStart_I_PUSH",
                "L_P_HOISTBRAKE_O_ON", "L_P_DREHTISCH2_O_TURN"}) == "clamp robot sensor button device turntable");
}

TEST_CASE("Without a known word in its name, its states give the shape, and how it is actuated") {
  CHECK(shapes({"L_P_A1_O_ADV", "L_P_A1_O_RET", "L_P_B1_O_OPEN", "L_P_B1_O_CLOSE", "L_P_C1_I_THERE", "L_P_D1_O_GLOW",
                "L_P_E1_O_ALPHA1", "L_P_E1_O_BETA2", "L_P_E1_I_ALPHA1"}) == "cylinder valve sensor lamp device");
}

TEST_CASE("A short word within another one is no word") {
  CHECK(shapes({"L_P_SCANDAL_O_A1", "L_P_SCANDAL_O_B2", "L_P_SCANDAL_I_A1"}) == "device");
}

TEST_CASE("`view` gives the shape instead") {
  description::Description description;
  description.view.push_back({.device = "l_p_clamp1", .shape = tables::Shape::gripper});
  CHECK(shapes({"L_P_CLAMP1_O_CLOSE", "L_P_CLAMP2_O_CLOSE"}, description) == "gripper clamp");
}

std::string scene_faults(std::vector<description::SceneName> names, std::vector<std::string> groups = {}) {
  description::Description description;
  description.scene.plan = "{}";
  description.scene.names = std::move(names);
  description.scene.groups = std::move(groups);
  return faults(analyse_described(bits({"L_P_AGV_O_P1", "L_P_AGV_O_P2", "L_P_AGV_I_P1"}), description));
}

TEST_CASE("Names in `plan` and `view3d` that the plant does not have are reported with the nearest one") {
  using Kind = description::SceneName::Kind;
  CHECK(scene_faults({{Kind::device, "L_P_AGV", "", "/a"},
                      {Kind::frame, "L P", "", "/b"},
                      {Kind::posed, "L_P_AGV", "P2", "/c"}}) == "");
  CHECK(scene_faults({{Kind::device, "L_P_AGX", "", "/plan/devices/L_P_AGX"}}) ==
        "/plan/devices/L_P_AGX: device `L_P_AGX` not found; did you mean `L_P_AGV`?");
  CHECK(scene_faults({{Kind::posed, "L_P_AGV", "P3", "/p"}}) ==
        "/p: state `P3` of `L_P_AGV` not found; did you mean `P1`?");
  CHECK(scene_faults({{Kind::posed, "AGV", "P1", "/p"}}) == "/p: device `AGV` not found");
  CHECK(scene_faults({{Kind::location, "CV1", "", "/p"}}) == "/p: track or place `CV1` not found");
  CHECK(scene_faults({{Kind::number, "T.angle", "", "/p"}}) == "/p: value or numeric symbol `T.angle` not found");
  CHECK(scene_faults({{Kind::frame, "Safety", "", "/p"}}) == "/p: station or group `Safety` not found");
  CHECK(scene_faults({{Kind::frame, "Safety", "", "/p"}}, {"Safety"}) == "");
}

}  // namespace
}  // namespace symplant::test

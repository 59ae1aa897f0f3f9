// `view` of a description: where the panel shows devices, and its faults.
#include "model/layout.hpp"

#include "description_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kHall = {"L1_A_D1_I_X1", "L1_A_D1_I_X2", "L1_B_D2_I_X1",
                                        "L1_B_D2_I_X2", "L1_A_D3_I_X1", "L1_A_D3_I_X2"};

Analysed seen(std::vector<description::GivenView> view) {
  description::Description description;
  description.view = std::move(view);
  return analyse_described(bits(kHall), description);
}

/// "LINE/PROCESS x,y" for each device.
std::string shape(const model::Layout& layout) {
  std::string text;
  for (const model::DevicePlace& place : layout.devices) {
    const model::Station& station = layout.stations[place.station];
    text += station.line + "/" + station.process + " " + std::to_string(place.x) + "," + std::to_string(place.y) + "\n";
  }
  return text;
}

TEST_CASE("Without a `view` the layout follows from the names of devices") {
  const Analysed list = seen({});
  CHECK_FALSE(model::has_layout(list.model()));
  const model::Layout layout = model::layout_of(list.model());
  CHECK(layout.stations == std::vector<model::Station>{{"L1", "A"}, {"L1", "B"}});
  CHECK(shape(layout) == "L1/A -1,-1\nL1/B -1,-1\nL1/A -1,-1\n");
}

TEST_CASE("A device has a given place in its station, or is in a group") {
  const Analysed list = seen({{"l1_a_d1", 3, 1, ""}, {"L1_B_D2", -1, -1, "Robots"}, {"L1_A_D3", 0, 0, "Robots"}});
  REQUIRE(faults(list) == "");
  CHECK(model::has_layout(list.model()));
  CHECK(shape(model::layout_of(list.model())) == "L1/A 3,1\n/Robots -1,-1\n/Robots 0,0\n");
}

TEST_CASE("A device that the plant does not have is reported with the nearest one") {
  CHECK(faults(seen({{"L1_A_D11", 0, 0, ""}})) ==
        "/view/L1_A_D11: device `L1_A_D11` not found; did you mean `L1_A_D1`?");
}

}  // namespace
}  // namespace symplant::test

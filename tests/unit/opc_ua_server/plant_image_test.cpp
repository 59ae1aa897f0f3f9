// What the cycle shows the server of the plant.
#include "symplant/link/opc_ua/plant_image.hpp"

#include "support/catch.hpp"
#include "symplant/link/opc_ua/carried.hpp"
#include "unit/exec/cell.hpp"

using namespace symplant;
using link::opc_ua::PlantImage;
using link::opc_ua::PlantWords;
using link::opc_ua::UnitState;
using link::opc_ua::unpack_unit;

namespace {

class Shown {
 public:
  Shown()
      : tables_(test::cell_tables()),
        map_(link::opc_ua::carried_symbols(tables_, 0, {}).map),
        plant_(tables_),
        image_(tables_, map_) {
    plant_->advance_to(0);
  }

  void cycle(tables::Time time) {
    plant_->advance_to(time);
    image_.write(*plant_, {.cycles = cycles_++});
    REQUIRE(image_.take());
  }
  UnitState unit(std::uint32_t unit) const { return unpack_unit(image_.words()[image_.at().units + unit]); }
  bool is_decided(std::uint32_t point) const { return (image_.words()[image_.at().decided] >> point & 1) != 0; }
  std::uint64_t word(std::size_t word) const { return image_.words()[word]; }
  plant::Plant& plant() { return *plant_; }
  PlantImage& image() { return image_; }

 private:
  tables::PlantTables tables_;
  link::image::Map map_;
  test::OwnedPlant plant_;
  PlantImage image_;
  std::uint64_t cycles_ = 0;
};

}  // namespace

TEST_CASE("The server sees the state of each device, and how far it has moved") {
  Shown shown;
  shown.cycle(0);
  CHECK(shown.unit(0).state == 0);
  CHECK_FALSE(shown.unit(0).moving);
  shown.plant().set_operation(test::cell::kAgvToP2, true);
  shown.cycle(10 * tables::kMillisecond);
  shown.cycle(510 * tables::kMillisecond);
  CHECK(shown.unit(0).state == 0);
  CHECK(shown.unit(0).target == 1);
  CHECK(shown.unit(0).moving);
  CHECK(shown.unit(0).progress == 500);
  shown.cycle(2 * tables::kSecond);
  CHECK(shown.unit(0).state == 1);
  CHECK_FALSE(shown.unit(0).moving);
}

TEST_CASE("The server sees cycles, plant time and whether the plant is frozen") {
  Shown shown;
  CHECK(shown.word(PlantWords::kCycles) == 0);
  shown.cycle(10 * tables::kMillisecond);
  shown.cycle(20 * tables::kMillisecond);
  CHECK(shown.word(PlantWords::kCycles) == 2);
  CHECK(shown.word(PlantWords::kPlantTime) == 20'000'000);
  CHECK(shown.word(PlantWords::kFrozen) == 0);
  shown.image().write(shown.plant(), {.cycles = 2, .frozen = true});
  REQUIRE(shown.image().take());
  CHECK(shown.word(PlantWords::kFrozen) == 1);
}

TEST_CASE("The server sees which events a malfunction decides, as long as it does") {
  Shown shown;
  const std::uint32_t stuck = shown.plant().malfunction_numbers().stuck(1, true);
  shown.cycle(0);
  CHECK_FALSE(shown.is_decided(1));
  REQUIRE(shown.plant().start_malfunction(stuck));
  shown.cycle(10 * tables::kMillisecond);
  CHECK(shown.is_decided(1));
  CHECK_FALSE(shown.is_decided(0));
  REQUIRE(shown.plant().stop_malfunction(stuck));
  shown.cycle(20 * tables::kMillisecond);
  CHECK_FALSE(shown.is_decided(1));
}

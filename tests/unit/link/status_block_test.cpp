// The registers of the status block.
#include "symplant/link/image/status_block.hpp"

#include "support/catch.hpp"

using symplant::exec::LinkState;
using symplant::link::WordOrder;
using namespace symplant::link::image;
using namespace symplant::link::modbus;
using symplant::link::kStatusWords;

namespace {

using Registers = std::array<std::uint16_t, kStatusRegisters>;

constexpr StatusBlock kBlock = {.state = PlantState::run,
                                .cycles = 0x1'0005,
                                .live = 0x7'8003,
                                .lost_exchanges = 0x1'2345'6789,
                                .overruns = 0x0002'0001,
                                .map_hash = 0x0123'4567'89AB'CDEF};

}  // namespace

TEST_CASE("The status block is as documented, with the low word first") {
  CHECK(registers_of(kBlock, WordOrder::low_first) ==
        Registers{1, 5, 1, 0x8003, 0x6789, 0x2345, 1, 2, 0xCDEF, 0x89AB, 0x4567, 0x0123});
}

TEST_CASE("The status block is as documented, with the high word first") {
  CHECK(registers_of(kBlock, WordOrder::high_first) ==
        Registers{1, 5, 1, 0x8003, 0x2345, 0x6789, 2, 1, 0x0123, 0x4567, 0x89AB, 0xCDEF});
}

TEST_CASE("The plant's state is that of the run, then of the plant, then of the link") {
  CHECK(plant_state(LinkState::waiting, false, false) == PlantState::waiting);
  CHECK(plant_state(LinkState::live, false, false) == PlantState::run);
  CHECK(plant_state(LinkState::lost, false, false) == PlantState::link_lost);
  CHECK(plant_state(LinkState::live, true, false) == PlantState::frozen);
  CHECK(plant_state(LinkState::lost, true, false) == PlantState::frozen);
  CHECK(plant_state(LinkState::lost, true, true) == PlantState::stopping);
  CHECK(plant_state(LinkState::waiting, false, true) == PlantState::stopping);
}

// The status of the plant as numbers, and as the registers of a Modbus server.
#include <vector>

#include "support/catch.hpp"
#include "symplant/link/image/status.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/link/modbus/tables.hpp"
#include "unit/link/symbol_list.hpp"

using symplant::exec::LinkState;
using symplant::link::WordOrder;
using symplant::test::SymbolList;
using namespace symplant::link::image;
using namespace symplant::link::modbus;

namespace {

constexpr Status kStatus = {.state = PlantState::run,
                            .cycles = 0x1'0005,
                            .live = 0x7'8003,
                            .lost_exchanges = 0x1'2345'6789,
                            .overruns = 0x0002'0001,
                            .map_hash = 0x0123'4567'89AB'CDEF};

using Registers = std::vector<std::uint16_t>;

/// The status block of a map whose other numbers are 0.
Registers registers_of(const Status& status, WordOrder order) {
  SymbolList list;
  list.add("N", SymbolList::kIn, 3, symplant::tables::DataType::dint);
  symplant::link::LinkSettings settings;
  settings.word_order = order;
  settings.status_block = 100;
  const IoMap map = make_io_map(list.tables(), 0, settings);
  const Map image = image_of(list.tables(), map);
  std::vector<std::uint64_t> numbers(image.size(symplant::link::Plane::event_numbers));
  std::uint32_t position = image.status.value();
  for (const std::uint64_t number : numbers_of(status)) numbers[position++] = number;
  const std::vector<std::uint32_t> lanes = lanes_of(map, image, Table::input_register);
  const InputRegisters input{numbers, lanes};
  Registers registers;
  for (std::uint32_t i = 0; i < symplant::link::kStatusWords; ++i) registers.push_back(input[100 + i]);
  CHECK(input[3] == 0);
  return registers;
}

}  // namespace

TEST_CASE("The status block is as documented, with the low word first") {
  CHECK(registers_of(kStatus, WordOrder::low_first) ==
        Registers{1, 5, 1, 0x8003, 0x6789, 0x2345, 1, 2, 0xCDEF, 0x89AB, 0x4567, 0x0123});
}

TEST_CASE("The status block is as documented, with the high word first") {
  CHECK(registers_of(kStatus, WordOrder::high_first) ==
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

// A Modbus server link over a socket, with cycles run by the test.
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

using exec::LinkState;
using link::LinkSettings;
using tables::kMillisecond;
using tables::kSecond;

/// Two coils, a holding register and a discrete input; the test runs each cycle of 10 ms.
struct LossBench {
  explicit LossBench(const LinkSettings& settings = {}) : tables(made()), plant(tables) {
    auto opened = link::open_link({"modbus-tcp-server://127.0.0.1:0", 0, settings}, tables);
    REQUIRE(std::holds_alternative<std::unique_ptr<link::Link>>(opened));
    link = std::move(std::get<std::unique_ptr<link::Link>>(opened));
    plant->advance_to(0);
    link->write_events(*plant, {});
    client = std::make_unique<RawClient>(port_of(*link));
  }
  const tables::PlantTables& made() {
    list.add("A", SymbolList::kOut, 0);
    list.add("B", SymbolList::kOut, 1);
    list.add("N", SymbolList::kOut, 2, tables::DataType::int_);
    list.add("E", SymbolList::kIn, 0);
    owned = list.tables();
    return owned;
  }

  void cycle(bool frozen = false) {
    now += 10 * kMillisecond;
    link->read_operations(*plant, now);
    plant->advance_to(plant->now() + 10 * kMillisecond);
    link->write_events(*plant,
                       {.cycles = cycles++, .live = link->state() == LinkState::live ? 1U : 0U, .frozen = frozen});
    plant->forget_changed_events();
  }
  void silence(tables::Time time) {
    for (tables::Time t = 0; t < time; t += 10 * kMillisecond) cycle();
  }
  bool a() { return plant->operation(0); }
  bool b() { return plant->operation(1); }
  std::uint64_t n() { return plant->operation_value(0); }

  void write_coil(std::uint8_t address, bool on) {
    REQUIRE(client->ask({5, 0, address, static_cast<std::uint8_t>(on ? 0xFF : 0), 0}).size() == 5);
  }
  void write_register(std::uint8_t address, std::uint8_t value) {
    REQUIRE(client->ask({6, 0, address, 0, value}).size() == 5);
  }
  /// A register of the status block, which starts at 100.
  int status(std::uint8_t address) {
    const Bytes answer = client->ask({4, 0, static_cast<std::uint8_t>(100 + address), 0, 1});
    REQUIRE(answer.size() == 4);
    return answer[2] << 8 | answer[3];
  }

  SymbolList list;
  tables::PlantTables owned{};
  tables::PlantTables tables;
  OwnedPlant plant;
  std::unique_ptr<link::Link> link;
  std::unique_ptr<RawClient> client;
  tables::Time now = 77;
  std::uint64_t cycles = 0;
};

}  // namespace symplant::test

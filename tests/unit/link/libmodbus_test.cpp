// An independent client, libmodbus, with the symplant server.
#include <modbus/modbus.h>

#include <array>

#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using test::SymbolList;

namespace {

class Client {
 public:
  explicit Client(std::uint16_t port) : context_(modbus_new_tcp("127.0.0.1", port)) {
    modbus_set_response_timeout(context_, 30, 0);
    REQUIRE(modbus_connect(context_) == 0);
  }
  ~Client() {
    modbus_close(context_);
    modbus_free(context_);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  operator modbus_t*() const { return context_; }

 private:
  modbus_t* context_;
};

}  // namespace

TEST_CASE("libmodbus reads and writes the paper's cell") {
  test::CellServer server;
  const Client client(server.port());
  std::array<std::uint8_t, 4> bits{};
  REQUIRE(modbus_read_input_bits(client, 1, 4, bits.data()) == 4);
  CHECK(bits == std::array<std::uint8_t, 4>{1, 0, 1, 0});
  CHECK(modbus_write_bit(client, 1, 1) == 1);
  const std::array<std::uint8_t, 3> more = {0, 0, 1};
  CHECK(modbus_write_bits(client, 2, 3, more.data()) == 3);
  REQUIRE(modbus_read_bits(client, 1, 4, bits.data()) == 4);
  CHECK(bits == std::array<std::uint8_t, 4>{1, 0, 0, 1});
  server.cycle(10 * tables::kMillisecond);
  server.cycle(tables::kSecond);
  REQUIRE(modbus_read_input_bits(client, 1, 4, bits.data()) == 4);
  CHECK(bits == std::array<std::uint8_t, 4>{0, 1, 0, 1});
}

TEST_CASE("libmodbus reads and writes registers") {
  SymbolList list;
  list.add("SPEED", SymbolList::kOut, 3, tables::DataType::int_);
  list.add("LEVEL", SymbolList::kIn, 2, tables::DataType::word);
  list.start_at(1, 0xBEEF);
  const auto tables = list.tables();
  test::OwnedPlant plant(tables);
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables);
  plant->advance_to(0);
  link->write_events(*plant, {});
  const Client client(test::port_of(*link));
  std::uint16_t value = 0;
  REQUIRE(modbus_read_input_registers(client, 2, 1, &value) == 1);
  CHECK(value == 0xBEEF);
  CHECK(modbus_write_register(client, 3, 1234) == 1);
  const std::array<std::uint16_t, 2> two = {0xFFFF, 7};
  CHECK(modbus_write_registers(client, 3, 2, two.data()) == 2);
  REQUIRE(modbus_read_registers(client, 4, 1, &value) == 1);
  CHECK(value == 7);
  link->read_operations(*plant, 0);
  plant->advance_to(tables::kMillisecond);
  CHECK(static_cast<std::int64_t>(plant->operation_value(0)) == -1);
  CHECK(link->status().writes_to_gaps == 1);
}

TEST_CASE("libmodbus understands the exceptions") {
  test::CellServer server;
  const Client client(server.port());
  std::array<std::uint8_t, 64> bits{};
  CHECK(modbus_read_bits(client, 0, 64, bits.data()) == -1);
  CHECK(errno == EMBXILADD);
  std::uint16_t value = 0;
  CHECK(modbus_mask_write_register(client, 0, 1, 1) == -1);
  CHECK(errno == EMBXILADD);
  CHECK(modbus_report_slave_id(client, bits.size(), bits.data()) == -1);
  CHECK(errno == EMBXILFUN);
  CHECK(modbus_read_registers(client, 0, 1, &value) == -1);
  CHECK(errno == EMBXILADD);
}

// An independent client and server, libmodbus, with the symplant server and client.
#include <modbus/modbus.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <thread>

#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"
#include "unit/modbus/dialog_bench.hpp"

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

/// A server with 100 addresses in each area, for one connection. Its memory may be used between two requests.
class Server {
 public:
  Server() : context_(modbus_new_tcp("127.0.0.1", 0)), memory_(modbus_mapping_new(100, 100, 100, 100)) {
    listener_ = modbus_tcp_listen(context_, 1);
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
      throw std::runtime_error("no port");
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  /// The client must have closed its connection.
  ~Server() {
    thread_.join();
    modbus_close(context_);
    ::close(listener_);
    modbus_mapping_free(memory_);
    modbus_free(context_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const { return port_; }
  modbus_mapping_t& memory() { return *memory_; }

 private:
  void run() {
    int listener = listener_;
    if (modbus_tcp_accept(context_, &listener) < 0) return;
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
    for (;;) {
      const int size = modbus_receive(context_, request.data());
      if (size < 0) return;
      modbus_reply(context_, request.data(), size, memory_);
    }
  }

  modbus_t* context_;
  modbus_mapping_t* memory_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

}  // namespace

TEST_CASE("The Modbus client reads and writes a server of libmodbus") {
  Server server;
  server.memory().tab_bits[3] = 1;
  server.memory().tab_registers[6] = 0xBEEF;
  SymbolList list;
  list.add("OPEN", SymbolList::kOut, 3);
  list.add("MODE", SymbolList::kOut, 6, tables::DataType::word);
  list.add("FAR", SymbolList::kOut, 100);
  list.add("IS_OPEN", SymbolList::kIn, 4);
  list.add("LEVEL", SymbolList::kIn, 2, tables::DataType::dint);
  test::DialogBench bench(list, server.port(), "events=coils:50&event-values=holding-registers:50&timeout=30s");
  REQUIRE_FALSE(bench.dialog().open());
  link::client::Fault fault;
  CHECK_THAT(bench.dialog().identify(fault).message, Catch::Matchers::ContainsSubstring("its operations can be read"));
  REQUIRE_FALSE(fault);
  REQUIRE_FALSE(bench.read());
  CHECK(bench.bit(3));
  CHECK(bench.number(6) == 0xBEEF);
  CHECK_THAT(bench.dialog().take_rejections().front().message,
             Catch::Matchers::ContainsSubstring("coil 100: exception 02"));
  bench.set_bit(4, true);
  bench.set_number(4, 0x1234);
  bench.set_number(5, 0x5678);
  REQUIRE_FALSE(bench.write());
  std::vector<std::uint64_t> bits(8);
  std::vector<std::uint64_t> numbers(8);
  REQUIRE_FALSE(bench.read_back(bits, numbers));
  CHECK(bench.outbox().differences({bits, numbers}).empty());
  bench.dialog().close();
  CHECK(server.memory().tab_bits[54] == 1);
  CHECK(server.memory().tab_registers[54] == 0x1234);
  CHECK(server.memory().tab_registers[55] == 0x5678);
}

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

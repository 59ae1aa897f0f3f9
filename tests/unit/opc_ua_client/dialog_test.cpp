// The link `opc-ua` with a PLC that is a server of open62541.
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "support/catch.hpp"
#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/link/opc_ua/client_link_parts.hpp"
#include "unit/link/symbol_list.hpp"
#include "unit/opc_ua_client/plc.hpp"

using namespace symplant;
using namespace symplant::link;
using Catch::Matchers::ContainsSubstring;
using client::Fault;
using tables::DataType;
using test::OpcUaPlc;
using test::SymbolList;

namespace {

constexpr auto kIn = SymbolList::kIn;
constexpr auto kOut = SymbolList::kOut;
constexpr tables::Time kSecond = tables::kSecond;

/// A dialog with a PLC, and the planes of its images. Times are given by the tests.
class Bench {
 public:
  Bench(const SymbolList& list, const OpcUaPlc& plc, const std::string& more = {}) : Bench(list, plc.port(), more) {}
  Bench(const SymbolList& list, std::uint16_t port, const std::string& more = {})
      : Bench(list, "127.0.0.1:" + std::to_string(port), more) {}
  Bench(const SymbolList& list, const std::string& address, const std::string& more = {})
      : tables_(list.tables()), parts_(parts_of("//" + address + kNodes + more, tables_)) {
    operation_bits.resize(image::bit_words(parts_.map.size(Plane::operation_bits)));
    operation_numbers.resize(parts_.map.size(Plane::operation_numbers));
    event_bits.resize(image::bit_words(parts_.map.size(Plane::event_bits)));
    event_numbers.resize(parts_.map.size(Plane::event_numbers));
  }

  client::Dialog& dialog() { return *parts_.dialog; }
  /// Connects and looks at the nodes.
  client::Identity start() {
    Fault fault = dialog().open();
    if (fault) FAIL(fault.message);
    const client::Identity identity = dialog().identify(fault);
    if (fault) FAIL(fault.message);
    return identity;
  }
  Fault read(tables::Time now = 0) { return dialog().read({operation_bits, operation_numbers}, now); }
  Fault read_back() { return dialog().read_back({event_bits, event_numbers}, 0); }

  /// Writes all lanes of the events, from the planes.
  std::vector<client::Unwritten> write() {
    std::vector<client::LaneChange> changes;
    for (const client::EventLanes& event : client::event_lanes(tables_, parts_.map)) {
      for (client::LaneChange lane : event.lanes) {
        const auto& words = lane.lane.plane == Plane::event_bits ? event_bits : event_numbers;
        lane.value = image::get_lane(words, lane.lane.number);
        if (!changes.empty() && changes.back().lane == lane.lane) {
          changes.back().mask = static_cast<std::uint16_t>(changes.back().mask | lane.mask);
        } else {
          changes.push_back(lane);
        }
      }
    }
    return write(changes);
  }
  std::vector<client::Unwritten> write(const std::vector<client::LaneChange>& changes) {
    std::vector<client::Unwritten> unwritten;
    if (const Fault fault = dialog().write(changes, unwritten)) FAIL(fault.message);
    return unwritten;
  }
  /// The messages of what the PLC refused since the last call.
  std::string rejections() {
    std::string text;
    for (const client::Rejection& one : dialog().take_rejections()) text += one.message + "\n";
    return text;
  }

  std::vector<std::uint64_t> operation_bits, operation_numbers, event_bits, event_numbers;

 private:
  static constexpr const char* kNodes = "?nodes=ns=1;s=\"{symbol}\"";

  static client::ClientParts parts_of(const std::string& rest, const tables::PlantTables& tables) {
    auto parts = opc_ua::client_link_parts(rest, {.url = "opc-ua:" + rest, .controller = 0}, tables);
    if (const auto* error = std::get_if<LinkError>(&parts)) FAIL(error->message);
    return std::get<client::ClientParts>(std::move(parts));
  }

  tables::PlantTables tables_;
  client::ClientParts parts_;
};

/// Two operations and two events.
SymbolList small_list() {
  SymbolList list;
  list.add("RUN", kOut, 0U);
  list.add("SPEED", kOut, 1U, DataType::int_);
  list.add("READY", kIn, 0U);
  list.add("LEVEL", kIn, 1U, DataType::dint);
  return list;
}

void add_small(OpcUaPlc& plc) {
  plc.add<UA_Boolean>("RUN", UA_TYPES_BOOLEAN, true);
  plc.add<UA_Int16>("SPEED", UA_TYPES_INT16, -7);
  plc.add<UA_Boolean>("READY", UA_TYPES_BOOLEAN, false);
  plc.add<UA_Int32>("LEVEL", UA_TYPES_INT32, 0);
}

std::int16_t as_int(std::uint64_t number) { return static_cast<std::int16_t>(number); }

}  // namespace

TEST_CASE("Operations are read in one request, events written in one and read back in one") {
  OpcUaPlc plc;
  add_small(plc);
  const SymbolList list = small_list();
  Bench bench(list, plc);
  const client::Identity identity = bench.start();
  CHECK(identity.kind == client::Identity::Kind::unverifiable);
  CHECK_THAT(identity.message, ContainsSubstring("it has the nodes of 2 of 2 operations and 2 of 2 events"));
  const std::uint64_t before = bench.dialog().requests();
  REQUIRE(!bench.read());
  CHECK(bench.dialog().requests() == before + 1);
  CHECK(image::get_bit(bench.operation_bits, 0));
  CHECK(as_int(bench.operation_numbers[0]) == -7);
  image::set_bit(bench.event_bits, 0, true);
  bench.event_numbers[0] = static_cast<std::uint64_t>(std::int64_t{-70'000});
  CHECK(bench.write().empty());
  CHECK(bench.dialog().requests() == before + 2);
  CHECK(plc.get<UA_Boolean>("READY"));
  CHECK(plc.get<UA_Int32>("LEVEL") == -70'000);
  bench.event_bits[0] = bench.event_numbers[0] = 0;
  REQUIRE(!bench.read_back());
  CHECK(bench.dialog().requests() == before + 3);
  CHECK(image::get_bit(bench.event_bits, 0));
  CHECK(static_cast<std::int32_t>(bench.event_numbers[0]) == -70'000);
}

TEST_CASE("A number of which a part has changed is written whole") {
  OpcUaPlc plc;
  add_small(plc);
  const SymbolList list = small_list();
  Bench bench(list, plc);
  bench.start();
  bench.event_numbers[0] = 0x0001'0002;
  bench.write();
  CHECK(bench.write({{{Plane::event_numbers, 1}, 0xFFFF, 5}}).empty());
  CHECK(plc.get<UA_Int32>("LEVEL") == 0x0005'0002);
}

TEST_CASE("A server that allows few nodes in a request gets several requests") {
  OpcUaPlc plc(2);
  SymbolList list;
  constexpr std::uint32_t kCount = 5;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    list.add("Q" + std::to_string(i), kOut, i);
    list.add("I" + std::to_string(i), kIn, i);
    plc.add<UA_Boolean>("Q" + std::to_string(i), UA_TYPES_BOOLEAN, i % 2 == 0);
    plc.add<UA_Boolean>("I" + std::to_string(i), UA_TYPES_BOOLEAN, false);
  }
  Bench bench(list, plc);
  bench.start();
  const std::uint64_t before = bench.dialog().requests();
  REQUIRE(!bench.read());
  CHECK(bench.dialog().requests() == before + 3);
  CHECK(bench.operation_bits[0] == 0b10101);
  bench.event_bits[0] = 0b11001;
  CHECK(bench.write().empty());
  CHECK(plc.get<UA_Boolean>("I4"));
  CHECK(!plc.get<UA_Boolean>("I1"));
  CHECK_THAT(bench.dialog().functions(), ContainsSubstring("reads 2 nodes in a request"));
}

TEST_CASE("If the server refuses one of several requests, only the nodes from it on have no value") {
  OpcUaPlc plc(2);
  SymbolList list;
  constexpr std::uint32_t kCount = 6;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    list.add("Q" + std::to_string(i), kOut, i);
    plc.add<UA_Boolean>("Q" + std::to_string(i), UA_TYPES_BOOLEAN, true);
  }
  Bench bench(list, plc);
  bench.start();
  plc.fail_read(2, UA_STATUSCODE_BADINTERNALERROR);
  CHECK(bench.read().kind == Fault::Kind::rejected);
  CHECK(bench.operation_bits[0] == 0b11);
  CHECK_THAT(bench.rejections(), ContainsSubstring("4 operations are not read: `Q2`"));
  CHECK(bench.dialog().rejected() == 1);
  REQUIRE(!bench.read());
  CHECK(bench.operation_bits[0] == 0b111111);
}

TEST_CASE("Nodes that are missing, of another type or read-only are reported, and the others exchanged") {
  OpcUaPlc plc;
  plc.add<UA_Boolean>("RUN", UA_TYPES_BOOLEAN, true);
  plc.add<UA_Float>("SPEED", UA_TYPES_FLOAT, 1.5F);
  plc.add<UA_Boolean>("READY", UA_TYPES_BOOLEAN, true, false);
  const SymbolList list = small_list();
  Bench bench(list, plc);
  CHECK_THAT(bench.start().message, ContainsSubstring("1 of 2 operations and 0 of 2 events"));
  REQUIRE(!bench.read());
  CHECK(image::get_bit(bench.operation_bits, 0));
  const std::string said = bench.rejections();
  CHECK_THAT(said,
             ContainsSubstring("1 operation is not read: `SPEED` (ns=1;s=\"SPEED\", the symbol is INT, which is Int16, "
                               "the node is Float): BadTypeMismatch"));
  CHECK_THAT(said, ContainsSubstring("1 event is not written: `READY` (ns=1;s=\"READY\"): BadNotWritable"));
  CHECK_THAT(said, ContainsSubstring("1 event is not written: `LEVEL` (ns=1;s=\"LEVEL\"): BadNodeIdUnknown"));
  REQUIRE(!bench.read_back());
  CHECK(image::get_bit(bench.event_bits, 0));  // it can be read
  CHECK(bench.write().size() == 3);            // a bit, and the two lanes of a number
  CHECK(bench.rejections().empty());           // once
  REQUIRE(!bench.read(2 * kSecond));
  CHECK(bench.dialog().take_left_out().empty());
  REQUIRE(!bench.read(4 * kSecond));
  const auto left_out = bench.dialog().take_left_out();
  REQUIRE(left_out.size() == 1);
  CHECK(left_out[0].lanes.lane == client::Lane{Plane::operation_numbers, 0});
}

TEST_CASE("A word of bits may be a number with a sign in the PLC") {
  OpcUaPlc plc;
  plc.add<UA_Int16>("Q", UA_TYPES_INT16, -1);
  plc.add<UA_Int32>("I", UA_TYPES_INT32, 0);
  SymbolList list;
  list.add("Q", kOut, 0U, DataType::word);
  list.add("I", kIn, 0U, DataType::dword);
  Bench bench(list, plc);
  bench.start();
  REQUIRE(!bench.read());
  CHECK(bench.operation_numbers[0] == 0xFFFF);
  bench.event_numbers[0] = 0xFFFF'FFFE;
  CHECK(bench.write().empty());
  CHECK(plc.get<UA_Int32>("I") == -2);
}

TEST_CASE("A value with a bad status is not used until it is good again") {
  OpcUaPlc plc;
  add_small(plc);
  const SymbolList list = small_list();
  Bench bench(list, plc);
  bench.start();
  REQUIRE(!bench.read());
  plc.set<UA_Int16>("SPEED", UA_TYPES_INT16, 99, UA_STATUSCODE_BADSENSORFAILURE);
  REQUIRE(!bench.read(kSecond));
  CHECK(as_int(bench.operation_numbers[0]) == -7);
  CHECK_THAT(bench.rejections(), ContainsSubstring("`SPEED` (ns=1;s=\"SPEED\"): BadSensorFailure"));
  REQUIRE(!bench.read(2 * kSecond));
  CHECK(bench.rejections().empty());
  plc.set<UA_Int32>("LEVEL", UA_TYPES_INT32, 5, UA_STATUSCODE_BADWAITINGFORINITIALDATA);
  REQUIRE(!bench.read_back());
  CHECK(bench.event_numbers[0] == 0);
  CHECK(bench.rejections().empty());  // an event may have no value before it is written
  plc.set<UA_Int16>("SPEED", UA_TYPES_INT16, 98, UA_STATUSCODE_UNCERTAININITIALVALUE);
  REQUIRE(!bench.read(3 * kSecond));
  CHECK(as_int(bench.operation_numbers[0]) == 98);
}

TEST_CASE("A node that appears later is found, and one that disappears is reported") {
  OpcUaPlc plc;
  add_small(plc);
  plc.remove("RUN");
  const SymbolList list = small_list();
  Bench bench(list, plc);
  bench.start();
  plc.add<UA_Boolean>("RUN", UA_TYPES_BOOLEAN, true);
  REQUIRE(!bench.read(kSecond / 10));
  CHECK(!image::get_bit(bench.operation_bits, 0));  // it is looked for again after half a second
  REQUIRE(!bench.read(kSecond));
  CHECK(image::get_bit(bench.operation_bits, 0));
  plc.remove("SPEED");
  bench.rejections();
  REQUIRE(!bench.read(2 * kSecond));
  CHECK_THAT(bench.rejections(), ContainsSubstring("`SPEED`"));
  plc.add<UA_Int16>("SPEED", UA_TYPES_INT16, 42);
  REQUIRE(!bench.read(10 * kSecond));
  CHECK(as_int(bench.operation_numbers[0]) == 42);
}

TEST_CASE("A PLC without any of the nodes is not a reading") {
  OpcUaPlc plc;
  const SymbolList list = small_list();
  Bench bench(list, plc);
  bench.start();
  CHECK(bench.read().kind == Fault::Kind::rejected);
}

TEST_CASE("A PLC that does not answer, or has another session, is a fault of the transport") {
  auto plc = std::make_unique<OpcUaPlc>();
  add_small(*plc);
  const SymbolList list = small_list();
  Bench bench(list, *plc, "&timeout=100ms");
  bench.start();
  plc->silent(true);
  Fault fault = bench.read();
  CHECK(fault.kind == Fault::Kind::transport);
  CHECK_THAT(fault.message, ContainsSubstring("does not answer any more"));
  bench.dialog().close();
  plc->silent(false);
  const std::uint16_t port = plc->port();
  bench.start();
  plc.reset();
  fault = bench.read();
  CHECK(fault.kind == Fault::Kind::transport);
  CHECK_THAT(fault.message, ContainsSubstring("connection lost"));
  bench.dialog().close();
  CHECK_THAT(bench.dialog().open().message, ContainsSubstring("no connection to 127.0.0.1:"));
  plc = std::make_unique<OpcUaPlc>(0, port);
  add_small(*plc);
  bench.start();
  REQUIRE(!bench.read());
  CHECK(image::get_bit(bench.operation_bits, 0));
}

TEST_CASE("A PLC that does not read a long request is a fault of the transport") {
  constexpr std::size_t kLongName = 100'000;
  constexpr std::uint32_t kCount = 100;  // of 10 MB: more than the buffers of the sockets
  OpcUaPlc plc;
  SymbolList list;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const std::string name = "Q" + std::to_string(i) + std::string(kLongName, 'x');
    list.add(name, kOut, i);
    plc.add<UA_Boolean>(name, UA_TYPES_BOOLEAN, false);
  }
  Bench bench(list, plc, "&timeout=2s");
  bench.start();
  REQUIRE(!bench.read());
  plc.silent(true);
  CHECK(bench.read().kind == Fault::Kind::transport);
}

TEST_CASE("A call that waits for a PLC ends when it is interrupted") {
  OpcUaPlc plc;
  add_small(plc);
  const SymbolList list = small_list();
  Bench bench(list, plc, "&timeout=1h");
  bench.start();
  plc.silent(true);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    bench.dialog().interrupt();
  });
  CHECK(bench.read().kind == Fault::Kind::interrupted);
  other.join();
}

TEST_CASE("A server that closes every connection is not flooded with new ones") {
  auto bound = net::listen_on({"127.0.0.1", 0});
  net::Listener& listener = std::get<net::Listener>(bound);
  std::atomic<bool> ended{false};
  std::atomic<int> accepted{0};
  std::thread server([&] {
    while (!ended) {
      if (const int socket = ::accept(listener.socket.get(), nullptr, nullptr); socket >= 0) {
        ++accepted;
        ::close(socket);
      } else {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
  });
  const SymbolList list = small_list();
  Bench bench(list, listener.bound.port);
  const Fault fault = bench.dialog().open();
  ended = true;
  server.join();
  CHECK(fault.kind == Fault::Kind::transport);
  CHECK_THAT(fault.message, ContainsSubstring("BadConnectionClosed"));
  CHECK(accepted > 0);
  CHECK(accepted <= 6);
}

TEST_CASE("The host of a PLC may have a name, and one that is not found is reported") {
  OpcUaPlc plc;
  add_small(plc);
  const SymbolList list = small_list();
  Bench(list, "localhost:" + std::to_string(plc.port())).start();
  Bench bench(list, "symplant.invalid:4840");
  const Fault fault = bench.dialog().open();
  CHECK(fault.kind == Fault::Kind::transport);
  CHECK_THAT(fault.message,
             ContainsSubstring("no connection to symplant.invalid:4840: host `symplant.invalid` has no"));
}

TEST_CASE("A server that accepts a connection and never answers is not connected to a second time") {
  auto bound = net::listen_on({"127.0.0.1", 0});
  net::Listener& listener = std::get<net::Listener>(bound);
  const SymbolList list = small_list();
  Bench bench(list, listener.bound.port);
  const Fault fault = bench.dialog().open();
  CHECK(fault.kind == Fault::Kind::transport);
  CHECK_THAT(fault.message, ContainsSubstring("no answer"));
  int connections = 0;
  for (int socket = 0; (socket = ::accept(listener.socket.get(), nullptr, nullptr)) >= 0; ++connections)
    ::close(socket);
  CHECK(connections == 1);
}

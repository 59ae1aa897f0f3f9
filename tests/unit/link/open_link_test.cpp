// Links by URL, and the messages for invalid ones.
#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"

using namespace symplant;
using ErrorKind = link::LinkError::Kind;

namespace {

link::LinkError fault(const std::string& url) {
  static const auto tables = test::cell_tables();
  auto result = link::open_link({url}, tables);
  REQUIRE(std::holds_alternative<link::LinkError>(result));
  return std::get<link::LinkError>(result);
}

void check_usage(const std::string& url, const std::string& words) {
  CAPTURE(url);
  const auto error = fault(url);
  CHECK(error.kind == ErrorKind::usage);
  CHECK_THAT(error.message, Catch::Matchers::ContainsSubstring(words));
}

}  // namespace

TEST_CASE("The loop is opened by its scheme alone") {
  const auto tables = test::cell_tables();
  CHECK(test::open_or_throw("loop:", tables)->url() == "loop:");
  check_usage("loop:x", "takes nothing");
}

TEST_CASE("A server's URL contains its actual port") {
  const auto tables = test::cell_tables();
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables);
  CHECK(test::port_of(*link) != 0);
  CHECK(test::RawClient(test::port_of(*link)).connected());
}

TEST_CASE("A server without a host is on the loopback") {
  const auto tables = test::cell_tables();
  const auto link = test::open_or_throw("modbus-tcp-server://:0", tables);
  CHECK_THAT(link->url(), Catch::Matchers::StartsWith("modbus-tcp-server://127.0.0.1:"));
}

TEST_CASE("A server is reachable by the name localhost and by IPv6 in brackets") {
  const auto tables = test::cell_tables();
  const auto named = test::open_or_throw("modbus-tcp-server://localhost:0", tables);
  CHECK_THAT(named->url(), Catch::Matchers::ContainsSubstring("localhost:"));
  CHECK(test::RawClient(test::port_of(*named)).connected());  // over IPv4, whatever the name also means
  auto result = link::open_link({"modbus-tcp-server://[::1]:0"}, tables);
  if (!std::holds_alternative<std::unique_ptr<link::Link>>(result)) return;  // a machine without IPv6
  const auto& link = std::get<std::unique_ptr<link::Link>>(result);
  CHECK_THAT(link->url(), Catch::Matchers::StartsWith("modbus-tcp-server://[::1]:"));
  test::RawClient client(test::port_of(*link), AF_INET6);
  CHECK(client.ask({2, 0, 1, 0, 1}).size() == 3);
}

TEST_CASE("A URL that names no link is reported with the known ones") {
  for (const char* url : {"", "modbus", "modbus-rtu:/dev/ttyS0", "LOOP", ":502"}) {
    check_usage(url, "modbus-tcp-server://HOST:PORT");
  }
}

TEST_CASE("An invalid server address is reported with the expected form") {
  check_usage("modbus-tcp-server:", "//HOST:PORT");
  check_usage("modbus-tcp-server:127.0.0.1:502", "//HOST:PORT");
  check_usage("modbus-tcp-server://127.0.0.1", "no port");
  check_usage("modbus-tcp-server://127.0.0.1:", "does not end in a port");
  check_usage("modbus-tcp-server://127.0.0.1:65536", "does not end in a port");
  check_usage("modbus-tcp-server://127.0.0.1:-1", "does not end in a port");
  check_usage("modbus-tcp-server://127.0.0.1:502x", "does not end in a port");
  check_usage("modbus-tcp-server://127.0.0.1:502?unit=1", "does not end in a port");
  check_usage("modbus-tcp-server://::1:502", "brackets");
  check_usage("modbus-tcp-server://a b:502", "not HOST:PORT");
}

TEST_CASE("A host that is no address of this machine is a usage error") {
  check_usage("modbus-tcp-server://192.0.2.1:0", "not an address of this machine");  // from the range for documentation
}

TEST_CASE("A port in use is a fault of the environment with a hint") {
  const auto tables = test::cell_tables();
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables);
  const auto error = fault(link->url());
  CHECK(error.kind == ErrorKind::environment);
  CHECK_THAT(error.message,
             Catch::Matchers::ContainsSubstring("port " + std::to_string(test::port_of(*link)) + " is in use"));
  CHECK_THAT(error.message, Catch::Matchers::ContainsSubstring("by this program itself") &&
                                Catch::Matchers::ContainsSubstring("its own port"));
  CHECK_THAT(error.message, Catch::Matchers::ContainsSubstring(std::to_string(::getpid())));
}

TEST_CASE("A port in use at a name's first address is not taken at its next") {
  const auto tables = test::cell_tables();
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables);
  const auto error = fault("modbus-tcp-server://localhost:" + std::to_string(test::port_of(*link)));
  CHECK(error.kind == ErrorKind::environment);
  CHECK_THAT(error.message, Catch::Matchers::ContainsSubstring("is in use on `localhost`"));
}

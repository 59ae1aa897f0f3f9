// The URL of a link `opc-ua-server`.
#include "symplant/link/opc_ua/server_settings.hpp"

#include "support/catch.hpp"
#include "symplant/link/opc_ua/server_link.hpp"

using namespace symplant;
using link::opc_ua::read_server_settings;
using link::opc_ua::Security;
using link::opc_ua::server_fault;
using link::opc_ua::ServerSettings;

TEST_CASE("The URL of an OPC UA server has an address and security") {
  const auto read = read_server_settings(
      "//192.168.0.7:4840?security=sign&user=scada&password-file=/run/"
      "pass%20word&certificate=own.der&key=own.pem&trust=clients");
  REQUIRE(std::holds_alternative<ServerSettings>(read));
  const auto& settings = std::get<ServerSettings>(read);
  CHECK(settings.address.host == "192.168.0.7");
  CHECK(settings.address.port == 4840);
  CHECK(settings.security.security == Security::sign);
  CHECK(settings.security.user == "scada");
  CHECK(settings.security.password_file == "/run/pass word");
  CHECK(settings.security.certificate == "own.der");
  CHECK(settings.security.key == "own.pem");
  CHECK(settings.security.trust == "clients");
}

TEST_CASE("Without a host an OPC UA server is for this computer only, and has no security unless it is given") {
  const auto read = read_server_settings("//:0");
  REQUIRE(std::holds_alternative<ServerSettings>(read));
  CHECK(std::get<ServerSettings>(read).address.host == "127.0.0.1");
  CHECK(std::get<ServerSettings>(read).security.security == Security::none);
}

TEST_CASE("A contradiction in the URL of an OPC UA server is an error") {
  CHECK(server_fault("//127.0.0.1:4840").empty());
  CHECK(server_fault("127.0.0.1:4840") ==
        "`127.0.0.1:4840` after `opc-ua-server:` is not an address: give //HOST:PORT");
  CHECK(server_fault("//127.0.0.1:4840/plant") ==
        "`/plant` after the port: the address of this server has no path, remove it");
  CHECK(server_fault("//127.0.0.1:4840?security=tls") == "`security=tls`: write one of none, sign, encrypt");
  CHECK(server_fault("//127.0.0.1:4840?securty=none") ==
        "`securty` is not a setting of a link `opc-ua-server`; did you mean `security`?");
  CHECK(server_fault("//127.0.0.1:4840?security=encrypt") ==
        "`security=sign` and `security=encrypt` need a user name: give `user=NAME&password-file=FILE`");
  CHECK(server_fault("//127.0.0.1:4840?user=a&password-file=b") ==
        "`user` and `password-file` need `security=sign` or `security=encrypt`: without security no password is sent");
  CHECK(server_fault("//127.0.0.1:4840?trust=a") ==
        "`certificate`, `key` and `trust` need `security=sign` or `security=encrypt`");
  CHECK(server_fault("//127.0.0.1:4840?security=sign&user=a") ==
        "`user` and `password-file` belong together: give both, or neither");
  CHECK(server_fault("//127.0.0.1:4840?security=sign&user=a&password-file=b&key=c") ==
        "`certificate` and `key` belong together: give both, or neither");
  CHECK(server_fault("//127.0.0.1:4840?user=a&user=b") == "`user` is set twice, to `a` and `b`: remove one");
}

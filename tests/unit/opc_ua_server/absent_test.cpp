// The links of OPC UA in a build without open62541.
#include "support/catch.hpp"
#include "symplant/link/link.hpp"
#include "unit/exec/cell.hpp"

using namespace symplant;

TEST_CASE("Without open62541 the links of OPC UA say what is missing, and invalid URLs are still invalid") {
  const tables::PlantTables tables = test::cell_tables();
  for (const char* url : {"opc-ua-server://127.0.0.1:0", "opc-ua://127.0.0.1:4840?nodes=ns=3;s={symbol}"}) {
    const auto result = link::open_link({url}, tables);
    const auto* const error = std::get_if<link::LinkError>(&result);
    REQUIRE(error != nullptr);
    CHECK(error->kind == link::LinkError::Kind::environment);
    CHECK(error->message ==
          "this symplant was built without OPC UA: build it on a system with open62541 1.4, such as Debian 13");
  }
  const auto invalid = link::open_link({"opc-ua-server://127.0.0.1:0?security=some"}, tables);
  REQUIRE(std::holds_alternative<link::LinkError>(invalid));
  CHECK(std::get<link::LinkError>(invalid).kind == link::LinkError::Kind::usage);
}

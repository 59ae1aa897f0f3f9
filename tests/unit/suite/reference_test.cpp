// What of a trace a reference trace has.
#include "suite/reference.hpp"

#include <sstream>

#include "support/catch.hpp"

namespace symplant::suite {
namespace {

constexpr const char* kTrace =
    R"({"symplant-trace":1,"plant":"p","model_hash":"1","seed":0,"clock":"virtual","programs":[{"name":"cell","digest":"ab"}]}
{"t":0,"symbol":"L_P_D_I_A","value":true}
{"t":10,"act":{"set":{"L_P_D_I_B":true}},"by":"scenario"}
{"t":10,"symbol":"L_P_D_O_A","value":true}
{"t":10,"symbol":"odd \"O\"","value":true}
{"t":20,"part":1,"kind":"raw","from":"BELT","to":"FIXTURE"}
)";

std::string reference(const std::vector<std::string>& only, std::initializer_list<std::string_view> operations) {
  std::istringstream trace(kTrace);
  return reference_text(trace, {&only, operations}, 30);
}

constexpr const char* kHeader =
    "{\"symplant-trace\":1,\"plant\":\"p\",\"model_hash\":\"1\",\"seed\":0,\"clock\":\"virtual\",\"end\":30}\n";

TEST_CASE("A reference trace has the operations, and nothing that changes with each build") {
  CHECK(reference({}, {"L_P_D_O_A"}) == kHeader + std::string("{\"t\":10,\"symbol\":\"L_P_D_O_A\",\"value\":true}\n"));
  CHECK(reference({}, {"odd \"O\""}) ==
        kHeader + std::string("{\"t\":10,\"symbol\":\"odd \\\"O\\\"\",\"value\":true}\n"));
}

TEST_CASE("Patterns choose symbols and the locations of parts instead") {
  CHECK(reference({"*_I_*"}, {"L_P_D_O_A"}) ==
        kHeader + std::string("{\"t\":0,\"symbol\":\"L_P_D_I_A\",\"value\":true}\n"));
  CHECK(reference({"FIX*"}, {}) ==
        kHeader + std::string("{\"t\":20,\"part\":1,\"kind\":\"raw\",\"from\":\"BELT\",\"to\":\"FIXTURE\"}\n"));
}

TEST_CASE("Of what is no trace nothing is made") {
  const std::vector<std::string> only;
  std::istringstream empty;
  CHECK(reference_text(empty, {&only, {}}, 0).empty());
  std::istringstream text("text\n");
  CHECK(reference_text(text, {&only, {}}, 0).empty());
}

}  // namespace
}  // namespace symplant::suite

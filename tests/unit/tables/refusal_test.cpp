// A refused request in 64 bits.
#include "symplant/tables/refusal.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using tables::Refusal;

TEST_CASE("A refusal keeps each of its fields in the 64 bits of a finding") {
  const Refusal refusal{Refusal::Side::slmp_client, 0xAB, 0xC059, 0x0001'2345};
  CHECK(pack(refusal) == 0x02AB'C059'0001'2345);
  CHECK(tables::unpack_refusal(pack(refusal)) == refusal);
}

}  // namespace
}  // namespace symplant::test

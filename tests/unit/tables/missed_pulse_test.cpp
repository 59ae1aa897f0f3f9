// A missed pulse in 64 bits.
#include "symplant/tables/missed_pulse.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kSecond;
using tables::MissedPulse;

TEST_CASE("A missed pulse keeps its level and its times in the 64 bits of a finding") {
  for (const bool on : {false, true}) {
    const MissedPulse pulse{on, 50 * kMillisecond, 200 * kMillisecond};
    CHECK(tables::unpack_missed_pulse(pack(pulse)) == pulse);
  }
}

TEST_CASE("Times of a missed pulse that are too long are cut") {
  const MissedPulse cut = tables::unpack_missed_pulse(pack(MissedPulse{true, 9000 * kSecond, 9000 * kSecond}));
  CHECK(cut.on);
  CHECK(cut.length / kSecond == 2147);
  CHECK(cut.every / kSecond == 4294);
}

}  // namespace
}  // namespace symplant::test

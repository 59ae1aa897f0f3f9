// The memory of the PLC: packing, sizes, shared devices.
#include <stdexcept>

#include "support/catch.hpp"
#include "support/slmp/plc_memory.hpp"

using namespace symplant::test::slmp;

TEST_CASE("A word of a bit device is 16 points from any number on, the first in bit 0") {
  PlcMemory memory;
  memory.set_word("M", 100, 0x1234);
  CHECK(memory.word("M", 100) == 0x1234);
  CHECK_FALSE(memory.bit("M", 100));
  CHECK(memory.bit("M", 102));
  CHECK(memory.bit("M", 112));
  memory.set_bit("M", 100, true);
  CHECK(memory.word("M", 100) == 0x1235);
  CHECK(memory.word("M", 99) == 0x246A);
  CHECK(memory.word("M", 8176) == 0);
}

TEST_CASE("A dword has its low word first") {
  PlcMemory memory;
  memory.set_dword("D", 1500, 0x04391202);
  CHECK(memory.word("D", 1500) == 0x1202);
  CHECK(memory.word("D", 1501) == 0x0439);
  memory.set_dword("M", 5, 0x80000001);
  CHECK(memory.dword("M", 5) == 0x80000001);
  CHECK(memory.bit("M", 36));
}

TEST_CASE("A point that the CPU does not have is an error of the test") {
  PlcMemory memory(Family::fx5);
  CHECK_THROWS_AS(memory.bit("X", 1024), std::out_of_range);
  CHECK_THROWS_AS(memory.word("M", 7680 - 15), std::out_of_range);
  CHECK_THROWS_AS(memory.set_word("D", 8000, 1), std::out_of_range);
  CHECK_THROWS_AS(memory.set_bit("DX", 0, true), std::out_of_range);
  CHECK_THROWS_AS(memory.set_dword("D", 7999, 1), std::out_of_range);
  CHECK_THROWS_AS(memory.configure("Q", 5), std::out_of_range);
}

TEST_CASE("DX, DY and R share the memory of X, Y and ZR") {
  PlcMemory memory(Family::q);
  memory.set_bit("DX", 0x1F, true);
  CHECK(memory.bit("X", 0x1F));
  memory.set_word("R", 7, 9);
  CHECK(memory.word("ZR", 7) == 9);
  memory.configure("ZR", 0);
  memory.set_word("R", 32'767, 5);
  CHECK(memory.word("R", 32'767) == 5);
}

TEST_CASE("Special registers hold the configured sizes") {
  PlcMemory r(Family::iqr);
  r.configure("D", 70'000);
  CHECK(r.dword("SD", 280) == 70'000);
  CHECK(r.dword("SD", 260) == 8192);
  PlcMemory q(Family::q);
  q.configure("X", 4096);
  CHECK(q.word("SD", 290) == 4096);
  CHECK(q.dword("SD", 308) == 12'288);
  CHECK(PlcMemory(Family::fx5).dword("SD", 304) == 32'768);
}

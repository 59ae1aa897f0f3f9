// Reading an address allocates nothing: it is on the path of every row.
#include <cstdlib>
#include <new>

#include "address/notation.hpp"
#include "support/catch.hpp"

using namespace symplant::address;

namespace {

std::size_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

TEST_CASE("Reading an address allocates nothing and throws nothing, in any notation") {
  constexpr const char* kTexts[] = {"%IX0.5",    "%IX1.2.3.4.5.6.7.8.9",
                                    "%I*",       "X1F",
                                    "D10.F",     "U3E0\\HG0",
                                    "J1\\X10",   "K4X0",
                                    "I   11.6 ", "DB1.DBX0.0",
                                    "PIW 64",    "Local:1:I.Data[12].8",
                                    "I:1/0",     "1052.02",
                                    "E0_0.05",   "300001.3",
                                    "nothing",   "%IX99999999999999999999999999"};
  for (const Notation notation :
       {Notation::iec, Notation::melsec, Notation::siemens, Notation::rockwell, Notation::omron, Notation::modbus}) {
    for (const char* text : kTexts) {
      const std::size_t before = allocations;
      const auto address = parse(text, {notation});
      const std::size_t after = allocations;
      INFO(text);
      CHECK(after == before);
      CHECK((!address || address->assigned || address->number != 0));
    }
  }
}

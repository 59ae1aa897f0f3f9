// An SLMP server with known contents of its memory: prints its port, and serves until its standard input ends.
//
//   slmp_known_plc iqr|fx5
//
// Word i of device k of {X, Y, M, B, D, W} has the value ((i + 1) * 40503 + k * 9973) mod 2^16; word i of a bit device
// has its points 16 * i to 16 * i + 15.
#include <cstdio>
#include <exception>
#include <iostream>
#include <string_view>

#include "support/slmp/slmp_plc.hpp"

using namespace symplant::test::slmp;

namespace {

void fill(PlcMemory& memory) {
  std::uint32_t k = 0;
  for (const std::string_view device : {"X", "Y", "M", "B", "D", "W"}) {
    const std::uint32_t step = device == "D" || device == "W" ? 1 : 16;
    for (std::uint32_t i = 0; i < memory.points(device) / step; ++i) {
      memory.set_word(device, step * i, static_cast<std::uint16_t>((i + 1) * 40'503 + k * 9'973));
    }
    ++k;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view family = argc == 2 ? argv[1] : "";
  if (family != "iqr" && family != "fx5") return 2;
  try {
    PlcOptions options;
    options.profile = profile_of(family == "fx5" ? Family::fx5 : Family::iqr);
    options.most_connections = 2;  // the end of a connection may come after the begin of the next one
    SlmpPlc plc(options);
    fill(plc.memory());
    std::cout << plc.port() << std::endl;
    while (std::cin.get() != std::char_traits<char>::eof()) {
    }
    for (const std::string& violation : plc.log().violations()) std::cout << violation << "\n";
    return plc.log().violations().empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "slmp_known_plc: " << error.what() << "\n";
    return 3;
  }
}

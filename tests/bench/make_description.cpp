// Writes the plant.json of such a list, with a condition for each device, to stdout: make_description DEVICES LIST
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/list_text.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: make_description DEVICES LIST\n", stderr);
    return 2;
  }
  const std::string text = symplant::bench::description_text(std::atoi(argv[1]), argv[2]);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 3;
}

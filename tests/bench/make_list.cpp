// Writes a list of a given size to standard output: make_list DEVICES TYPES
#include <cstdio>
#include <cstdlib>

#include "bench/list_text.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: make_list DEVICES TYPES\n", stderr);
    return 2;
  }
  const std::string text = symplant::bench::list_text(std::atoi(argv[1]), std::atoi(argv[2]));
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 3;
}

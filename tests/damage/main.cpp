// Writes a damaged list to standard output: damage_list LIST [KIND SEED]. Without a kind it lists all kinds.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sstream>

#include "damage/measure.hpp"

namespace symplant::damage {
namespace {

int run(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fputs("usage: damage_list LIST [KIND SEED]\n", stderr);
    return 2;
  }
  if (argc == 2) {
    for (const Kind& kind : kinds()) {
      std::printf("%-26s %-28s %s\n", std::string(kind.name).c_str(), std::string(kind.rule).c_str(),
                  std::string(kind.what).c_str());
    }
    return 0;
  }
  std::ifstream file(argv[1], std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  const Shop shop(read_list(text.str()));
  for (const Kind& kind : kinds()) {
    if (kind.name != argv[2]) continue;
    Dice dice(std::strtoull(argv[3], nullptr, 10));
    const Damaged damaged = kind.apply(shop, dice);
    std::fputs(damaged.list.text().c_str(), stdout);
    for (const std::size_t row : damaged.roots)
      std::fprintf(stderr, "%s %zu\n", std::string(kind.rule).c_str(), row + 2);
    std::fputs(Clean(shop.list).compare(kind, damaged).reported.c_str(), stderr);
    return 0;
  }
  std::fprintf(stderr, "there is no kind `%s`\n", argv[2]);
  return 2;
}

}  // namespace
}  // namespace symplant::damage

int main(int argc, char** argv) {
  try {
    return symplant::damage::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

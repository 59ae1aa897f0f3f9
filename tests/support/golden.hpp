// Compares with a golden file. SYMPLANT_UPDATE_GOLDENS=1 in the environment writes the files instead.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "support/catch.hpp"

namespace symplant::test {

inline std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  INFO("reading " << path);
  REQUIRE(file.good());
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

inline void check_golden(const std::string& path, const std::string& actual) {
  if (std::getenv("SYMPLANT_UPDATE_GOLDENS") != nullptr) {
    std::ofstream(path, std::ios::binary) << actual;
    return;
  }
  INFO("golden file " << path);
  CHECK(actual == read_bytes(path));
}

}  // namespace symplant::test

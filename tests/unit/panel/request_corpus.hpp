// The seeds of the fuzz target `http`: requests of every route.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace symplant::test {

/// The seeds by the names of their files.
inline std::map<std::string, std::string> request_seeds() {
  std::map<std::string, std::string> seeds;
  for (const auto& entry : std::filesystem::directory_iterator(SYMPLANT_SOURCE_DIR "/tests/fuzz/corpus/http")) {
    std::ifstream file(entry.path(), std::ios::binary);
    seeds[entry.path().filename()] =
        std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  }
  return seeds;
}

}  // namespace symplant::test

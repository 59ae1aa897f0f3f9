// Tries every hostile input under every command of the tool, and keeps docs/reliability.md current.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

#include "page.hpp"

namespace {

using namespace symplant::hostile;

/// Runs all; faults go to standard error. `small`: but for what takes seconds.
Trials try_all(const std::string& tool, const Limits& limits, bool small, const std::string& scratch, bool& well) {
  Trials trials;
  const auto tell = [&](const Outcome& outcome) {
    for (const std::string& fault : outcome.faults) std::cerr << "FAULT: " << fault << std::endl;
    well = well && outcome.faults.empty();
  };
  for (const Input& input : inputs()) {
    if (small && input.large) continue;
    std::cout << input.what << std::endl;
    trials.inputs.emplace_back(input, try_out(tool, input, limits, scratch));
    for (const Outcome& outcome : trials.inputs.back().second) tell(outcome);
  }
  for (const Misuse& misuse : misuses()) {
    std::cout << misuse.what << std::endl;
    trials.misuses.emplace_back(misuse, try_out(tool, misuse, limits, scratch));
    tell(trials.misuses.back().second);
  }
  return trials;
}

bool is_current(const std::string& file, const std::string& text) {
  if (std::getenv("SYMPLANT_UPDATE_GOLDENS") != nullptr) {
    std::ofstream(file, std::ios::binary) << text;
    return true;
  }
  std::ifstream old(file, std::ios::binary);
  if (text == std::string((std::istreambuf_iterator<char>(old)), std::istreambuf_iterator<char>())) return true;
  std::ofstream("reliability.md", std::ios::binary) << text;
  std::cerr << "FAULT: " << file << " is not current: compare it with reliability.md in this test's folder; "
            << "SYMPLANT_UPDATE_GOLDENS=1 writes it anew\n";
  return false;
}

}  // namespace

// hostile TOOL SCRATCH PAGE: all, and PAGE must be current. hostile --sanitized TOOL SCRATCH: small inputs, wide
// limits.
int main(int argc, char** argv) {
  const bool sanitized = argc == 4 && std::string_view(argv[1]) == "--sanitized";
  if (argc != 4) return 2;
  const std::string tool = std::filesystem::absolute(argv[sanitized ? 2 : 1]).string();
  const std::string scratch = std::filesystem::absolute(argv[sanitized ? 3 : 2]).string();
  const Limits limits = sanitized ? Limits{100, 64L * 1024 * 1024} : Limits{};
  std::filesystem::remove_all(scratch);
  std::filesystem::create_directories(scratch);
  bool well = true;
  const Trials trials = try_all(tool, limits, sanitized, scratch, well);
  if (!sanitized) well = is_current(argv[3], page(trials)) && well;
  return well ? 0 : 1;
}

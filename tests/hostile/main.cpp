// Tries every hostile input under every command of the tool, and checks that docs/reliability.md is current.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

#include "page.hpp"
#include "process.hpp"

namespace {

using namespace symplant::hostile;

/// Selects the inputs to try.
struct Choice {
  bool small = false;          ///< skip inputs that take seconds
  std::string_view word = {};  ///< only inputs whose description contains it
  bool takes(std::string_view what, bool large) const { return !(small && large) && what.find(word) != what.npos; }
};

/// Runs the inputs; faults go to standard error.
Trials try_all(const std::string& tool, const Limits& limits, const Choice& choice, const std::string& scratch,
               bool& well) {
  Trials trials;
  const auto report = [&](const Outcome& outcome) {
    for (const std::string& fault : outcome.faults) std::cerr << "FAULT: " << fault << std::endl;
    well = well && outcome.faults.empty();
  };
  for (const Input& input : inputs()) {
    if (!choice.takes(input.what, input.large)) continue;
    std::cout << input.what << std::endl;
    trials.inputs.emplace_back(input, try_out(tool, input, limits, scratch));
    for (const Outcome& outcome : trials.inputs.back().second) report(outcome);
  }
  for (const Misuse& misuse : misuses()) {
    if (!choice.takes(misuse.what, false)) continue;
    std::cout << misuse.what << std::endl;
    trials.misuses.emplace_back(misuse, try_out(tool, misuse, limits, scratch));
    report(trials.misuses.back().second);
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
            << "SYMPLANT_UPDATE_GOLDENS=1 regenerates it\n";
  return false;
}

}  // namespace

// hostile TOOL SCRATCH PAGE: all inputs; PAGE must be current. hostile --sanitized TOOL SCRATCH: small inputs, wide
// limits. hostile --only WORD TOOL SCRATCH: inputs whose description contains WORD, and what the page would show.
int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  const bool sanitized = mode == "--sanitized";
  const bool only = mode == "--only";
  if (argc != (only ? 5 : 4)) return 2;
  const int first = only ? 3 : sanitized ? 2 : 1;
  const std::string tool = std::filesystem::absolute(argv[first]).string();
  const std::string scratch = std::filesystem::absolute(argv[first + 1]).string();
  const Limits limits = sanitized ? Limits{100, 64L * 1024 * 1024} : Limits{};
  std::filesystem::remove_all(scratch);
  std::filesystem::create_directories(scratch);
  if (!sanitized) limit_address_space(4 * limits.peak_kilobytes);
  bool well = true;
  const Trials trials = try_all(tool, limits, {sanitized, only ? argv[2] : ""}, scratch, well);
  if (only) std::cout << page(trials);
  if (!sanitized && !only) well = is_current(argv[3], page(trials)) && well;
  return well ? 0 : 1;
}

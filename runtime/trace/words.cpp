// Short texts that messages about a run share.
#include "symplant/trace/words.hpp"

#include <string_view>

namespace symplant::trace {

std::string address_or_name(std::uint32_t symbol, const PlantNames& names) {
  const std::string_view address = names.address(symbol);
  return std::string(address.empty() ? names.symbol(symbol) : address);
}

std::string since_words(tables::Time changed) { return changed == 0 ? "since the start" : "since " + seconds(changed); }

std::string seconds(tables::Time time) {
  std::string text = std::to_string(time / tables::kSecond);
  const tables::Time rest = time % tables::kSecond;
  if (rest != 0) {
    std::string digits = std::to_string(tables::kSecond + rest);
    digits.front() = '.';
    text += digits.substr(0, digits.find_last_not_of('0') + 1);
  }
  return text + " s";
}

std::string written_words(std::uint32_t symbol, tables::Time time, const PlantNames& names) {
  for (const PlantNames::Program& program : names.programs()) {
    const tables::Time scanned = time - program.delay;
    if (!program.written[symbol] || scanned < 0 || scanned % program.period != 0) continue;
    return ", written by program `" + program.name + "` in scan " + std::to_string(scanned / program.period) + " (" +
           seconds(scanned) + ")";
  }
  return {};
}

}  // namespace symplant::trace

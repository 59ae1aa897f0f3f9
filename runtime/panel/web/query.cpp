// Reads the queries of requests.
#include "symplant/panel/web/query.hpp"

#include <vector>

namespace symplant::panel {
namespace {

constexpr std::size_t kMostSeries = 32;

std::vector<std::uint32_t> indexes_of(const std::string& text, std::size_t count, bool& well) {
  std::vector<std::uint32_t> indexes;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    std::uint32_t index = 0;
    const auto [next, error] = std::from_chars(at, end, index);
    if (error != std::errc() || index >= count || (next != end && *next != ',')) {
      well = false;
      return indexes;
    }
    indexes.push_back(index);
    at = next == end ? end : next + 1;
  }
  return indexes;
}

}  // namespace

bool read_chart(const std::map<std::string, std::string>& query, const trace::PlantNames& names, ChartWish& wish) {
  bool well = true;
  const auto text = [&](const char* key) {
    const auto found = query.find(key);
    return found == query.end() ? std::string() : found->second;
  };
  wish.symbols = indexes_of(text("symbols"), names.tables().symbols.size(), well);
  wish.devices = indexes_of(text("devices"), names.tables().units.size(), well);
  wish.values = indexes_of(text("values"), names.tables().values.outputs, well);
  read_number(query, "from", wish.from, well);
  read_number(query, "to", wish.to, well);
  read_number(query, "after", wish.after, well);
  read_number(query, "after_value", wish.after_value, well);
  return well && wish.symbols.size() + wish.devices.size() + wish.values.size() <= kMostSeries;
}

}  // namespace symplant::panel

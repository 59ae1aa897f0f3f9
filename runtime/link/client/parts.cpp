// The parts that a protocol builds from the URL of a link that goes to the PLC.
#include "symplant/link/client/parts.hpp"

#include <algorithm>
#include <utility>

#include "symplant/tables/names.hpp"

namespace symplant::link::client {

std::vector<std::string> request_notes(std::size_t reads, std::size_t writes, std::size_t reads_back) {
  const auto requests = [](std::size_t count) {
    return std::to_string(count) + (count == 1 ? " request" : " requests");
  };
  return {"operations: " + requests(reads) + " to read all",
          "events: " + requests(writes) + " to write all, " + requests(reads_back) + " to read them back"};
}

std::string unreachable_text(const std::vector<Unreachable>& unreachable, const tables::PlantTables& tables) {
  constexpr std::size_t kNamed = 3;
  const std::size_t count = unreachable.size();
  if (count == 0) return {};
  const auto texts = tables::split_names(tables.symbol_names);
  std::string text = std::to_string(count) + (count == 1 ? " symbol is" : " symbols are") + " not linked: ";
  for (std::size_t i = 0; i < std::min(count, kNamed); ++i) {
    const Unreachable& one = unreachable[i];
    text.append(i == 0 ? "`" : ", `").append(texts[std::size_t{2} * one.symbol]).append("` ").append(one.reason);
  }
  return text + (count > kNamed ? ", ..." : "") + "; `symplant map` lists all symbols";
}

LinkMap link_map(ClientParts parts) {
  LinkMap map{{}, std::move(parts.unreachable), std::move(parts.notes), nullptr};
  map.symbols.reserve(parts.map.points.size());
  for (std::size_t i = 0; i < parts.map.points.size(); ++i) {
    const image::Point& point = parts.map.points[i];
    map.symbols.push_back({point.symbol, std::move(parts.addresses[i]), parts.word_orders[i], point.on_loss});
  }
  return map;
}

}  // namespace symplant::link::client

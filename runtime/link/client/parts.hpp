// The parts that a protocol builds from the URL of a link that goes to the PLC.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// When a client link acts. Times in ns, > 0.
struct ClientTimes {
  tables::Time poll = 10 * tables::kMillisecond;  ///< from one reading of the operations to the next
  tables::Time refresh = 2 * tables::kSecond;     ///< interval of writing all events and repeating rejected requests
  tables::Time read_back = 0;                     ///< interval of reading back and comparing what was written; 0: never
  tables::Time first_retry = tables::kSecond;     ///< after a failed connection; each further one doubles it
  tables::Time last_retry = 30 * tables::kSecond;
  bool zero_at_end = false;  ///< at the end of the run all events are written as 0; otherwise they keep their values
};

/// The parts that a protocol builds from a URL: the conversation, and where each symbol lies.
struct ClientParts {
  std::unique_ptr<Dialog> dialog;
  image::Map map;
  std::vector<std::string> addresses;  ///< in the PLC, of the map's points in their order
  std::vector<WordOrder> word_orders;  ///< of the map's points
  std::vector<Unreachable> unreachable;
  ClientTimes times;
  std::vector<std::string> notes;  ///< on the map, for the user: "operations: 2 requests read all"
};

/// Notes on how many requests read all operations, write all events, and read those back.
std::vector<std::string> request_notes(std::size_t reads, std::size_t writes, std::size_t reads_back);

/// "3 symbols are not linked: `A` has no address, ...": at most three by name; empty if all are.
std::string unreachable_text(const std::vector<Unreachable>& unreachable, const tables::PlantTables& tables);

/// The map of a link from its parts. O(symbols).
LinkMap link_map(ClientParts parts);

using PartsResult = std::variant<ClientParts, LinkError>;

}  // namespace symplant::link::client

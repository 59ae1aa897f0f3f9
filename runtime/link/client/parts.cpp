// What a protocol makes of a URL of a link that goes to the PLC.
#include "symplant/link/client/parts.hpp"

namespace symplant::link::client {

std::vector<std::string> request_notes(std::size_t reads, std::size_t writes, std::size_t reads_back) {
  const auto requests = [](std::size_t count) {
    return std::to_string(count) + (count == 1 ? " request" : " requests");
  };
  return {"operations: " + requests(reads) + " to read all",
          "events: " + requests(writes) + " to write all, " + requests(reads_back) + " to read them back"};
}

}  // namespace symplant::link::client

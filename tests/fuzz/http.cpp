// Any bytes as a request to the panel: an answer with a status of the interface, and no handler throws.
#include <algorithm>
#include <array>

#include "fuzz/http_plant.hpp"
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant::fuzz;
  static HttpPlant plant;
  const HttpPlant::Statuses statuses = plant.play(sent_text({reinterpret_cast<const char*>(data), size}));
  constexpr std::array kStatuses = {0, 200, 400, 401, 403, 404, 405, 409, 422, 429, 501};
  for (const int status : {statuses.live, statuses.recording}) {
    require(std::find(kStatuses.begin(), kStatuses.end(), status) != kStatuses.end(),
            "a status that is not documented");
  }
  return statuses.live == 0 ? -1 : 0;
}

// Requests for any number of nodes, as few as a server allows.
#include "symplant/link/opc_ua/client_batches.hpp"

#include <array>

namespace symplant::link::opc_ua {

using client::Fault;

bool is_too_large(UA_StatusCode status) noexcept {
  constexpr std::array kCodes = {UA_STATUSCODE_BADTOOMANYOPERATIONS, UA_STATUSCODE_BADREQUESTTOOLARGE,
                                 UA_STATUSCODE_BADRESPONSETOOLARGE, UA_STATUSCODE_BADENCODINGLIMITSEXCEEDED,
                                 UA_STATUSCODE_BADTCPMESSAGETOOLARGE};
  return std::find(kCodes.begin(), kCodes.end(), status) != kCodes.end();
}

Fault read_attributes(ClientConnection& connection, std::span<const UA_ReadValueId> items, std::uint32_t& limit,
                      UA_StatusCode& result, const TakeValues& take) {
  return in_batches(items.size(), limit, result, [&](std::size_t first, std::size_t count, UA_StatusCode& answer) {
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
    request.nodesToRead = const_cast<UA_ReadValueId*>(items.data() + first);  // open62541 does not change it
    request.nodesToReadSize = count;
    Owned<UA_ReadResponse, UA_TYPES_READRESPONSE> response;
    Fault fault = connection.call(request, UA_TYPES_READREQUEST, response, answer);
    if (fault || is_bad(answer)) return fault;
    if (response->resultsSize != count) {
      return Fault{Fault::Kind::transport,
                   "the server's answer has another number of values than requested; connecting again"};
    }
    take(first, std::span(response->results, response->resultsSize));
    return fault;
  });
}

}  // namespace symplant::link::opc_ua

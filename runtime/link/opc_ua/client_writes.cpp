// What a link `opc-ua` writes, and what happens if the server does not take it.
#include "symplant/link/image/words.hpp"
#include "symplant/link/opc_ua/client_batches.hpp"
#include "symplant/link/opc_ua/client_dialog.hpp"
#include "symplant/link/opc_ua/data_types.hpp"

namespace symplant::link::opc_ua {

using client::Fault;
using client::LaneChange;

/// The nodes of the changes with their whole values: a change of a number may be a part of it.
std::vector<ClientDialog::Writing> ClientDialog::writings_of(std::span<const LaneChange> changes) {
  std::vector<Writing> writings;
  for (std::size_t c = 0; c < changes.size(); ++c) {
    const LaneChange& change = changes[c];
    if (change.lane.plane == Plane::event_numbers) {
      image::set_lane(numbers_, change.lane.number, change.value);
      const std::uint32_t position = change.lane.number / image::kLanesPerWord;
      const std::size_t node = event_of_number_[position];
      if (!writings.empty() && writings.back().node == node) {
        writings.back().number = numbers_[position];
        ++writings.back().count;
      } else if (node != kNoNode) {
        writings.push_back({node, numbers_[position], c, 1, 0});
      }
      continue;
    }
    for (std::uint32_t bit = 0; bit < client::kLaneBits; ++bit) {
      const auto mask = static_cast<std::uint16_t>(1U << bit);
      if ((change.mask & mask) == 0) continue;
      const std::size_t node = event_of_bit_[client::kLaneBits * change.lane.number + bit];
      if (node == kNoNode) continue;
      writings.push_back({node, (change.value & mask) != 0 ? 1U : 0U, c, 1, mask});
    }
  }
  return writings;
}

Fault ClientDialog::write(std::span<const LaneChange> changes, std::vector<client::Unwritten>& unwritten) {
  if (Fault fault = prepare()) return fault;
  std::vector<Writing> some;
  for (const Writing& writing : writings_of(changes)) {
    if (events_.is_usable(writing.node)) {
      some.push_back(writing);
    } else {
      refuse(writing, events_.status(writing.node), changes, unwritten);
    }
  }
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  std::size_t done = 0;
  Fault fault =
      in_batches(some.size(), limits_.write, result, [&](std::size_t first, std::size_t count, UA_StatusCode& answer) {
        Fault one = write_some(std::span(some).subspan(first, count), changes, unwritten, answer);
        if (!one && !is_bad(answer)) done = first + count;
        return one;
      });
  if (fault) return fault;
  for (; done < some.size(); ++done) {
    events_.note(some[done].node, result);
    refuse(some[done], result, changes, unwritten);
  }
  return {};
}

/// One request.
Fault ClientDialog::write_some(std::span<const Writing> some, std::span<const LaneChange> changes,
                               std::vector<client::Unwritten>& unwritten, UA_StatusCode& result) {
  std::vector<Scalar> scalars;
  scalars.reserve(some.size());
  std::vector<UA_WriteValue> values(some.size());
  for (std::size_t k = 0; k < some.size(); ++k) {
    UA_WriteValue& value = values[k];
    value.nodeId = events_.id(some[k].node);
    value.attributeId = UA_ATTRIBUTEID_VALUE;
    value.value.hasValue = true;
    value.value.value = scalars.emplace_back(some[k].number, events_.type(some[k].node)).variant();
  }
  UA_WriteRequest request;
  UA_WriteRequest_init(&request);
  request.nodesToWrite = values.data();
  request.nodesToWriteSize = values.size();
  Owned<UA_WriteResponse, UA_TYPES_WRITERESPONSE> response;
  if (Fault fault = connection_.call(request, UA_TYPES_WRITEREQUEST, response, result)) return fault;
  if (is_bad(result)) {
    rejected_.fetch_add(1, std::memory_order_relaxed);
    return {};
  }
  if (response->resultsSize != some.size()) {
    return {Fault::Kind::transport, "the server's answer has another number of results than written; connecting again"};
  }
  for (std::size_t k = 0; k < some.size(); ++k) {
    const UA_StatusCode status = response->results[k];
    events_.note(some[k].node, status);
    if (is_bad(status)) refuse(some[k], status, changes, unwritten);
  }
  return {};
}

/// Notes the changes of a node that the server did not take.
void ClientDialog::refuse(const Writing& writing, UA_StatusCode status, std::span<const LaneChange> changes,
                          std::vector<client::Unwritten>& unwritten) {
  for (std::size_t c = writing.first; c < writing.first + writing.count; ++c) {
    LaneChange change = changes[c];
    if (writing.mask != 0) change.mask = writing.mask;
    unwritten.push_back({change, answer_of(status), refusal_of(true, status)});
  }
}

}  // namespace symplant::link::opc_ua

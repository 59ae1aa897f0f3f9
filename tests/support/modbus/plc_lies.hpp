// The lies of a PLC that serves Modbus: what it sends instead of a reply.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "support/modbus/plc_answers.hpp"

namespace symplant::test::modbus {

enum class Lie : std::uint8_t {
  none,
  late,                 ///< after the client's patience
  truncated,            ///< the first part, then nothing
  byte_by_byte,         ///< true, each byte in its own segment
  merged,               ///< true, between two copies of the reply before
  foreign_transaction,  ///< with another id and wrong values, sometimes followed by the true one
  wrong_unit,
  wrong_function,
  wrong_byte_count,
  garbage,
  protocol_id,  ///< of another protocol
  silent,
  reset,    ///< of the connection
  flooded,  ///< many frames with other ids, then the true one
  early,    ///< true, and after it a wrong one with the id of the next request
};
inline constexpr int kLies = 15;

/// Sends of one reply, each a segment. All values in frames that differ from `reply` are inverted.
struct Lying {
  std::vector<Bytes> segments = {};
  bool is_late = false;
  bool resets = false;
};

Lying lie_of(Lie lie, const Bytes& reply, const Bytes& before, std::mt19937& random);

}  // namespace symplant::test::modbus

// The lies of a PLC that serves Modbus.
#include "support/modbus/plc_lies.hpp"

#include <algorithm>

namespace symplant::test::modbus {

namespace {

constexpr std::size_t kUnit = 6;
constexpr std::size_t kFunction = 7;
constexpr std::size_t kData = 8;

/// The frame with all its data inverted, after the byte count of a reading reply.
Bytes inverted(Bytes frame) {
  const bool reads = frame[kFunction] <= 4;
  for (std::size_t i = reads ? kData + 1 : kData; i < frame.size(); ++i)
    frame[i] = static_cast<std::uint8_t>(~frame[i]);
  return frame;
}

Bytes with(Bytes frame, std::size_t at, int difference) {
  frame[at] = static_cast<std::uint8_t>(frame[at] + difference);
  return frame;
}

Bytes garbage(std::mt19937& random) {
  Bytes bytes(1 + random() % 40);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// More or fewer bytes than requested, with a length that fits or not.
Bytes with_other_count(Bytes frame, std::mt19937& random) {
  const bool longer = random() % 2 == 0;
  frame = with(inverted(frame), kData, longer ? 2 : -2);
  if (random() % 2 == 0) return frame;
  if (longer) frame.insert(frame.end(), 2, 0xA5);
  if (!longer && frame.size() > kData + 3) frame.resize(frame.size() - 2);
  frame[5] = static_cast<std::uint8_t>(frame.size() - 6);
  return frame;
}

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

Lying lie_of(Lie lie, const Bytes& reply, const Bytes& before, std::mt19937& random) {
  Lying lying;
  switch (lie) {
    case Lie::none:
      lying.segments = {reply};
      break;
    case Lie::late:
      lying.segments = {reply};
      lying.is_late = true;
      break;
    case Lie::truncated:
      lying.segments = {Bytes(reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(random() % reply.size()))};
      break;
    case Lie::byte_by_byte:
      for (const std::uint8_t byte : reply) lying.segments.push_back({byte});
      break;
    case Lie::merged:
      lying.segments = {joined({before, reply, before})};
      break;
    case Lie::foreign_transaction: {
      const int difference = 1 + static_cast<int>(random() % 255);
      lying.segments = {with(inverted(reply), 1, difference)};
      if (random() % 2 == 0) lying.segments.push_back(reply);
      break;
    }
    case Lie::wrong_unit:
      lying.segments = {with(inverted(reply), kUnit, 1)};
      break;
    case Lie::wrong_function:
      lying.segments = {with(inverted(reply), kFunction, 1 + static_cast<int>(random() % 100))};
      break;
    case Lie::wrong_byte_count:
      lying.segments = {with_other_count(reply, random)};
      break;
    case Lie::garbage:
      lying.segments = {garbage(random)};
      break;
    case Lie::protocol_id:
      lying.segments = {with(inverted(reply), 3, 1)};
      break;
    case Lie::silent:
      break;
    case Lie::reset:
      lying.resets = true;
      break;
    case Lie::flooded:
      for (int i = 1; i <= 200; ++i) lying.segments.push_back(with(inverted(reply), 1, i));
      lying.segments.push_back(reply);
      break;
    case Lie::early: {
      Bytes next = with(inverted(reply), 1, 1);
      if (next[1] == 0) next = with(next, 0, 1);
      lying.segments = {joined({reply, next})};
      break;
    }
  }
  return lying;
}

}  // namespace symplant::test::modbus

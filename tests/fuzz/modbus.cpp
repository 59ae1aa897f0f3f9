// Any bytes as input from a Modbus client, cut anywhere: answers are those of its frames, in their order, complete.
#include <algorithm>
#include <array>
#include <vector>

#include "fuzz/dice.hpp"
#include "fuzz/target.hpp"
#include "symplant/link/modbus/connection.hpp"

namespace symplant::fuzz {
namespace {

using namespace link::image;
using namespace link::modbus;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kBits = 100;
constexpr std::uint32_t kRegisters = 40;

/// Answers from a small memory, and checks that only what the answer reports is written.
class Memory final : public Responder {
 public:
  Answer respond(const ClientId& /*client*/, std::span<const std::uint8_t> request,
                 std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    const auto coils = coils_;
    const auto holding = holding_;
    const Answer answer =
        answer_request(request, {{coils_, kBits}, {inputs_, kBits}, {holding_, kRegisters}, {inputs_, lanes_}},
                       {"v", "p", "r"}, reply);
    require(answer.size <= kMaxPdu, "an answer is longer than a frame holds");
    require(answer.exception == Exception::none || answer.count == 0, "a refused request has written");
    for (std::uint32_t i = 0; i < kBits; ++i) {
      require(get_bit(coils, i) == get_bit(coils_, i) || is_reported(answer, link::modbus::Table::coil, i),
              "a coil changed untold");
    }
    for (std::uint32_t i = 0; i < kRegisters; ++i) {
      const bool same = get_lane(holding, i) == get_lane(holding_, i);
      require(same || is_reported(answer, link::modbus::Table::holding_register, i), "a register changed untold");
    }
    require(coils_.back() >> (kBits % kBitsPerWord) == 0, "bits behind the last coil changed");
    return answer;
  }
  void refused(std::span<const std::uint8_t> /*request*/) noexcept override {}

 private:
  static bool is_reported(const Answer& answer, link::modbus::Table table, std::uint32_t index) {
    return answer.written == table && index >= answer.first && index < std::uint32_t{answer.first} + answer.count;
  }

  std::array<std::uint64_t, bit_words(kBits)> coils_{};
  std::array<std::uint64_t, lane_words(kRegisters)> holding_{};
  std::array<std::uint64_t, lane_words(kRegisters)> inputs_{};
  std::array<std::uint32_t, kRegisters> lanes_ = [] {
    std::array<std::uint32_t, kRegisters> lanes{};
    for (std::uint32_t i = 0; i < kRegisters; ++i) lanes[i] = i;
    return lanes;
  }();
};

class Peer final : public Sink {
 public:
  std::ptrdiff_t write(std::span<const std::uint8_t> bytes) noexcept override {
    const std::size_t count = std::min(bytes.size(), window);
    window -= count;
    taken.insert(taken.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return static_cast<std::ptrdiff_t>(count);
  }

  Bytes taken;
  std::size_t window = 0;
};

struct Heads {
  std::vector<std::array<std::uint8_t, 3>> heads;  ///< transaction and unit
  bool broken = false;                             ///< the rest is not a frame
};

/// The frames in a stream; of requests, only the answered ones.
Heads frames_of(const Bytes& bytes, bool requests) {
  Heads result;
  std::size_t at = 0;
  while (at + 6 <= bytes.size()) {
    const std::size_t length = static_cast<std::size_t>(bytes[at + 4] << 8 | bytes[at + 5]);
    if (length < 2 || length > 254) {
      result.broken = true;
      break;
    }
    if (at + 6 + length > bytes.size()) break;
    const bool modbus = bytes[at + 2] == 0 && bytes[at + 3] == 0;
    require(modbus || requests, "an answer has another protocol");
    if (!requests || (modbus && bytes[at + 7] < 128)) result.heads.push_back({bytes[at], bytes[at + 1], bytes[at + 6]});
    at += 6 + length;
  }
  if (!requests) require(at == bytes.size(), "an answer is cut, or no frame");
  return result;
}

void play(const Bytes& bytes, bool reads_all) {
  Dice dice(bytes);
  Connection connection;
  Memory memory;
  Peer peer;
  auto state = Connection::State::open;
  std::size_t fed = 0;
  while (state == Connection::State::open && (fed < bytes.size() || connection.has_answers_to_send())) {
    peer.window = reads_all ? SIZE_MAX : dice.below(600);
    const auto room = connection.room();
    if (fed == bytes.size() || room.empty()) {
      state = connection.resume(memory, peer);
      continue;
    }
    const std::size_t count = std::min({room.size(), bytes.size() - fed, 1 + dice.below(400)});
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(fed), count, room.begin());
    fed += count;
    state = connection.received(count, memory, peer);
  }
  const Heads wanted = frames_of(bytes, true);
  require((state == Connection::State::closed) == wanted.broken, "closed without need, or open in spite of it");
  if (wanted.broken && !reads_all) return;  // what was not read before the end is lost
  require(frames_of(peer.taken, false).heads == wanted.heads, "answers are not those of the requests");
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::uint8_t> bytes(data, data + size);
  symplant::fuzz::play(bytes, true);
  symplant::fuzz::play(bytes, false);
  return 0;
}

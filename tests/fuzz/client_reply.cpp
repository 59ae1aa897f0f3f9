// Any bytes as replies to a client, SLMP or Modbus, cut anywhere: taken as when they come whole, and read as they are.
//
// The first byte chooses what was asked: below 80 (hex) SLMP, bit 0 frame 4E, bit 1 ASCII; otherwise Modbus, bits 0 and
// 1 the area, bit 2 writing, bit 3 the identification. The second byte is the number of addresses of Modbus, less one.
#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/dice.hpp"
#include "fuzz/target.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/client_codec.hpp"
#include "symplant/link/slmp/framing.hpp"

namespace symplant::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint16_t kSerial = 0x1234;
constexpr std::size_t kHead = 2;

/// What a client does with the bytes received so far.
struct Step {
  enum class Kind : std::uint8_t { incomplete, taken, dropped, broken } kind = Kind::incomplete;
  std::size_t consumed = 0;
  std::uint32_t code = 0;
  Bytes data = {};
  friend bool operator==(const Step&, const Step&) = default;
};

/// The steps of a client that receives the bytes, at most `part(rest)` at a time, up to a broken reply.
template <class Parse, class Part>
std::vector<Step> steps_of(const Bytes& bytes, const Parse& parse, Part part) {
  std::vector<Step> steps;
  Bytes received;
  for (std::size_t fed = 0; fed < bytes.size();) {
    const std::size_t count = part(bytes.size() - fed);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(fed);
    received.insert(received.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    received.shrink_to_fit();
    fed += count;
    for (;;) {
      const Step step = parse(received);
      if (step.kind == Step::Kind::incomplete) break;
      steps.push_back(step);
      if (step.kind == Step::Kind::broken) return steps;
      require(step.consumed != 0 && step.consumed <= received.size(), "a reply has another size than its bytes");
      received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(step.consumed));
      received.shrink_to_fit();
    }
  }
  return steps;
}

template <class Parse>
std::vector<Step> steps_in_any_parts(const Bytes& bytes, const Parse& parse) {
  Dice dice(bytes);
  const auto whole = steps_of(bytes, parse, [](std::size_t rest) { return rest; });
  for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{40}}) {
    const auto cut = steps_of(bytes, parse, [&](std::size_t rest) { return std::min(rest, 1 + dice.below(most)); });
    require(cut == whole, "replies in parts are taken otherwise than whole");
  }
  return whole;
}

// SLMP.

using link::slmp::Code;
using link::slmp::DataReader;
using link::slmp::FrameType;
using link::slmp::Framing;
using SlmpReply = link::slmp::Reply;

Step slmp_step(const Bytes& bytes, const Framing& framing, bool datagram) {
  const SlmpReply reply = parse_reply(bytes, framing, kSerial, datagram);
  Step step{.consumed = reply.consumed, .code = reply.end_code, .data = {reply.data.begin(), reply.data.end()}};
  switch (reply.kind) {
    case SlmpReply::Kind::incomplete:
      require(reply.consumed == 0, "an incomplete reply was consumed");
      break;
    case SlmpReply::Kind::complete:
      step.kind = Step::Kind::taken;
      break;
    case SlmpReply::Kind::late:
      step.kind = Step::Kind::dropped;
      require(framing.frame == FrameType::e4, "a reply without serial number is late");
      break;
    case SlmpReply::Kind::broken:
      require(*reply.reason != '\0', "no reason for a broken reply");
      return {.kind = Step::Kind::broken};
  }
  return step;
}

/// The value of a digit; 16 if it is not hexadecimal.
std::uint32_t digit(std::uint8_t c) {
  const std::string_view digits = "0123456789abcdef";
  const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c + ('a' - 'A')) : static_cast<char>(c);
  return static_cast<std::uint32_t>(std::min(digits.find(lower), digits.size()));
}

/// Word i of the data; 10000 (hex) if it is not one.
std::uint32_t word_at(const Bytes& data, bool ascii, std::size_t i) {
  if (!ascii) return data[2 * i] + 256U * data[2 * i + 1];
  std::uint32_t word = 0;
  for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
    if (digit(data[k]) == 16) return 0x10000;
    word = 16 * word + digit(data[k]);
  }
  return word;
}

/// Reads the data as words and, at random, as numbers of two words.
void read_data(const Bytes& data, Code code, Dice& dice) {
  const bool ascii = code == Code::ascii;
  const std::size_t size = ascii ? 4 : 2;
  const std::size_t count = data.size() / size;
  DataReader reader(data, code);
  require(reader.holds(count) == (data.size() % size == 0) && !reader.holds(count + 1), "data hold another number");
  for (std::size_t i = 0; i < count;) {
    const std::size_t part = 1 + dice.below(count - i);
    std::vector<std::uint16_t> words(part);
    const bool pair = part == 2;
    const bool valid = pair ? reader.low_high(std::span<std::uint16_t, 2>(words)) : reader.words(words);
    bool wanted = true;
    for (std::size_t k = 0; k < part; ++k) {
      const std::uint32_t known = word_at(data, ascii, pair && ascii ? i + 1 - k : i + k);
      wanted = wanted && known < 0x10000;
      require(!valid || words[k] == known, "a word has another value");
    }
    require(valid == wanted, "text is taken for a number, or a number for text");
    i += part;
  }
  std::uint16_t none = 0;
  require(!reader.words({&none, 1}), "a word is read behind the end");
}

void play_slmp(std::uint8_t choice, const Bytes& bytes) {
  Framing framing;
  framing.frame = (choice & 1) != 0 ? FrameType::e4 : FrameType::e3;
  framing.code = (choice & 2) != 0 ? Code::ascii : Code::binary;
  Dice dice(bytes);
  const auto parse = [&](const Bytes& received) { return slmp_step(received, framing, false); };
  for (const Step& step : steps_in_any_parts(bytes, parse)) {
    if (step.kind == Step::Kind::taken) read_data(step.data, framing.code, dice);
  }
  const Step stream = slmp_step(bytes, framing, false);
  const Step datagram = slmp_step(bytes, framing, true);
  const bool fits = stream.kind != Step::Kind::incomplete && stream.consumed == bytes.size();
  require(fits ? datagram == stream : datagram.kind == Step::Kind::broken, "a datagram that is not one reply is taken");
}

// Modbus.

using link::modbus::ClientHeader;
using link::modbus::ClientReply;
using link::modbus::ClientRequest;

ClientRequest request_of(std::uint8_t choice, std::uint8_t count) {
  ClientRequest request;
  request.area = static_cast<link::modbus::Area>(choice & 3);
  request.count = static_cast<std::uint16_t>(count + 1);
  if ((choice & 4) != 0) request.kind = ClientRequest::Kind::write;
  if ((choice & 8) != 0) request.kind = ClientRequest::Kind::identify;
  return request;
}

Step modbus_step(const Bytes& bytes, const ClientRequest& request) {
  const ClientReply reply = parse_client_reply(bytes, {.transaction = kSerial, .unit = 1}, request);
  Step step{.consumed = reply.consumed, .code = reply.exception, .data = {reply.data.begin(), reply.data.end()}};
  switch (reply.kind) {
    case ClientReply::Kind::incomplete:
      require(reply.consumed == 0, "an incomplete reply was consumed");
      break;
    case ClientReply::Kind::complete:
      step.kind = Step::Kind::taken;
      break;
    case ClientReply::Kind::foreign:
      step.kind = Step::Kind::dropped;
      break;
    case ClientReply::Kind::broken:
      require(*reply.reason != '\0', "no reason for a broken reply");
      return {.kind = Step::Kind::broken};
  }
  return step;
}

void read_bits(const Bytes& data, std::uint32_t count, std::uint32_t first) {
  std::vector<std::uint64_t> words(link::image::bit_words(first + count), 0x5555'5555'5555'5555);
  const auto before = words;
  link::modbus::copy_bits(data, count, words, first);
  for (std::uint32_t i = 0; i < 64 * words.size(); ++i) {
    const bool inside = i >= first && i < first + count;
    const bool known = inside ? (data[(i - first) / 8] >> ((i - first) % 8) & 1) != 0 : link::image::get_bit(before, i);
    require(link::image::get_bit(words, i) == known, "a bit has another value");
  }
}

void play_modbus(const ClientRequest& request, const Bytes& bytes) {
  using Kind = ClientRequest::Kind;
  Dice dice(bytes);
  const auto parse = [&](const Bytes& received) { return modbus_step(received, request); };
  for (const Step& step : steps_in_any_parts(bytes, parse)) {
    if (step.kind != Step::Kind::taken) continue;
    const bool bits = has_bits(request.area);
    if (step.code != 0) {
      require(!exception_text(static_cast<std::uint8_t>(step.code), request).empty() && step.data.empty(),
              "an exception without text, or with data");
    } else if (request.kind == Kind::read) {
      require(step.data.size() == (bits ? (request.count + 7U) / 8U : 2U * request.count), "data of another size");
      if (bits) read_bits(step.data, request.count, static_cast<std::uint32_t>(dice.below(130)));
    } else if (request.kind == Kind::identify) {
      const std::string text = link::modbus::identification_text(step.data);
      require(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 0x7F && c != '`'; }),
              "an identification has other characters than printable ASCII");
    } else {
      require(step.data.empty(), "a confirmation has data");
    }
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant::fuzz;
  if (size < kHead) return -1;
  const Bytes bytes(data + kHead, data + size);
  if (data[0] < 0x80) {
    play_slmp(data[0], bytes);
  } else {
    play_modbus(request_of(data[0], data[1]), bytes);
  }
  return 0;
}

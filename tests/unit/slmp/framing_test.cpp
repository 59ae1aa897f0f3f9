// Frames byte by byte: the golden vectors that other implementations agree on, and replies that are not.
#include "symplant/link/slmp/framing.hpp"

#include <sstream>

#include "support/catch.hpp"
#include "support/slmp/golden_vectors.hpp"

using namespace symplant::link::slmp;
using symplant::test::slmp::golden_bytes;
using symplant::test::slmp::GoldenReply;
using symplant::test::slmp::GoldenRequest;

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::uint32_t hexadecimal(const std::string& text) { return static_cast<std::uint32_t>(std::stoul(text, nullptr, 16)); }

/// `D100*3=1995,1202`: a device with its number of points and values.
struct Item {
  Device device;
  std::uint16_t count = 1;
  std::vector<std::uint32_t> values;
};

Item item_of(const std::string& text) {
  Item item;
  const auto sides = split(text, '=');
  const auto head = split(sides[0], '*');
  item.device = *parse_device(head[0], Family::q);
  if (head.size() > 1) item.count = static_cast<std::uint16_t>(std::stoul(head[1]));
  for (const std::string& value : sides.size() > 1 ? split(sides[1], ',') : std::vector<std::string>()) {
    item.values.push_back(hexadecimal(value));
  }
  return item;
}

/// Two lists, separated by ` | `.
std::pair<std::vector<Item>, std::vector<Item>> items_of(const std::string& text) {
  std::pair<std::vector<Item>, std::vector<Item>> lists;
  bool second = false;
  for (const std::string& word : split(text, ' ')) {
    if (word == "|") {
      second = true;
    } else if (!word.empty()) {
      (second ? lists.second : lists.first).push_back(item_of(word));
    }
  }
  return lists;
}

Framing framing_of(bool iqr, bool ascii, bool e4, std::uint16_t timer = 4) {
  return {.frame = e4 ? FrameType::e4 : FrameType::e3,
          .code = ascii ? Code::ascii : Code::binary,
          .commands = iqr ? Commands::iqr : Commands::ql,
          .timer = timer};
}

/// Writes the request that `meaning` describes; false if the client has no such command.
bool write_request(RequestWriter& writer, const std::string& meaning) {
  const auto command = static_cast<Command>(hexadecimal(meaning.substr(0, 4)));
  const bool bits = (hexadecimal(meaning.substr(5, 4)) & 1) != 0;
  const std::string rest = meaning.size() > 10 ? meaning.substr(10) : "";
  writer.begin(command, bits, 0);
  const bool writes = command == Command::write || command == Command::write_random || command == Command::write_blocks;
  const auto put_values = [&](const Item& item, bool wide) {
    for (const std::uint32_t value : item.values) {
      if (wide) {
        writer.put_32(value);
      } else {
        writer.put_16(static_cast<std::uint16_t>(value));
      }
    }
  };
  switch (command) {
    case Command::read_model:
      return true;
    case Command::read:
    case Command::write: {
      const Item item = item_of(rest);
      writer.put_device(item.device.kind, item.device.number);
      writer.put_16(item.count);
      if (bits && writes) {
        writer.put_bits(std::vector<std::uint8_t>(item.values.begin(), item.values.end()));
      } else {
        put_values(item, false);
      }
      return true;
    }
    case Command::read_random:
    case Command::write_random:
    case Command::read_blocks:
    case Command::write_blocks: {
      const auto [first, second] = items_of(rest);
      const bool blocks = command == Command::read_blocks || command == Command::write_blocks;
      writer.put_8(static_cast<std::uint8_t>(first.size()));
      if (!bits) writer.put_8(static_cast<std::uint8_t>(second.size()));
      for (const auto* list : {&first, &second}) {
        for (const Item& item : *list) {
          writer.put_device(item.device.kind, item.device.number);
          if (blocks) writer.put_16(item.count);
          if (bits) {
            writer.put_listed_bit(item.values.front() != 0);
          } else {
            put_values(item, !blocks && list == &second);
          }
        }
      }
      return true;
    }
  }
  return false;
}

std::vector<std::uint8_t> reply_bytes(const GoldenReply& golden) { return golden_bytes(golden.frame, golden.is_ascii); }

}  // namespace

TEST_CASE("The client's requests are the golden vectors") {
  int compared = 0;
  for (const GoldenRequest& golden : symplant::test::slmp::kGoldenRequests) {
    CAPTURE(golden.name);
    RequestWriter writer(framing_of(golden.is_iqr, golden.is_ascii, golden.is_4e, golden.timer));
    if (!write_request(writer, std::string(golden.meaning))) continue;
    const auto frame = writer.finish();
    CHECK(std::vector<std::uint8_t>(frame.begin(), frame.end()) == golden_bytes(golden.frame, golden.is_ascii));
    ++compared;
  }
  CHECK(compared >= 40);
}

TEST_CASE("The client reads the golden replies, whole only") {
  for (const GoldenReply& golden : symplant::test::slmp::kGoldenReplies) {
    CAPTURE(golden.name);
    const Framing framing = framing_of(false, golden.is_ascii, golden.is_4e);
    const auto bytes = reply_bytes(golden);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CHECK(parse_reply(std::span(bytes).first(size), framing, golden.serial, false).kind == Reply::Kind::incomplete);
      CHECK(parse_reply(std::span(bytes).first(size), framing, golden.serial, true).kind == Reply::Kind::broken);
    }
    const Reply reply = parse_reply(bytes, framing, golden.serial, true);
    CHECK(reply.kind == Reply::Kind::complete);
    CHECK(reply.consumed == bytes.size());
    CHECK(reply.end_code == golden.end_code);
    const bool words = golden.end_code == 0 && (golden.subcommand & 1) == 0 &&
                       golden.values.find('|') == std::string_view::npos && !golden.values.empty();
    if (!words) continue;
    const auto values = split(std::string(golden.values), ',');
    std::vector<std::uint16_t> read(values.size());
    DataReader data(reply.data, framing.code);
    REQUIRE(data.holds(values.size()));
    CHECK(data.words(read));
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(read[i] == hexadecimal(values[i]));
  }
}

TEST_CASE("A reply to an earlier request is late with 4E, and unknown with 3E") {
  std::vector<std::uint8_t> bytes = golden_bytes(
      "D40034120000"
      "00FFFF0300"
      "0800"
      "0000"
      "951902123011",
      false);
  const Framing e4 = framing_of(false, false, true);
  CHECK(parse_reply(bytes, e4, 0x1234, false).kind == Reply::Kind::complete);
  const Reply late = parse_reply(bytes, e4, 0x1235, false);
  CHECK(late.kind == Reply::Kind::late);
  CHECK(late.consumed == bytes.size());
}

TEST_CASE("A reply that cannot be the answer is broken") {
  const Framing e3 = framing_of(false, false, false);
  const auto kind = [&](const char* frame, bool datagram = false) {
    return parse_reply(golden_bytes(frame, false), e3, 0, datagram).kind;
  };
  CHECK(kind("D00000FFFF0300040000003412") == Reply::Kind::complete);
  CHECK(kind("D40000FFFF0300040000003412") == Reply::Kind::broken);  // a subheader of 4E
  CHECK(kind("500000FFFF0300040000003412") == Reply::Kind::broken);  // a request
  CHECK(kind("D00001FFFF0300040000003412") == Reply::Kind::broken);  // another network
  CHECK(kind("D00000FEFF0300040000003412") == Reply::Kind::broken);  // another station
  CHECK(kind("D00000FFFF0300010000003412") == Reply::Kind::broken);  // no room for an end code
  CHECK(kind("D00000FFFF0300FFFF00003412") == Reply::Kind::broken);  // longer than any reply
  CHECK(kind("D00000FFFF030006000000341256") == Reply::Kind::incomplete);
  CHECK(kind("D00000FFFF030006000000341256", true) == Reply::Kind::broken);
  const Framing ascii = framing_of(false, true, false);
  CHECK(parse_reply(golden_bytes("D00000FF03FF00000400Z0", true), ascii, 0, false).kind == Reply::Kind::broken);
}

TEST_CASE("Data that is not hexadecimal or has another length is not read") {
  const auto text = golden_bytes("12G4", true);
  std::uint16_t word = 0;
  CHECK_FALSE(DataReader(text, Code::ascii).words({&word, 1}));
  const std::vector<std::uint8_t> odd = {1, 2, 3};
  CHECK_FALSE(DataReader(odd, Code::binary).holds(1));
  CHECK_FALSE(DataReader(odd, Code::binary).holds(2));
}

TEST_CASE("A double word is low word first, in ASCII high digit first") {
  std::array<std::uint16_t, 2> words{};
  CHECK(DataReader(golden_bytes("4E4F544C", false), Code::binary).low_high(words));
  CHECK(words == std::array<std::uint16_t, 2>{0x4F4E, 0x4C54});
  CHECK(DataReader(golden_bytes("04391202", true), Code::ascii).low_high(words));
  CHECK(words == std::array<std::uint16_t, 2>{0x1202, 0x0439});
}

TEST_CASE("FX5 has octal numbers of X and Y in ASCII") {
  RequestWriter writer({.code = Code::ascii, .family = Family::fx5});
  writer.begin(Command::read, false, 0);
  writer.put_device(*kind_of("X"), 8);
  const auto frame = writer.finish();
  CHECK(std::string(frame.end() - 8, frame.end()) == "X*000010");
}

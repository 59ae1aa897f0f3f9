// The server reads each golden request as what it means, and writes each golden reply exactly.
#include <cstdio>

#include "support/catch.hpp"
#include "support/slmp/golden_vectors.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

std::string hex(std::uint32_t value, int digits) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%0*X", digits, value);
  return text.data();
}

std::string item_text(const Item& item, bool has_points) {
  std::string text = address_text(*item.device, item.number);
  if (has_points) text += "*" + std::to_string(item.points);
  for (std::size_t i = 0; i < item.values.size(); ++i) {
    text += (i == 0 ? "=" : ",") + hex(item.values[i], static_cast<int>(item.width / 4));
  }
  return text;
}

/// Whether the item belongs to the second list: dwords, or blocks of bit devices.
bool is_second(const Item& item, bool has_points) { return has_points ? item.device->is_bit : item.width == 32; }

std::string items_text(const DeviceRequest& request) {
  const bool is_batch = request.command == kRead || request.command == kWrite;
  const bool has_points = is_batch || request.command == kReadBlocks || request.command == kWriteBlocks;
  std::string text;
  bool has_second = false;
  for (const Item& item : request.items) {
    const bool begins_second = !is_batch && !has_second && is_second(item, has_points);
    has_second |= begins_second;
    text += (begins_second ? " | " : " ") + item_text(item, has_points);
  }
  return text;
}

std::string meaning_of(const RequestFrame& frame, Code code) {
  const DecodedRequest decoded = decode(frame, profile_of(Family::iqr), code);
  std::string text = hex(frame.command, 4) + "/" + hex(frame.subcommand, 4);
  if (decoded.end_code == kCommand) {
    text += " ";
    for (const std::uint8_t byte : frame.payload) text += hex(byte, 2);
    return text;
  }
  if (decoded.end_code != kOk) return text + " refused with " + hex(decoded.end_code, 4);
  if (!decoded.request.text.empty()) text += " " + decoded.request.text;
  return text + items_text(decoded.request);
}

/// `1995,1202` with a length for all values.
void write_values(FieldWriter& data, std::string_view values, bool is_bits, std::size_t bytes) {
  std::vector<std::uint32_t> bits;
  while (!values.empty()) {
    const std::size_t comma = std::min(values.find(','), values.size());
    const auto value = static_cast<std::uint32_t>(std::stoul(std::string(values.substr(0, comma)), nullptr, 16));
    values.remove_prefix(std::min(comma + 1, values.size()));
    if (is_bits) bits.push_back(value);
    if (!is_bits) data.number(value, bytes);
  }
  data.bits(bits);
}

}  // namespace

TEST_CASE("Each golden request has its documented meaning") {
  CHECK(kGoldenRequests.size() == 46);
  for (const GoldenRequest& golden : kGoldenRequests) {
    INFO(golden.name);
    const Code code = golden.is_ascii ? Code::ascii : Code::binary;
    const Bytes bytes = golden_bytes(golden.frame, golden.is_ascii);
    const FoundRequest found = find_request(bytes, code);
    REQUIRE(found.found == Found::request);
    CHECK(found.size == bytes.size());
    CHECK(found.frame.is_4e == golden.is_4e);
    CHECK(found.frame.timer == golden.timer);
    CHECK(found.frame.route == Route{});
    CHECK(found.frame.serial == 0);
    CHECK(meaning_of(found.frame, code) == golden.meaning);
  }
}

TEST_CASE("Each beginning of a golden request is a part of a request") {
  for (const GoldenRequest& golden : kGoldenRequests) {
    INFO(golden.name);
    const Bytes bytes = golden_bytes(golden.frame, golden.is_ascii);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const FoundRequest found = find_request({bytes.data(), size}, golden.is_ascii ? Code::ascii : Code::binary);
      CHECK(found.found == Found::part);
    }
  }
}

TEST_CASE("A golden request in the other code is foreign") {
  for (const GoldenRequest& golden : kGoldenRequests) {
    INFO(golden.name);
    const Bytes bytes = golden_bytes(golden.frame, golden.is_ascii);
    CHECK(find_request(bytes, golden.is_ascii ? Code::binary : Code::ascii).found == Found::foreign);
  }
}

TEST_CASE("Each golden reply is encoded exactly") {
  CHECK(kGoldenReplies.size() == 11);
  for (const GoldenReply& golden : kGoldenReplies) {
    INFO(golden.name);
    const Code code = golden.is_ascii ? Code::ascii : Code::binary;
    RequestFrame request;
    request.is_4e = golden.is_4e;
    request.serial = golden.serial;
    request.command = golden.command;
    request.subcommand = golden.subcommand;
    FieldWriter data(code);
    const std::size_t bar = std::min(golden.values.find(" | "), golden.values.size());
    write_values(data, golden.values.substr(0, bar), (golden.subcommand & 1U) != 0, 2);
    if (bar < golden.values.size()) write_values(data, golden.values.substr(bar + 3), false, 4);
    CHECK(encode_reply(request, code, golden.end_code, data.bytes()) == golden_bytes(golden.frame, golden.is_ascii));
  }
}

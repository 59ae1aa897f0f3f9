// What an SLMP link does with end codes, closed connections, and answers that are not SLMP.
#include "symplant/link/slmp/refusal.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/slmp/plc_request.hpp"
#include "symplant/link/slmp/other_answer.hpp"
#include "symplant/tables/names.hpp"
#include "unit/slmp/cell_bench.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using link::slmp::Code;
using link::slmp::FrameType;
using link::slmp::other_answer;
using test::slmp::Delivery;
using test::slmp::Exchange;
using test::slmp::PlcMemory;
using test::slmp::PlcOptions;
using test::slmp::SlmpPlc;

namespace {

using Dialog = link::client::Dialog;

/// Symbols and the dialog of a link with them, over images in plain memory.
class Conversation {
 public:
  Conversation(test::SymbolList list, std::uint16_t port, const std::string& parameters)
      : list_(std::move(list)), tables_(list_.tables()) {
    auto parts = link::client_parts(
        {"slmp://127.0.0.1:" + std::to_string(port) + "?family=iqr&events=direct&" + parameters, 0}, tables_);
    if (auto* error = std::get_if<link::LinkError>(&parts)) throw std::runtime_error(error->message);
    parts_ = std::get<link::client::ClientParts>(std::move(parts));
    bits_.resize(link::image::bit_words(parts_.map.size(link::Plane::operation_bits)) + 1);
    numbers_.resize(parts_.map.size(link::Plane::operation_numbers) + 1);
    if (auto fault = parts_.dialog->open()) throw std::runtime_error(fault.message);
  }

  Dialog& dialog() { return *parts_.dialog; }
  link::client::Fault read(tables::Time now) { return parts_.dialog->read({bits_, numbers_}, now); }
  std::uint16_t number(const std::string& name) {
    for (const link::image::Point& point : parts_.map.points) {
      const auto texts = tables::split_names(tables_.symbol_names);
      if (texts[std::size_t{2} * point.symbol] == name) return static_cast<std::uint16_t>(numbers_[point.position]);
    }
    throw std::runtime_error("no symbol " + name);
  }

 private:
  test::SymbolList list_;
  tables::PlantTables tables_;
  link::client::ClientParts parts_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint64_t> numbers_;
};

/// Operations at these words of D.
test::SymbolList words_list(const std::vector<std::uint32_t>& numbers) {
  test::SymbolList list;
  for (const std::uint32_t number : numbers) {
    list.add_device("D" + std::to_string(number), test::SymbolList::kOut, "D" + std::to_string(number),
                    tables::DataType::word);
  }
  return list;
}

Delivery honest(const Exchange& exchange) {
  Delivery delivery;
  delivery.parts.push_back({exchange.reply, {}});
  return delivery;
}

Delivery refused(const Exchange& exchange, std::uint16_t end_code) {
  Delivery delivery;
  delivery.parts.push_back({encode_reply(exchange.request, exchange.code, end_code, {}), {}});
  return delivery;
}

PlcOptions cell_options() {
  PlcOptions options;
  options.program = [](PlcMemory& memory) { test::scan_cell(memory); };
  return options;
}

std::vector<std::uint8_t> bytes(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace

TEST_CASE("A reading that gets an end code once is sent again in the next pass, whatever the code is") {
  for (const int end_code : {0x0050, 0x0055, 0x4031, 0x4ABC, 0xC051, 0xC056, 0xC059, 0xC05B, 0xCEE0, 0xFFFF}) {
    const auto code = static_cast<std::uint16_t>(end_code);
    CAPTURE(end_code);
    bool refuses = true;
    SlmpPlc plc({}, [&](const Exchange& exchange) {
      return std::exchange(refuses, false) ? refused(exchange, code) : honest(exchange);
    });
    plc.memory().set_word("D", 20, 7);
    Conversation link(words_list({20, 21}), plc.port(), "");
    CHECK(link.read(0).kind == link::client::Fault::Kind::rejected);
    CHECK_FALSE(link.read(1));
    CHECK(link.number("D20") == 7);
  }
}

TEST_CASE("A reading that the PLC refuses is divided until the refused word is alone, and whole again later") {
  SlmpPlc plc;
  plc.memory().configure("D", 100);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 60; i <= 100; ++i) numbers.push_back(i);
  for (std::uint32_t i = 60; i < 100; ++i) plc.memory().set_word("D", i, static_cast<std::uint16_t>(i));
  Conversation link(words_list(numbers), plc.port(), "");
  tables::Time now = 0;
  for (int pass = 0; pass < 20 && link.read(now); ++pass) now += tables::kMillisecond;
  CHECK_FALSE(link.dialog().is_dividing());
  for (std::uint32_t i = 60; i < 100; ++i) CHECK(link.number("D" + std::to_string(i)) == i);
  CHECK(link.dialog().take_rejections().size() == 1);
  CHECK(link.dialog().take_left_out().empty());
  for (; now < 10 * tables::kSecond; now += 10 * tables::kMillisecond) CHECK_FALSE(link.read(now));
  const auto left_out = link.dialog().take_left_out();
  REQUIRE(left_out.size() == 1);
  CHECK(left_out.front().lanes.lane == link::client::Lane{link::Plane::operation_numbers, 4 * 40});
  CHECK(left_out.front().refusal.code == 0x4031);
  CHECK_THAT(link::slmp::refusal_text(left_out.front().refusal),
             ContainsSubstring("reading from D100 on: end code 4031"));
  plc.memory().configure("D", 200);
  plc.memory().set_word("D", 100, 5);
  CHECK_FALSE(link.read(now + 60 * tables::kSecond));
  CHECK(link.number("D100") == 5);
  const std::uint64_t before = link.dialog().requests();
  CHECK_FALSE(link.read(now + 120 * tables::kSecond));
  CHECK(link.dialog().requests() - before == 1);
}

TEST_CASE("A link goes on through end codes that come and go") {
  std::uint64_t count = 0;
  const std::vector<std::uint16_t> codes = {0x4031, 0xC051, 0xC056, 0xC059, 0xC05B, 0xCEE0};
  SlmpPlc plc(cell_options(), [&](const Exchange& exchange) {
    ++count;
    return count > 20 && count % 7 == 0 ? refused(exchange, codes[count / 7 % codes.size()]) : honest(exchange);
  });
  const test::CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms");
  CHECK(plc.wait_until([&] { return plc.memory().word("D", 0) >= 2; }));
}

TEST_CASE("An SLMP server that closes after each answer is served") {
  std::set<std::size_t> peers;
  SlmpPlc plc(cell_options(), [&](const Exchange& exchange) {
    Delivery delivery = honest(exchange);
    delivery.resets = peers.insert(exchange.peer.id).second;
    return delivery;
  });
  const test::CellClient client(plc.port(), "family=iqr&events=direct&poll=1ms");
  CHECK(plc.wait_until([&] { return plc.memory().word("D", 0) >= 2; }));
}

TEST_CASE("With 3E an old answer to a reading is not taken for the confirmation of a write") {
  SlmpPlc plc({}, [&](const Exchange& exchange) {
    Delivery delivery;
    const bool writes = exchange.request.command == test::slmp::kWrite;
    delivery.parts.push_back({writes ? encode_reply(exchange.request, exchange.code, 0, {7, 0}) : exchange.reply, {}});
    return delivery;
  });
  test::SymbolList list;
  list.add_device("E", test::SymbolList::kIn, "D7", tables::DataType::word);
  Conversation link(list, plc.port(), "");
  std::vector<link::client::Unwritten> unwritten;
  const std::vector<link::client::LaneChange> changes = {{{link::Plane::event_numbers, 0}, 0xFFFF, 3}};
  const auto fault = link.dialog().write(changes, unwritten);
  CHECK(fault.kind == link::client::Fault::Kind::transport);
  CHECK_THAT(fault.message, ContainsSubstring("answers a request to write with values"));
}

TEST_CASE("What answers instead of an SLMP port of the link's form is recognized") {
  using namespace std::string_view_literals;
  const auto of = [](std::string_view text, FrameType frame = FrameType::e3, Code code = Code::binary) {
    return other_answer(bytes(text), {.frame = frame, .code = code});
  };
  CHECK_THAT(of("D00000FF03FF000004"sv), ContainsSubstring("set `code=ascii`"));
  CHECK_THAT(of("\xD0\0\0\xFF\xFF\x03\0\x02\0\0\0"sv, FrameType::e4, Code::ascii),
             ContainsSubstring("set `code=binary` `frame=3e`"));
  CHECK_THAT(of("\xD4\0\x01\0\0\0"sv), ContainsSubstring("set `frame=4e`"));
  CHECK_THAT(of("\xD0\x50"sv), ContainsSubstring("1E frames only"));
  CHECK_THAT(of("\xD0\x5B\x10\0"sv), ContainsSubstring("1E frames only"));
  CHECK_THAT(of("D050"sv, FrameType::e3, Code::ascii), ContainsSubstring("1E frames only"));
  CHECK_THAT(of("\x50\0\0\0\0\x03\xFF\x81\x01"sv), ContainsSubstring("a Modbus server answers: use `modbus-tcp://`"));
  CHECK_THAT(of("HTTP/1.1 400 Bad Request\r\n"sv), ContainsSubstring("`HTTP/1.1 400 Bad Request`"));
  CHECK_THAT(of("\x15\x03\x01"sv), ContainsSubstring("the bytes 15 03 01"));
}

TEST_CASE("An end code does not advise a setting that the link has") {
  CHECK_THAT(link::slmp::end_code_text(0x0050, {.frame = FrameType::e4}), ContainsSubstring("set `frame=3e`"));
  CHECK_THAT(link::slmp::end_code_text(0x0050, {}), !ContainsSubstring("set `frame=3e`"));
  CHECK_THAT(link::slmp::end_code_text(0xC050, {.code = Code::ascii}), ContainsSubstring("set `code=binary`"));
  CHECK_THAT(link::slmp::end_code_text(0xC050, {}), !ContainsSubstring("set `code=binary`"));
}

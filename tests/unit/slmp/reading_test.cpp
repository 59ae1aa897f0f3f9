// Reading all symbols of a MELSEC PLC without writing.
#include <random>

#include "support/catch.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/record/image_reader.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using test::SymbolList;
using test::slmp::SlmpPlc;

namespace {

constexpr std::uint32_t kBits = 20;        ///< events X100 and up
constexpr std::uint32_t kNumbers = 1'200;  ///< operations D0, D3 ...: of 32 bits, in more words than one request has

SymbolList bits_and_numbers() {
  SymbolList list;
  for (std::uint32_t i = 0; i < kBits; ++i) {
    const std::string number = std::to_string(100 + i);
    list.add_device("I" + number, SymbolList::kIn, "X" + number);
  }
  for (std::uint32_t i = 0; i < kNumbers; ++i) {
    list.add_device("N" + std::to_string(i), SymbolList::kOut, "D" + std::to_string(3 * i), tables::DataType::udint);
  }
  return list;
}

/// Sets all of them to random values, which it returns by symbol.
std::vector<std::uint64_t> fill(SlmpPlc& plc) {
  std::mt19937 random(7);
  std::vector<std::uint64_t> values;
  for (std::uint32_t i = 0; i < kBits; ++i) {
    values.push_back(random() % 2);
    const auto number = static_cast<std::uint32_t>(std::stoul(std::to_string(100 + i), nullptr, 16));
    plc.memory().set_bit("X", number, values.back() != 0);
  }
  for (std::uint32_t i = 0; i < kNumbers; ++i) {
    values.push_back(random() & 0xFFFF'FFFF);
    plc.memory().set_word("D", 3 * i, static_cast<std::uint16_t>(values.back()));
    plc.memory().set_word("D", 3 * i + 1, static_cast<std::uint16_t>(values.back() >> 16));
  }
  return values;
}

}  // namespace

TEST_CASE("A link that only reads takes events from X without a choice") {
  const SymbolList list = bits_and_numbers();
  const tables::PlantTables tables = list.tables();
  for (const std::string parameters : {"family=iqr", "family=iqr&frame=3e", "family=iqr&transport=udp"}) {
    CAPTURE(parameters);
    SlmpPlc plc;
    const std::vector<std::uint64_t> values = fill(plc);
    link::LinkChoice choice{"slmp://127.0.0.1:" + std::to_string(plc.port()) + "?timeout=20s&" + parameters, 0};
    choice.settings.reads_only = true;
    auto made = link::client_parts(choice, tables);
    if (auto* error = std::get_if<link::LinkError>(&made)) FAIL(error->message);
    auto& parts = std::get<link::client::ClientParts>(made);
    REQUIRE_FALSE(parts.dialog->open());
    link::record::ImageReader reader(*parts.dialog, tables, parts.map);
    REQUIRE_FALSE(reader.read(link::client::steady_now()));
    std::vector<std::uint64_t> read(values.size());
    std::vector<tables::Time> times;
    std::size_t unread = 0;
    for (const link::record::Reading& reading : reader.readings()) {
      if (!reading.is_read) ++unread;
      read[reading.symbol] = reading.value;
      if (times.empty() || times.back() != reading.time) times.push_back(reading.time);
    }
    CHECK(unread == 0);
    CHECK(read == values);
    CHECK(times.size() > 2);  // more than one request for each direction
    CHECK(plc.log().writes().empty());
    CHECK(plc.log().violations().empty());
  }
}

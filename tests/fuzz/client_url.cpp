// Any text as the URL of a link to a PLC: settings within their ranges, or an error; and the map that they make.
#include <algorithm>
#include <string>
#include <variant>

#include "fuzz/target.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/slmp/map.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::fuzz {
namespace {

using link::LinkError;
using namespace link::slmp;

/// Inputs, outputs and numbers, which URLs move.
const test::SymbolList& moved_list() {
  static const test::SymbolList list = [] {
    test::SymbolList made;
    using tables::DataType;
    for (std::uint32_t i = 0; i < 8; ++i) {
      made.add_device("I" + std::to_string(i), test::SymbolList::kIn, "X" + std::to_string(i), i);
      made.add_device("O" + std::to_string(i), test::SymbolList::kOut, "Y" + std::to_string(i), i);
    }
    made.add_device("N", test::SymbolList::kIn, "D10", DataType::int_);
    made.add_device("L", test::SymbolList::kOut, "D20", DataType::lreal);
    made.add_device("K", test::SymbolList::kOut, "K4Y40", DataType::word);
    made.add_device("B", test::SymbolList::kIn, "W1F.A");
    return made;
  }();
  return list;
}

void require_usage(const LinkError& error) {
  require(error.kind == LinkError::Kind::usage && !error.message.empty(), "an error without text, or not of the URL");
}

void require_device(const Device& device, Family family) {
  require(device.number < kMostDevices, "a device is beyond those that a request can name");
  require(parse_device(device_text(device, family), family) == device, "the text of a device is another device");
}

void require_ascending(const std::vector<Cell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    require(cells[i].word < kMostDevices / (info_of(cells[i].kind).bit ? 16 : 1), "a word is beyond all devices");
    require(i == 0 || cells[i - 1] < cells[i], "the words of a map do not ascend");
  }
}

void require_cells(const Cells& cells) {
  require_ascending(cells.bits);
  std::vector<Cell> numbers;
  for (const NumberCell& number : cells.numbers) numbers.push_back(number.cell);
  require_ascending(numbers);
}

void play_slmp_url(std::string_view rest) {
  const auto read = read_settings(rest);
  if (const auto* error = std::get_if<LinkError>(&read)) return require_usage(*error);
  const auto& settings = std::get<Settings>(read);
  const Family family = settings.framing.family;
  require(settings.address.port != 0 && settings.timeout > 0 && settings.times.poll > 0, "a setting is 0");
  for (const Move& move : settings.moves) {
    require(move.last >= move.first.number && move.last < kMostDevices, "a range of devices is none");
    require_device(move.first, family);
    require_device(move.to, family);
  }
  for (const SymbolMove& move : settings.symbol_moves) require_device(move.to, family);
  const auto made = make_device_map(moved_list().tables(), 0, {}, settings);
  if (const auto* error = std::get_if<LinkError>(&made)) return require_usage(*error);
  const auto& map = std::get<DeviceMap>(made);
  require(map.devices.size() == map.image.points.size(), "points and devices differ in number");
  for (const Device& device : map.devices) require_device(device, family);
  require_cells(map.operations);
  require_cells(map.events);
  for (const link::image::Point& point : map.image.points) {
    require(point.position < map.image.size(point.plane), "a point is outside of its image");
  }
}

void play_modbus_url(const std::string& rest) {
  const auto read = link::modbus::read_client_settings(rest);
  if (const auto* error = std::get_if<LinkError>(&read)) require_usage(*error);
  const auto parts = link::client_parts({"modbus-tcp:" + rest, 0}, moved_list().tables());
  if (const auto* error = std::get_if<LinkError>(&parts)) require(!error->message.empty(), "an error without text");
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  symplant::fuzz::play_slmp_url(text);
  symplant::fuzz::play_modbus_url(text);
  return 0;
}

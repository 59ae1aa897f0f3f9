// Slave devices of OpenPLC (mbconfig.cfg) that transfer a map.
//
// OpenPLC polls the devices in their order. It puts all discrete inputs one after another from %IX100.0 on, coils from
// %QX100.0, input registers from %IW100, holding registers that it writes from %QW100; at most 400 of each, and each
// device has one block of each. It has no other memory for them: a number of two registers is two words.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

#include "map/channels.hpp"
#include "map/formats.hpp"
#include "map/variables.hpp"
#include "read/types/data_types.hpp"
#include "symplant/link/modbus/transfer_range.hpp"
#include "symplant/link/net/host_port.hpp"

namespace symplant::map {
namespace {

using link::modbus::Table;

constexpr std::uint32_t kFirst = 100;  ///< the byte or word of the first one
constexpr std::uint32_t kByte = 8;
constexpr std::string_view kServer = "modbus-tcp-server:";

/// Numbers that a device transfers, and the bit or word of OpenPLC that the first one is, counted from %IX100.0 or
/// %IW100.
struct Block {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t at = 0;
};

class OpenPlcConfig {
 public:
  explicit OpenPlcConfig(const LinkView& view) : view_(view), names_(view) {}

  FormatFault write(base::TextSink& sink) {
    if (auto fault = find_address()) return fault;
    for (std::size_t t = 0; t < link::modbus::kTables; ++t) {
      if (auto fault = make_blocks(static_cast<Table>(t))) return fault;
    }
    base::PartCollector out(sink);
    write_devices(out);
    write_variables(out);
    out.finish();
    return std::nullopt;
  }

 private:
  static link::LinkError fault(std::string message) { return {link::LinkError::Kind::usage, std::move(message)}; }

  FormatFault find_address() {
    if (!view_.choice.url.starts_with(kServer)) return std::nullopt;  // no URL is given
    std::string_view rest = std::string_view(view_.choice.url).substr(kServer.size());
    if (rest.starts_with("//")) rest.remove_prefix(2);
    auto parsed = link::net::parse_host_port(rest);
    if (auto* error = std::get_if<link::LinkError>(&parsed)) return std::move(*error);
    const auto& address = std::get<link::net::HostPort>(parsed);
    if (address.port == 0) {
      return fault(
          "the URL has port 0, which is any free port: give the port that OpenPLC connects to, as in `--link "
          "modbus-tcp-server://127.0.0.1:1502`");
    }
    port_ = address.port;
    const bool here = address.host.empty() || address.host == "0.0.0.0" || address.host == "localhost" ||
                      address.host == "::" || address.host == "::1";
    if (!here) host_ = address.host;
    constexpr std::size_t kLongestAddress = 99;
    if (host_.size() > kLongestAddress || host_.find_first_not_of("0123456789.") != std::string::npos) {
      return fault("OpenPLC connects to an IPv4 address, not to the name `" + host_ + "`: give the address in the URL");
    }
    return std::nullopt;
  }

  FormatFault make_blocks(Table table) {
    std::vector<Block>& blocks = blocks_[static_cast<std::size_t>(table)];
    const std::uint32_t extra = link::modbus::extra_numbers(view_.served(), table);
    std::uint32_t used = 0;
    if (const auto range = link::modbus::openplc_range(view_.of->tables, view_.served(), table)) {
      used = range->count;
      if (used > link::modbus::kMostOfOpenPlc - extra) {
        return fault(fmt::format(
            "OpenPLC has {} {}s of slave devices, and this map needs {}, from {} to {}{}: give the symbols other "
            "numbers in `links`",
            link::modbus::kMostOfOpenPlc, link::modbus::table_name(table), used + extra, range->first, range->end() - 1,
            extra == 0 ? "" : " and the status block"));
      }
      cut(points_of(view_.served(), table), range->first, range->end(), channel_limit(table), blocks);
    }
    if (extra == 0) return std::nullopt;
    const std::uint32_t first =
        table == Table::input_register ? *view_.served().status_block : *view_.served().watchdog;
    extra_at_[static_cast<std::size_t>(table)] = used;
    blocks.push_back({first, extra, used});
    return std::nullopt;
  }

  /// Blocks of at most `limit` without a gap between them, none of which ends within a number.
  static void cut(const std::vector<const link::modbus::IoPoint*>& points, std::uint32_t start, std::uint32_t end,
                  std::uint32_t limit, std::vector<Block>& blocks) {
    for (std::uint32_t first = start; first < end;) {
      std::uint32_t next = std::min(end, first + limit);
      for (const link::modbus::IoPoint* const point : points) {
        if (point->number < next && next <= point->last()) next = point->number;
      }
      blocks.push_back({first, next - first, first - start});
      first = next;
    }
  }

  void write_devices(base::PartCollector& out) const {
    std::size_t devices = 1;
    for (const auto& blocks : blocks_) devices = std::max(devices, blocks.size());
    out.add("# Written by `symplant map --format openplc`.\n");
    out.add(fmt::format("Num_Devices = \"{}\"\nPolling_Period = \"50\"\nTimeout = \"1000\"\n", devices));
    for (std::size_t device = 0; device < devices; ++device) {
      const auto add = [&](std::string_view key, const auto& value) {
        out.add(fmt::format("device{}.{} = \"{}\"\n", device, key, value));
      };
      out.add("\n");
      add("name", fmt::format("symplant_{}", device));
      add("slave_id", 1);
      add("protocol", "TCP");
      add("address", host_);
      add("IP_Port", port_);
      const auto block = [&](Table table, std::string_view key) {
        const auto& blocks = blocks_[static_cast<std::size_t>(table)];
        const Block found = device < blocks.size() ? blocks[device] : Block{};
        add(fmt::format("{}_Start", key), found.first);
        add(fmt::format("{}_Size", key), found.count);
      };
      block(Table::discrete_input, "Discrete_Inputs");
      block(Table::coil, "Coils");
      block(Table::input_register, "Input_Registers");
      add("Holding_Registers_Read_Start", 0);
      add("Holding_Registers_Read_Size", 0);
      block(Table::holding_register, "Holding_Registers");
    }
  }

  void declare(base::PartCollector& out, const std::string& name, std::string_view type, Table table, std::uint32_t at,
               const std::string& comment) const {
    const char direction = is_event(table) ? 'I' : 'Q';
    const std::string address = has_bits(table) ? fmt::format("%{}X{}.{}", direction, kFirst + at / kByte, at % kByte)
                                                : fmt::format("%{}W{}", direction, kFirst + at);
    out.add(fmt::format("#   {} AT {} : {}; (* {} *)\n", name, address, type, comment));
  }

  /// A number of several words, each with a variable: _W0 has the lowest bits.
  void declare_words(base::PartCollector& out, const std::string& name, std::uint32_t words, link::WordOrder order,
                     Table table, std::uint32_t at, const std::string& comment) {
    for (std::uint32_t i = 0; i < words; ++i) {
      const std::uint32_t significance = order == link::WordOrder::low_first ? i : words - 1 - i;
      declare(out, names_.add(fmt::format("{}_W{}", name, significance)), "UINT", table, at + i, comment);
    }
  }

  void write_variables(base::PartCollector& out) {
    out.add("\n# Variables of the PLC program:\n# VAR\n");
    for (const Table table : {Table::discrete_input, Table::coil, Table::input_register, Table::holding_register}) {
      const auto& blocks = blocks_[static_cast<std::size_t>(table)];
      for (const link::modbus::IoPoint* const point : points_of(view_.served(), table)) {
        declare_point(out, *point, point->number - blocks.front().first);
      }
      if (link::modbus::extra_numbers(view_.served(), table) == 0) continue;
      const std::uint32_t at = extra_at_[static_cast<std::size_t>(table)];
      if (table == Table::holding_register) {
        declare(out, names_.add("PLANT_WATCHDOG"), "UINT", table, at, "the program changes it in every cycle");
        continue;
      }
      for (const link::StatusField& field : link::kStatusFields) {
        const std::string comment = status_comment(view_, field);
        if (field.words == 1) {
          declare(out, names_.add(status_name(field)), "UINT", table, at + field.first, comment);
        } else {
          declare_words(out, status_name(field), field.words, view_.choice.settings.word_order, table, at + field.first,
                        comment);
        }
      }
    }
    out.add("# END_VAR\n");
  }

  void declare_point(base::PartCollector& out, const link::modbus::IoPoint& point, std::uint32_t at) {
    const tables::DataType type = view_.of->tables.symbols[point.symbol].type();
    const std::string comment = variable_comment(view_, names_, point);
    const std::string& name = names_[point.symbol];
    if (point.width > 1) {
      return declare_words(out, name, point.width, point.word_order, point.table, at,
                           fmt::format("{}, {}", read::data_type_name(type), comment));
    }
    declare(out, name, link::modbus::is_8_bits(type) ? "UINT" : read::data_type_name(type), point.table, at, comment);
  }

  const LinkView& view_;
  VariableNames names_;
  std::string host_ = "127.0.0.1";
  std::uint16_t port_ = 1502;
  std::array<std::vector<Block>, link::modbus::kTables> blocks_;  ///< of each table, in the order of the devices
  std::array<std::uint32_t, link::modbus::kTables> extra_at_{};   ///< the word of the status block or the watchdog
};

}  // namespace

FormatFault write_openplc(std::span<const LinkView> views, base::TextSink& sink) {
  return OpenPlcConfig(views.front()).write(sink);
}

}  // namespace symplant::map

// Declarations of the variables of a map: structured text of IEC 61131-3, and for CODESYS.
#include <fmt/format.h>

#include <string>

#include "map/formats.hpp"
#include "map/placing.hpp"
#include "map/variables.hpp"
#include "read/types/data_types.hpp"
#include "symplant/link/modbus/transfer_range.hpp"

namespace symplant::map {
namespace {

constexpr std::uint32_t kLongWords = 4;  ///< words of a number of 64 bits

class Declaring {
 public:
  Declaring(const LinkView& view, IoMemory memory)
      : view_(view), memory_(memory), channels_(place(view, memory)), names_(view) {}

  void write(base::PartCollector& out, std::string_view format) {
    out.add(fmt::format("(* Written by `symplant map --format {}`. Channels of the I/O scanner, counted from 0:\n",
                        format));
    for (const PlacedChannel& placed : channels_) out.add(channel_line(placed));
    out.add("*)\nVAR_GLOBAL\n");
    for (const PlacedChannel& placed : channels_) {
      out.add(fmt::format("  (* {}: {} *)\n", placed.channel.access(), placed.channel.part_name()));
      declare(out, placed);
    }
    out.add("END_VAR\n");
  }

 private:
  std::string channel_line(const PlacedChannel& placed) const {
    const Channel& channel = placed.channel;
    const bool bits = channel.function() == 2 || channel.function() == 15;
    const std::string first = bits ? bit_address(channel.table, placed.at) : address(channel.table, 'W', placed.at);
    return fmt::format("   {:<24}  function {:<2}  start {:<5}  count {:<4}  from {}\n", channel.access(),
                       channel.function(), channel.first, channel.count, first);
  }

  void declare(base::PartCollector& out, const PlacedChannel& placed) {
    const Channel& channel = placed.channel;
    if (channel.part == Channel::Part::status_block) {
      for (const link::StatusField& field : link::kStatusFields) {
        const std::string located = number(channel.table, placed.at + field.first, field.words,
                                           unsigned_type(field.words), view_.choice.settings.word_order);
        out.add(line(names_.add(status_name(field)), located, status_comment(view_, field)));
      }
    }
    if (channel.part == Channel::Part::watchdog) declare_watchdog(out, placed);
    if (channel.part != Channel::Part::symbols) return;
    for (const link::modbus::IoPoint* const point : points_of(view_.served(), channel.table)) {
      if (point->number < channel.first || point->number >= channel.end()) continue;
      out.add(line(names_[point->symbol], located(*point, placed.at_number(point->number)),
                   variable_comment(view_, names_, *point)));
    }
    const auto watchdog = view_.served().watchdog;
    if (channel.table == link::modbus::Table::holding_register && watchdog && channel.first <= *watchdog &&
        *watchdog < channel.end()) {
      declare_watchdog(out, placed);
    }
  }

  void declare_watchdog(base::PartCollector& out, const PlacedChannel& placed) {
    const std::uint32_t at = placed.at_number(*view_.served().watchdog);
    out.add(line(names_.add("PLANT_WATCHDOG"), "AT " + address(placed.channel.table, 'W', at) + " : UINT",
                 "the program changes it in every cycle"));
  }

  static std::string line(const std::string& name, const std::string& located, const std::string& comment) {
    return fmt::format("  {} {}; (* {} *)\n", name, located, comment);
  }

  static std::string address(link::modbus::Table table, char size, std::uint32_t at) {
    return fmt::format("%{}{}{}", is_event(table) ? 'I' : 'Q', size, at);
  }
  static std::string bit_address(link::modbus::Table table, std::uint32_t at) {
    return fmt::format("%{}X{}.{}", is_event(table) ? 'I' : 'Q', at / 8, at % 8);
  }

  /// "AT %IW5 : INT". A number that is no variable of its size there is an array of its words.
  std::string located(const link::modbus::IoPoint& point, std::uint32_t at) const {
    const tables::DataType type = view_.of->tables.symbols[point.symbol].type();
    if (type == tables::DataType::boolean) return "AT " + bit_address(point.table, at) + " : BOOL";
    return number(point.table, at, point.width, link::modbus::is_8_bits(type) ? "WORD" : read::data_type_name(type),
                  point.word_order);
  }

  std::string number(link::modbus::Table table, std::uint32_t at, std::uint32_t words, std::string_view type,
                     link::WordOrder order) const {
    if (words == 1) return fmt::format("AT {} : {}", address(table, 'W', at), type);
    const bool known = memory_ == IoMemory::separate || (order == link::WordOrder::low_first && words < kLongWords);
    if (!known || at % words != 0) {
      return fmt::format("AT {} : ARRAY [0..{}] OF WORD", address(table, 'W', at), words - 1);
    }
    return fmt::format("AT {} : {}", address(table, words == kLongWords ? 'L' : 'D', at / words), type);
  }

  const LinkView& view_;
  const IoMemory memory_;
  const std::vector<PlacedChannel> channels_;
  VariableNames names_;
};

FormatFault write_declarations(const LinkView& view, IoMemory memory, std::string_view format, base::TextSink& sink) {
  base::PartCollector out(sink);
  Declaring(view, memory).write(out, format);
  out.finish();
  return std::nullopt;
}

}  // namespace

FormatFault write_st(std::span<const LinkView> views, base::TextSink& sink) {
  return write_declarations(views.front(), IoMemory::separate, "st", sink);
}

FormatFault write_codesys(std::span<const LinkView> views, base::TextSink& sink) {
  return write_declarations(views.front(), IoMemory::overlaid, "codesys", sink);
}

}  // namespace symplant::map

// Where each symbol lies in a PLC's memory, and in the images of its link.
#include "symplant/link/slmp/map.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::slmp {

namespace {

constexpr std::uint32_t kCellBits = 16;
constexpr std::uint32_t kBitsPerDigit = 4;

LinkError error_of(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

std::string ticked(std::string_view text) { return "`" + std::string(text) + "`"; }

bool is_output(Kind kind) { return info_of(kind).name == "Y" || info_of(kind).name == "DY"; }
bool is_input(Kind kind) { return info_of(kind).name == "X" || info_of(kind).name == "DX"; }

/// The device that `move` gives to `device`; nothing if it is out of the range.
std::optional<Device> moved(const Device& device, const Move& move) {
  if (device.kind != move.first.kind || device.number < move.first.number || device.number > move.last) return {};
  const std::uint32_t offset = device.number - move.first.number;
  Device to = move.to;
  if (info_of(device.kind).bit && !info_of(to.kind).bit) {
    const std::uint32_t bit = offset + (to.bit == Device::kNoBit ? 0 : to.bit);
    to.number += bit / kCellBits;
    const bool whole = device.digits != 0 && bit % kCellBits == 0;  // a group of bits becomes words
    to.bit = whole ? Device::kNoBit : static_cast<std::uint8_t>(bit % kCellBits);
    return to;
  }
  to.number += offset;
  to.digits = device.digits;
  if (device.bit != Device::kNoBit) to.bit = device.bit;
  return to;
}

/// One location of the PLC's memory and the symbol that has it.
struct Use {
  Cell cell;
  std::uint16_t mask;
  std::uint32_t symbol;
  bool operation;
  Device device;
};

class Maker {
 public:
  Maker(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& link, const Settings& settings)
      : tables_(tables),
        controller_(controller),
        link_(link),
        settings_(settings),
        texts_(tables::split_names(tables.symbol_names)),
        leader_(tables.symbols.size()) {
    for (std::uint32_t symbol = 0; symbol < leader_.size(); ++symbol) leader_[symbol] = symbol;
    for (const tables::SharedAddress& shared : tables.shared_addresses) leader_[shared.symbol] = shared.leader;
  }

  std::variant<DeviceMap, LinkError> make() {
    for (const SymbolMove& move : settings_.symbol_moves) {
      if (!knows(move.symbol)) return error_of("`map` moves " + ticked(move.symbol) + ", which is not a symbol");
    }
    const MapRow* next = link_.rows.data();
    const MapRow* const end = next + link_.rows.size();
    for (std::uint32_t symbol = 0; symbol < tables_.symbols.size(); ++symbol) {
      const bool is_set = next != end && next->symbol == symbol;
      const bool excluded = is_set && next->excluded;
      if (is_set) ++next;
      if (tables::controller_of(tables_, symbol) != controller_) continue;
      if (excluded) {
        skip(symbol, "is excluded from the link");
        continue;
      }
      if (auto error = add(symbol)) return std::move(*error);
    }
    if (auto error = conflict()) return std::move(*error);
    number_all();
    return std::move(map_);
  }

 private:
  /// The position of a number in the images, and which of its words comes first.
  struct Number {
    std::uint32_t position;
    WordOrder order;
  };

  std::string_view name(std::uint32_t symbol) const { return texts_[std::size_t{2} * symbol]; }
  std::string_view address(std::uint32_t symbol) const { return texts_[std::size_t{2} * symbol + 1]; }

  bool knows(std::string_view wanted) const {
    for (std::uint32_t symbol = 0; symbol < tables_.symbols.size(); ++symbol) {
      if (tables::equal_ignoring_case(name(symbol), wanted)) return true;
    }
    return false;
  }

  void skip(std::uint32_t symbol, std::string reason) { map_.unreachable.push_back({symbol, std::move(reason)}); }

  /// Finds the device of a symbol and notes it.
  std::optional<LinkError> add(std::uint32_t symbol) {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    for (const SymbolMove& move : settings_.symbol_moves) {
      if (tables::equal_ignoring_case(name(symbol), move.symbol)) return use(symbol, move.to);
    }
    if (address(symbol).empty()) return skip(symbol, "has no address"), std::nullopt;
    const auto device = parse_device(address(symbol), settings_.framing.family);
    if (!device)
      return skip(symbol, "has the address " + ticked(address(symbol)) + ", which is not a device of this family"),
             std::nullopt;
    if (auto error = counted_otherwise(symbol, *device)) return error;
    if (!fits_group(symbol, *device)) return skip_group(symbol, std::string(address(symbol))), std::nullopt;
    for (const Move& move : settings_.moves) {
      if (const auto to = moved(*device, move)) return use(symbol, *to);
    }
    if (row.direction() == tables::Direction::event && is_input(device->kind)) return use_input(symbol, *device);
    return use(symbol, *device);
  }

  /// Whether a number is as long as its group of bits: K4X0 has 16.
  bool fits_group(std::uint32_t symbol, const Device& device) const {
    const tables::DataType type = tables_.symbols[symbol].type();
    if (device.digits == 0 || type == tables::DataType::boolean) return true;
    return device.digits * kBitsPerDigit == image::words_of(type) * kCellBits;
  }

  void skip_group(std::uint32_t symbol, const std::string& where) {
    const std::uint32_t bits = image::words_of(tables_.symbols[symbol].type()) * kCellBits;
    skip(symbol, "is a number of " + std::to_string(bits) + " bits at " + where);
  }

  /// The list counts X and Y in another base than the family, so that its addresses would be others in the PLC.
  std::optional<LinkError> counted_otherwise(std::uint32_t symbol, const Device& device) const {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    const bool counted = row.form() == tables::AddressForm::number && (is_input(device.kind) || is_output(device.kind));
    if (!counted || device.digits != 0 || device.number == row.number) return std::nullopt;
    const bool fx = settings_.framing.family == Family::fx5;
    return error_of(ticked(name(symbol)) + " at " + std::string(address(symbol)) + ": the list was read with " +
                    (fx ? "hexadecimal" : "octal") + " X and Y, the family of the link counts them in " +
                    (fx ? "octal" : "hexadecimal") + "; give `--xy " + (fx ? "octal" : "hex") +
                    "` or another `family`");
  }

  std::optional<LinkError> use_input(std::uint32_t symbol, Device device) {
    if (settings_.events == EventAccess::unset && !link_.reads_only) {
      return error_of(
          ticked(name(symbol)) + " is at " + std::string(address(symbol)) +
          ", and a PLC overwrites X in every scan where it has an input module: choose how events reach it. "
          "`events=direct` writes X, for a simulator, a vacant slot or a CPU without modules; `map=X0-X3F:X800` writes "
          "to other X without a module; `map=X0-X7F:M1000` (or B, L, D, W) writes to devices that the program uses "
          "instead of its inputs; `events=dx` writes DX. docs/mitsubishi.md compares them");
    }
    if (settings_.events == EventAccess::dx) device.kind = *kind_of("DX");
    return use(symbol, device);
  }

  std::optional<LinkError> use(std::uint32_t symbol, const Device& device) {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    const bool operation = row.direction() == tables::Direction::operation;
    const bool bit = row.type() == tables::DataType::boolean;
    const std::string where = device_text(device, settings_.framing.family);
    if (!operation && is_output(device.kind)) {
      return error_of(ticked(name(symbol)) + " is an event at " + where +
                      ": outputs are never written; move it by `map`, or check its direction");
    }
    if (bit != device.is_bit()) {
      skip(symbol, bit ? "is BOOL at " + where + ", which has 16 bits: give the bit, as in D100.0"
                       : "is a number at " + where + ", which is a bit: give a word, or K4X0");
      return std::nullopt;
    }
    const std::uint32_t more = bit ? 0 : image::words_of(row.type()) * (info_of(device.kind).bit ? kCellBits : 1) - 1;
    if (device.number + more >= kMostDevices) {
      return error_of(ticked(name(symbol)) + " is at " + where +
                      ", beyond the devices that a request can name: " + "correct its address or `map`");
    }
    if (bit) {
      const bool of_word = device.bit != Device::kNoBit;
      const Cell cell{device.kind, of_word ? device.number : device.number / kCellBits};
      const std::uint32_t shift = of_word ? device.bit : device.number % kCellBits;
      uses_.push_back({cell, static_cast<std::uint16_t>(1U << shift), symbol, operation, device});
      return std::nullopt;
    }
    add_number(symbol, device, operation, where);
    return std::nullopt;
  }

  void add_number(std::uint32_t symbol, const Device& device, bool operation, const std::string& where) {
    const std::uint8_t width = image::words_of(tables_.symbols[symbol].type());
    std::uint32_t first = device.number;
    if (info_of(device.kind).bit) {
      if (!fits_group(symbol, device)) return skip_group(symbol, where);
      if (device.number % kCellBits != 0) return skip(symbol, "is at " + where + ", not at a multiple of 16");
      first /= kCellBits;
    }
    for (std::uint32_t k = 0; k < width; ++k) {
      uses_.push_back({{device.kind, first + k}, 0xFFFF, symbol, operation, device});
    }
  }

  /// Whether two symbols may have one location: they are equal in the PLC's program, too.
  bool may_share(const Use& a, const Use& b) const {
    if (a.operation != b.operation || a.device != b.device) return false;
    const bool same =
        leader_[a.symbol] == leader_[b.symbol] || tables::equal_ignoring_case(address(a.symbol), address(b.symbol));
    return same &&
           image::words_of(tables_.symbols[a.symbol].type()) == image::words_of(tables_.symbols[b.symbol].type());
  }

  /// Two symbols on one bit; or an event, whose whole word is written, in a word with anything else.
  std::optional<LinkError> conflict() {
    std::sort(uses_.begin(), uses_.end(), [](const Use& a, const Use& b) {
      return std::tuple(a.cell, a.mask, a.symbol) < std::tuple(b.cell, b.mask, b.symbol);
    });
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      const Use& use = uses_[i];
      for (std::size_t j = i + 1; j < uses_.size() && uses_[j].cell == use.cell; ++j) {
        const Use& other = uses_[j];
        const bool meets = (use.mask & other.mask) != 0 && !may_share(use, other);
        const bool whole = !info_of(use.cell.kind).bit && use.operation != other.operation;
        const bool mixed = (use.mask == 0xFFFF) != (other.mask == 0xFFFF) && !(use.operation && other.operation);
        if (!meets && !whole && !mixed) continue;
        return error_of(ticked(name(use.symbol)) + " on " + device_text(use.device, settings_.framing.family) +
                        " and " + ticked(name(other.symbol)) + " on " +
                        device_text(other.device, settings_.framing.family) +
                        (meets ? " overlap" : " share a word, which is written whole") + ": move one of them by `map`");
      }
    }
    return std::nullopt;
  }

  /// Gives each symbol its position in the images, and each cell its lane. Numbers of one device have one position.
  void number_all() {
    for (const Use& use : uses_) {
      std::vector<Cell>& bits = cells_of(use).bits;
      if (is_bit(use) && (bits.empty() || bits.back() != use.cell)) bits.push_back(use.cell);
    }
    std::stable_sort(uses_.begin(), uses_.end(), [](const Use& a, const Use& b) {
      return std::tuple(a.symbol, a.cell) < std::tuple(b.symbol, b.cell);
    });
    const MapRow* next = link_.rows.data();
    const MapRow* const end = next + link_.rows.size();
    for (const Use& use : uses_) {
      if (!map_.image.points.empty() && map_.image.points.back().symbol == use.symbol) continue;
      while (next != end && next->symbol < use.symbol) ++next;
      const bool is_set = next != end && next->symbol == use.symbol;
      add_point(use, is_set ? *next : MapRow{.symbol = use.symbol});
    }
    set_size(Plane::operation_bits, kCellBits * map_.operations.bits.size());
    set_size(Plane::event_bits, kCellBits * map_.events.bits.size());
    for (Cells* const cells : {&map_.operations, &map_.events}) {
      std::sort(cells->numbers.begin(), cells->numbers.end(),
                [](const NumberCell& a, const NumberCell& b) { return a.cell < b.cell; });
    }
  }

  /// A MELSEC has the low word first, whatever the list looks like.
  WordOrder order_of(const MapRow& row) const {
    if (row.word_order != WordOrder::as_link) return row.word_order;
    return link_.word_order_given ? link_.word_order : WordOrder::low_first;
  }

  bool is_bit(const Use& use) const { return tables_.symbols[use.symbol].type() == tables::DataType::boolean; }
  Cells& cells_of(const Use& use) { return use.operation ? map_.operations : map_.events; }

  void add_point(const Use& use, const MapRow& row) {
    const Plane plane = image::plane_of(tables_.symbols[use.symbol]);
    const OnLoss on_loss = row.on_loss == OnLoss::as_link ? link_.on_loss : row.on_loss;
    const Number number = is_bit(use) ? Number{bit_position(use), order_of(row)} : number_of(use, plane, order_of(row));
    map_.image.points.push_back({use.symbol, plane, number.position, on_loss});
    map_.devices.push_back(use.device);
    map_.word_orders.push_back(number.order);
  }

  std::uint32_t bit_position(const Use& use) {
    const std::vector<Cell>& bits = cells_of(use).bits;
    const auto cell = static_cast<std::uint32_t>(std::lower_bound(bits.begin(), bits.end(), use.cell) - bits.begin());
    return kCellBits * cell + static_cast<std::uint32_t>(std::countr_zero(use.mask));
  }

  /// `use` has the first cell of the number. Symbols that share a number have the word order of the first one.
  Number number_of(const Use& use, Plane plane, WordOrder order) {
    std::uint32_t& size = map_.image.sizes[static_cast<std::size_t>(plane)];
    const auto [place, is_new] = numbers_.try_emplace({plane, use.cell}, Number{size, order});
    if (!is_new) return place->second;
    const std::uint32_t words = image::words_of(tables_.symbols[use.symbol].type());
    for (std::uint32_t k = 0; k < words; ++k) {
      const Cell cell{use.cell.kind, use.cell.word + (order == WordOrder::low_first ? k : words - 1 - k)};
      cells_of(use).numbers.push_back({cell, image::kLanesPerWord * size + k});
    }
    ++size;
    return place->second;
  }

  void set_size(Plane plane, std::size_t size) {
    map_.image.sizes[static_cast<std::size_t>(plane)] = static_cast<std::uint32_t>(size);
  }

  const tables::PlantTables& tables_;
  const std::uint32_t controller_;
  const LinkSettings& link_;
  const Settings& settings_;
  std::vector<std::string_view> texts_;  ///< two for each symbol: name, address
  std::vector<std::uint32_t> leader_;    ///< by symbol: the first one with its address
  std::vector<Use> uses_;
  std::map<std::pair<Plane, Cell>, Number> numbers_;  ///< by first cell
  DeviceMap map_;
};

}  // namespace

std::variant<DeviceMap, LinkError> make_device_map(const tables::PlantTables& tables, std::uint32_t controller,
                                                   const LinkSettings& link, const Settings& settings) {
  return Maker(tables, controller, link, settings).make();
}

}  // namespace symplant::link::slmp

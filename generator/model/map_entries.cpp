// Matches the entries of a link's `map` with symbols, and combines them.
#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "address/address.hpp"
#include "description/faults.hpp"
#include "elements/link/resolve.hpp"
#include "elements/link/symbol.hpp"
#include "model/classify.hpp"
#include "model/plant_model.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using address::Address;

constexpr std::uint64_t kBeyondAll = link::MapRow::kDefault - 1;  ///< a number that no table has
constexpr std::string_view kAreas = "X, Y, %IX, %QX, %IB, %QB, %IW, %QW, %ID, %QD, %IL or %QL";

/// How many numbers of its table an address takes.
std::uint64_t width_of(const Address& address) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(address.size) / 16);
}

/// In IEC 61131-3 or in the notation of a controller's lists; in SIMATIC %IW64 is another word than in IEC 61131-3.
std::optional<Address> read_address(std::string_view text, const address::Dialect& dialect) {
  const bool is_siemens = dialect.notation == address::Notation::siemens;
  const auto first = is_siemens ? address::parse(text, dialect) : address::parse_iec(text);
  if (first) return first;
  return is_siemens ? address::parse_iec(text) : address::parse(text, dialect);
}

bool is_io(const std::optional<Address>& address) { return address && address->area != address::Area::memory; }

/// Whether type and address have the same size, and the address has a number.
bool has_number(const Symbol& symbol) {
  return symbol.address && symbol.address->plain &&
         static_cast<int>(symbol.address->size) == data_type_bits(symbol.type);
}

/// An entry with its texts resolved.
struct Meant {
  const description::MapEntry* entry;
  description::Pointer pointer;
  std::optional<Address> first;  ///< the first address; of an area its address 0
  std::uint64_t last = 0;        ///< of a range, the number of the last address
  std::size_t rank = 0;          ///< higher for a more specific entry
  std::size_t matched = 0;
  bool loss_acts = false;   ///< one of its symbols is an operation
  bool order_acts = false;  ///< one of its symbols has several registers
};

/// A value for a symbol, and the entry that gives it.
template <class Value>
struct Chosen {
  Value value{};
  const Meant* by = nullptr;
};

class LinkResolver {
 public:
  LinkResolver(const PlantModel& plant, std::uint32_t controller, const description::LinkDescription& link,
               description::Faults& faults)
      : plant_(plant), controller_(controller), link_(link), faults_(faults) {
    const auto index = static_cast<std::size_t>(&link - plant.description->links.data());
    pointer_ = (description::Pointer("/links") / index / "map").text();
  }

  void run(ControllerLink& result) {
    find_symbols();
    for (std::size_t i = 0; i < link_.map.size(); ++i) understand(link_.map[i], description::Pointer(pointer_) / i);
    std::stable_sort(meant_.begin(), meant_.end(), [](const Meant& a, const Meant& b) { return a.rank > b.rank; });
    std::vector<link::MapRow> rows;
    for (const std::uint32_t symbol : symbols_) rows.push_back(row_of(symbol));
    join_addresses(rows);
    for (const link::MapRow& row : rows) {
      const bool differs =
          row.word_order != link::WordOrder::as_link || row.on_loss != link::OnLoss::as_link || !row.node.empty();
      if (differs || row.number != link::MapRow::kDefault) result.rows.push_back(row);
    }
    for (const Meant& meant : meant_) warn_of(meant);
  }

 private:
  void warn_of(const Meant& meant) {
    const description::MapEntry& entry = *meant.entry;
    const auto warn = [&](const description::Pointer& at, const std::string& what) {
      faults_.warn(at, what + words_of(entry), description::FaultKind::matches_nothing);
    };
    if (meant.matched == 0) {
      warn(meant.pointer, "no symbol of this controller ");
      return;
    }
    if (entry.on_loss && !meant.loss_acts) {
      warn(meant.pointer / "on-loss", "`on-loss` applies only to operations, and no operation ");
    }
    if (entry.word_order && !meant.order_acts) {
      warn(meant.pointer / "word-order", "`word-order` applies only to numbers of 32 or 64 bits, and no such number ");
    }
  }

  static std::string words_of(const description::MapEntry& entry) {
    if (entry.by == description::MapEntry::By::area) return "is in the area " + description::ticked(entry.text);
    if (entry.by == description::MapEntry::By::range)
      return "is between " + description::ticked(entry.text) + " and " + description::ticked(entry.last);
    return "is matched by " + description::ticked(entry.text);
  }

  void find_symbols() {
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (plant_.controller_of(plant_.symbols[i]) != controller_) continue;
      by_name_.try_emplace(plant_.symbols[i].name(), i);
      symbols_.push_back(i);
    }
  }

  address::Dialect dialect() const {
    for (const PlantList& list : plant_.lists) {
      if (list.controller == controller_) return list.dialect();
    }
    return {address::Notation::melsec};
  }

  /// Keeps an entry that can match symbols; reports an entry that cannot.
  void understand(const description::MapEntry& entry, description::Pointer pointer) {
    if (entry.text.empty()) return;  // already reported as a fault of shape
    Meant meant{&entry, std::move(pointer), std::nullopt};
    const bool sound = entry.by == description::MapEntry::By::area    ? understand_area(meant)
                       : entry.by == description::MapEntry::By::range ? understand_range(meant)
                                                                      : understand_symbol(meant);
    if (sound) meant_.push_back(std::move(meant));
  }

  bool understand_area(Meant& meant) {
    meant.first = read_address(meant.entry->text + "0", dialect());
    if (!is_io(meant.first)) meant.first = read_address(meant.entry->text + "0.0", dialect());  // E of SIMATIC
    const bool ends_in_letter =
        text::upper(meant.entry->text.back()) >= 'A' && text::upper(meant.entry->text.back()) <= 'Z';
    if (is_io(meant.first) && ends_in_letter) return true;
    faults_.add(meant.pointer / "area", description::ticked(meant.entry->text) +
                                            " is not an area of inputs or outputs; write " + std::string(kAreas));
    return false;
  }

  bool understand_range(Meant& meant) {
    meant.rank = 1;
    const auto understood = [&](const std::string& text, std::size_t which) {
      auto address = read_address(text, dialect());
      if (is_io(address) && address->plain) return address;
      faults_.add(meant.pointer / "range" / which,
                  description::ticked(text) +
                      " is not an input or output address with a number; write one such as `X10` or `%IX100.0`");
      return std::optional<Address>();
    };
    meant.first = understood(meant.entry->text, 0);
    const auto last = understood(meant.entry->last, 1);
    if (!meant.first || !last) return false;
    meant.last = last->number;
    if (meant.first->area == last->area && meant.first->size == last->size && meant.first->number <= last->number)
      return true;
    faults_.add(meant.pointer / "range",
                description::ticked(meant.entry->text) + " and " + description::ticked(meant.entry->last) +
                    " are not the first and the last address of one area; write them in ascending order");
    return false;
  }

  bool understand_symbol(Meant& meant) {
    const std::string& text = meant.entry->text;
    constexpr std::size_t kPattern = 2;
    constexpr std::size_t kExact = 1'000'000;
    if (text::is_pattern(text)) {
      meant.rank = kPattern + text::literal_characters(text);
      if (!meant.entry->number) return true;
      faults_.add(
          meant.pointer / "number",
          description::ticked(text) + " is a pattern, but its symbols cannot share one `number`; name each symbol");
      return false;
    }
    meant.rank = kExact;
    if (by_name_.count(text) != 0) return true;
    report_no_symbol(plant_, controller_, text, "remove this entry", meant.pointer / "symbol", faults_);
    return false;
  }

  bool matches(const Meant& meant, const Symbol& symbol) const {
    if (meant.entry->by == description::MapEntry::By::symbol)
      return text::matches_pattern(symbol.name(), meant.entry->text);
    if (!symbol.address || symbol.address->area != meant.first->area || symbol.address->size != meant.first->size)
      return false;
    if (meant.entry->by == description::MapEntry::By::area) return true;
    return symbol.address->plain && symbol.address->number >= meant.first->number &&
           symbol.address->number <= meant.last;
  }

  /// The number that an entry gives a symbol; nothing if it gives none.
  static std::optional<std::uint32_t> number_for(const Meant& meant, const Symbol& symbol) {
    if (!meant.entry->number) return std::nullopt;
    if (meant.entry->by == description::MapEntry::By::symbol) return meant.entry->number;
    if (!has_number(symbol)) return std::nullopt;
    const std::uint64_t away = symbol.address->number - meant.first->number;
    if (away > kBeyondAll / 4) return static_cast<std::uint32_t>(kBeyondAll);
    return static_cast<std::uint32_t>(*meant.entry->number + away * width_of(*symbol.address));
  }

  template <class Value>
  void choose(Chosen<Value>& chosen, const std::optional<Value>& value, const Meant& meant, std::string_view key,
              const Symbol& symbol) {
    if (!value || (chosen.by != nullptr && chosen.by->rank > meant.rank)) return;
    if (chosen.by == nullptr || chosen.by->rank < meant.rank) {
      chosen = {*value, &meant};
    } else if (chosen.value != *value && reported_.try_emplace(meant.pointer.text() + std::string(key), true).second) {
      const bool named =
          meant.entry->by == description::MapEntry::By::symbol && meant.entry->text == chosen.by->entry->text;
      description::DescriptionFault fault{
          (meant.pointer / key).text(),
          "two equally specific entries give " + description::ticked(symbol.name()) + " different values of " +
              description::ticked(key) + "; remove one" +
              (named || text::equal_ignoring_case(meant.entry->text, symbol.name()) ? "" : ", or name the symbol")};
      fault.related = (chosen.by->pointer / key).text();
      fault.related_message = "the other entry";
      faults_.add(std::move(fault));
    }
  }

  link::MapRow row_of(std::uint32_t index) {
    const Symbol& symbol = plant_.symbols[index];
    Chosen<std::uint32_t> number{link::MapRow::kDefault};
    Chosen<link::WordOrder> word_order{link::WordOrder::as_link};
    Chosen<link::OnLoss> on_loss{link::OnLoss::as_link};
    Chosen<std::string> node;
    for (Meant& meant : meant_) {
      if (!matches(meant, symbol)) continue;
      ++meant.matched;
      meant.loss_acts = meant.loss_acts || symbol.direction == tables::Direction::operation;
      meant.order_acts = meant.order_acts || data_type_bits(symbol.type) > 16;
      choose(number, number_for(meant, symbol), meant, "number", symbol);
      choose(word_order, meant.entry->word_order, meant, "word-order", symbol);
      choose(on_loss, meant.entry->on_loss, meant, "on-loss", symbol);
      choose(node, meant.entry->node, meant, "node", symbol);
    }
    if (number.by != nullptr) check_end(number, symbol);
    if (number.by != nullptr && number.by->entry->by == description::MapEntry::By::symbol)
      own_.emplace(index, number.by);
    const std::string_view text = node.by == nullptr ? std::string_view() : *node.by->entry->node;
    return {index, number.value, word_order.value, on_loss.value, false, text};
  }

  void check_end(const Chosen<std::uint32_t>& number, const Symbol& symbol) {
    constexpr std::uint64_t kAddresses = 65'536;
    const auto width = static_cast<std::uint64_t>(std::max(1, data_type_bits(symbol.type) / 16));
    if (number.value + width <= kAddresses) return;
    const description::Pointer at = number.by->pointer / "number";
    if (!reported_.try_emplace(at.text() + " end", true).second) return;
    faults_.add(at, description::ticked(symbol.name()) +
                        " would end after 65535, the last address of Modbus; give a lower number");
  }

  /// Gives all symbols of one address the number that an entry gives one of them by name.
  void join_addresses(std::vector<link::MapRow>& rows) {
    // leader -> number, and the symbol that gave it
    std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> numbers;
    const auto leader = [&](std::uint32_t i) {
      return plant_.symbols[i].leader == kNone ? i : plant_.symbols[i].leader;
    };
    for (const link::MapRow& row : rows) {
      const auto own = own_.find(row.symbol);
      if (own == own_.end()) continue;
      const auto [found, added] = numbers.try_emplace(leader(row.symbol), row.number, row.symbol);
      if (added || found->second.first == row.number) continue;
      faults_.add(own->second->pointer / "number",
                  description::ticked(plant_.symbols[row.symbol].name()) + " has the same address as " +
                      description::ticked(plant_.symbols[found->second.second].name()) +
                      ", which has another `number`; give both the same");
    }
    if (numbers.empty()) return;
    for (link::MapRow& row : rows) {
      const auto found = numbers.find(leader(row.symbol));
      if (found != numbers.end()) row.number = found->second.first;
    }
  }

  const PlantModel& plant_;
  const std::uint32_t controller_;
  const description::LinkDescription& link_;
  description::Faults& faults_;
  std::string pointer_;
  std::vector<std::uint32_t> symbols_;  ///< of the controller
  text::ByName<std::uint32_t> by_name_;
  std::vector<Meant> meant_;
  std::unordered_map<std::uint32_t, const Meant*> own_;  ///< symbols to which an entry gives a number by name
  std::unordered_map<std::string, bool> reported_;
};

/// Whether a list of the controller has a MELSEC address: then its PLC has the low word first.
bool is_mitsubishis(const PlantModel& plant, std::uint32_t controller) {
  return std::any_of(plant.symbols.begin(), plant.symbols.end(), [&](const Symbol& symbol) {
    const std::string_view address = symbol.row->vendor_address;
    return !address.empty() && address.front() != '%' && plant.controller_of(symbol) == controller &&
           plant.lists[symbol.list].table->notation == address::Notation::melsec;
  });
}

/// Marks the symbols that the link does not carry. A pattern is of names or addresses.
void exclude_symbols(const PlantModel& plant, std::uint32_t controller, const description::LinkDescription& link,
                     ControllerLink& result, description::Faults& faults) {
  const auto index = static_cast<std::size_t>(&link - plant.description->links.data());
  const description::Pointer here = description::Pointer("/links") / index / "exclude";
  std::vector<std::uint32_t> excluded;
  for (std::size_t i = 0; i < link.exclude.size(); ++i) {
    const std::string& pattern = link.exclude[i];
    const auto matches = [&](std::string_view text) { return !text.empty() && text::matches_pattern(text, pattern); };
    const std::size_t before = excluded.size();
    for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
      const Symbol& symbol = plant.symbols[s];
      if (plant.controller_of(symbol) != controller) continue;
      if (matches(symbol.name()) || matches(symbol.row->vendor_address) || matches(symbol.row->iec_address)) {
        excluded.push_back(s);
      }
    }
    if (excluded.size() != before) continue;
    faults.warn(here / i, description::ticked(pattern) + " matches no symbol of the link by name or address",
                description::FaultKind::matches_nothing);
  }
  std::sort(excluded.begin(), excluded.end());
  excluded.erase(std::unique(excluded.begin(), excluded.end()), excluded.end());
  if (std::binary_search(excluded.begin(), excluded.end(), result.link.clock.symbol)) {
    faults.add(here, "the clock of the link, " + description::ticked(plant.symbols[result.link.clock.symbol].name()) +
                         ", is excluded; make the pattern narrower");
  }
  std::vector<link::MapRow> rows;
  auto next = result.rows.begin();
  for (const std::uint32_t symbol : excluded) {
    while (next != result.rows.end() && next->symbol < symbol) rows.push_back(*next++);
    const bool is_set = next != result.rows.end() && next->symbol == symbol;
    rows.push_back(is_set ? *next++ : link::MapRow{.symbol = symbol});
    rows.back().excluded = true;
  }
  rows.insert(rows.end(), next, result.rows.end());
  result.rows = std::move(rows);
}

}  // namespace

void resolve_links(PlantModel& plant, const std::vector<const description::LinkDescription*>& links,
                   description::Faults& faults) {
  plant.links.resize(plant.controllers.size());
  for (std::uint32_t c = 0; c < plant.links.size(); ++c) {
    ControllerLink& result = plant.links[c];
    if (links[c] != nullptr) result.link = links[c]->settings;
    const bool low = is_mitsubishis(plant, c);
    result.link.word_order = low ? link::WordOrder::low_first : link::WordOrder::high_first;
    if (links[c] == nullptr) continue;
    result.link.word_order = links[c]->word_order.value_or(result.link.word_order);
    result.link.word_order_given = links[c]->word_order.has_value();
    result.link.clock.symbol = resolve_clock(plant, c, *links[c], faults);
    result.keep.assign(links[c]->keep.begin(), links[c]->keep.end());
    if (!links[c]->map.empty()) LinkResolver(plant, c, *links[c], faults).run(result);
    exclude_symbols(plant, c, *links[c], result, faults);
  }
}

}  // namespace symplant::model

// What the description says about single symbols: which are inverted, and which follow a condition.
#include "model/symbol_settings.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "model/described_devices.hpp"
#include "model/symbol_names.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::Pointer;
using description::ticked;

bool is_bit(const Symbol& symbol) { return symbol.type == tables::DataType::boolean; }

/// Calls `take(symbol)` for each BOOL symbol that a name or a pattern means; reports those that mean none.
template <class Take>
void for_each_bit(PlantModel& plant, const SymbolNames& names, const std::vector<std::string>& texts,
                  std::string_view key, description::Faults& faults, const Take& take) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Pointer here = Pointer(std::string(key)) / i;
    if (!text::is_pattern(texts[i])) {
      const std::uint32_t symbol = names.find(texts[i], here, faults);
      if (symbol == kNone) continue;
      if (is_bit(plant.symbols[symbol])) {
        take(plant.symbols[symbol]);
      } else {
        faults.add(here,
                   ticked(texts[i]) + " is a number; only BOOL symbols can be in `" + std::string(key.substr(1)) + "`");
      }
      continue;
    }
    bool any = false;
    for (Symbol& symbol : plant.symbols) {
      if (!is_bit(symbol) || !text::matches_pattern(symbol.name(), texts[i])) continue;
      take(symbol);
      any = true;
    }
    if (!any) faults.warn(here, ticked(texts[i]) + " matches no BOOL symbol", FaultKind::matches_nothing);
  }
}

/// An entry of `follow` or `signals`: the symbols that it means, and what they follow.
struct Entry {
  std::string_view symbol;  ///< a name, or a pattern
  std::string_view text;
  std::string_view off = {};  ///< of a switch with hysteresis
};

/// What the two elements differ in.
struct EntryKind {
  std::string_view key;  ///< "/follow"
  bool (*may)(const Symbol&);
  std::string_view may_not;  ///< what follows the name of a symbol that may not
  std::string_view nothing;  ///< what follows a pattern that matches nothing
  std::string_view what;     ///< "conditions"
};

constexpr EntryKind kFollow{
    "/follow", [](const Symbol& symbol) { return is_bit(symbol) && symbol.direction == tables::Direction::event; },
    " is not a BOOL input of the PLC; only those follow a condition", " matches no BOOL input of the PLC",
    "conditions"};
constexpr EntryKind kSignals{
    "/signals", [](const Symbol& symbol) { return !is_bit(symbol) && symbol.direction == tables::Direction::event; },
    " is not a numeric input of the PLC; a BOOL input that depends on a value has `follow`",
    " matches no numeric input of the PLC", "formulas"};

/// Entries by index: exact names first, then patterns, the most specific first.
std::vector<std::uint32_t> by_specificity(const std::vector<Entry>& entries) {
  std::vector<std::uint32_t> order(entries.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::uint32_t i) {
    return text::is_pattern(entries[i].symbol) ? text::literal_characters(entries[i].symbol) : std::string::npos;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return rank(a) > rank(b); });
  return order;
}

/// Finds the entry of each symbol.
class PatternMatcher {
 public:
  PatternMatcher(const PlantModel& plant, const SymbolNames& names, const EntryKind& kind, std::vector<Entry> entries,
                 description::Faults& faults)
      : plant_(plant),
        names_(names),
        kind_(kind),
        given_(std::move(entries)),
        faults_(faults),
        entries_(plant.symbols.size(), kNone) {}

  /// By symbol: its entry, or kNone.
  std::vector<std::uint32_t> run() {
    for (const std::uint32_t entry : by_specificity(given_)) {
      if (text::is_pattern(given_[entry].symbol)) {
        match(entry);
      } else {
        assign_exact(entry);
      }
    }
    return std::move(entries_);
  }

 private:
  Pointer key_of(std::uint32_t entry) const { return Pointer(std::string(kind_.key)) / given_[entry].symbol; }

  void assign_exact(std::uint32_t entry) {
    const std::string_view name = given_[entry].symbol;
    const std::uint32_t symbol = names_.find(std::string(name), key_of(entry), faults_);
    if (symbol == kNone) return;
    if (!kind_.may(plant_.symbols[symbol])) {
      faults_.add(key_of(entry), ticked(name) + std::string(kind_.may_not));
    } else if (entries_[symbol] != kNone) {
      faults_.add(key_of(entry), ticked(name) + " appears twice; remove one");
    } else {
      entries_[symbol] = entry;
    }
  }

  void match(std::uint32_t entry) {
    const std::string_view pattern = given_[entry].symbol;
    const std::size_t literals = text::literal_characters(pattern);
    bool any = false;
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (!kind_.may(plant_.symbols[i]) || !text::matches_pattern(plant_.symbols[i].name(), pattern)) continue;
      any = true;
      if (entries_[i] == kNone) {
        entries_[i] = entry;
        continue;
      }
      const Entry& other = given_[entries_[i]];
      const bool equal = text::is_pattern(other.symbol) && text::literal_characters(other.symbol) == literals;
      const bool differs = other.text != given_[entry].text || other.off != given_[entry].off;
      if (equal && differs) contradiction(i, entry);
    }
    if (!any) faults_.warn(key_of(entry), ticked(pattern) + std::string(kind_.nothing), FaultKind::matches_nothing);
  }

  void contradiction(std::uint32_t symbol, std::uint32_t entry) {
    description::DescriptionFault fault{
        key_of(entry).text(), ticked(given_[entry].symbol) + " and " + ticked(given_[entries_[symbol]].symbol) +
                                  " are equally specific and give " + ticked(plant_.symbols[symbol].name()) +
                                  " different " + std::string(kind_.what) +
                                  "; make one more specific or name the symbol"};
    fault.kind = FaultKind::patterns;
    fault.at_key = true;
    fault.related = key_of(entries_[symbol]).text();
    fault.related_message = "the other " + std::string(kind_.what).substr(0, kind_.what.size() - 1);
    faults_.add(std::move(fault));
  }

  const PlantModel& plant_;
  const SymbolNames& names_;
  const EntryKind& kind_;
  const std::vector<Entry> given_;
  description::Faults& faults_;
  std::vector<std::uint32_t> entries_;  ///< by symbol
};

void match_follows(PlantModel& plant, const std::vector<description::GivenFollow>& given, const SymbolNames& names,
                   description::Faults& faults) {
  std::vector<Entry> entries;
  entries.reserve(given.size());
  for (const description::GivenFollow& follow : given) {
    entries.push_back({follow.symbol, follow.condition, follow.off});
  }
  const std::vector<std::uint32_t> found = PatternMatcher(plant, names, kFollow, std::move(entries), faults).run();
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    if (found[i] == kNone) continue;
    plant.symbols[i].account = Account::follows;
    plant.follows.push_back({i, {}, {}, found[i]});
  }
}

void match_signals(PlantModel& plant, const std::vector<description::GivenSignal>& given, const SymbolNames& names,
                   description::Faults& faults) {
  std::vector<Entry> entries;
  entries.reserve(given.size());
  for (const description::GivenSignal& signal : given) entries.push_back({signal.symbol, signal.of});
  const std::vector<std::uint32_t> found = PatternMatcher(plant, names, kSignals, std::move(entries), faults).run();
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    if (found[i] == kNone) continue;
    plant.symbols[i].account = Account::shows_value;
    Signal signal;
    signal.row.symbol = i;
    signal.given = found[i];
    plant.signals.push_back(std::move(signal));
  }
}

void add_followed(const condition::Tree& tree, const std::vector<std::uint32_t>& index_of,
                  std::vector<std::uint32_t>& followed) {
  if (tree.kind == condition::Tree::Kind::atom && tree.atom.kind == condition::Atom::Kind::bit &&
      index_of[tree.atom.of] != kNone) {
    followed.push_back(index_of[tree.atom.of]);
  }
  for (const condition::Tree& child : tree.children) add_followed(child, index_of, followed);
}

}  // namespace

description::Pointer follow_pointer(const PlantModel& plant, std::uint32_t given) {
  return Pointer("/follow") / std::string_view(plant.description->follow[given].symbol);
}

void apply_symbol_settings(PlantModel& plant, const description::Description& description,
                           description::Faults& faults) {
  if (description.inverted.empty() && description.follow.empty() && description.signals.empty() &&
      description.plain.empty() &&
      std::none_of(description.devices.begin(), description.devices.end(),
                   [](const description::DeviceDescription& device) { return device.names_symbols(); })) {
    return;
  }
  const SymbolNames names(plant);
  for_each_bit(plant, names, description.inverted, "/inverted", faults, [](Symbol& symbol) { symbol.inverted = true; });
  for_each_bit(plant, names, description.plain, "/plain", faults,
               [](Symbol& symbol) { symbol.account = Account::plain; });
  match_follows(plant, description.follow, names, faults);
  match_signals(plant, description.signals, names, faults);
  claim_symbols(plant, description, names, faults);
}

/// Removes, again and again, the entries that no remaining entry reads: what is left is in a cycle or read by one.
void check_follow_cycles(const PlantModel& plant, description::Faults& faults) {
  std::vector<std::uint32_t> index_of(plant.symbols.size(), kNone);
  for (std::uint32_t i = 0; i < plant.follows.size(); ++i) index_of[plant.follows[i].symbol] = i;
  std::vector<std::vector<std::uint32_t>> reads(plant.follows.size());
  std::vector<std::uint32_t> readers(plant.follows.size());
  for (std::uint32_t i = 0; i < plant.follows.size(); ++i) {
    add_followed(plant.follows[i].condition, index_of, reads[i]);
    if (plant.follows[i].off) add_followed(*plant.follows[i].off, index_of, reads[i]);
    for (const std::uint32_t other : reads[i]) ++readers[other];
  }
  std::vector<std::uint32_t> unread;
  for (std::uint32_t i = 0; i < readers.size(); ++i) {
    if (readers[i] == 0) unread.push_back(i);
  }
  std::size_t removed = 0;
  for (; removed < unread.size(); ++removed) {
    for (const std::uint32_t other : reads[unread[removed]]) {
      if (--readers[other] == 0) unread.push_back(other);
    }
  }
  if (removed == plant.follows.size()) return;
  // Follow any remaining reader backwards: after as many steps as there are entries it is in a cycle.
  std::uint32_t entry = 0;
  while (readers[entry] == 0) ++entry;
  std::vector<std::uint32_t> reader_of(plant.follows.size(), kNone);
  for (std::uint32_t i = 0; i < reads.size(); ++i) {
    if (readers[i] == 0) continue;
    for (const std::uint32_t other : reads[i]) reader_of[other] = i;
  }
  for (std::size_t i = 0; i < plant.follows.size(); ++i) entry = reader_of[entry];
  const auto name_of = [&](std::uint32_t each) { return ticked(plant.symbols[plant.follows[each].symbol].name()); };
  std::string cycle;
  std::vector<std::uint32_t> readers_before;  // from the entry backwards
  for (std::uint32_t next = reader_of[entry]; next != entry; next = reader_of[next]) readers_before.push_back(next);
  for (auto next = readers_before.rbegin(); next != readers_before.rend(); ++next) {
    cycle.append(" follows ").append(name_of(*next));
  }
  faults.add(follow_pointer(plant, plant.follows[entry].given), name_of(entry) + " follows itself: " + name_of(entry) +
                                                                    cycle + " follows " + name_of(entry) +
                                                                    "; remove one of the conditions");
}

}  // namespace symplant::model

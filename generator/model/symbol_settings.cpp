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

bool is_pattern(std::string_view name) { return name.find_first_of("*?") != std::string_view::npos; }
bool is_bit(const Symbol& symbol) { return symbol.type == tables::DataType::boolean; }

/// Calls `take(symbol)` for each BOOL symbol that a name or a pattern means; reports those that mean none.
template <class Take>
void for_each_bit(PlantModel& plant, const SymbolNames& names, const std::vector<std::string>& texts,
                  std::string_view key, description::Faults& faults, const Take& take) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Pointer here = Pointer(std::string(key)) / i;
    if (!is_pattern(texts[i])) {
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

/// The entries of `follow`: exact names first, then patterns, the most specific first.
std::vector<std::uint32_t> by_specificity(const std::vector<description::GivenFollow>& follow) {
  std::vector<std::uint32_t> order(follow.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::uint32_t i) {
    return is_pattern(follow[i].symbol) ? text::literal_characters(follow[i].symbol) : std::string::npos;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return rank(a) > rank(b); });
  return order;
}

class FollowMatcher {
 public:
  FollowMatcher(PlantModel& plant, const SymbolNames& names, const std::vector<description::GivenFollow>& given,
                description::Faults& faults)
      : plant_(plant), names_(names), given_(given), faults_(faults), entries_(plant.symbols.size(), kNone) {}

  void run() {
    for (const std::uint32_t entry : by_specificity(given_)) {
      const Pointer here = follow_key(entry);
      if (is_pattern(given_[entry].symbol)) {
        match(entry, here);
      } else {
        assign_exact(entry, here);
      }
    }
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i] == kNone) continue;
      plant_.symbols[i].account = Account::follows;
      plant_.follows.push_back({i, {}, entries_[i]});
    }
  }

 private:
  Pointer follow_key(std::uint32_t entry) const { return Pointer("/follow") / std::string_view(given_[entry].symbol); }

  static bool may_follow(const Symbol& symbol) {
    return is_bit(symbol) && symbol.direction == tables::Direction::event;
  }

  void assign_exact(std::uint32_t entry, const Pointer& here) {
    const std::uint32_t symbol = names_.find(given_[entry].symbol, here, faults_);
    if (symbol == kNone) return;
    if (!may_follow(plant_.symbols[symbol])) {
      faults_.add(here,
                  ticked(given_[entry].symbol) + " is not a BOOL input of the PLC; only those follow a condition");
    } else if (entries_[symbol] != kNone) {
      faults_.add(here, ticked(given_[entry].symbol) + " appears twice; remove one");
    } else {
      entries_[symbol] = entry;
    }
  }

  void match(std::uint32_t entry, const Pointer& here) {
    const std::string& pattern = given_[entry].symbol;
    const std::size_t literals = text::literal_characters(pattern);
    bool any = false;
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (!may_follow(plant_.symbols[i]) || !text::matches_pattern(plant_.symbols[i].name(), pattern)) continue;
      any = true;
      if (entries_[i] == kNone) {
        entries_[i] = entry;
        continue;
      }
      const description::GivenFollow& other = given_[entries_[i]];
      const bool equal = is_pattern(other.symbol) && text::literal_characters(other.symbol) == literals;
      if (equal && other.condition != given_[entry].condition) contradiction(i, entry, here);
    }
    if (!any) faults_.warn(here, ticked(pattern) + " matches no BOOL input of the PLC", FaultKind::matches_nothing);
  }

  void contradiction(std::uint32_t symbol, std::uint32_t entry, const Pointer& here) {
    description::DescriptionFault fault{
        here.text(), ticked(given_[entry].symbol) + " and " + ticked(given_[entries_[symbol]].symbol) +
                         " are equally specific and give " + ticked(plant_.symbols[symbol].name()) +
                         " different conditions; make one more specific or name the symbol"};
    fault.kind = FaultKind::patterns;
    fault.at_key = true;
    fault.related = follow_key(entries_[symbol]).text();
    fault.related_message = "the other condition";
    faults_.add(std::move(fault));
  }

  PlantModel& plant_;
  const SymbolNames& names_;
  const std::vector<description::GivenFollow>& given_;
  description::Faults& faults_;
  std::vector<std::uint32_t> entries_;  ///< by symbol: the entry that gives its condition
};

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
  if (description.inverted.empty() && description.follow.empty() && description.plain.empty() &&
      std::none_of(description.devices.begin(), description.devices.end(),
                   [](const description::DeviceDescription& device) { return device.names_symbols(); })) {
    return;
  }
  const SymbolNames names(plant);
  for_each_bit(plant, names, description.inverted, "/inverted", faults, [](Symbol& symbol) { symbol.inverted = true; });
  for_each_bit(plant, names, description.plain, "/plain", faults,
               [](Symbol& symbol) { symbol.account = Account::plain; });
  FollowMatcher(plant, names, description.follow, faults).run();
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

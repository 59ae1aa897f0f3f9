// Pairs the symbols of two plants in stages: each stage compares the rows that the stages before it left over.
#include "diff/symbols.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "address/address.hpp"
#include "base/index_table.hpp"
#include "diff/fields.hpp"
#include "text/ascii.hpp"

namespace symplant::diff {
namespace {

/// A row of either plant.
struct Candidate {
  const read::ListRow* row;
  RowRef at;
  std::string_view controller;
  std::string_view scope;
  std::optional<address::Address> address;  ///< read for rows that names do not pair
};

using Rest = std::vector<std::uint32_t>;  ///< indexes of candidates, ascending

std::size_t mixed(std::size_t hash, std::size_t more) { return (hash ^ more) * 0x9E37'79B9'7F4A'7C15U; }
std::size_t hash_of(std::string_view text) { return std::hash<std::string_view>{}(text); }

/// A stage: what rows of a pair have in common.
struct Key {
  std::size_t (*hash)(const Candidate&);
  bool (*same)(const Candidate&, const Candidate&);
  bool single;  ///< only if no other row of its plant has the same
};

std::size_t hash_of_name(const Candidate& c) { return mixed(hash_of(c.row->name), hash_of(c.scope)); }
bool same_name(const Candidate& a, const Candidate& b) {
  return a.row->name == b.row->name && a.controller == b.controller;
}

constexpr Key kNameAndAddress{
    [](const Candidate& c) { return mixed(hash_of_name(c), hash_of(written_address(*c.row))); },
    [](const Candidate& a, const Candidate& b) {
      return same_name(a, b) && a.scope == b.scope && written_address(*a.row) == written_address(*b.row);
    },
    false};
constexpr Key kScopeAndName{
    hash_of_name, [](const Candidate& a, const Candidate& b) { return same_name(a, b) && a.scope == b.scope; }, false};
constexpr Key kName{[](const Candidate& c) { return hash_of(c.row->name); }, same_name, false};

std::size_t hash_of_address(const Candidate& c) {
  return mixed(static_cast<std::size_t>(c.address->number) * 3 + static_cast<std::size_t>(c.address->area),
               hash_of(c.controller));
}
bool same_place(const Candidate& a, const Candidate& b) {
  return a.controller == b.controller && address::same_location(*a.address, *b.address);
}
bool same_meaning(const Candidate& a, const Candidate& b) {
  return a.row->comment == b.row->comment && same_type(a.row->type, b.row->type);
}

constexpr Key kAddressAndMeaning{
    [](const Candidate& c) { return mixed(hash_of_address(c), hash_of(c.row->comment)); },
    [](const Candidate& a, const Candidate& b) { return same_place(a, b) && same_meaning(a, b); }, true};
constexpr Key kAddress{hash_of_address, same_place, true};
constexpr Key kMeaning{
    [](const Candidate& c) { return mixed(hash_of(c.row->comment), hash_of(c.controller)); },
    [](const Candidate& a, const Candidate& b) { return a.controller == b.controller && same_meaning(a, b); }, true};

/// Old candidates of one key: a queue through `Stage::next`.
struct Queue {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t olds = 1;
  std::uint32_t news = 0;
};

class Pairer {
 public:
  Pairer(const model::PlantModel& before, const model::PlantModel& after)
      : before_(before),
        after_(after),
        controllers_count_(before.controllers.size() > 1 && after.controllers.size() > 1) {
    result_.rows[0] = add(before, old_, result_.after);
    result_.rows[1] = add(after, new_, result_.before);
    next_.assign(all_.size(), kNone);
  }

  SymbolPairs run() {
    pair(kNameAndAddress, old_, new_);
    pair(kScopeAndName, old_, new_);
    pair(kName, old_, new_);
    Rest old_addressed;
    Rest new_addressed;
    split(before_, old_, old_addressed);
    split(after_, new_, new_addressed);
    pair(kAddressAndMeaning, old_addressed, new_addressed);
    pair(kAddress, old_addressed, new_addressed);
    pair(kMeaning, old_, new_);
    return std::move(result_);
  }

 private:
  std::size_t add(const model::PlantModel& plant, Rest& rest, std::vector<std::vector<RowRef>>& partners) {
    for (std::uint32_t l = 0; l < plant.lists.size(); ++l) {
      const read::SymbolTable& table = *plant.lists[l].table;
      partners.emplace_back(table.rows.size());
      all_.reserve(all_.size() + table.rows.size());
      for (std::uint32_t r = 0; r < table.rows.size(); ++r) {
        const read::ListRow& row = table.rows[r];
        if (row.name.empty()) continue;
        rest.push_back(static_cast<std::uint32_t>(all_.size()));
        const std::string_view controller =
            controllers_count_ ? std::string_view(plant.controllers[plant.lists[l].controller]) : std::string_view();
        all_.push_back({&row, {l, r}, controller, table.extra_of(row).scope, std::nullopt});
      }
    }
    return rest.size();
  }

  /// Moves the candidates with a known location to `addressed`. `rest` keeps those without an address that have a
  /// comment.
  void split(const model::PlantModel& plant, Rest& rest, Rest& addressed) {
    Rest kept;
    for (const std::uint32_t i : rest) {
      Candidate& c = all_[i];
      c.address = address_of(plant, c.at);
      if (c.address && c.address->assigned) {
        addressed.push_back(i);
      } else if (!c.row->comment.empty() && (c.address || written_address(*c.row).empty())) {
        kept.push_back(i);
      }
    }
    rest = std::move(kept);
  }

  /// Pairs by a key, and removes the paired ones from both rests. O(rests).
  void pair(const Key& key, Rest& old_rest, Rest& new_rest) {
    if (old_rest.empty() || new_rest.empty()) return;
    base::IndexTable index(old_rest.size());
    std::vector<Queue> queues;
    queues.reserve(old_rest.size());
    for (const std::uint32_t i : old_rest) {
      next_[i] = kNone;
      const auto made = static_cast<std::uint32_t>(queues.size());
      const std::uint32_t found = index.find_or_add(
          key.hash(all_[i]), made, [&](std::uint32_t q) { return key.same(all_[queues[q].first], all_[i]); });
      if (found == made) {
        queues.push_back({i, i});
      } else {
        next_[queues[found].last] = i;
        queues[found].last = i;
        ++queues[found].olds;
      }
    }
    const std::vector<std::uint32_t> queue_of = queues_of(key, new_rest, index, queues);
    take(key, new_rest, queue_of, queues);
    std::erase_if(old_rest, [&](std::uint32_t i) { return result_.after_of(all_[i].at).exists(); });
    std::erase_if(new_rest, [&](std::uint32_t i) { return partner(i).exists(); });
  }

  std::vector<std::uint32_t> queues_of(const Key& key, const Rest& rest, const base::IndexTable& index,
                                       std::vector<Queue>& queues) const {
    std::vector<std::uint32_t> of;
    of.reserve(rest.size());
    for (const std::uint32_t i : rest) {
      of.push_back(
          index.find(key.hash(all_[i]), [&](std::uint32_t q) { return key.same(all_[queues[q].first], all_[i]); }));
      if (of.back() != base::IndexTable::kNothing) ++queues[of.back()].news;
    }
    return of;
  }

  void take(const Key& key, const Rest& rest, const std::vector<std::uint32_t>& queue_of, std::vector<Queue>& queues) {
    for (std::size_t n = 0; n < rest.size(); ++n) {
      if (queue_of[n] == base::IndexTable::kNothing) continue;
      Queue& queue = queues[queue_of[n]];
      if (queue.first == kNone || (key.single && (queue.olds > 1 || queue.news > 1))) continue;
      const RowRef old = all_[queue.first].at;
      const RowRef now = all_[rest[n]].at;
      result_.after[old.list][old.row] = now;
      result_.before[now.list][now.row] = old;
      queue.first = next_[queue.first];
    }
  }

  const RowRef& partner(std::uint32_t i) const { return result_.before[all_[i].at.list][all_[i].at.row]; }

  const model::PlantModel& before_;
  const model::PlantModel& after_;
  const bool controllers_count_;
  std::vector<Candidate> all_;  ///< the old ones first
  std::vector<std::uint32_t> next_;
  Rest old_;
  Rest new_;
  SymbolPairs result_;
};

/// Calls `use(at)` for every row with a name.
template <class Use>
void for_each_row(const model::PlantModel& plant, Use use) {
  for (std::uint32_t l = 0; l < plant.lists.size(); ++l) {
    const auto& rows = plant.lists[l].table->rows;
    for (std::uint32_t r = 0; r < rows.size(); ++r) {
      if (!rows[r].name.empty()) use(RowRef{l, r});
    }
  }
}

}  // namespace

SymbolPairs pair_symbols(const model::PlantModel& before, const model::PlantModel& after) {
  return Pairer(before, after).run();
}

std::vector<SymbolChange> symbol_changes(const model::PlantModel& before, const model::PlantModel& after,
                                         const SymbolPairs& pairs) {
  std::vector<SymbolChange> changes;
  for_each_row(after, [&](const RowRef& now) {
    const RowRef& old = pairs.before[now.list][now.row];
    if (!old.exists()) return changes.push_back({{}, now, {}});
    const Fields fields = differing_fields(before, old, after, now);
    if (!fields.empty()) changes.push_back({old, now, fields});
  });
  for_each_row(before, [&](const RowRef& old) {
    if (!pairs.after_of(old).exists()) changes.push_back({old, {}, {}});
  });
  return changes;
}

}  // namespace symplant::diff

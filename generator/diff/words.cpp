// A difference in words, for the formats that people read.
#include "diff/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "diff/fields.hpp"

namespace symplant::diff {
namespace {

constexpr std::size_t kExamples = 3;
constexpr std::size_t kMostItems = 6;  ///< of one device

/// Both addresses of a row, if it has two: either may have changed.
std::string addresses(const read::ListRow& row) {
  const bool both = !row.vendor_address.empty() && !row.iec_address.empty();
  return std::string(row.vendor_address) + (both ? " " : "") + std::string(row.iec_address);
}

Piece quoted(std::string_view text) { return {std::string(text), true}; }
Piece plain(std::string text) { return {std::move(text), false}; }
void append(Words& words, Words more) {
  words.insert(words.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// `state `P3` (`O_P3, I_P3`) gained`, `initial state `P1` -> `P2``.
Words item_words(const ItemChange& item) {
  Words words{plain(item.element)};
  const auto add_value = [&](const std::string& value) { words.push_back(value.empty() ? plain("-") : quoted(value)); };
  if (!item.key.empty()) append(words, {plain(" "), quoted(item.key)});
  if (item.before && item.after) {
    words.push_back(plain(item.key.empty() ? " " : ": "));
    add_value(*item.before);
    words.push_back(plain(" -> "));
    add_value(*item.after);
    return words;
  }
  const std::string& value = item.before ? *item.before : *item.after;
  if (!value.empty()) append(words, {plain(" ("), quoted(value), plain(")")});
  words.push_back(plain(item.before ? " lost" : " gained"));
  return words;
}

Words items_words(const std::vector<ItemChange>& items) {
  Words words;
  std::size_t shown = 0;
  std::size_t follow = 0;
  std::size_t more = 0;
  for (const ItemChange& item : items) {
    if (item.follows) {
      ++follow;
    } else if (shown == kMostItems) {
      ++more;
    } else {
      if (shown++ != 0) words.push_back(plain("; "));
      append(words, item_words(item));
    }
  }
  if (more != 0) words.push_back(plain(fmt::format("; {} more", more)));
  if (follow != 0)
    words.push_back(plain(follow == 1 ? "; 1 change follows" : fmt::format("; {} changes follow", follow)));
  return words;
}

class Reporter {
 public:
  Reporter(const Comparison& comparison, std::size_t most, bool all)
      : before_(comparison.before),
        after_(comparison.after),
        difference_(comparison.difference),
        most_(most),
        all_(all) {
    report_.head = {quoted(comparison.before_name), plain(sizes(difference_.rows[0], before_) + " -> "),
                    quoted(comparison.after_name), plain(sizes(difference_.rows[1], after_))};
  }

  Report take() {
    add_symbols();
    add_devices();
    add_plant();
    append_summary(model_text());
    report_.summary = std::move(summary_);
    return std::move(report_);
  }

 private:
  using Rows = std::function<std::vector<Words>(std::size_t change)>;
  using Example = std::function<Words(std::size_t change)>;

  static std::string sizes(std::size_t rows, const model::PlantModel& plant) {
    return fmt::format(" ({}, {})", counted(rows, "symbol"), counted(plant.units.size(), "device"));
  }

  void append_summary(const std::string& text) { summary_.append(summary_.empty() ? "" : ", ").append(text); }

  const SymbolChange& change_at(std::size_t i) const { return difference_.symbols[i]; }
  const read::ListRow& old_row(std::size_t i) const { return change_at(i).before.in(before_); }
  const read::ListRow& new_row(std::size_t i) const { return change_at(i).after.in(after_); }
  Words location(std::size_t i) const {
    const bool removed = change_at(i).removed();
    const RowRef& at = removed ? change_at(i).before : change_at(i).after;
    const model::PlantModel& plant = removed ? before_ : after_;
    return {quoted(fmt::format("{}:{}", plant.lists[at.list].name(), at.in(plant).line))};
  }

  /// Adds a section of the changes for which `belongs` holds. `kinds` are the causes that are about them.
  template <class Belongs>
  void add(const std::string& noun, const std::string& verb, std::size_t changes, Belongs belongs,
           const std::vector<Cause>& causes, std::initializer_list<Cause::Kind> kinds, std::vector<std::string> columns,
           const Rows& row, const Example& example) {
    Section section;
    std::vector<bool> covered(changes);
    for (const Cause& cause : causes) {
      if (std::find(kinds.begin(), kinds.end(), cause.kind) == kinds.end()) continue;
      section.causes.push_back(cause_words(cause, noun, example));
      for (const std::uint32_t member : cause.members) covered[member] = true;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < changes; ++i) {
      if (!belongs(i)) continue;
      ++count;
      if (covered[i] && !all_) continue;
      if (section.rows.size() < most_) {
        section.rows.push_back(row(i));
      } else {
        ++section.more;
      }
    }
    if (count == 0) return;
    section.title = counted(count, noun) + " " + verb;
    section.columns = std::move(columns);
    append_summary(section.title);
    report_.sections.push_back(std::move(section));
  }

  Words cause_words(const Cause& cause, const std::string& noun, const Example& example) const {
    const std::string count = counted(cause.members.size(), noun);
    Words words;
    switch (cause.kind) {
      case Cause::Kind::added:
      case Cause::Kind::removed:
        words = {plain(count + " of "), quoted(cause.kind == Cause::Kind::added ? cause.after : cause.before)};
        break;
      case Cause::Kind::replaced:
      case Cause::Kind::retyped:
        words = {quoted(cause.before), plain(" -> "), quoted(cause.after), plain(" in " + count)};
        break;
      case Cause::Kind::shifted:
        words = {plain(fmt::format("{}, {}: {}", cause.before, cause.after, count))};
        break;
      case Cause::Kind::modelled:
        words = items_words(difference_.devices[cause.members.front()].items);
        words.push_back(plain(" in " + count));
        break;
    }
    for (std::size_t n = 0; n < kExamples && n < cause.members.size(); ++n) {
      words.push_back(plain(n == 0 ? ", such as " : ", "));
      append(words, example(cause.members[n]));
    }
    return words;
  }

  void add_symbols() {
    const auto& causes = difference_.symbol_causes;
    const std::size_t n = difference_.symbols.size();
    const auto changed = [&](Field field) {
      return [this, field](std::size_t i) { return change_at(i).fields.has(field); };
    };
    const auto cell = [](std::string_view text) { return Words{quoted(text)}; };
    const auto whole_row = [&](std::size_t i) {
      const read::ListRow& row = change_at(i).removed() ? old_row(i) : new_row(i);
      return std::vector<Words>{cell(row.name), cell(written_address(row)), cell(row.type), location(i)};
    };
    const Example name = [&](std::size_t i) { return cell((change_at(i).removed() ? old_row(i) : new_row(i)).name); };
    const std::vector<std::string> whole{"symbol", "address", "type", "row"};
    add(
        "symbol", "added", n, [&](std::size_t i) { return change_at(i).added(); }, causes, {Cause::Kind::added}, whole,
        whole_row, name);
    add(
        "symbol", "removed", n, [&](std::size_t i) { return change_at(i).removed(); }, causes, {Cause::Kind::removed},
        whole, whole_row, name);
    add(
        "symbol", "renamed", n, changed(Field::name), causes, {Cause::Kind::replaced},
        {"before", "after", "address", "row"},
        [&](std::size_t i) {
          return std::vector<Words>{cell(old_row(i).name), cell(new_row(i).name), cell(written_address(new_row(i))),
                                    location(i)};
        },
        [&](std::size_t i) {
          return Words{quoted(old_row(i).name), plain(" -> "), quoted(new_row(i).name)};
        });
    const std::vector<std::string> columns{"symbol", "before", "after", "row"};
    const auto add_field = [&](const std::string& verb, Field field, std::initializer_list<Cause::Kind> kinds,
                               std::string (*of)(const read::ListRow&)) {
      const auto row = [&, of](std::size_t i) {
        return std::vector<Words>{cell(new_row(i).name), cell(of(old_row(i))), cell(of(new_row(i))), location(i)};
      };
      const auto example = [&, of](std::size_t i) {
        return Words{quoted(new_row(i).name), plain(" ("), quoted(of(old_row(i))), plain(" -> "),
                     quoted(of(new_row(i))),  plain(")")};
      };
      add("symbol", verb, n, changed(field), causes, kinds, columns, row, example);
    };
    add_field("moved", Field::address, {Cause::Kind::shifted}, &addresses);
    add_field("retyped", Field::type, {Cause::Kind::retyped},
              [](const read::ListRow& row) { return std::string(row.type); });
    add_field("with another initial value", Field::initial, {},
              [](const read::ListRow& row) { return std::string(row.initial); });
    add_count(Field::comment, "comment", "changed");
    add_count(Field::other, "symbol", "changed in other columns");
  }

  /// Comments, and what only some formats have, are counted.
  void add_count(Field field, std::string_view noun, std::string_view verb) {
    std::size_t count = 0;
    for (const SymbolChange& change : difference_.symbols) count += change.fields.has(field) ? 1U : 0U;
    if (count == 0) return;
    append_summary(counted(count, noun) + " " + std::string(verb));
  }

  std::string_view path(std::size_t i) const {
    const DeviceChange& change = difference_.devices[i];
    return change.removed() ? before_.units[change.before].path : after_.units[change.after].path;
  }

  /// `3 symbols, 2 states`.
  Words device_size(std::size_t i) const {
    const DeviceChange& change = difference_.devices[i];
    const model::Unit& unit = change.removed() ? before_.units[change.before] : after_.units[change.after];
    return {plain(counted(unit.operations.size() + unit.events.size(), "symbol") + ", " +
                  counted(unit.states.size(), "state"))};
  }

  void add_devices() {
    const auto& causes = difference_.device_causes;
    const auto& devices = difference_.devices;
    const auto sized = [&](std::size_t i) { return std::vector<Words>{{quoted(path(i))}, device_size(i)}; };
    const Example name = [&](std::size_t i) { return Words{quoted(path(i))}; };
    add(
        "device", "added", devices.size(), [&](std::size_t i) { return devices[i].added(); }, causes,
        {Cause::Kind::added}, {"device", "model"}, sized, name);
    add(
        "device", "removed", devices.size(), [&](std::size_t i) { return devices[i].removed(); }, causes,
        {Cause::Kind::removed}, {"device", "model"}, sized, name);
    const auto old_path = [&](std::size_t i) { return quoted(before_.units[devices[i].before].path); };
    add(
        "device", "renamed", devices.size(), [&](std::size_t i) { return devices[i].renamed; }, causes,
        {Cause::Kind::replaced}, {"before", "after"},
        [&](std::size_t i) {
          return std::vector<Words>{{old_path(i)}, {quoted(path(i))}};
        },
        [&](std::size_t i) {
          return Words{old_path(i), plain(" -> "), quoted(path(i))};
        });
    add(
        "device", "with another model", devices.size(), [&](std::size_t i) { return !devices[i].items.empty(); },
        causes, {Cause::Kind::modelled}, {"device", "changes"},
        [&](std::size_t i) {
          return std::vector<Words>{{quoted(path(i))}, items_words(devices[i].items)};
        },
        name);
  }

  void add_plant() {
    const auto& items = difference_.plant;
    add(
        "part", "of the plant changed", items.size(), [](std::size_t) { return true; }, {}, {}, {"change"},
        [&](std::size_t i) { return std::vector<Words>{item_words(items[i])}; }, {});
  }

  std::string model_text() const {
    if (!difference_.same_model) return "model hashes not compared, because of errors";
    if (*difference_.same_model) return summary_.empty() ? "no difference" : "equal model hashes";
    return summary_.empty() ? "different model hashes: the order of rows, or the spelling of addresses"
                            : "different model hashes";
  }

  const model::PlantModel& before_;
  const model::PlantModel& after_;
  const Difference& difference_;
  const std::size_t most_;
  const bool all_;
  Report report_;
  std::string summary_;
};

}  // namespace

Report report_of(const Comparison& comparison, std::size_t most, bool all) {
  return Reporter(comparison, most, all).take();
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace symplant::diff

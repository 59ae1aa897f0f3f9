// Spreads keys at random, then fixes what does not resolve to the wanted result.
#include "property/files/spread.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace symplant::property::files {
namespace {

using nlohmann::json;

class Spreader {
 public:
  Spreader(const std::vector<Wish>& wishes, const Style& style, Counts& counts)
      : wishes_(wishes), style_(style), sayer_(style, "entries", counts), dice_(sayer_.dice), counts_(counts) {}

  std::vector<Entry> spread() {
    for (const Wish& wish : wishes_) entries_.push_back({sayer_.name(wish.path), {}});
    const bool patterns = style_.patterns && dice_.percent(80);
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      for (const auto& [key, value] : wishes_[i].keys) {
        if (!patterns || dice_.percent(40) || !by_pattern(i, key, value)) entries_[i].keys[key] = value;
      }
    }
    if (patterns) decoys();
    fix();
    count();
    drop_empty();
    return std::move(entries_);
  }

 private:
  /// The entry of the pattern, perhaps a new one.
  Entry& entry_of(const std::string& pattern) {
    for (std::size_t i = wishes_.size(); i < entries_.size(); ++i) {
      if (same(entries_[i].name, pattern)) return entries_[i];
    }
    entries_.push_back({pattern, {}});
    return entries_.back();
  }
  static bool same(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
  }

  Entry& some_pattern(const std::string& path) {
    if (dice_.percent(25)) return entry_of("L?" + path.substr(2));  // and its copies on other lines
    std::vector<std::size_t> fitting;
    for (std::size_t i = wishes_.size(); i < entries_.size(); ++i) {
      if (fits(path, entries_[i].name)) fitting.push_back(i);
    }
    if (!fitting.empty() && dice_.percent(60)) return entries_[dice_.pick(fitting)];
    for (;;) {
      const std::string pattern = sayer_.name(random_pattern(dice_, path));
      if (pattern.find_first_of("*?") != pattern.npos) return entry_of(pattern);
    }
  }

  bool by_pattern(std::size_t device, const std::string& key, const json& value) {
    Entry& entry = some_pattern(wishes_[device].path);
    const auto there = entry.keys.find(key);
    if (there == entry.keys.end()) {
      entry.keys[key] = dice_.percent(70) ? braced(value, key, device, entry.name) : value;
      return true;
    }
    json taken = there->second;
    leave_out(taken, wishes_[device], key, entry.name);
    if (same_meaning(key, taken, value)) return true;
    // Two devices with nothing in common may share an array: each ignores what it lacks.
    if (!value.is_structured() || key == "states" || key == "inputs" || dice_.percent(10)) return false;
    const json before = there->second;
    for (int tries = 0; tries < 3; ++tries) {
      const json further = dice_.percent(90) ? braced(value, key, device, entry.name) : value;
      if (value.is_array()) {
        for (const json& each : further) there->second.push_back(each);
      } else {
        there->second.update(further);
      }
      if (same_meaning(key, resolve(entries_, wishes_[device], key).value, value)) return true;
      entry.keys[key] = before;
    }
    return false;
  }

  /// The value with braces that every device that the pattern matches can read as names.
  json braced(json value, const std::string& key, std::size_t device, const std::string& pattern) {
    edit_texts(value, key, [&](const std::string& text) {
      const std::string made = with_braces(dice_, text, brace_names(wishes_[device].path, pattern));
      const bool reads = std::all_of(wishes_.begin(), wishes_.end(), [&](const Wish& wish) {
        return !fits(wish.path, pattern) || stays_a_condition(made, brace_names(wish.path, pattern));
      });
      return reads ? made : text;
    });
    return value;
  }

  /// Another value that the same device could have.
  json another(const std::string& key, json value) {
    if (value.is_array() && value.size() > 1 && dice_.percent(50)) {
      std::reverse(value.begin(), value.end());
    } else if (key == "transitions") {
      value[0]["takes"] = "17 ms";
    } else if (value.is_structured()) {
      value.erase(value.begin());
    } else if (value.is_boolean()) {
      value = !value.get<bool>();
    } else if (key == "actuation") {
      value = value == "held" ? "bistable" : "held";
    } else if (key == "sequence") {
      value = value == "cycle" ? "neighbours" : "cycle";
    } else if (key == "overrun") {
      value = "19 ms";
    } else if (key == "type" || key == "behaviour") {
      value = "Other";
    }
    return value;
  }

  /// Entries without effect, or with the same value again.
  void decoys() {
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      for (const auto& [key, value] : wishes_[i].keys) {
        if (!dice_.percent(30)) continue;
        Entry& entry = some_pattern(wishes_[i].path);
        if (!entry.keys.contains(key)) entry.keys[key] = dice_.percent(40) ? value : another(key, value);
      }
    }
    if (dice_.percent(10)) entry_of("NOBODY_*").keys["initial"] = "NOWHERE";
  }

  void fix() {
    std::set<std::string> keys;
    for (const Entry& entry : entries_) {
      for (const auto& [key, value] : entry.keys) keys.insert(key);
    }
    for (bool fixed = true; fixed;) {
      fixed = false;
      for (std::size_t i = 0; i < wishes_.size(); ++i) {
        for (const std::string& key : keys) fixed = fix(i, key) || fixed;
      }
      for (const std::string& key : keys) {
        for (std::size_t i = wishes_.size(); !fixed && i < entries_.size(); ++i) fixed = drop_idle(i, key);
      }
    }
  }

  bool fix(std::size_t device, const std::string& key) {
    const Wish& wish = wishes_[device];
    const auto wanted = wish.keys.find(key);
    const Resolved found = resolve(entries_, wish, key);
    if (found.clash) {
      for (std::size_t i = entries_.size(); i-- > wishes_.size();) {
        if (fits(wish.path, entries_[i].name) && entries_[i].keys.erase(key) > 0) return true;
      }
    }
    if (same_meaning(key, found.value, wanted == wish.keys.end() ? json() : wanted->second)) return false;
    if (wanted != wish.keys.end()) {
      entries_[device].keys[key] = wanted->second;
    } else if (!neutral(key).is_null()) {
      entries_[device].keys[key] = neutral(key);
    } else {
      entries_[*found.entry].keys.erase(key);
    }
    return true;
  }

  /// A part that every device with the key from this pattern lacks is an error.
  bool drop_idle(std::size_t pattern, const std::string& key) {
    const auto said = entries_[pattern].keys.find(key);
    if (said == entries_[pattern].keys.end()) return false;
    std::vector<const Wish*> takers;       // devices with the key from it, or from an entry with the same value
    std::vector<const Wish*> sure_takers;  // devices with it from no other entry
    for (const Wish& wish : wishes_) {
      const Resolved found = resolve(entries_, wish, key);
      if (!found.best.contains(pattern)) continue;
      takers.push_back(&wish);
      if (found.best.size() == 1) sure_takers.push_back(&wish);
    }
    const auto idle = [&](const json& value) {
      const auto lacks = [&](const Wish* wish) {
        json copy = value;
        return leave_out(copy, *wish, key, entries_[pattern].name).parts > 0;
      };
      return std::any_of(takers.begin(), takers.end(), lacks) &&
             std::all_of(sure_takers.begin(), sure_takers.end(), lacks);
    };
    json kept = said->second;
    if (kept.is_array()) {
      kept = json::array();
      for (const json& each : said->second) {
        if (!idle(json::array({each}))) kept.push_back(each);
      }
    } else if (kept.is_object()) {
      kept = json::object();
      for (const auto& member : said->second.items()) {
        if (!idle({{member.key(), member.value()}})) kept[member.key()] = member.value();
      }
    } else if (idle(kept)) {
      entries_[pattern].keys.erase(key);
      return true;
    }
    if (kept == said->second) return false;
    said->second = kept;
    return true;
  }

  void count() {
    std::map<std::pair<std::size_t, std::string>, int> winners;
    for (const Wish& wish : wishes_) {
      std::set<std::string> keys;
      for (const Entry& entry : entries_) {
        for (const auto& [key, value] : entry.keys) keys.insert(key);
      }
      for (const std::string& key : keys) {
        const Resolved found = resolve(entries_, wish, key);
        if (!found.entry) continue;
        counts_[Seen::lost] += found.beaten - found.agreeing > 0 ? 1 : 0;
        counts_[Seen::agreeing] += found.agreeing;
        if (entries_[*found.entry].exact()) continue;
        ++counts_[Seen::won];
        counts_[Seen::left_out] += found.left_out.parts;
        counts_[Seen::made_left_out] += found.left_out.made;
        const bool braces = entries_[*found.entry].keys.at(key) != made(entries_[*found.entry], wish, key);
        if (braces) ++counts_[Seen::braces];
        if (++winners[{*found.entry, key}] != 2) continue;
        ++counts_[Seen::shared];
        if (braces) ++counts_[Seen::shared_braces];
      }
    }
  }

  void drop_empty() {
    std::erase_if(entries_,
                  [&](const Entry& entry) { return entry.keys.empty() && !(style_.decorated && dice_.percent(2)); });
  }

  const std::vector<Wish>& wishes_;
  const Style& style_;
  Sayer sayer_;
  Dice& dice_;
  Counts& counts_;
  std::vector<Entry> entries_;  ///< one for each device, in the order of wishes_, then patterns
};

}  // namespace

std::vector<Entry> spread(const std::vector<Wish>& wishes, const Style& style, Counts& counts) {
  return Spreader(wishes, style, counts).spread();
}

}  // namespace symplant::property::files

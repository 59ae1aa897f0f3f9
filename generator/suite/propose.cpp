// Proposes cases for a suite.
#include "suite/propose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "suite/state_pairs.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/trace_lines.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::suite {
namespace {

namespace fs = std::filesystem;
using TraceJson = nlohmann::json;

constexpr std::size_t kPrime = 7919;
constexpr tables::Time kPress = 500 * tables::kMillisecond;

/// Reads what a scenario did, and when the operations of programs changed.
class BaseReader {
 public:
  BaseReader(const trace::PlantNames& names, BaseRun& base) : base_(base) {
    for (std::uint32_t symbol = 0; symbol < names.tables().symbols.size(); ++symbol) {
      if (names.is_operation(symbol)) operations_.insert(names.symbol(symbol));
    }
  }

  void read(std::istream& trace) {
    trace::TraceLines lines(trace);
    for (TraceJson json; lines.next(json);) {
      if (lines.is_header()) {
        header(json);
      } else if (json.contains("act")) {
        act(json, lines.time());
      } else if (json.contains("symbol")) {
        change(json, lines.time());
      }
    }
    changes_.push_back(base_.end);
    find_phases();
  }

 private:
  void header(const TraceJson& json) {
    if (!json.contains("programs")) return;
    for (const TraceJson& program : json["programs"]) {
      for (const TraceJson& symbol : program["writes"]) written_.insert(symbol.get<std::string>());
    }
  }

  void act(const TraceJson& json, tables::Time time) {
    const std::string members = json["act"].dump();
    base_.acts.push_back({time, members.substr(1, members.size() - 2)});
  }

  void change(const TraceJson& json, tables::Time time) {
    const std::string name = json["symbol"];
    if (!operations_.contains(name)) {
      if (json["value"].is_boolean()) base_.toggles[name].push_back(time);
      return;
    }
    if (!written_.contains(name)) {
      base_.acts.push_back({time, fmt::format("\"set\":{{{}:{}}}", trace::json_string(name), json["value"].dump())});
    }
    if (changes_.empty() || changes_.back() != time) {
      changes_.push_back(time);
      patterns_.push_back(on_);
    }
    json["value"].is_boolean() && json["value"].get<bool>() ? static_cast<void>(on_.insert(name))
                                                            : static_cast<void>(on_.erase(name));
    patterns_.back() = on_;
  }

  /// A phase is a pattern of operations that are on; it is represented by the middle of the first span of time with it.
  void find_phases() {
    std::set<std::set<std::string>> seen;
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      const tables::Time middle =
          std::midpoint(changes_[i], changes_[i + 1]) / tables::kMillisecond * tables::kMillisecond;
      if (middle > changes_[i] && seen.insert(patterns_[i]).second) base_.phases.push_back(middle);
    }
  }

  BaseRun& base_;
  std::unordered_set<std::string_view> operations_;
  std::unordered_set<std::string> written_;
  std::set<std::string> on_;
  std::vector<tables::Time> changes_;            ///< of operations; the end of the run is the last
  std::vector<std::set<std::string>> patterns_;  ///< what is on from each change on
};

/// A name of a file.
std::string file_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (plain) {
      name += c;
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  return name;
}

class Proposer {
 public:
  Proposer(const BaseRun& base, std::string name, const tables::PlantTables& tables)
      : base_(base), base_name_(std::move(name)), tables_(tables), names_(tables), use_(tables) {}

  std::vector<Proposal> run(bool with_program) {
    presses();
    if (with_program) restarts();
    states();
    malfunctions();
    return std::move(proposals_);
  }

 private:
  void presses() {
    for (std::uint32_t symbol = 0; symbol < tables_.symbols.size(); ++symbol) {
      const tables::SymbolRow& row = tables_.symbols[symbol];
      if (names_.is_operation(symbol) || row.type() != tables::DataType::boolean) continue;
      if (use_.driver(symbol).kind != why::SymbolDriver::Kind::none) continue;
      const std::string name(names_.symbol(symbol));
      const auto set = [&](bool on) { return fmt::format("\"set\":{{{}:{}}}", trace::json_string(name), on); };
      each_phase([&](std::size_t phase, tables::Time time) {
        const bool on = is_on(name, time);
        add(Proposal::Kind::press, fmt::format("press {} in phase {}", name, phase),
            {{time, set(!on)}, {time + kPress, set(on)}});
      });
    }
  }

  /// What an input has in the base case.
  bool is_on(const std::string& event, tables::Time time) const {
    const auto found = base_.toggles.find(event);
    if (found == base_.toggles.end()) return false;
    return (std::upper_bound(found->second.begin(), found->second.end(), time) - found->second.begin()) % 2 != 0;
  }

  void restarts() {
    each_phase([&](std::size_t phase, tables::Time time) {
      add(Proposal::Kind::restart, fmt::format("restart in phase {}", phase), {{time, "\"restart\":true"}});
    });
  }

  void states() {
    for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) {
      for (std::uint8_t state = 0; state < tables_.types[tables_.units[unit].type].states; ++state) {
        if (state == tables_.units[unit].initial) continue;
        const std::string device(names_.unit(unit));
        const std::string name(names_.state(unit, state));
        add(Proposal::Kind::state, fmt::format("start with {} in {}", device, name),
            {{0, fmt::format("\"state\":{{{}:{}}}", trace::json_string(device), trace::json_string(name))}});
      }
    }
  }

  void malfunctions() {
    const tables::MalfunctionNumbers numbers(tables_);
    const auto count = static_cast<std::uint32_t>(tables_.malfunctions.rows.size() + 2 * tables_.units.size() +
                                                  2 * tables_.symbols.size());
    for (std::uint32_t number = 0; number < count; ++number) {
      if (!numbers.exists(number)) continue;
      const std::string name = names_.malfunction(number);
      add(Proposal::Kind::malfunction, name, {{0, fmt::format("\"start\":{}", trace::json_string(name))}});
    }
  }

  template <class Do>
  void each_phase(Do act) {
    for (std::size_t i = 0; i < base_.phases.size(); ++i) act(i + 1, base_.phases[i]);
  }

  void add(Proposal::Kind kind, const std::string& words, std::vector<BaseRun::Act> acts) {
    std::string name = file_name(words);
    if (!taken_.insert(name).second) {
      name += fmt::format("-{}", proposals_.size());
      taken_.insert(name);
    }
    acts.insert(acts.begin(), base_.acts.begin(), base_.acts.end());
    std::stable_sort(acts.begin(), acts.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    std::string text = fmt::format("{{\n  \"symplant-scenario\": 1,\n  // Proposed from `{}`: {}.\n  \"steps\": [\n",
                                   base_name_, words);
    for (const BaseRun::Act& act : acts) {
      if (act.time <= base_.end) text += fmt::format("    {{ \"at\": \"{}ns\", {} }},\n", act.time, act.members);
    }
    text += fmt::format("    {{ \"at\": \"{}ns\" }}\n  ]\n}}\n", base_.end);
    proposals_.push_back({kind, std::move(name), words, std::move(text)});
  }

  const BaseRun& base_;
  const std::string base_name_;
  const tables::PlantTables& tables_;
  const trace::PlantNames names_;
  const why::SymbolUse use_;
  std::set<std::string> taken_;
  std::vector<Proposal> proposals_;
};

/// Runs a scenario with the files that are wanted. Returns the exit code.
int run_with(const Setup& setup, const host::PlantProgram& plant, host::RunOptions run, std::string& messages) {
  run.limit = setup.suite.limit;
  run.programs = setup.run.programs;
  run.clock = host::RunOptions::Clock::virtual_time;
  std::ostringstream out;
  std::ostringstream err;
  const int code = host::run(plant, run, out, err);
  messages = err.str();
  return code;
}

std::vector<std::uint64_t> pairs_in(const std::string& vcd, const tables::PlantTables& tables) {
  const trace::PlantNames names(tables);
  std::ifstream file(vcd, std::ios::binary);
  return state_pairs(file, names);
}

}  // namespace

bool run_base(const Setup& setup, const host::PlantProgram& plant, const std::string& scenario,
              const std::string& folder, BaseRun& base, std::string& error) {
  host::RunOptions run;
  run.scenario = scenario;
  run.trace = (fs::path(folder) / "base.jsonl").generic_string();
  run.vcd = (fs::path(folder) / "base.vcd").generic_string();
  run.stats = (fs::path(folder) / "base.json").generic_string();
  if (run_with(setup, plant, run, error) != host::kGood) return false;
  std::ifstream stats(run.stats);
  base.end = TraceJson::parse(stats).at("plant_time").get<tables::Time>();
  const trace::PlantNames names(plant.tables);
  std::ifstream trace(run.trace, std::ios::binary);
  BaseReader(names, base).read(trace);
  base.pairs = pairs_in(run.vcd, plant.tables);
  return true;
}

std::vector<Proposal> proposals_of(const BaseRun& base, const std::string& name, const tables::PlantTables& tables,
                                   bool with_program) {
  return Proposer(base, name, tables).run(with_program);
}

std::vector<Proposal> spread(std::vector<Proposal> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::map<Proposal::Kind, std::vector<std::size_t>> kinds;
  for (std::size_t i = 0; i < all.size(); ++i) kinds[all[i].kind].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  groups.reserve(kinds.size());
  for (auto& [kind, group] : kinds) groups.push_back(std::move(group));
  std::sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<std::size_t> kept;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::vector<std::size_t>& group = groups[g];
    const std::size_t share = std::min(group.size(), (most - kept.size()) / (groups.size() - g));
    for (std::size_t i = 0; i < share; ++i) {  // one of each span, at different places, as neighbors are alike
      const std::size_t begin = i * group.size() / share;
      const std::size_t width = (i + 1) * group.size() / share - begin;
      kept.push_back(group[begin + i * kPrime % width]);
    }
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Proposal> some;
  some.reserve(kept.size());
  for (const std::size_t i : kept) some.push_back(std::move(all[i]));
  return some;
}

std::vector<std::uint64_t> new_pairs(const Setup& setup, const host::PlantProgram& plant, const Proposal& proposal,
                                     const BaseRun& base, const std::string& folder) {
  host::RunOptions run;
  run.scenario = (fs::path(folder) / (proposal.name + ".json")).generic_string();
  run.vcd = (fs::path(folder) / (proposal.name + ".vcd")).generic_string();
  std::ofstream(run.scenario, std::ios::binary) << proposal.text;
  std::string messages;
  const int code = run_with(setup, plant, run, messages);
  std::vector<std::uint64_t> pairs;
  if (code == host::kGood || code == host::kFindings) {
    const std::vector<std::uint64_t> all = pairs_in(run.vcd, plant.tables);
    std::set_difference(all.begin(), all.end(), base.pairs.begin(), base.pairs.end(), std::back_inserter(pairs));
  }
  std::error_code ignored;
  fs::remove(run.scenario, ignored);
  fs::remove(run.vcd, ignored);
  return pairs;
}

std::vector<std::size_t> choose(const std::vector<std::vector<std::uint64_t>>& pairs, std::size_t most) {
  std::vector<std::size_t> chosen;
  std::vector<bool> taken(pairs.size(), false);
  std::unordered_set<std::uint64_t> seen;
  while (chosen.size() < std::min(most, pairs.size())) {
    std::size_t best = pairs.size();
    std::ptrdiff_t best_new = -1;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (taken[i] || std::ssize(pairs[i]) <= best_new) continue;
      const auto fresh =
          std::count_if(pairs[i].begin(), pairs[i].end(), [&](std::uint64_t pair) { return !seen.contains(pair); });
      if (fresh > best_new) {
        best = i;
        best_new = fresh;
      }
    }
    taken[best] = true;
    chosen.push_back(best);
    seen.insert(pairs[best].begin(), pairs[best].end());
  }
  return chosen;
}

}  // namespace symplant::suite

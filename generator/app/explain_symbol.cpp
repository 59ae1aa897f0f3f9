// Writes how the naming rule reads one symbol.
#include "app/explain_symbol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "diag/visible_text.hpp"
#include "name/symbol_reader.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"
#include "text/folding.hpp"
#include "view/words.hpp"

namespace symplant::app {
namespace {

using diag::visible;
using model::Symbol;

constexpr std::size_t kNearest = 3;

std::string pattern_text(const name::SymbolRule& rule, std::size_t pattern) {
  return pattern < rule.patterns.size() ? rule.patterns[pattern].pattern : "";
}

std::string end_text(const name::SymbolRule& rule, const name::RuleTrial& trial) {
  switch (trial.end) {
    case name::RuleTrial::End::reads:
      return "reads it";
    case name::RuleTrial::End::other_side:
      return fmt::format("is for {} only", *rule.side == name::Direction::operation ? "outputs" : "inputs");
    case name::RuleTrial::End::word_absent:
      return fmt::format("none of its words is there: {}", fmt::join(rule.has, ", "));
    case name::RuleTrial::End::pattern:
      break;
  }
  return rule.patterns.size() < 2 ? "the pattern does not match"
                                  : fmt::format("the pattern `{}` does not match", pattern_text(rule, trial.pattern));
}

std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text::folded(text) + " ") {
    const bool is_word = text::is_digit(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
    if (is_word) {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// The rule of a plant again, for a separate reader. A plant's rule has no faults.
std::shared_ptr<const name::CompiledNaming> compiled(const model::PlantModel& plant) {
  std::vector<name::NamingFault> faults;
  return name::CompiledNaming::compile(plant.naming(), faults);
}

class SymbolWriter {
 public:
  SymbolWriter(const model::PlantModel& plant, const Symbol& symbol)
      : plant_(plant), symbol_(symbol), reader_(compiled(plant)) {
    const read::SymbolTable& table = *plant.list_of(symbol).table;
    text_of_ = {symbol.name(), symbol.row->comment, table.extra_of(*symbol.row).parent_comment, {}};
    if (symbol.address) {
      text_of_.address =
          symbol.address->area == address::Area::output ? name::Direction::operation : name::Direction::event;
    }
  }

  std::string run() {
    head();
    rules();
    result();
    nearest();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }

  void head() {
    const std::string address =
        symbol_.written_address().empty() ? "no address" : std::string(symbol_.written_address());
    line("{}: {}, {}, row {} of {}", visible(symbol_.name()), visible(address),
         symbol_.direction == tables::Direction::operation ? "operation" : "event", symbol_.row->line,
         visible(plant_.list_of(symbol_).table->source->path()));
    line("  name as patterns see it: {}", visible(reader_.normal_text(text_of_, name::Source::name)));
    if (!symbol_.row->comment.empty())
      line("  comment as patterns see it: {}", visible(reader_.normal_text(text_of_, name::Source::comment)));
  }

  void rules() {
    const name::Naming& naming = reader_.naming().naming();
    line("rules of {}:", visible(plant_.rule_text()));
    if (symbol_.account == model::Account::ignored) return line("  a pattern of `ignore` matches it");
    const std::vector<name::RuleTrial> trials = reader_.trials(text_of_);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const name::SymbolRule& rule = naming.rules[i];
      line("  {:>3}  {}: {}", i + 1, visible(rule.name.empty() ? pattern_text(rule, 0) : rule.name),
           visible(end_text(rule, trials[i])));
    }
  }

  void result() {
    const name::DeviceLevels* const levels = symbol_.reading.levels();
    if (levels != nullptr) {
      line("read: device {}, task {}", visible(levels->path), visible(symbol_.reading.task()));
    }
    if (symbol_.unit == model::kNone || !plant_.is_linked(number())) {
      const model::Account account = plant_.pairing == nullptr ? symbol_.account : plant_.pairing->accounts[number()];
      line("not paired: {}", view::unmodelled_reason(account));
      return;
    }
    const model::Unit& unit = plant_.units[symbol_.unit];
    line("in the device {}, with:", visible(unit.path));
    for (const auto* side : {&unit.operations, &unit.events}) {
      for (const std::uint32_t other : *side) {
        if (&plant_.symbols[other] == &symbol_) continue;
        line("  {} {}", side == &unit.operations ? "operation" : "event    ", visible(plant_.symbols[other].name()));
      }
    }
  }

  std::uint32_t number() const { return static_cast<std::uint32_t>(&symbol_ - plant_.symbols.data()); }

  void nearest() {
    std::vector<std::pair<std::size_t, std::string_view>> found;
    const std::set<std::string> own = words_of(
        reader_.normal_text(text_of_, symbol_.row->is_named_by_address() ? name::Source::comment : name::Source::name));
    for (const Symbol& other : plant_.symbols) {
      if (other.direction == symbol_.direction || other.type != symbol_.type) continue;
      const name::SymbolText texts{other.name(), other.row->comment, {}, {}};
      const std::set<std::string> words = words_of(
          reader_.normal_text(texts, other.row->is_named_by_address() ? name::Source::comment : name::Source::name));
      const auto common = static_cast<std::size_t>(
          std::count_if(words.begin(), words.end(), [&](const std::string& word) { return own.contains(word); }));
      if (common != 0) found.emplace_back(common * 100 / std::max(own.size(), words.size()), other.name());
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    if (found.empty()) return;
    line("nearest of the other side:");
    for (std::size_t i = 0; i < std::min(found.size(), kNearest); ++i) {
      line("  {} ({} % of the words)", visible(found[i].second), found[i].first);
    }
  }

  const model::PlantModel& plant_;
  const Symbol& symbol_;
  name::SymbolReader reader_;
  name::SymbolText text_of_;
  std::string text_;
};

}  // namespace

std::optional<std::string> symbol_text(const model::PlantModel& plant, std::string_view name) {
  const auto found = std::find_if(plant.symbols.begin(), plant.symbols.end(),
                                  [&](const Symbol& symbol) { return text::equal_ignoring_case(symbol.name(), name); });
  if (found == plant.symbols.end()) return std::nullopt;
  return SymbolWriter(plant, *found).run();
}

std::string nearest_symbol(const model::PlantModel& plant, std::string_view name) {
  tables::NearestName nearest(name);
  for (const Symbol& symbol : plant.symbols) nearest.offer(symbol.name());
  return std::string(nearest.name());
}

}  // namespace symplant::app

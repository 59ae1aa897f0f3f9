// The series of a run and of the base case that its chart shows.
#include "campaign/chart.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "base/text_source.hpp"
#include "compare/words.hpp"
#include "diag/visible_text.hpp"
#include "view/json_writer.hpp"

namespace symplant::campaign {
namespace {

constexpr std::size_t kMostSeries = 12;
constexpr std::size_t kMostDifferences = 40;
constexpr std::size_t kMostChanges = 300;  ///< of a series

class Chart {
 public:
  Chart(const trace::PlantNames& names, base::TextSink& sink)
      : names_(names), json_(sink, view::JsonWriter::Form::compact) {}

  void write(const BaseCase& base, const RunLog& log, const compare::Comparison& comparison,
             const ChartChoice& choice) {
    from_ = comparison.differences.empty() ? 0 : comparison.differences.front().time;
    json_.begin_object();
    json_.key("series");
    json_.begin_array();
    for (const Shown& one : choice.shown()) {
      numbers_.emplace(name_of(one), numbers_.size());
      json_.begin_object();
      json_.member("name", diag::visible(name_of(one)));
      write_changes("base", one.is_output ? base.log.outputs : base.log.symbols, one);
      write_changes("run", one.is_output ? log.outputs : log.symbols, one);
      json_.end_object();
    }
    json_.end_array();
    json_.key("differences");
    json_.begin_array();
    std::size_t written = 0;
    for (const compare::Difference& difference : comparison.differences) {
      const auto found = numbers_.find(difference.of->name);
      if (found == numbers_.end() || ++written > kMostDifferences) continue;
      write_difference(difference, found->second);
    }
    json_.end_array();
    json_.member("end", log.end);
    json_.member("left_out", choice.left_out());
    json_.member("cut", cut_);
    json_.end_object();
    json_.finish();
  }

 private:
  std::string name_of(const Shown& of) const {
    return of.is_output ? names_.output(of.of) : std::string(names_.symbol(of.of));
  }

  /// All changes, or, if there are too many, the last one before `from_` and those that follow.
  void write_changes(std::string_view key, const std::vector<Change>& changes, const Shown& of) {
    std::vector<const Change*> own;
    for (const Change& change : changes) {
      if (change.of == of.of) own.push_back(&change);
    }
    auto first = own.begin();
    if (own.size() > kMostChanges) {
      first = std::find_if(own.begin(), own.end(), [&](const Change* change) { return change->time >= from_; });
      if (first != own.begin()) --first;
      if (own.end() - first > static_cast<std::ptrdiff_t>(kMostChanges)) own.erase(first + kMostChanges, own.end());
      cut_ = true;
    }
    json_.key(key);
    json_.begin_array();
    for (; first != own.end(); ++first) {
      const double value = of.is_output ? std::bit_cast<double>((*first)->value)
                                        : number_of(names_.tables().symbols[of.of], (*first)->value);
      json_.value((*first)->time);
      write_number(std::isfinite(value) ? value : 0);
    }
    json_.end_array();
  }

  void write_number(double value) {
    const bool whole = std::trunc(value) == value && std::abs(value) < 1e15;
    whole ? json_.value(static_cast<std::int64_t>(value)) : json_.value(value);
  }

  void write_difference(const compare::Difference& difference, std::size_t number) {
    const bool early = difference.kind == compare::Difference::Kind::early;
    const tables::Time begin = difference.time - (early ? difference.by : 0);
    json_.begin_object();
    json_.member("t", difference.time);
    json_.member("from", begin);
    json_.member("to", begin + difference.by);
    json_.member("of", number);
    json_.member("words", diag::visible(compare::difference_words(difference)));
    json_.end_object();
  }

  const trace::PlantNames& names_;
  view::JsonWriter json_;
  std::unordered_map<std::string, std::size_t> numbers_;  ///< of series, by name
  tables::Time from_ = 0;                                 ///< from where a series with too many changes is shown
  bool cut_ = false;                                      ///< one has too many
};

}  // namespace

void ChartChoice::add(const Shown& one) {
  if (std::find(shown_.begin(), shown_.end(), one) != shown_.end()) return;
  shown_.size() < kMostSeries ? shown_.push_back(one) : static_cast<void>(left_out_.insert({one.is_output, one.of}));
}

std::string chart_of(const BaseCase& base, const RunLog& log, const compare::Comparison& comparison,
                     const trace::PlantNames& names, const ChartChoice& choice) {
  return base::text_of([&](base::TextSink& sink) { Chart(names, sink).write(base, log, comparison, choice); });
}

}  // namespace symplant::campaign

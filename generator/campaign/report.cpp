// The results of a campaign for a terminal, spreadsheets and build servers.
#include "campaign/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "convert/cells.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/words.hpp"
#include "text/utf8.hpp"

namespace symplant::campaign {
namespace {

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, "; ")); }

/// Seconds as a number, for a cell; empty if there is no such time.
std::string cell_of(tables::Time time) { return time < 0 ? "" : fmt::format("{}", static_cast<double>(time) / 1e9); }

std::string short_text(const std::string& text, std::size_t most) {
  if (text::count_code_points(text) <= most) return text;
  return std::string(text::first_code_points(text, most - 3)) + "...";
}

}  // namespace

Overview overview_of(const Results& results) {
  Overview overview;
  std::vector<std::pair<int, std::size_t>> ranked;
  for (std::size_t number = 0; number < results.header().count; ++number) {
    if (!results.has(number)) {
      ++overview.missing;
      continue;
    }
    const Result result = results.read(number);
    ++overview.counts[static_cast<std::size_t>(result.is)];
    if (!result.ran) ++overview.not_run;
    ranked.emplace_back(rank(result.is), number);
  }
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [worst, number] : ranked) overview.numbers.push_back(number);
  return overview;
}

std::string summary(const Overview& overview) {
  std::vector<Class> classes;
  for (std::size_t i = 0; i < kClasses; ++i) classes.push_back(static_cast<Class>(i));
  std::sort(classes.begin(), classes.end(), [](Class a, Class b) { return rank(a) < rank(b); });
  std::string counts;
  for (const Class one : classes) {
    if (overview.count(one) == 0) continue;
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", overview.count(one), class_name(one));
  }
  const std::size_t all = overview.numbers.size() + overview.missing;
  std::string text = fmt::format("{} fault{}: {}", all, all == 1 ? "" : "s", counts.empty() ? "none" : counts);
  if (overview.not_run != 0) {
    text += fmt::format(" ({} not run: they hold what the base case shows)", overview.not_run);
  }
  if (overview.missing != 0) text += fmt::format("; {} without a result", overview.missing);
  return text;
}

bool fails(const Overview& overview, const Classes& fail_on) {
  if (overview.missing + overview.count(Class::error) != 0) return true;
  for (std::size_t i = 0; i < kClasses; ++i) {
    if (fail_on[i] && overview.counts[i] != 0) return true;
  }
  return false;
}

void write_table(const Results& results, const Overview& overview, std::size_t most, std::ostream& out) {
  std::vector<std::array<std::string, 4>> rows;
  std::array<std::size_t, kClasses> shown{};
  std::array<std::size_t, 3> widths{5, 5, 11};  // of the heads
  for (const std::size_t number : overview.numbers) {
    const Result result = results.read(number);
    if (result.is == Class::no_effect) break;
    std::size_t& of_class = shown[static_cast<std::size_t>(result.is)];
    if (++of_class > most) {
      if (of_class == most + 1) {
        rows.push_back({std::string(class_name(result.is)),
                        fmt::format("... and {} more", overview.count(result.is) - most), "", ""});
      }
      continue;
    }
    std::string fault = diag::visible(result.item + " " + result.mode);
    if (result.at != 0) fault += " at " + trace::seconds(result.at);
    rows.push_back({std::string(class_name(result.is)), short_text(fault, 60),
                    result.detection < 0 ? "-" : trace::seconds(result.detection),
                    short_text(diag::visible(result.reaction.substr(0, result.reaction.find("; "))), 70)});
    for (std::size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], rows.back()[c].size());
  }
  if (rows.empty()) return;
  out << fmt::format("{:{}}  {:{}}  {:{}}  reaction\n", "class", widths[0], "fault", widths[1], "alarm after",
                     widths[2]);
  for (const auto& row : rows) {
    std::string line =
        fmt::format("{:{}}  {:{}}  {:{}}  {}", row[0], widths[0], row[1], widths[1], row[2], widths[2], row[3]);
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << "\n";
  }
}

void write_csv(const Results& results, const Overview& overview, base::TextSink& sink) {
  base::PartCollector out(sink);
  out.add(
      "item,address and comment,failure mode,phase,from [s],class,seen first by the program,seen at [s],reaction,"
      "violated requirement,violated at [s],step of the base case that fails,alarms,alarm after [s],on at the end,"
      "severity,measure,remark,command\n");
  for (const std::size_t number : overview.numbers) {
    const Result result = results.read(number);
    const std::array<std::string, 19> cells{result.item,
                                            result.more,
                                            result.mode,
                                            result.phase,
                                            cell_of(result.at),
                                            std::string(class_name(result.is)),
                                            result.seen,
                                            cell_of(result.seen_at),
                                            result.reaction,
                                            result.requirement,
                                            cell_of(result.violated_at),
                                            result.failed_step,
                                            joined(result.alarms),
                                            cell_of(result.detection),
                                            result.on.empty() ? result.end : joined(result.on),
                                            "",
                                            "",
                                            "",
                                            result.command};
    std::string row;
    for (const std::string& cell : cells) {
      if (&cell != cells.data()) row += ',';
      convert::append_protected_cell(row, cell);
    }
    out.add(row + "\n");
  }
  out.finish();
}

std::string junit_text(const Results& results, const Overview& overview, const Classes& fail_on) {
  std::vector<trace::TestCase> cases;
  for (std::size_t number = 0; number < results.header().count; ++number) {
    if (!results.has(number)) continue;
    const Result result = results.read(number);
    const std::string words = fmt::format("{}: {}", class_name(result.is), result.reaction);
    const bool failed = fail_on[static_cast<std::size_t>(result.is)];
    trace::TestCase& one = cases.emplace_back();
    one.name = result.title();
    if (result.is == Class::error) {
      one.error = words;
    } else if (failed) {
      one.failure = fmt::format("{}\n{}", words, result.command);
    }
  }
  if (overview.missing != 0) {
    cases.push_back({"every fault has a result", 0, "", fmt::format("{} faults have none", overview.missing)});
  }
  return trace::junit_xml("campaign of " + results.header().of, cases, 0);
}

}  // namespace symplant::campaign

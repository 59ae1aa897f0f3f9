// Writes the report of symplant infer as text.
#include "app/infer_text.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "diag/visible_text.hpp"

namespace symplant::app {
namespace {

using diag::visible;

constexpr std::array<std::string_view, infer::kSuspicions> kSuspicionTexts{
    "an interlock of both sides", "a lamp and a button", "a completion before its request"};

std::string_view side_text(name::Direction side) { return side == name::Direction::operation ? "output" : "input"; }

std::string percent(double share) { return fmt::format("{:.0f} %", share * 100); }

std::string example(const std::string& operation, const std::string& event) {
  return operation.empty() ? visible(event) : visible(operation) + " -> " + visible(event);
}

/// Builds the report section by section.
class ReportWriter {
 public:
  ReportWriter(const infer::Report& report, const InferAnswers& answers) : report_(report), answers_(answers) {}

  std::string run() {
    correspondences();
    suspicious();
    questions();
    accounted();
    left_over();
    near_misses();
    shapes("names that contradict the direction of their address (the address decides):", report_.direction_conflicts);
    if (report_.names_do_not_link()) {
      line(fmt::format("{}, {} paired: names do not say what moves; describe the devices in plant.json",
                       counted(report_.operations, "output"), grouped(report_.operations_paired)));
    }
    return std::move(text_);
  }

 private:
  void line(std::string_view text) { text_.append(text).append("\n"); }

  void numbered(std::size_t index, std::string_view text, std::string_view mark) {
    line(fmt::format("{:>4}  {}{}", index + 1, text, mark));
  }

  void correspondences() {
    if (report_.correspondences.empty()) return;
    line("correspondences (--refuse N,.. leaves some out):");
    for (std::size_t i = 0; i < report_.correspondences.size(); ++i) {
      const infer::Correspondence& one = report_.correspondences[i];
      std::string mark;
      for (const std::size_t other : one.needed_by) {
        mark.append(mark.empty() ? "; needed by " : ", ").append(std::to_string(other + 1));
      }
      if (answers_.refused.contains(i)) mark += "; refused";
      numbered(i, correspondence_text(one), mark);
    }
  }

  void suspicious() {
    bool first = true;
    for (std::size_t i = 0; i < report_.correspondences.size(); ++i) {
      for (const infer::SuspiciousPairs& pairs : report_.correspondences[i].suspicious) {
        if (first) line("suspicious pairs in these correspondences:");
        first = false;
        numbered(i,
                 fmt::format("{}: {}, e.g. {}", kSuspicionTexts[static_cast<std::size_t>(pairs.why)],
                             counted(pairs.count, "pair"), example(pairs.operation, pairs.event)),
                 "");
      }
    }
  }

  void questions() {
    if (report_.questions.empty()) return;
    const bool interlocks = report_.questions.back().about_interlocks();
    const std::size_t contacts = report_.questions.size() - (interlocks ? 1 : 0);
    if (contacts != 0) line("are these inputs on in a healthy plant? (--accept N,.. makes them constant):");
    for (std::size_t i = 0; i < contacts; ++i) question(i);
    if (report_.more_questions != 0) line(fmt::format("      and {}", counted(report_.more_questions, "more shape")));
    if (!interlocks) return;
    line("interlocks with one text on both sides, which nothing drives (--accept N pairs them):");
    question(contacts);
  }

  void question(std::size_t i) {
    numbered(report_.correspondences.size() + i, question_text(report_.questions[i]),
             answers_.accepted.contains(i) ? "; accepted" : "");
  }

  void accounted() {
    std::string kinds;
    const auto add = [&](std::size_t count, std::string_view kind) {
      if (count != 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", grouped(count), kind);
    };
    add(report_.operator_panel, "of the operator");
    add(report_.constants, "constant");
    add(report_.data, "data");
    add(report_.interlocks, "interlock");
    if (!kinds.empty()) line("accounted for without a pair: " + kinds);
  }

  void left_over() {
    const std::size_t left = report_.score.counted() - report_.score.accounted();
    const std::string asked =
        report_.asked == 0 ? "" : fmt::format(", {} of them in questions", grouped(report_.asked));
    shapes(
        fmt::format("left over: {} of {} symbols{} ({} accounted for); the most frequent texts, # is a number:",
                    grouped(left), grouped(report_.score.counted()), asked, percent(report_.score.accounted_share())),
        report_.left_over);
  }

  void shapes(const std::string& title, const infer::Shapes& shapes) {
    if (shapes.shown.empty()) return;
    line(title);
    for (const infer::TextShape& shape : shapes.shown) {
      const std::string count = counted(shape.count, side_text(shape.side));
      line(fmt::format("  {:>12}  {}, e.g. {}", count, visible(shape.text), visible(shape.example)));
    }
    if (shapes.more_shapes != 0) {
      line(fmt::format("  and {} in {}", counted(shapes.more_symbols, "symbol"),
                       counted(shapes.more_shapes, "more shape")));
    }
  }

  void near_misses() {
    if (report_.near_misses.empty()) return;
    line("outputs without a pair, and the inputs that are closest to them:");
    for (const infer::NearMiss& miss : report_.near_misses) {
      std::string events;
      for (const std::string& event : miss.events) events.append(events.empty() ? "" : " | ").append(visible(event));
      const std::string alike = miss.alike == 1 ? "" : fmt::format(" ({} alike)", grouped(miss.alike));
      line(fmt::format("  {}{}: {}", visible(miss.operation), alike, events));
    }
  }

  const infer::Report& report_;
  const InferAnswers& answers_;
  std::string text_;
};

}  // namespace

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string counted(std::size_t number, std::string_view thing) {
  return fmt::format("{} {}{}", grouped(number), thing, number == 1 ? "" : "s");
}

std::string infer_lists_text(const model::PlantModel& plant) {
  std::vector<std::array<std::size_t, 2>> counts(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    ++counts[symbol.list][symbol.direction == tables::Direction::operation ? 0 : 1];
  }
  std::string text;
  for (std::size_t i = 0; i < plant.lists.size(); ++i) {
    const read::SymbolTable& table = *plant.lists[i].table;
    text +=
        fmt::format("{}: {}, {}, {} and {}\n", visible(table.source->path()), table.title,
                    counted(table.rows.size(), "row"), counted(counts[i][0], "output"), counted(counts[i][1], "input"));
  }
  return text;
}

std::string correspondence_text(const infer::Correspondence& one) {
  return fmt::format("{}, {} of {}, e.g. {}", visible(one.what), grouped(one.linked), grouped(one.candidates),
                     example(one.operation, one.event));
}

std::string question_text(const infer::Question& question) {
  if (question.about_interlocks()) {
    return fmt::format("{}, {}, e.g. {}", fmt::join(question.rule.has, ", "), counted(question.shape.count, "symbol"),
                       visible(question.shape.example));
  }
  return fmt::format("{}, {}, e.g. {}", visible(question.shape.text), counted(question.shape.count, "input"),
                     visible(question.shape.example));
}

std::string infer_report_text(const infer::Report& report, const InferAnswers& answers) {
  return ReportWriter(report, answers).run();
}

std::string infer_score_text(const name::Counts& score) {
  return fmt::format("paired {} ({} of {}), accounted {}", percent(score.paired_share()), grouped(score.paired()),
                     grouped(score.counted()), percent(score.accounted_share()));
}

}  // namespace symplant::app

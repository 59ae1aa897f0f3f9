// How two sessions differ, as rows and as text.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "compare/session.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::compare {
namespace {

using tables::Time;

constexpr const char* kNothing = "-";

std::string signed_number(std::int64_t number) { return fmt::format("{:+}", number); }

std::string signed_seconds(Time time) { return (time < 0 ? "-" : "+") + short_seconds(time < 0 ? -time : time); }

SessionRow row_of_times(std::string what, std::optional<Time> expert, std::optional<Time> trainee) {
  SessionRow row{std::move(what), kNothing, kNothing, "", ""};
  if (expert) row.expert = short_seconds(*expert);
  if (trainee) row.trainee = short_seconds(*trainee);
  if (!expert || !trainee) return row;
  row.difference = signed_seconds(*trainee - *expert);
  if (*expert > 0) row.ratio = fmt::format("{:.2f}", static_cast<double>(*trainee) / static_cast<double>(*expert));
  return row;
}

SessionRow row_of_counts(std::string what, std::size_t expert, std::size_t trainee) {
  return {std::move(what), std::to_string(expert), std::to_string(trainee),
          signed_number(static_cast<std::int64_t>(trainee) - static_cast<std::int64_t>(expert)), ""};
}

std::string score_words(const Session& of) {
  return of.exercise.empty() ? kNothing : fmt::format("{} of {}", of.score, of.most);
}

std::string time_words(const Session& of) { return short_seconds(of.end) + (of.is_over ? "" : ", not over"); }

void add_totals(SessionComparison& comparison) {
  const Session& expert = *comparison.expert;
  const Session& trainee = *comparison.trainee;
  const bool with_score = !expert.exercise.empty() && !trainee.exercise.empty();
  comparison.totals.push_back({"score", score_words(expert), score_words(trainee),
                               with_score ? signed_number(trainee.score - expert.score) : "", ""});
  SessionRow time = row_of_times("time", expert.end, trainee.end);
  time.expert = time_words(expert);
  time.trainee = time_words(trainee);
  comparison.totals.push_back(std::move(time));
  comparison.totals.push_back(row_of_counts("acts", expert.acts.size(), trainee.acts.size()));
  comparison.totals.push_back(row_of_counts("findings", expert.findings.size(), trainee.findings.size()));
}

/// Steps that act at once in both sessions take no time, and have no row.
void add_steps(SessionComparison& comparison) {
  const std::vector<Session::Step>& ours = comparison.expert->steps;
  const std::vector<Session::Step>& theirs = comparison.trainee->steps;
  const Session::Step none{"", "", std::nullopt, std::nullopt};
  for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
    const Session::Step& expert = i < ours.size() ? ours[i] : none;
    const Session::Step& trainee = i < theirs.size() ? theirs[i] : none;
    if (expert.took == Time{0} && trainee.took == Time{0} && expert.state != "failed" && trainee.state != "failed") {
      continue;
    }
    const std::string& words = i < ours.size() ? expert.words : trainee.words;
    SessionRow row = row_of_times(fmt::format("{}: {}", i + 1, words), expert.took, trainee.took);
    if (expert.state == "failed") row.expert += " (failed)";
    if (trainee.state == "failed") row.trainee += " (failed)";
    comparison.steps.push_back(std::move(row));
  }
}

/// The first malfunction of a name belongs to the first one of that name in the other session, and so on.
void add_reactions(SessionComparison& comparison) {
  std::map<std::string, std::vector<const Session::Reaction*>> theirs;
  for (const Session::Reaction& reaction : comparison.trainee->reactions) {
    theirs[reaction.malfunction].push_back(&reaction);
  }
  std::map<std::string, std::size_t> seen;
  for (const Session::Reaction& reaction : comparison.expert->reactions) {
    const std::vector<const Session::Reaction*>& same = theirs[reaction.malfunction];
    const std::size_t turn = seen[reaction.malfunction]++;
    comparison.reactions.push_back(
        row_of_times(reaction.malfunction, reaction.time, turn < same.size() ? same[turn]->time : std::nullopt));
  }
  for (const Session::Reaction& reaction : comparison.trainee->reactions) {
    if (seen[reaction.malfunction] == 0) {
      comparison.reactions.push_back(row_of_times(reaction.malfunction, std::nullopt, reaction.time));
    } else {
      --seen[reaction.malfunction];
    }
  }
}

/// The width of a text in a terminal, by characters.
std::size_t width_of(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

void put_cell(std::string& line, const std::string& text, std::size_t width) {
  line += text + std::string(width - std::min(width, width_of(text)) + 2, ' ');
}

void put_table(std::string& text, std::string_view head, const std::vector<SessionRow>& rows) {
  if (rows.empty()) return;
  std::vector<SessionRow> all{{std::string(head), "expert", "trainee", "difference", "ratio"}};
  all.insert(all.end(), rows.begin(), rows.end());
  std::size_t widths[4] = {};
  for (SessionRow& row : all) {
    row.what = diag::visible(row.what);
    const std::string* const cells[] = {&row.what, &row.expert, &row.trainee, &row.difference};
    for (std::size_t i = 0; i < 4; ++i) widths[i] = std::max(widths[i], width_of(*cells[i]));
  }
  for (const SessionRow& row : all) {
    std::string line;
    put_cell(line, row.what, widths[0]);
    put_cell(line, row.expert, widths[1]);
    put_cell(line, row.trainee, widths[2]);
    put_cell(line, row.difference, widths[3]);
    line += row.ratio;
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  text += "\n";
}

std::string title_line(std::string_view side, const Session& of) {
  std::string names;
  for (const std::string& name : of.names) names += (names.empty() ? " (" : ", ") + name;
  if (!names.empty()) names += ")";
  return diag::visible(
             fmt::format("{}: {}{}{}{}", side, of.file, names, of.exercise.empty() ? "" : ", ", of.exercise)) +
         "\n";
}

}  // namespace

std::string short_seconds(Time time) {
  constexpr Time kUnit = tables::kMillisecond;
  return trace::seconds((time + kUnit / 2) / kUnit * kUnit);
}

SessionComparison compare_sessions(const Session& expert, const Session& trainee) {
  SessionComparison comparison;
  comparison.expert = &expert;
  comparison.trainee = &trainee;
  if (expert.model_hash != trainee.model_hash) {
    comparison.error = fmt::format(
        "the sessions are of two plants: `{}` is of `{}` with the model hash {}, `{}` of `{}` with {}; compare "
        "sessions "
        "of one plant",
        expert.file, expert.plant, expert.model_hash, trainee.file, trainee.plant, trainee.model_hash);
    return comparison;
  }
  if (expert.exercise_name != trainee.exercise_name || expert.exercise != trainee.exercise ||
      expert.steps.size() != trainee.steps.size()) {
    const auto exercise = [](const Session& of) {
      return of.exercise.empty() ? "no exercise" : fmt::format("`{}` with {} steps", of.exercise, of.steps.size());
    };
    comparison.warning = fmt::format("the sessions are of different exercises: the expert's of {}, the trainee's of {}",
                                     exercise(expert), exercise(trainee));
  }
  add_totals(comparison);
  add_steps(comparison);
  add_reactions(comparison);
  return comparison;
}

std::string summary(const SessionComparison& comparison) {
  const auto side = [](const Session& of) {
    return short_seconds(of.end) + (of.exercise.empty() ? "" : fmt::format(" and {} points", of.score));
  };
  return fmt::format("expert {}, trainee {}", side(*comparison.expert), side(*comparison.trainee));
}

void write_text(const SessionComparison& comparison, base::TextSink& sink) {
  std::string text = title_line("expert ", *comparison.expert) + title_line("trainee", *comparison.trainee) + "\n";
  put_table(text, "", comparison.totals);
  put_table(text, "step", comparison.steps);
  put_table(text, "reaction to", comparison.reactions);
  text.pop_back();
  sink.put(text);
}

}  // namespace symplant::compare

// Two sessions at the panel: how an expert and a trainee did one exercise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_source.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::compare {

/// A file NAME.session.json of the panel. Times are plant times since the start of its exercise, or of its run without
/// one, in ns.
struct Session {
  struct Step {
    std::string words;  ///< its text, or else what it does
    std::string state;
    std::optional<tables::Time> at;    ///< when it was done
    std::optional<tables::Time> took;  ///< since the step before it was done
  };
  /// An act on the plant by hand, or a finding.
  struct Mark {
    tables::Time at;
    std::string words;
    std::string name = {};  ///< of the trainee; empty: not known
  };
  struct Reaction {
    std::string malfunction;
    std::optional<tables::Time> time;  ///< the first of its trainees
  };

  std::string file;
  std::string plant;
  std::string model_hash;
  std::vector<std::string> names;  ///< of the trainees that acted
  std::string exercise;            ///< its title; empty: the session has no exercise
  std::string exercise_name;
  bool is_over = false;
  tables::Time end = 0;
  std::int64_t score = 0;
  std::int64_t most = 0;
  std::vector<Step> steps;
  std::vector<Mark> acts;
  std::vector<Mark> findings;
  std::vector<Reaction> reactions;
};

struct ReadSession {
  Session session;
  std::string error;  ///< empty: it could be read
};

/// Whether a text begins as a session does. O(its first blanks).
bool is_session(std::string_view text);

/// Reads a session. Of its acts on the plant those in the exercise count, or without one those since the last reset, if
/// some have a name only these; what a restore took back does not count. O(text).
ReadSession read_session(std::string_view text, const std::string& file);

/// Whether an act changes the plant, and not only its clock, its malfunctions or the session.
bool is_on_plant(const nlohmann::json& act);
/// An act in words: "set X on, Y off".
std::string act_words(const nlohmann::json& act);

/// A line of the comparison: a number or a time of each side.
struct SessionRow {
  std::string what;
  std::string expert;  ///< `-`: unknown
  std::string trainee;
  std::string difference;  ///< of the trainee to the expert; empty: one of them is unknown
  std::string ratio;
};

/// How two sessions differ. The sessions must outlive it.
struct SessionComparison {
  const Session* expert = nullptr;
  const Session* trainee = nullptr;
  std::string error;    ///< they cannot be compared: they are of two plants
  std::string warning;  ///< they are of two exercises
  std::vector<SessionRow> totals;
  std::vector<SessionRow> steps;
  std::vector<SessionRow> reactions;
};

SessionComparison compare_sessions(const Session& expert, const Session& trainee);

/// The most acts, and the most findings, that the page shows of a session.
inline constexpr std::size_t kMostMarks = 2000;

/// "expert 41.2 s and 20 points, trainee 95 s and 12 points".
std::string summary(const SessionComparison& comparison);
/// The lines as a table.
void write_text(const SessionComparison& comparison, base::TextSink& sink);
/// The lines, and both sessions on one time axis: one page that needs no network and no script.
void write_html(const SessionComparison& comparison, base::TextSink& sink);

/// The chart of write_html(), as SVG.
std::string session_chart(const SessionComparison& comparison);
/// A time to the millisecond: "12.345 s".
std::string short_seconds(tables::Time time);

}  // namespace symplant::compare

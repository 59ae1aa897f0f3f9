// Reads the sessions that the panel writes.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "compare/session.hpp"

namespace symplant::compare {
namespace {

using Json = nlohmann::json;
using tables::Time;

constexpr std::string_view kMark = "\"symplant-session\"";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr Time kLatest = Time{1} << 60;  ///< 36 years; sums of two times fit

/// A time of a file. Throws if it is not one.
Time time_of(const Json& json) {
  if (!json.is_number_integer()) throw std::out_of_range("a time is not valid");
  const auto time = json.get<Time>();
  if (time < 0 || time > kLatest) throw std::out_of_range("a time is not valid");
  return time;
}

std::optional<Time> maybe_time(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(time_of(json));
}

/// Reads the members of a session; throws what nlohmann::json throws, or std::out_of_range.
class Reader {
 public:
  Reader(const Json& root, Session& session) : root_(root), session_(session) {}

  void read() {
    session_.plant = root_.at("plant");
    session_.model_hash = root_.at("model_hash");
    until_ = time_of(root_.at("t"));
    if (!root_.at("exercise").is_null()) read_exercise(root_.at("exercise"));
    session_.end = until_ - std::min(since_, until_);
    read_acts(root_.at("acts"));
    read_findings(root_.at("findings"));
    if (root_.contains("training")) read_training(root_.at("training"));
  }

 private:
  void read_exercise(const Json& exercise) {
    session_.exercise = exercise.at("title");
    session_.exercise_name = exercise.at("name");
    session_.score = exercise.at("score");
    session_.most = exercise.at("most");
    since_ = time_of(exercise.at("since"));
    if (const auto took = maybe_time(exercise.at("took"))) {
      session_.is_over = true;
      until_ = since_ + *took;
    }
    Time before = since_;
    for (const Json& one : exercise.at("steps")) {
      Session::Step step;
      const std::string text = one.at("text");
      step.words = text.empty() ? one.at("does").get<std::string>() : text;
      step.state = one.at("state");
      if (const auto at = maybe_time(one.at("t"))) {
        step.at = std::max(*at, since_) - since_;
        step.took = std::max(*at, before) - before;
        before = std::max(*at, before);
      }
      session_.steps.push_back(std::move(step));
    }
  }

  /// Acts come in the order in which they were done: a reset and a restore set plant time back.
  void read_acts(const Json& acts) {
    for (const Json& one : acts) {
      const Time at = time_of(one.at("t"));
      const Json& act = one.at("act");
      if (act.contains("reset") || act.contains("exercise")) {
        session_.acts.clear();
        continue;
      }
      if (act.contains("restore")) {
        std::erase_if(session_.acts, [&](const Session::Mark& mark) { return mark.at + since_ > at; });
      }
      if (one.at("by") == "scenario" || at < since_ || at > until_ || !is_on_plant(act)) continue;
      session_.acts.push_back({at - since_, act_words(act), one.value("name", "")});
    }
    name_acts();
  }

  void name_acts() {
    std::vector<Session::Mark>& acts = session_.acts;
    const auto has_name = [](const Session::Mark& act) { return !act.name.empty(); };
    if (std::none_of(acts.begin(), acts.end(), has_name)) return;
    std::erase_if(acts, std::not_fn(has_name));
    std::vector<std::string>& names = session_.names;
    for (const Session::Mark& act : acts) {
      if (std::find(names.begin(), names.end(), act.name) == names.end()) names.push_back(act.name);
    }
    if (names.size() == 1) return;
    for (Session::Mark& act : acts) act.words = act.name + ": " + act.words;
  }

  void read_findings(const Json& findings) {
    for (const Json& one : findings) {
      const Time at = time_of(one.at("t"));
      if (one.at("severity") == "note" || at < since_ || at > until_) continue;
      session_.findings.push_back({at - since_, one.at("text"), {}});
    }
  }

  void read_training(const Json& training) {
    for (const Json& run : training.at("malfunctions")) {
      const Time start = time_of(run.at("start"));
      if (start < since_ || start > until_) continue;
      Session::Reaction reaction{run.at("name"), std::nullopt};
      for (const Json& one : run.at("reactions")) {
        const Time time = time_of(one.at(1));
        reaction.time = std::min(reaction.time.value_or(time), time);
      }
      session_.reactions.push_back(std::move(reaction));
    }
  }

  const Json& root_;
  Session& session_;
  Time since_ = 0;  ///< the start of the exercise
  Time until_ = 0;  ///< its end, or that of the session
};

}  // namespace

bool is_session(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const auto skip_blanks = [&text] { text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size())); };
  skip_blanks();
  if (!text.starts_with('{')) return false;
  text.remove_prefix(1);
  skip_blanks();
  return text.starts_with(kMark);
}

ReadSession read_session(std::string_view text, const std::string& file) {
  ReadSession read;
  read.session.file = file;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  try {
    const Json root = Json::parse(text);
    if (root.at("symplant-session") != 1) {
      read.error = fmt::format("`{}` is a session of version {}; this symplant reads version 1", file,
                               root.at("symplant-session").dump());
      return read;
    }
    Reader(root, read.session).read();
  } catch (const Json::exception& error) {
    read.error = fmt::format("`{}` is not a whole session: {}", file, error.what());
  } catch (const std::out_of_range& error) {
    read.error = fmt::format("`{}` is not a whole session: {}", file, error.what());
  }
  return read;
}

}  // namespace symplant::compare

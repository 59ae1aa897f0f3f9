// Explanations that a user asks for with `--why`.
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "symplant/host/links.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/why/explainer.hpp"

namespace symplant::host {

/// A name of the command line, and what it means.
struct Question {
  std::string name;
  std::vector<why::Reference> things;
};

/// Nothing, with a message on `err` for each name, if one is not found.
std::optional<std::vector<Question>> questions_of(const std::vector<std::string>& named, const trace::PlantNames& names,
                                                  std::ostream& err);

struct Answer {
  std::string name;
  why::Explanation explanation;
};

/// What a run knows in addition to its stage.
struct RunKnowledge {
  const Links& links;
  const std::vector<bool>& carried;    ///< by symbol: whether a link carries it
  const scenario::Scenario* scenario;  ///< that is played at the end; null: none
  bool frozen_at_panel;
};

/// At the end of a run, when no other thread uses the stage.
std::vector<Answer> answers_to(std::span<const Question> questions, const Stage& stage, const RunKnowledge& knowledge);

/// The answers as text: `why: ` and a line for each sentence.
std::string answers_text(std::span<const Answer> answers);
/// As JSON, an array.
std::string answers_json(std::span<const Answer> answers, const trace::PlantNames& names);

}  // namespace symplant::host

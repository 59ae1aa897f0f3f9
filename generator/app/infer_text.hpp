// What symplant infer shows.
#pragma once

#include <set>
#include <string>

#include "infer/report.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// "1,386"
std::string grouped(std::size_t number);
/// "1 input", "1,386 inputs"
std::string counted(std::size_t number, std::string_view thing);

/// What a person decided, as indexes of correspondences and of questions.
struct InferAnswers {
  std::set<std::size_t> refused;
  std::set<std::size_t> accepted;
};

/// A line for each list: its format, its rows, its I/O symbols.
std::string infer_lists_text(const model::PlantModel& plant);
/// "PROG SELECT {x} -> PROG ECHO {x}, mirror, 2,688 of 2,704, e.g. A -> B"
std::string correspondence_text(const infer::Correspondence& one);
std::string question_text(const infer::Question& question);
/// Correspondences and questions with their numbers, then what is left over.
std::string infer_report_text(const infer::Report& report, const InferAnswers& answers);
/// "paired 37 % (512 of 1,386), accounted 81 %"
std::string infer_score_text(const name::Counts& score);

}  // namespace symplant::app

// What a report about a proposed naming rule holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

/// Why a pair may be wrong although its names fit.
enum class Suspicion : std::uint8_t { interlock_both_ways, lamp_and_button, completion_before_request };
inline constexpr std::size_t kSuspicions = 3;

struct SuspiciousPairs {
  Suspicion why{};
  std::size_t count = 0;
  std::string operation;  ///< an example
  std::string event;
};

/// A part of the naming rule that links operations with events.
struct Correspondence {
  std::string what;            ///< "PROG SELECT {x} -> PROG ECHO {x}, mirror"
  std::size_t linked = 0;      ///< linked operations, or events of a constant
  std::size_t candidates = 0;  ///< those and similar unlinked ones
  std::string operation;       ///< an example; empty for a constant
  std::string event;
  std::vector<std::size_t> rules;       ///< indexes in Naming::rules
  std::vector<std::size_t> archetypes;  ///< indexes in Naming::archetypes
  std::vector<std::size_t> needed_by;   ///< correspondences whose archetypes are in the devices of these rules
  std::vector<SuspiciousPairs> suspicious;
};

/// Texts that are equal except for their digits.
struct TextShape {
  std::string text;  ///< `#` for each run of digits
  std::size_t count = 0;
  std::string example;
  name::Direction side{};
  name::Source source{};
};

/// A contact that may be on in a healthy plant: `rule`, for Naming::rest, makes it a constant. Or, if `rule` has the
/// role `interlock`, the symbols of that rule, which are to be paired: then infer() runs again with Interlocks::paired.
struct Question {
  TextShape shape;
  name::SymbolRule rule;

  bool about_interlocks() const { return rule.role == name::Role::interlock; }
};

struct NearMiss {
  std::string operation;
  std::size_t alike = 0;            ///< unpaired operations of its shape
  std::vector<std::string> events;  ///< the closest first
};

/// A link to complete by hand: what names cannot pair.
struct OpenLink {
  std::string operation;  ///< the name of a symbol
  std::string state;
  std::string text;                 ///< of the operation, if it is not the name
  std::vector<std::string> events;  ///< names, with their texts; the closest first
};

/// Shapes in the order of their counts, and how many more there are.
struct Shapes {
  std::vector<TextShape> shown;
  std::size_t more_shapes = 0;
  std::size_t more_symbols = 0;
};

struct Report {
  name::Counts score;
  std::size_t operations = 0;  ///< BOOL; not ignored, and not accounted for as operator's, data, interlock or constant
  std::size_t operations_paired = 0;
  std::size_t constants = 0;
  std::size_t operator_panel = 0;
  std::size_t data = 0;
  std::size_t interlocks = 0;
  std::vector<Correspondence> correspondences;  ///< the one that links most first
  std::vector<Question> questions;              ///< the most common first
  std::size_t more_questions = 0;               ///< shapes that are not in `questions`
  std::size_t asked = 0;                        ///< symbols of all questions
  Shapes left_over;                             ///< without those of questions
  Shapes direction_conflicts;                   ///< names that give another side than the address
  std::vector<NearMiss> near_misses;
  std::vector<OpenLink> open_links;

  /// Whether most outputs have no pair, so that a plant.json must say what they move.
  bool names_do_not_link() const;
};

}  // namespace symplant::infer

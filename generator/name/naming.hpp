// A naming rule as data: how names and comments say device, task and direction (docs/naming.md).
//
// All texts are as the user wrote them. CompiledNaming makes a reader of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "name/level_rule.hpp"

namespace symplant::name {

/// What a rule's symbols are. Only `io` symbols are linked; the others are accounted for.
enum class Role : std::uint8_t { io, operator_panel, data, interlock, constant, none };

/// A text of a symbol.
enum class Source : std::uint8_t {
  name_then_comment,  ///< the name; the comment if the pattern does not match the name
  name,
  comment,
  parent_and_comment,  ///< the comment of the word or module, then that of the bit
};

/// A regular expression of RE2 and its replacement, in which `$1` is the first group.
struct Replacement {
  std::string expression;
  std::string replacement;
};

struct Normalise {
  bool collapse = true;       ///< runs of blanks and line breaks become one blank
  std::string line_break;     ///< how the export writes a line break (`$N`); empty: only real ones
  std::uint32_t columns = 0;  ///< a comment is cut into columns of this width; 0: it is not
  bool camel_case = false;    ///< a capital letter begins a word
  std::vector<Replacement> replace;
};

/// What a field of a pattern may hold.
struct FieldRule {
  std::string field;                 ///< without braces
  std::string expression;            ///< of RE2, for the whole field; empty: anything
  std::vector<DirectionWord> words;  ///< of a direction field
};

struct SourcePattern {
  Source source = Source::name_then_comment;
  std::string pattern;
};

/// One rule. The first rule that matches a symbol wins.
struct SymbolRule {
  std::string name;                     ///< for messages; empty: its number
  std::vector<SourcePattern> patterns;  ///< all must match
  std::vector<FieldRule> fields;
  std::vector<DirectionWord> classes;  ///< words of the field `class`; empty: the vocabulary's
  std::vector<Replacement> replace;    ///< after those of Normalise
  std::vector<std::string> has;     ///< the text must have one of these words or phrases, digits at a word's end apart
  std::optional<Direction> side;    ///< only symbols whose address is on this side
  std::optional<std::string> task;  ///< the task of all its symbols
  bool exact = false;               ///< the pattern is the whole name as written, each of its fields one level
  bool unlinked_states = false;     ///< events that nothing links name states, too
  bool fan_out = false;             ///< an operation drives every device of its process whose words contain its own
  Role role = Role::io;
  std::optional<bool> value;  ///< of the role `constant`
};

/// What gives a symbol its direction.
enum class Evidence : std::uint8_t { address, field, klass, prefix };

struct DirectionRule {
  std::vector<Evidence> evidence = {Evidence::address, Evidence::field, Evidence::klass, Evidence::prefix};
  bool conflict_is_error = false;  ///< else the first evidence wins
};

enum class SensorIndex : std::uint8_t {
  off,
  on,        ///< ADV1 and ADV2 sense ADV
  appended,  ///< the event's number is that of the operation and one more digit: CLAMP3, UNCLAMP31
};

struct TaskRules {
  bool vocabulary = true;                                  ///< the words that ship, after those given here
  std::vector<std::pair<std::string, std::string>> pairs;  ///< rest position, other position
  std::vector<std::string> operation_affixes;              ///< words that only say the side
  std::vector<std::string> event_affixes;
  std::vector<std::pair<std::string, std::string>> synonyms;  ///< words, canonical word
  SensorIndex sensor_index = SensorIndex::on;
  bool sequence = false;  ///< trailing digits are sequence numbers
};

/// What becomes a unit.
enum class Units : std::uint8_t {
  facets,  ///< symbols of a device that archetypes and words link
  device,  ///< all symbols of a device (Park, Wang and Park); names differ in more than the case of ASCII letters
};

enum class ArchetypeModel : std::uint8_t { mirror, handshake, constant, two_position, contactor };
inline constexpr std::size_t kArchetypeModels = 5;

/// The roles of all archetypes.
enum class ArchetypeRole : std::uint8_t {
  operation,
  event,
  start,
  busy,
  done,
  ack,
  reset,
  a,
  b,
  at_a,
  at_b,
  on,
  is_on
};
inline constexpr std::size_t kArchetypeRoles = 13;
std::string_view archetype_role_name(ArchetypeRole role);

/// A ready-made I/O model for the tasks of a device that match its texts. `{x}` is the same text in all roles.
struct Archetype {
  std::string name;
  ArchetypeModel model = ArchetypeModel::mirror;
  std::vector<std::pair<ArchetypeRole, std::string>> texts;  ///< `*`, `|` and `{x}` are allowed
  std::int64_t delay = 0;                                    ///< ns, of mirror and contactor
  std::int64_t takes = 1'000'000'000;                        ///< ns, of handshake and two_position
  bool inverted = false;                                     ///< of mirror: the event is on while the operation is off
  bool value = true;                                         ///< of constant
};

/// A link that names cannot express: the operation leads to `state`, which the event reports.
struct NamedLink {
  std::string operation;  ///< empty: that of the row above
  std::string event;
  std::string state;
};

struct Naming {
  std::string name;
  Normalise normalise;
  std::string separators = " _";
  std::vector<std::string> ignore;  ///< patterns with `*` and `?` on the normalised text
  std::vector<SymbolRule> rules;
  std::vector<SymbolRule> rest;                      ///< roles of symbols that nothing links
  std::vector<std::pair<Level, std::string>> fixed;  ///< line, process or device that no name carries
  DirectionRule direction;
  Units units = Units::facets;
  TaskRules tasks;
  std::vector<NamedLink> links;
  std::vector<Archetype> archetypes;
};

}  // namespace symplant::name

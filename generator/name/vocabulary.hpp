// The words of a naming rule: motions in pairs, synonyms, affixes and classes, those of the rule and those that ship.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "name/naming.hpp"
#include "name/reading.hpp"

namespace symplant::name {

/// The words that ship with the tool, folded; `symplant naming --words` prints them.
struct BuiltInWords {
  struct Pair {
    std::string_view rest;
    std::string_view other;
    bool noun = false;  ///< `other` is also the name of a thing (CLAMP, LOCK): a motion only without another one
  };
  struct Synonym {
    std::string_view words;  ///< one or more, separated by blanks
    std::string_view canonical;
  };
  struct ClassWord {
    std::string_view word;
    Direction side;
  };
  struct Cause {
    std::string_view operation;  ///< words, separated by blanks
    std::string_view event;
  };
  std::span<const Pair> pairs;
  std::span<const Synonym> synonyms;
  std::span<const std::string_view> fused_motions;  ///< motions that follow another word without a blank
  std::span<const std::string_view> operation_affixes;
  std::span<const std::string_view> event_affixes;
  std::span<const ClassWord> classes;
  std::span<const std::string_view> panel;  ///< of what an operator sees or touches
  std::span<const std::string_view> alarm;
  std::span<const std::string_view> diagnosis;  ///< of what sensors say of themselves
  std::span<const std::string_view> data;
  std::span<const std::string_view> parts;  ///< of work pieces that sensors see
  std::span<const std::string_view> spare;
  std::span<const std::string_view> healthy;  ///< of contacts that are on in a healthy plant
  std::span<const std::string_view> echo;     ///< a text repeats what the other side says
  std::span<const std::string_view> start;    ///< work may begin
  std::span<const std::string_view> done;     ///< work is done
  std::span<const std::string_view> reset;
  std::span<const std::string_view> interlock;  ///< of permissions between machines
  std::span<const std::string_view> mutual;     ///< those of them by which two machines keep out of each other's room
  std::span<const Cause> causes;                ///< words of an operation and of the event that it causes
};
const BuiltInWords& built_in_words();

/// A word that means a motion.
struct Motion {
  std::string_view canonical;  ///< the word of the pair, as written where the pair is given
  std::string_view rest_word;  ///< the pair's first word
  std::uint32_t pair = 0;
  bool rest = false;
  bool noun = false;
  std::string_view index;  ///< digits at the end of the word; empty: none
};

/// Immutable; may be shared by threads. Views point into it, into the naming rule, or into the words asked for.
class Vocabulary {
 public:
  Vocabulary(const TaskRules& rules, const std::vector<DirectionWord>& classes);

  /// The motion of a folded word, without regard to digits at its end and to affixes fused with it.
  std::optional<Motion> motion(std::string_view folded) const;
  bool is_affix(std::string_view folded, Direction side) const;
  /// The canonical words for folded words separated by blanks; empty if they are no synonym.
  std::string_view synonym(std::string_view folded_words) const;
  std::optional<Said> class_said(std::string_view folded) const;
  /// Whether a folded word is a motion, an affix, a class, or the first word of a synonym.
  bool knows(std::string_view folded) const;
  std::size_t longest_synonym() const { return longest_synonym_; }  ///< in words

 private:
  struct Pair {
    std::string_view rest;  ///< as written
    std::string_view other;
  };
  struct Entry {
    std::uint32_t pair;
    bool rest;
    bool noun;
  };
  void add_built_in(const BuiltInWords& words);
  void add_pair(std::string_view rest, std::string_view other, bool noun);
  void add_synonym(std::string_view words, std::string_view canonical);
  void add_affix(Direction side, std::string_view word);
  std::string_view keep(std::string text);
  std::string_view fold(std::string_view text);
  const Entry* entry(std::string_view folded) const;

  std::vector<Pair> pairs_;
  std::unordered_map<std::string_view, Entry> motions_;
  std::unordered_map<std::string_view, std::string_view> synonyms_;
  std::unordered_set<std::string_view> operation_affixes_;
  std::unordered_set<std::string_view> event_affixes_;
  std::vector<std::string_view> fused_affixes_;  // longest first
  std::unordered_map<std::string_view, Said> classes_;
  std::unordered_set<std::string_view> starts_;  // first words of synonyms
  std::size_t longest_synonym_ = 1;
  std::unordered_set<std::string> kept_;
};

}  // namespace symplant::name

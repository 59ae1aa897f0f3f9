// The words of a naming rule: motions in pairs, synonyms, affixes and classes, its own and those that ship.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "name/naming.hpp"

namespace symplant::name {

/// A known motion word.
struct Motion {
  std::string_view canonical;  ///< the word of the pair that it means
  std::uint32_t pair;          ///< index of the pair
  bool rest;                   ///< it is the pair's rest position
};

/// A table of words that ships with the tool.
struct WordPair {
  std::string_view rest;
  std::string_view other;
};
struct WordSynonym {
  std::string_view words;
  std::string_view canonical;
};
struct ClassWord {
  std::string_view word;
  Side side;
};
struct BuiltInWords {
  std::vector<WordPair> pairs;
  std::vector<WordSynonym> synonyms;
  std::vector<std::string_view> operation_affixes;
  std::vector<std::string_view> event_affixes;
  std::vector<ClassWord> classes;
  std::vector<std::string_view> panel;  ///< of what an operator sees or touches
  std::vector<std::string_view> alarm;
  std::vector<std::string_view> data;
  std::vector<std::string_view> spare;
  std::vector<std::string_view> healthy;  ///< of contacts that are on in a healthy plant
};
/// Words of several languages; docs/naming.md lists them.
const BuiltInWords& built_in_words();

}  // namespace symplant::name

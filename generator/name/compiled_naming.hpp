// A naming rule made ready to read symbols.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "name/naming.hpp"
#include "name/naming_fault.hpp"

namespace symplant::name {

class Vocabulary;
struct NamingParts;

/// Patterns, regular expressions and vocabulary of a rule. Immutable; may be shared by threads.
class CompiledNaming {
 public:
  /// With a fault the result is null. Reports every fault.
  static std::shared_ptr<const CompiledNaming> compile(Naming naming, std::vector<NamingFault>& faults);
  ~CompiledNaming();
  CompiledNaming(const CompiledNaming&) = delete;
  CompiledNaming& operator=(const CompiledNaming&) = delete;

  const Naming& naming() const { return naming_; }
  const Vocabulary& vocabulary() const;

  const NamingParts& parts() const { return *parts_; }
  /// The levels of names, if all rules are one exact rule: then a name that is not read has a NameFault. Else null.
  const LevelRule* levels() const;

 private:
  explicit CompiledNaming(Naming naming);

  Naming naming_;
  std::unique_ptr<NamingParts> parts_;
};

/// Reads an archetype's text: `*` is any run, `|` separates alternatives, `{x}` is a run that may be empty; blanks
/// match any run of separators.
class ArchetypeText {
 public:
  ArchetypeText(const CompiledNaming& naming, std::size_t archetype, std::size_t text);
  ~ArchetypeText();
  ArchetypeText(ArchetypeText&&) noexcept;
  ArchetypeText& operator=(ArchetypeText&&) noexcept;

  /// Whether the text matches `task`, which is TaskReading::text. Sets `x` to what `{x}` matches, folded, words
  /// separated by `_`; empty without `{x}`.
  bool matches(std::string_view task, std::string& x) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace symplant::name

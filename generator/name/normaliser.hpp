// Brings texts of a list into the form that patterns read.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "name/naming.hpp"
#include "name/prepared_text.hpp"
#include "name/vocabulary.hpp"

namespace symplant::name {

/// Regular expressions with their replacements, in their order.
class Replacements {
 public:
  Replacements();
  /// `faults` gets the index and the reason of each expression or replacement that is not valid.
  Replacements(const std::vector<Replacement>& replacements, std::vector<std::pair<std::size_t, std::string>>& faults);
  ~Replacements();
  Replacements(Replacements&&) noexcept;
  Replacements& operator=(Replacements&&) noexcept;

  bool empty() const;
  void apply(std::string& text) const;

 private:
  struct Compiled;
  std::vector<Compiled> compiled_;
};

/// `text` in normal form, with blanks for line breaks, columns and camel case, and with runs of blanks collapsed.
/// O(text).
std::string normalised(std::string_view text, const Normalise& rules, const Vocabulary& vocabulary,
                       const Separators& separators);

}  // namespace symplant::name

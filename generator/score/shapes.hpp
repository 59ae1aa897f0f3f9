// Symbols of one shape: their texts differ only in digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "score/score.hpp"

namespace symplant::score {

/// Symbols of one shape and account.
struct Shape {
  std::string text;  ///< `#` for each run of digits, one blank for each run of blanks
  Account account{};
  std::size_t count = 0;
  std::uint32_t first = 0;  ///< its first symbol
};

/// Sums symbols by shape.
class Shapes {
 public:
  explicit Shapes(const model::PlantModel& plant);

  void add(std::uint32_t symbol, Account account);
  /// The most frequent first, those of equal counts in list order.
  std::vector<Shape> take();

 private:
  const model::PlantModel& plant_;
  bool by_comment_;  ///< the naming rule reads comments only
  std::vector<Shape> shapes_;
  base::IndexTable table_;
  std::string text_;
};

/// The text by which people know a symbol: its name, or its comment where the name is an address or the naming rule
/// reads comments only.
std::string_view known_text(const model::PlantModel& plant, const model::Symbol& symbol, bool by_comment);
/// Whether all rules of a custom naming rule read comments only.
bool reads_comments_only(const model::PlantModel& plant);

/// The symbols that are not accounted for, those to repair first come first. O(symbols).
std::vector<Shape> left_over_shapes(const model::PlantModel& plant, const PlantScore& score);

}  // namespace symplant::score

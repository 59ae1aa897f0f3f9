// Finds numbers that are spread over bits, and symbols that have the same text.
#include <bit>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/index_table.hpp"
#include "pairing/work.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

constexpr int kLeastWeights = 4;
constexpr std::size_t kMostOfMotion = 4;  ///< valves of one motion, or sensors of one position, with the same text

/// Texts of one device and side that are equal but for one number.
struct Series {
  std::uint32_t input = 0;    ///< its first symbol
  std::uint32_t digits = 0;   ///< where the number begins in its text
  std::uint32_t length = 0;   ///< of the number
  std::uint32_t binary = 0;   ///< powers of two that occur, by exponent
  std::uint32_t decimal = 0;  ///< 1, 2, 4, 8, 10, 20 ... that occur, by index
  bool all_binary = true;
  bool all_decimal = true;

  bool is_data() const {
    return (all_binary && std::popcount(binary) >= kLeastWeights) ||
           (all_decimal && std::popcount(decimal) >= kLeastWeights);
  }
  void take(std::string_view number);
};

void Series::take(std::string_view number) {
  std::uint32_t value = 0;
  for (const char c : number) value = value * 10 + static_cast<std::uint32_t>(c - '0');
  if (std::has_single_bit(value)) {
    binary |= 1U << static_cast<unsigned>(std::countr_zero(value));
  } else {
    all_binary = false;
  }
  unsigned index = 0;
  for (; value != 0 && value % 10 == 0; value /= 10) index += 4;
  if (value < 10 && std::has_single_bit(value)) {
    decimal |= 1U << (index + static_cast<unsigned>(std::countr_zero(value)));
  } else {
    all_decimal = false;
  }
}

class DataSymbols {
 public:
  explicit DataSymbols(Work& work) : work_(work) {}

  void set_repeated() {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> repeated;  // by the first symbol: the others
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (!work_.is_free(i)) continue;
      const std::uint32_t first = first_of_text(i);
      if (first != i) repeated[first].push_back(i);
    }
    for (const auto& [first, others] : repeated) {
      const bool motion = work_.reading(first).task->pair != name::kNoPair;
      if (motion && others.size() < kMostOfMotion) continue;
      work_.result.accounts[first] = Account::data;
      for (const std::uint32_t input : others) work_.result.accounts[input] = Account::data;
    }
  }

  void set_weights() {
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (work_.is_free(i)) add_numbers(i);
    }
    for (const auto& [input, series] : in_series_) {
      if (series_[series].is_data()) work_.result.accounts[input] = Account::data;
    }
  }

 private:
  static constexpr std::size_t kLongestNumber = 5;

  std::string_view text_of(std::uint32_t input) const { return work_.reading(input).task->text; }

  bool same_side(std::uint32_t a, std::uint32_t b) const {
    return work_.device[a] == work_.device[b] && work_.inputs[a].side == work_.inputs[b].side;
  }
  std::uint64_t hash_of_side(std::uint32_t input) const {
    return (std::uint64_t{work_.device[input]} * 2 + (work_.is_operation(input) ? 1 : 0)) * 0x9E37'79B9'7F4A'7C15U;
  }

  /// The first symbol of its device, side and text.
  std::uint32_t first_of_text(std::uint32_t input) {
    return texts_.find_or_add(
        hash_of_side(input) ^ text::hash_ignoring_case(text_of(input)), input, [&](std::uint32_t other) {
          return same_side(input, other) && text::equal_ignoring_case(text_of(input), text_of(other));
        });
  }

  void add_numbers(std::uint32_t input) {
    const std::string_view text = text_of(input);
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
      if (!text::is_digit(text[begin])) continue;
      std::size_t end = begin;
      while (end < text.size() && text::is_digit(text[end])) ++end;
      if (end - begin <= kLongestNumber) add_number(input, begin, end - begin);
      begin = end;
    }
  }

  void add_number(std::uint32_t input, std::size_t begin, std::size_t length) {
    const std::string_view text = text_of(input);
    const std::string_view before = text.substr(0, begin);
    const std::string_view after = text.substr(begin + length);
    const std::uint64_t hash =
        hash_of_side(input) ^ text::hash_ignoring_case(before) ^ std::rotl(text::hash_ignoring_case(after), 32) ^ begin;
    const auto next = static_cast<std::uint32_t>(series_.size());
    const std::uint32_t index = by_text_.find_or_add(hash, next, [&](std::uint32_t other) {
      const Series& series = series_[other];
      const std::string_view known = text_of(series.input);
      return same_side(input, series.input) && series.digits == begin &&
             text::equal_ignoring_case(known.substr(0, series.digits), before) &&
             text::equal_ignoring_case(known.substr(series.digits + series.length), after);
    });
    if (index == next) {
      Series& added = series_.emplace_back();
      added.input = input;
      added.digits = static_cast<std::uint32_t>(begin);
      added.length = static_cast<std::uint32_t>(length);
    }
    series_[index].take(text.substr(begin, length));
    in_series_.push_back({input, index});
  }

  struct InSeries {
    std::uint32_t input;
    std::uint32_t series;
  };

  Work& work_;
  base::IndexTable texts_;  ///< device, side and text -> the first symbol
  base::IndexTable by_text_;
  std::vector<Series> series_;
  std::vector<InSeries> in_series_;
};

}  // namespace

void set_repeated_texts_aside(Work& work) { DataSymbols(work).set_repeated(); }

void set_weights_aside(Work& work) { DataSymbols(work).set_weights(); }

}  // namespace symplant::pairing

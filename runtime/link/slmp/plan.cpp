// Packs words and bits of a PLC's memory into the fewest requests.
#include "symplant/link/slmp/plan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace symplant::link::slmp {

namespace {

/// A word or a bit to transfer.
struct Item {
  Kind kind;
  std::uint32_t number;
  std::uint32_t index;  ///< in the list to plan
};

/// What batch and random requests may hold.
struct Shape {
  std::uint32_t batch;     ///< numbers in a row
  bool exact;              ///< a batch must not cover numbers between items
  std::uint32_t single;    ///< weight of an item in a random request
  std::uint32_t pair;      ///< weight of two adjacent items as one; 0: not possible
  std::uint32_t capacity;  ///< of a random request
};

bool adjacent(const Item& a, const Item& b) { return a.kind == b.kind && a.number + 1 == b.number; }

constexpr std::uint32_t ceil_of(std::uint32_t value, std::uint32_t divisor) { return (value + divisor - 1) / divisor; }

/// Chooses, for items in ascending order, which of them to transfer by batches, so that batches and random requests
/// together are the fewest. weight[k][i] is the least weight of random access for the first i items if k batches are
/// used; a batch that ends with item i covers as many items before it as it can.
class Cover {
 public:
  Cover(std::span<const Item> items, const Shape& shape) : items_(items), shape_(shape), before_(items.size() + 1) {
    for (std::size_t i = 1, start = 0; i <= items.size(); ++i) {
      const Item& last = items[i - 1];
      const bool breaks = i > 1 && (items[start].kind != last.kind || (shape.exact && !adjacent(items[i - 2], last)));
      if (breaks) start = i - 1;
      while (last.number - items[start].number >= shape.batch) ++start;
      before_[i] = static_cast<std::uint32_t>(start);
      longest_ = std::max(longest_, static_cast<std::uint32_t>(i - start));
    }
  }

  std::vector<Transfer> plan() {
    std::vector<std::uint32_t> weight = first_weights();
    std::uint32_t fewest = ceil_of(weight.back(), shape_.capacity);
    std::size_t batches = 0;
    // A batch replaces at most the weight of the items that it covers: no more of them than could still pay off.
    const std::uint32_t most_saved = std::max(longest_ * shape_.single, shape_.capacity);
    for (std::uint32_t k = 1; k - 1 + ceil_of(weight.back(), most_saved) < fewest; ++k) {
      weight = next_weights(weight);
      const std::uint32_t total = k + ceil_of(weight.back(), shape_.capacity);
      if (total > fewest) continue;
      fewest = total;
      batches = k;
    }
    return transfers(batches);
  }

 private:
  enum class Choice : std::uint8_t { single, pair, batch };

  bool is_pair(std::size_t i) const { return shape_.pair != 0 && i > 1 && adjacent(items_[i - 2], items_[i - 1]); }

  /// Takes item i by random access, alone or with the one before it.
  void add_random(std::vector<std::uint32_t>& weight, std::vector<Choice>& choice, std::size_t i) const {
    weight[i] = weight[i - 1] + shape_.single;
    if (is_pair(i) && weight[i - 2] + shape_.pair < weight[i]) {
      weight[i] = weight[i - 2] + shape_.pair;
      choice[i] = Choice::pair;
    }
  }

  std::vector<std::uint32_t> first_weights() {
    std::vector<std::uint32_t> weight(items_.size() + 1);
    auto& choice = choices_.emplace_back(items_.size() + 1, Choice::single);
    for (std::size_t i = 1; i <= items_.size(); ++i) add_random(weight, choice, i);
    return weight;
  }

  std::vector<std::uint32_t> next_weights(const std::vector<std::uint32_t>& with_fewer) {
    std::vector<std::uint32_t> weight(items_.size() + 1);
    auto& choice = choices_.emplace_back(items_.size() + 1, Choice::single);
    for (std::size_t i = 1; i <= items_.size(); ++i) {
      add_random(weight, choice, i);
      if (with_fewer[before_[i]] > weight[i]) continue;
      weight[i] = with_fewer[before_[i]];
      choice[i] = Choice::batch;
    }
    return weight;
  }

  std::vector<Transfer> transfers(std::size_t batches) const {
    std::vector<Transfer> result;
    std::vector<Span> random;
    for (std::size_t i = items_.size(); i > 0;) {
      const Choice choice = choices_[batches][i];
      const std::size_t from = choice == Choice::batch ? before_[i] : i - (choice == Choice::pair ? 2 : 1);
      const Item& first = items_[from];
      const Span span{first.kind, first.number, items_[i - 1].number - first.number + 1, first.index};
      if (choice == Choice::batch) {
        result.push_back({Access::batch, {span}});
        --batches;
      } else {
        random.push_back(span);
      }
      i = from;
    }
    std::reverse(result.begin(), result.end());
    std::stable_sort(random.begin(), random.end(), [](const Span& a, const Span& b) { return a.count > b.count; });
    add_random_transfers(random, result);
    return result;
  }

  void add_random_transfers(const std::vector<Span>& random, std::vector<Transfer>& result) const {
    std::uint32_t weight = shape_.capacity + 1;
    for (const Span& span : random) {
      const std::uint32_t more = span.count == 1 ? shape_.single : shape_.pair;
      weight += more;
      if (weight > shape_.capacity) {
        result.push_back({Access::random, {}});
        weight = more;
      }
      result.back().spans.push_back(span);
    }
    for (Transfer& transfer : result) {
      std::stable_sort(transfer.spans.begin(), transfer.spans.end(),
                       [](const Span& a, const Span& b) { return a.count < b.count; });
    }
  }

  std::span<const Item> items_;
  Shape shape_;
  std::vector<std::uint32_t> before_;         ///< items before the batch that ends with item i, which counts from 1
  std::uint32_t longest_ = 0;                 ///< the most items of a batch
  std::vector<std::vector<Choice>> choices_;  ///< by number of batches and item
};

/// Batches only, as few as possible.
std::vector<Transfer> plan_batches(std::span<const Item> items, std::uint32_t batch, bool exact) {
  std::vector<Transfer> result;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    if (!result.empty()) {
      Span& span = result.back().spans.front();
      const bool fits = span.kind == item.kind && item.number - span.first < batch;
      if (fits && (!exact || adjacent(items[i - 1], item))) {
        span.count = item.number - span.first + 1;
        continue;
      }
    }
    result.push_back({Access::batch, {{item.kind, item.number, 1, item.index}}});
  }
  return result;
}

/// Block requests over gaps of at most `gap` numbers; a block costs `cost` points in addition to its own.
std::vector<Transfer> plan_blocks(std::span<const Item> items, std::uint32_t gap, const Limits& limits,
                                  std::uint32_t cost) {
  std::vector<Transfer> result;
  std::uint32_t points = limits.block_points;
  const auto has_room = [&] {
    return !result.empty() && result.back().spans.size() < limits.blocks && points + cost < limits.block_points;
  };
  const Item* before = nullptr;
  for (const Item& item : items) {
    const bool same = before != nullptr && before->kind == item.kind && item.number - before->number - 1 <= gap;
    const std::uint32_t distance = same ? item.number - before->number : 0;
    before = &item;
    if (same && points + distance <= limits.block_points) {
      result.back().spans.back().count += distance;
      points += distance;
      continue;
    }
    if (!has_room()) {
      result.push_back({Access::blocks, {}});
      points = 0;
    }
    result.back().spans.push_back({item.kind, item.number, 1, item.index});
    points += cost + 1;
  }
  for (Transfer& transfer : result) {
    std::stable_partition(transfer.spans.begin(), transfer.spans.end(),
                          [](const Span& span) { return !info_of(span.kind).bit; });
    const bool batch = transfer.spans.size() == 1 && transfer.spans.front().count <= limits.words;
    if (batch) transfer.access = Access::batch;
  }
  return result;
}

/// Random requests for single items only.
std::vector<Transfer> plan_lists(std::span<const Item> items, std::uint32_t capacity) {
  std::vector<Transfer> result;
  for (const Item& item : items) {
    if (result.empty() || result.back().spans.size() == capacity) result.push_back({Access::random, {}});
    result.back().spans.push_back({item.kind, item.number, 1, item.index});
  }
  return result;
}

void take_fewer(std::vector<Transfer>& best, std::vector<Transfer> other) {
  if (other.size() < best.size()) best = std::move(other);
}

/// Items whose kind allows random access, and the others.
struct Sorted {
  std::vector<Item> free;
  std::vector<Item> batch_only;
};

Sorted sorted_cells(std::span<const Cell> cells) {
  Sorted items;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const bool only = info_of(cells[i].kind).batch_only;
    (only ? items.batch_only : items.free).push_back({cells[i].kind, cells[i].word, i});
  }
  return items;
}

std::vector<Transfer> plan_cells(std::span<const Cell> cells, const Limits& limits, const Shape& shape,
                                 std::span<const std::uint32_t> gaps, std::uint32_t block_cost) {
  const Sorted items = sorted_cells(cells);
  std::vector<Transfer> best = plan_batches(items.free, shape.batch, shape.exact);
  // Block requests hold no more points than batches, so that fewer than two requests cannot be improved.
  if (best.size() > 1) take_fewer(best, Cover(items.free, shape).plan());
  if (limits.blocks != 0 && best.size() > 1) {
    for (const std::uint32_t gap : gaps) take_fewer(best, plan_blocks(items.free, gap, limits, block_cost));
  }
  for (Transfer& transfer : plan_batches(items.batch_only, shape.batch, shape.exact)) {
    best.push_back(std::move(transfer));
  }
  return best;
}

}  // namespace

std::vector<Transfer> plan_reads(std::span<const Cell> cells, const Limits& limits) {
  constexpr std::array<std::uint32_t, 10> kGaps = {0, 1, 2, 4, 8, 16, 32, 64, 128, 256};
  return plan_cells(cells, limits, {limits.words, false, 1, 1, limits.random_reads}, kGaps, 0);
}

std::vector<Transfer> plan_writes(std::span<const Cell> cells, const Limits& limits) {
  constexpr std::array<std::uint32_t, 1> kNoGap = {0};
  return plan_cells(cells, limits, {limits.words, true, kRandomWord, kRandomDouble, limits.random_write}, kNoGap,
                    limits.block_cost);
}

std::vector<Transfer> plan_bit_writes(std::span<const Bit> bits, const Limits& limits) {
  Sorted items;
  for (std::uint32_t i = 0; i < bits.size(); ++i) {
    const bool only = info_of(bits[i].kind).batch_only;
    (only ? items.batch_only : items.free).push_back({bits[i].kind, bits[i].number, i});
  }
  if (limits.bits == 0) return plan_lists(items.free, limits.random_bits);
  std::vector<Transfer> best = plan_batches(items.free, limits.bits, true);
  if (best.size() > 1) take_fewer(best, Cover(items.free, {limits.bits, true, 1, 0, limits.random_bits}).plan());
  for (Transfer& transfer : plan_batches(items.batch_only, limits.bits, true)) best.push_back(std::move(transfer));
  return best;
}

}  // namespace symplant::link::slmp

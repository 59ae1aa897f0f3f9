// Converts a tree to truth tables: merges parts up to six inputs; larger parts become tables.
#include "symplant/condition/truth_table.hpp"

#include <array>
#include <optional>
#include <utility>

namespace symplant::condition {
namespace {

constexpr std::size_t kRows = std::size_t{1} << kMostInputs;
/// The truth of input k only.
constexpr std::array<std::uint64_t, kMostInputs> kColumns{
    0xAAAA'AAAA'AAAA'AAAA, 0xCCCC'CCCC'CCCC'CCCC, 0xF0F0'F0F0'F0F0'F0F0,
    0xFF00'FF00'FF00'FF00, 0xFFFF'0000'FFFF'0000, 0xFFFF'FFFF'0000'0000,
};

bool same(const Input& a, const Input& b) {
  return a.is_table == b.is_table && (a.is_table ? a.table == b.table : a.atom == b.atom);
}

/// A part of the tree with at most six inputs. With fewer inputs its truth repeats.
struct Part {
  std::uint64_t truth = 0;
  std::vector<Input> inputs;
};

/// The truth of a part after its input k became input `index[k]`.
std::uint64_t moved(std::uint64_t truth, const std::vector<std::size_t>& index) {
  std::uint64_t result = 0;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::size_t old_row = 0;
    for (std::size_t k = 0; k < index.size(); ++k) old_row |= (row >> index[k] & 1) << k;
    result |= (truth >> old_row & 1) << row;
  }
  return result;
}

/// Removes inputs that have no effect on the truth (`A or not A`), so that they are not watched.
void drop_idle_inputs(Part& part) {
  std::vector<Input> kept;
  std::vector<std::size_t> rows_of;  // a kept input's old index
  for (std::size_t k = 0; k < part.inputs.size(); ++k) {
    const std::uint64_t where_on = (part.truth & kColumns[k]) >> (std::size_t{1} << k);
    if (where_on == (part.truth & ~kColumns[k])) continue;
    rows_of.push_back(k);
    kept.push_back(part.inputs[k]);
  }
  if (kept.size() == part.inputs.size()) return;
  std::uint64_t truth = 0;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::size_t old_row = 0;
    for (std::size_t k = 0; k < rows_of.size(); ++k) old_row |= (row >> k & 1) << rows_of[k];
    truth |= (part.truth >> old_row & 1) << row;
  }
  part = {truth, std::move(kept)};
}

/// Merges two parts by `and` or `or`; empty if they have too many inputs together.
std::optional<Part> merged(const Part& a, const Part& b, Tree::Kind kind) {
  Part result{a.truth, a.inputs};
  std::vector<std::size_t> index;
  for (const Input& input : b.inputs) {
    std::size_t k = 0;
    while (k < result.inputs.size() && !same(result.inputs[k], input)) ++k;
    if (k == kMostInputs) return std::nullopt;
    if (k == result.inputs.size()) result.inputs.push_back(input);
    index.push_back(k);
  }
  const std::uint64_t other = moved(b.truth, index);
  result.truth = kind == Tree::Kind::all ? result.truth & other : result.truth | other;
  drop_idle_inputs(result);
  return result;
}

class Network {
 public:
  Part part_of(const Tree& tree) {
    switch (tree.kind) {
      case Tree::Kind::constant:
        return {tree.value ? ~std::uint64_t{0} : 0, {}};
      case Tree::Kind::atom:
        return {kColumns[0], {Input{false, 0, tree.atom}}};
      case Tree::Kind::negation: {
        Part part = part_of(tree.children.front());
        part.truth = ~part.truth;
        return part;
      }
      case Tree::Kind::all:
      case Tree::Kind::any:
        break;
    }
    std::vector<Part> parts;
    parts.reserve(tree.children.size());
    for (const Tree& child : tree.children) parts.push_back(part_of(child));
    return joined(std::move(parts), tree.kind);
  }

  std::vector<TruthTable> finish(const Part& whole) {
    add(whole);
    drop_unread();
    return std::move(tables_);
  }

 private:
  /// Joins parts layer by layer, so that a change passes through few tables for any number of children.
  Part joined(std::vector<Part> parts, Tree::Kind kind) {
    for (;;) {
      std::vector<Part> groups{std::move(parts.front())};
      for (std::size_t i = 1; i < parts.size(); ++i) {
        if (auto both = merged(groups.back(), parts[i], kind)) {
          groups.back() = std::move(*both);
        } else {
          groups.push_back(std::move(parts[i]));
        }
      }
      if (groups.size() == 1) return std::move(groups.front());
      for (Part& group : groups) {
        if (group.inputs.size() < 2) continue;
        const std::uint32_t table = add(group);
        group = {kColumns[0], {Input{true, table, {}}}};
      }
      parts = std::move(groups);
    }
  }

  std::uint32_t add(const Part& part) {
    const std::size_t rows = std::size_t{1} << part.inputs.size();
    const std::uint64_t truth = rows == kRows ? part.truth : part.truth & ((std::uint64_t{1} << rows) - 1);
    tables_.push_back({truth, part.inputs});
    return static_cast<std::uint32_t>(tables_.size() - 1);
  }

  /// Removes tables that are not read after all (as in `A and false`).
  void drop_unread() {
    std::vector<bool> read(tables_.size());
    read.back() = true;
    for (std::size_t t = tables_.size(); t-- > 0;) {
      if (!read[t]) continue;
      for (const Input& input : tables_[t].inputs) {
        if (input.is_table) read[input.table] = true;
      }
    }
    std::vector<std::uint32_t> index(tables_.size());
    std::uint32_t kept = 0;
    for (std::size_t t = 0; t < tables_.size(); ++t) {
      if (!read[t]) continue;
      index[t] = kept;
      for (Input& input : tables_[t].inputs) {
        if (input.is_table) input.table = index[input.table];
      }
      if (kept != t) tables_[kept] = std::move(tables_[t]);
      ++kept;
    }
    tables_.resize(kept);
  }

  std::vector<TruthTable> tables_;
};

}  // namespace

std::vector<TruthTable> truth_tables(const Tree& tree) {
  Network network;
  const Part whole = network.part_of(tree);
  return network.finish(whole);
}

}  // namespace symplant::condition

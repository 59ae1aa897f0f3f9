// Makes changes of symbols from the cells of a table.
#include "recording/table_changes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recording/table_values.hpp"

namespace symplant::recording {
namespace {

constexpr std::size_t kMostWarnings = 10;

}  // namespace

std::string TableChanges::at_cell(CellAt at, std::string_view text) const {
  return fmt::format("{}:{}:{}: {}", read_.recording.name, at.line, at.column + 1, text);
}

std::uint32_t TableChanges::add(std::string_view name, CellAt at) {
  Symbol symbol;
  symbol.name = renamer_.symbol_of(name);
  names_.emplace_back(name);
  const auto [found, is_new] = begins_.emplace(symbol.name, at);
  if (!is_new) {
    symbol.left_out = true;
    if (++left_out_ <= kMostWarnings) {
      read_.warnings.push_back(
          at_cell(at, fmt::format("`{}` is in {} {}, too; this one is left out", symbol.name,
                                  found->second.line == at.line ? "column" : "line",
                                  found->second.line == at.line ? found->second.column + 1 : found->second.line)));
    }
  }
  symbols_.push_back(std::move(symbol));
  return static_cast<std::uint32_t>(symbols_.size() - 1);
}

std::uint32_t TableChanges::symbol(std::string_view name, CellAt at) {
  key_ = name;
  const auto found = by_name_.find(key_);
  if (found != by_name_.end()) return found->second;
  const std::uint32_t added = add(name, at);
  by_name_.emplace(key_, added);
  return added;
}

bool TableChanges::take(std::uint32_t number, tables::Time time, std::string_view cell, CellAt at) {
  Symbol& symbol = symbols_[number];
  if (symbol.left_out || (symbol.begun && symbol.cell == cell)) return true;
  if (undo_) undo_->symbols.emplace_back(number, symbol);
  const auto value = cell_value(cell);
  if (!value) {
    if (is_no_value(cell)) {
      if (unknown_++ == 0) first_unknown_ = at_cell(at, fmt::format("`{}`", cell));
      return true;
    }
    if (!symbol.begun) {
      leave_out(symbol, cell, at);
      return true;
    }
    read_.error = at_cell(at, fmt::format("`{}` is not a value; write TRUE, FALSE or a number, or nothing if the value "
                                          "did not change",
                                          cell));
    return false;
  }
  symbol.has_words |= value->kind == CellValue::Kind::word;
  symbol.has_numbers |= value->kind == CellValue::Kind::number;
  if (symbol.has_words && symbol.has_numbers) {
    read_.error =
        at_cell(at, fmt::format("there is `{}`, but `{}` has {} before; write one kind of values", cell, symbol.name,
                                value->kind == CellValue::Kind::word ? "numbers" : "TRUE or FALSE"));
    return false;
  }
  const bool changed = !symbol.begun || symbol.value != value->number;
  symbol.begun = true;
  symbol.cell = cell;
  symbol.value = value->number;
  if (changed) all_.push_back({time, value->number, number});
  return true;
}

void TableChanges::begin_undo() { undo_ = Undo{all_.size(), read_.warnings.size(), left_out_, unknown_, {}}; }

void TableChanges::undo() {
  all_.resize(undo_->changes);
  read_.warnings.resize(undo_->warnings);
  left_out_ = undo_->left_out;
  unknown_ = undo_->unknown;
  for (std::size_t i = undo_->symbols.size(); i-- != 0;) {
    auto& [number, symbol] = undo_->symbols[i];
    symbols_[number] = std::move(symbol);
  }
  undo_.reset();
}

void TableChanges::leave_out(Symbol& symbol, std::string_view cell, CellAt at) {
  symbol.left_out = true;
  if (++left_out_ > kMostWarnings) return;
  read_.warnings.push_back(
      at_cell(at, fmt::format("`{}` has texts, such as `{}`, and is left out", symbol.name, cell)));
}

void TableChanges::finish(tables::Time begin) {
  if (left_out_ > kMostWarnings) {
    read_.warnings.push_back(fmt::format("{}: {} more are left out", read_.recording.name, left_out_ - kMostWarnings));
  }
  if (unknown_ != 0) {
    read_.warnings.push_back(
        fmt::format("{} says that the value is not known; such cells count as empty: {}", first_unknown_, unknown_));
  }
  const auto before = [](const Change& a, const Change& b) { return a.time < b.time; };
  if (!std::is_sorted(all_.begin(), all_.end(), before)) std::stable_sort(all_.begin(), all_.end(), before);
  constexpr std::uint32_t kNoSeries = ~std::uint32_t{0};
  std::vector<std::uint32_t> series(symbols_.size(), kNoSeries);
  for (const Change& change : all_) {
    std::uint32_t& of = series[change.symbol];
    const Symbol& symbol = symbols_[change.symbol];
    if (of == kNoSeries) {
      of = changes_.symbol(symbol.has_numbers ? Series::Kind::number : Series::Kind::boolean, symbol.name);
      read_.recording.series[of].may_be_number = !symbol.has_numbers && !symbol.has_words;
    }
    changes_.add(of, change.time - begin, change.value);
  }
  changes_.finish();
}

}  // namespace symplant::recording

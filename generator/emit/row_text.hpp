// Writes rows of tables as C++, from their fields.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "emit/row_writer.hpp"
#include "symplant/tables/fields.hpp"

namespace symplant::emit {

/// `tables::Comparison::less`
std::string_view enumerator(tables::Comparison value);
std::string_view enumerator(tables::FormulaInputKind value);
std::string_view enumerator(tables::FormulaOp value);
std::string_view enumerator(tables::MalfunctionKind value);
std::string_view enumerator(tables::NumberKind value);
std::string_view enumerator(tables::Operand::Kind value);
std::string_view enumerator(tables::RandomTime::Kind value);
std::string_view enumerator(tables::ReaderKind value);
std::string_view enumerator(tables::RequirementRow::Kind value);
std::string_view enumerator(tables::SensorReads value);
std::string_view enumerator(tables::ValueKind value);

/// The shortest text of a double that C++ reads back as the same bits.
std::string double_text(double value);

/// Writes each field that it gets, with commas between.
class FieldText {
 public:
  explicit FieldText(RowWriter& rows) : rows_(rows) {}

  void operator()(bool value) { next().text(value ? "true" : "false"); }
  void operator()(std::uint8_t value) { next().number(unsigned{value}); }
  void operator()(double value) { next().text(double_text(value)); }
  template <class Number>
  void operator()(tables::Index<Number> index) {
    or_name(index.value, tables::kNone, "tables::kNone");
  }
  template <class Number>
  void operator()(tables::Location<Number> location) {
    or_name(location.value, tables::kOut, "tables::kOut");
  }
  template <class Number>
  void operator()(tables::Position<Number> position) {
    or_name(position.value, tables::kWhole, "tables::kWhole");
  }
  template <class Number>
  void operator()(tables::Count<Number> count) {
    or_name(count.value, tables::kAnyNumber, "tables::kAnyNumber");
  }
  template <class Number>
  void operator()(tables::Bits<Number> bits) {
    next().hex(bits.value);
  }
  template <class Number>
  void operator()(tables::Word<Number> word) {
    next().number(word.value).text("U");
  }
  template <class Number>
  void operator()(tables::UnitPosition<Number> state) {
    if (state.value == tables::kNoState) {
      next().text("tables::kNoState");
    } else {
      or_name(unsigned{state.value}, unsigned{tables::kMovingState}, "tables::kMovingState");
    }
  }
  template <class Number>
  void operator()(tables::Optional<Number> time) {
    if (time.value != 0) next().number(time.value);
  }
  template <class Number>
  void operator()(tables::OptionalIndex<Number> index) {
    if (index.value != tables::kNone) next().number(index.value);
  }
  template <class Number>
  void operator()(tables::OptionalNumber<Number> number) {
    if (number.value != 0) (*this)(number.value);
  }
  template <class Other>
  void operator()(const Other& value) {
    if constexpr (std::is_enum_v<Other>) {
      next().text(enumerator(value));
    } else if constexpr (std::is_integral_v<Other>) {
      next().number(value);
    } else {
      next().text("{");
      fields(value, FieldText(rows_));
      rows_.text("}");
    }
  }

 private:
  RowWriter& next() {
    if (!first_) rows_.text(", ");
    first_ = false;
    return rows_;
  }
  template <class Number>
  void or_name(Number value, Number named, std::string_view name) {
    value == named ? next().text(name) : next().number(value);
  }

  RowWriter& rows_;
  bool first_ = true;
};

/// `    {1, 2},`
template <class Row>
RowWriter& bare_row(RowWriter& rows, const Row& row) {
  rows.text("    ");
  FieldText{rows}(row);
  return rows.text(",");
}

/// `    {1, 2},  // `: the row, and the beginning of its comment.
template <class Row>
RowWriter& row_text(RowWriter& rows, const Row& row) {
  return bare_row(rows, row).text("  // ");
}

}  // namespace symplant::emit

// The names of enumerators in generated rows.
#include "emit/row_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace symplant::emit {
namespace {

template <std::size_t Size, class Enumeration>
std::string_view name_of(const std::array<std::string_view, Size>& names, Enumeration value) {
  return names[static_cast<std::size_t>(value)];
}

}  // namespace

std::string_view enumerator(tables::Comparison value) {
  static constexpr std::array<std::string_view, 5> kNames{
      "tables::Comparison::less", "tables::Comparison::less_equal", "tables::Comparison::equal",
      "tables::Comparison::greater_equal", "tables::Comparison::greater"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::FormulaInputKind value) {
  static constexpr std::array<std::string_view, 7> kNames{"tables::FormulaInputKind::output",
                                                          "tables::FormulaInputKind::truth",
                                                          "tables::FormulaInputKind::operation_value",
                                                          "tables::FormulaInputKind::event_value",
                                                          "tables::FormulaInputKind::parts",
                                                          "tables::FormulaInputKind::weight",
                                                          "tables::FormulaInputKind::time"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::FormulaOp value) {
  static constexpr std::array<std::string_view, 38> kNames{
      "tables::FormulaOp::number",     "tables::FormulaOp::input",  "tables::FormulaOp::negate",
      "tables::FormulaOp::no",         "tables::FormulaOp::add",    "tables::FormulaOp::subtract",
      "tables::FormulaOp::multiply",   "tables::FormulaOp::divide", "tables::FormulaOp::less",
      "tables::FormulaOp::less_equal", "tables::FormulaOp::equal",  "tables::FormulaOp::greater_equal",
      "tables::FormulaOp::greater",    "tables::FormulaOp::all",    "tables::FormulaOp::any",
      "tables::FormulaOp::abs",        "tables::FormulaOp::sign",   "tables::FormulaOp::floor",
      "tables::FormulaOp::ceil",       "tables::FormulaOp::round",  "tables::FormulaOp::sqrt",
      "tables::FormulaOp::exp",        "tables::FormulaOp::ln",     "tables::FormulaOp::sin",
      "tables::FormulaOp::cos",        "tables::FormulaOp::tan",    "tables::FormulaOp::asin",
      "tables::FormulaOp::acos",       "tables::FormulaOp::atan",   "tables::FormulaOp::pow",
      "tables::FormulaOp::mod",        "tables::FormulaOp::atan2",  "tables::FormulaOp::min",
      "tables::FormulaOp::max",        "tables::FormulaOp::wrap",   "tables::FormulaOp::limit",
      "tables::FormulaOp::choose",     "tables::FormulaOp::curve"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::MalfunctionKind value) {
  static constexpr std::array<std::string_view, 7> kNames{
      "tables::MalfunctionKind::slower",  "tables::MalfunctionKind::stuck", "tables::MalfunctionKind::force",
      "tables::MalfunctionKind::flicker", "tables::MalfunctionKind::lose",  "tables::MalfunctionKind::set",
      "tables::MalfunctionKind::distort"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::NumberKind value) {
  static constexpr std::array<std::string_view, 3> kNames{
      "tables::NumberKind::signed_integer", "tables::NumberKind::unsigned_integer", "tables::NumberKind::real"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::Operand::Kind value) {
  static constexpr std::array<std::string_view, 6> kNames{
      "tables::Operand::Kind::number",      "tables::Operand::Kind::output", "tables::Operand::Kind::operation_value",
      "tables::Operand::Kind::event_value", "tables::Operand::Kind::parts",  "tables::Operand::Kind::weight"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::RandomTime::Kind value) {
  static constexpr std::array<std::string_view, 3> kNames{
      "tables::RandomTime::Kind::uniform", "tables::RandomTime::Kind::normal", "tables::RandomTime::Kind::seconds"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::ReaderKind value) {
  static constexpr std::array<std::string_view, 13> kNames{
      "tables::ReaderKind::unit",         "tables::ReaderKind::condition",   "tables::ReaderKind::requirement",
      "tables::ReaderKind::follow",       "tables::ReaderKind::drive",       "tables::ReaderKind::stop",
      "tables::ReaderKind::end",          "tables::ReaderKind::transfer",    "tables::ReaderKind::work",
      "tables::ReaderKind::source",       "tables::ReaderKind::malfunction", "tables::ReaderKind::change",
      "tables::ReaderKind::formula_input"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::RequirementRow::Kind value) {
  static constexpr std::array<std::string_view, 2> kNames{"tables::RequirementRow::Kind::never",
                                                          "tables::RequirementRow::Kind::expect"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::SensorReads value) {
  static constexpr std::array<std::string_view, 3> kNames{"tables::SensorReads::part", "tables::SensorReads::code",
                                                          "tables::SensorReads::number"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::ValueKind value) {
  static constexpr std::array<std::string_view, 11> kNames{
      "tables::ValueKind::parameter", "tables::ValueKind::integral", "tables::ValueKind::lag",
      "tables::ValueKind::ramp",      "tables::ValueKind::delay",    "tables::ValueKind::derivative",
      "tables::ValueKind::is",        "tables::ValueKind::position", "tables::ValueKind::noise",
      "tables::ValueKind::pid",       "tables::ValueKind::linear"};
  return name_of(kNames, value);
}

std::string double_text(double value) {
  if (std::isinf(value)) return value < 0 ? "-tables::kInfinity" : "tables::kInfinity";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

}  // namespace symplant::emit

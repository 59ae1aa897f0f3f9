// The names of enumerators in generated rows.
#include "emit/row_text.hpp"

#include <array>

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

std::string_view enumerator(tables::MalfunctionKind value) {
  static constexpr std::array<std::string_view, 5> kNames{
      "tables::MalfunctionKind::slower", "tables::MalfunctionKind::stuck", "tables::MalfunctionKind::force",
      "tables::MalfunctionKind::flicker", "tables::MalfunctionKind::lose"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::NumberKind value) {
  static constexpr std::array<std::string_view, 3> kNames{
      "tables::NumberKind::signed_integer", "tables::NumberKind::unsigned_integer", "tables::NumberKind::real"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::RandomTime::Kind value) {
  static constexpr std::array<std::string_view, 2> kNames{"tables::RandomTime::Kind::uniform",
                                                          "tables::RandomTime::Kind::normal"};
  return name_of(kNames, value);
}

std::string_view enumerator(tables::ReaderKind value) {
  static constexpr std::array<std::string_view, 11> kNames{
      "tables::ReaderKind::unit",   "tables::ReaderKind::condition",  "tables::ReaderKind::requirement",
      "tables::ReaderKind::follow", "tables::ReaderKind::drive",      "tables::ReaderKind::stop",
      "tables::ReaderKind::end",    "tables::ReaderKind::transfer",   "tables::ReaderKind::work",
      "tables::ReaderKind::source", "tables::ReaderKind::malfunction"};
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

}  // namespace symplant::emit

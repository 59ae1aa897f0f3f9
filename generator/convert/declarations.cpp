// Declarations of variables in IEC 61131-3, as structured text and PLCopen XML have them.
#include "convert/declarations.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "convert/losses.hpp"
#include "convert/types.hpp"
#include "model/classify.hpp"

namespace symplant::convert {
namespace {

constexpr Loss kLengthLost{"length of a string is not written", "lengths of strings are not written",
                           "OpenPLC has strings of one length only"};
constexpr Loss kOtherSize{"address is not written", "addresses are not written",
                          "OpenPLC locates only a type of the same size as the address"};
constexpr Loss kOpenAddress{"address is left to the target", "addresses are left to the target",
                            "declared as `AT %I*` or `AT %Q*`; link each to a terminal"};

/// Types of the third edition of IEC 61131-3, and the string that the compiler of OpenPLC lacks.
constexpr std::array<std::string_view, 5> kLaterTypes{"CHAR", "WCHAR", "LTIME", "LTOD", "WSTRING"};

bool is_later(std::string_view type) {
  return std::find(kLaterTypes.begin(), kLaterTypes.end(), type.substr(0, type.find('['))) != kLaterTypes.end();
}

/// The type as OpenPLC has it.
std::optional<std::string> program_type(std::string type) {
  if (const auto array = array_type(type)) {
    const std::string_view element = array->element;
    return is_later(element) || !string_length(element).empty() ? std::nullopt : std::optional(std::move(type));
  }
  if (is_later(type)) return std::nullopt;
  return string_length(type).empty() ? std::move(type) : "STRING";
}

bool fits(const Symbol& symbol, std::string_view type) {
  const auto data_type = model::data_type(type);
  return data_type && symbol.address && model::data_type_bits(*data_type) == static_cast<int>(symbol.address->size);
}

}  // namespace

std::optional<std::string> Declarations::type_of(const Symbol& symbol) const {
  auto type = iec_type(symbol);
  return type && dialect_.program ? program_type(std::move(*type)) : type;
}

Declarations::Declarations(const Writing& writing) : symbols_(writing.symbols), dialect_(writing.dialect) {
  std::vector<std::uint32_t> declared;
  for (std::uint32_t i = 0; i < symbols_->all.size(); ++i) {
    const Symbol& symbol = symbols_->all[i];
    const auto type = type_of(symbol);
    if (!type) {
      writing.report.add(kUnknownType, symbol.row->name);
      continue;
    }
    report(symbol, *type, writing.report);
    declared.push_back(i);
    written_.add(symbol);
  }
  names_.emplace(*symbols_, declared, kIecNames, writing.report);
  group(Kind::input, "inputs", declared);
  group(Kind::output, "outputs", declared);
  group(Kind::internal, "other variables", declared);
  group(Kind::constant, "constants", declared);
}

Declaration Declarations::operator[](std::uint32_t symbol) const {
  const Symbol& of = symbols_->all[symbol];
  std::string type = type_of(of).value_or("");
  std::string initial = iec_literal(of.row->initial, type).value_or("");
  return {(*names_)[symbol], address_of(of), std::move(type), std::move(initial), of.row->comment};
}

void Declarations::report(const Symbol& symbol, const std::string& type, Report& report) const {
  const std::string_view name = symbol.row->name;
  const std::string address = address_of(symbol);
  if (dialect_.program && type == "STRING" && !string_length(symbol.row->type).empty()) report.add(kLengthLost, name);
  if (address.empty() && !address_in(symbol, dialect_.addresses).empty()) {
    report.add(kOtherSize, name);
  } else if (address.ends_with('*')) {
    report.add(kOpenAddress, name);
  } else if (address.empty() && !source_address(symbol).empty()) {
    report.add(kNoEquivalentAddress, name);
  } else if (!address.empty() && is_bit_of_word(symbol)) {
    report.add(kBitOfWord, name);
  }
  if (!iec_literal(symbol.row->initial, type)) report.add(kUnknownInitial, name);
  report_scope(symbol, report);
}

std::string Declarations::address_of(const Symbol& symbol) const {
  if (symbol.kind == Kind::constant) return {};
  std::string address = address_in(symbol, dialect_.addresses);
  if (dialect_.program && !fits(symbol, type_of(symbol).value_or(""))) return {};
  if (!address.empty() || !dialect_.open_addresses) return address;
  return symbol.kind == Kind::input ? "%I*" : symbol.kind == Kind::output ? "%Q*" : "";
}

void Declarations::group(Kind kind, std::string_view title, const std::vector<std::uint32_t>& declared) {
  DeclarationGroup located{title, kind, true, {}};
  DeclarationGroup rest{title, kind, false, {}};
  for (const std::uint32_t i : declared) {
    const Symbol& symbol = symbols_->all[i];
    if (symbol.kind != kind) continue;
    const bool apart = dialect_.program && !address_of(symbol).empty();
    (apart ? located : rest).symbols.push_back(i);
  }
  for (DeclarationGroup* made : {&located, &rest}) {
    if (!made->symbols.empty()) groups_.push_back(std::move(*made));
  }
}

}  // namespace symplant::convert

// Declarations of variables in IEC 61131-3, as structured text and PLCopen XML have them.
#include "convert/declarations.hpp"

#include <utility>

#include "convert/losses.hpp"
#include "convert/types.hpp"

namespace symplant::convert {
namespace {

constexpr Loss kOpenAddress{"address is left to the target", "addresses are left to the target",
                            "declared as `AT %I*` or `AT %Q*`; link each to a terminal"};

}  // namespace

Declarations::Declarations(const Writing& writing) : symbols_(writing.symbols), dialect_(writing.dialect) {
  std::vector<std::uint32_t> declared;
  for (std::uint32_t i = 0; i < symbols_->all.size(); ++i) {
    const Symbol& symbol = symbols_->all[i];
    const auto type = iec_type(symbol);
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
  std::string type = iec_type(of).value_or("");
  std::string initial = iec_literal(of.row->initial, type).value_or("");
  return {(*names_)[symbol], address_of(of), std::move(type), std::move(initial), of.row->comment};
}

void Declarations::report(const Symbol& symbol, const std::string& type, Report& report) const {
  const std::string_view name = symbol.row->name;
  const std::string address = address_of(symbol);
  if (address.ends_with('*')) {
    report.add(kOpenAddress, name);
  } else if (address.empty() && !source_address(symbol).empty()) {
    report.add(kNoEquivalentAddress, name);
  }
  if (!iec_literal(symbol.row->initial, type)) report.add(kUnknownInitial, name);
  report_scope(symbol, report);
}

std::string Declarations::address_of(const Symbol& symbol) const {
  if (symbol.kind == Kind::constant) return {};
  std::string address = address_in(symbol, dialect_.addresses);
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

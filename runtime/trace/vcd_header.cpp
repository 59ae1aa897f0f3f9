// The variables of a VCD file.
#include "symplant/trace/vcd_header.hpp"

#include <fmt/format.h>

#include <map>

#include "symplant/tables/version.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/trace/value_traces.hpp"

namespace symplant::trace {
namespace {

/// A level of paths, with the units whose path ends there.
struct Scope {
  std::string name;
  std::vector<std::uint32_t> units;
  std::vector<Scope> children;                 ///< in the order of their first unit
  std::map<std::string, std::size_t> indexes;  ///< a child's name -> its index in children
};

Scope& child_of(Scope& scope, std::string_view name) {
  const auto [found, is_new] = scope.indexes.try_emplace(std::string(name), scope.children.size());
  if (is_new) scope.children.emplace_back().name = vcd_name(name);
  return scope.children[found->second];
}

Scope scopes_of(const PlantNames& names) {
  Scope root;
  root.name = vcd_name(names.tables().name);
  for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) {
    std::string_view path = names.unit(unit);
    Scope* scope = &root;
    for (;;) {
      const std::size_t end = path.find_first_of("_.");
      const std::string_view level = path.substr(0, end);
      if (!level.empty()) scope = &child_of(*scope, level);
      if (end == path.npos) break;
      path.remove_prefix(end + 1);
    }
    scope->units.push_back(unit);
  }
  return root;
}

void write_symbol(std::string& text, const PlantNames& names, std::uint32_t symbol) {
  const tables::DataType type = names.tables().symbols[symbol].type();
  text += fmt::format("$var {} {} {} {} $end\n", is_real(type) ? "real" : "wire", is_real(type) ? 64 : width(type),
                      vcd_identifier(symbol), vcd_name(names.symbol(symbol)));
}

/// `$comment signed ! # $end`: VCD itself cannot say that the bits of a variable have a sign.
std::string signed_symbols(const PlantNames& names) {
  std::string text;
  for (std::uint32_t symbol = 0; symbol < names.tables().symbols.size(); ++symbol) {
    if (is_signed(names.tables().symbols[symbol].type())) text += " " + vcd_identifier(symbol);
  }
  return text.empty() ? text : "$comment signed" + text + " $end\n";
}

void write_malfunctions(std::string& text, const PlantNames& names) {
  text += "$scope module malfunctions $end\n";
  for (std::uint32_t m = 0; m < names.tables().malfunctions.size(); ++m) {
    text += fmt::format("$var wire 1 {} {} $end\n", vcd_identifier(first_malfunction(names.tables()) + m),
                        vcd_name(names.malfunction(m)));
  }
  text += "$upscope $end\n";
}

void write_scope(std::string& text, const PlantNames& names, const Scope& scope, bool is_root) {
  text += "$scope module " + scope.name + " $end\n";
  const auto symbols = static_cast<std::uint32_t>(names.tables().symbols.size());
  for (const std::uint32_t unit : scope.units) {
    text += fmt::format("$var string 1 {} {} $end\n", vcd_identifier(std::size_t{symbols} + unit),
                        vcd_name(names.unit(unit)));
    for (const std::uint32_t symbol : names.symbols_of(unit)) write_symbol(text, names, symbol);
  }
  for (std::uint32_t symbol = 0; is_root && symbol < symbols; ++symbol) {
    if (names.tables().symbols[symbol].unit == tables::kNone) write_symbol(text, names, symbol);
  }
  const tables::MaterialTables& material = names.tables().material;
  const std::size_t first = std::size_t{symbols} + names.tables().units.size();
  for (std::uint32_t location = 0; is_root && location < material.locations(); ++location) {
    text += fmt::format("$var {} {} {} $end\n", material.is_track(location) ? "integer 32" : "string 1",
                        vcd_identifier(first + location), vcd_name(names.location(location)));
  }
  const std::vector<tables::Time> traces = is_root ? traces_of(names.tables().values) : std::vector<tables::Time>();
  for (std::uint32_t output = 0; output < traces.size(); ++output) {
    if (traces[output] == 0) continue;
    text += fmt::format("$var real 64 {} {} $end\n", vcd_identifier(first_output(names.tables()) + output),
                        vcd_name(names.output(output)));
  }
  if (is_root && !names.tables().malfunctions.empty()) write_malfunctions(text, names);
  for (const Scope& child : scope.children) write_scope(text, names, child, false);
  text += "$upscope $end\n";
}

}  // namespace

std::size_t first_malfunction(const tables::PlantTables& tables) {
  return tables.symbols.size() + tables.units.size() + tables.material.locations();
}

std::size_t first_output(const tables::PlantTables& tables) {
  return first_malfunction(tables) + tables.malfunctions.size();
}

std::string vcd_identifier(std::size_t number) {
  constexpr std::size_t kDigits = 94;  // from ! to ~
  std::string text;
  do {
    text += static_cast<char>('!' + number % kDigits);
    number /= kDigits;
  } while (number-- != 0);
  return text;
}

std::string vcd_name(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    if (byte < 0x80) {
      text += byte <= ' ' || byte == 0x7F ? '_' : name[i];
      continue;
    }
    const unsigned more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;  // names are UTF-8
    unsigned code = byte & (0x3FU >> more);
    for (unsigned k = 0; k < more && i + 1 < name.size(); ++k) {
      code = code << 6 | (static_cast<unsigned char>(name[++i]) & 0x3FU);
    }
    text += fmt::format("u{:04X}", code);
  }
  return text.empty() ? "_" : text;
}

std::string vcd_string(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= ' ' || byte >= 0x7F || c == '\\') {
      escaped += fmt::format("\\x{:02X}", byte);
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string vcd_header(const PlantNames& names) {
  std::string text = fmt::format("$version symplant {} $end\n$timescale 1 ns $end\n", tables::version());
  text += signed_symbols(names);
  write_scope(text, names, scopes_of(names), true);
  return text + "$enddefinitions $end\n";
}

}  // namespace symplant::trace

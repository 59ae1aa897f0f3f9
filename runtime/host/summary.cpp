// A short summary of a plant.
#include "symplant/host/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "symplant/host/words.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/row_of.hpp"
#include "symplant/trace/name_index.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::host {
namespace {

constexpr std::size_t kNamesShown = 8;

/// `d_ext, l_leave`
std::string functions_text(std::uint8_t replaced) {
  using tables::ModelFunction;
  std::string text;
  for (const auto& [function, name] :
       {std::pair{ModelFunction::d_ext, "d_ext"}, std::pair{ModelFunction::d_int, "d_int"},
        std::pair{ModelFunction::l_enter, "l_enter"}, std::pair{ModelFunction::l_leave, "l_leave"}}) {
    if ((replaced & static_cast<std::uint8_t>(function)) != 0) text.append(text.empty() ? "" : ", ").append(name);
  }
  return text;
}

/// Whether an event is driven, or an operation moves a device or is read. `has_code`: of the behavior of each unit.
bool has_effect(const why::SymbolUse& use, std::uint32_t symbol, const std::vector<bool>& has_code) {
  const why::SymbolDriver driver = use.driver(symbol);
  if (driver.kind == why::SymbolDriver::Kind::behavior ? has_code[driver.unit]
                                                       : driver.kind != why::SymbolDriver::Kind::none) {
    return true;
  }
  const auto readers = use.readers(symbol);
  return std::any_of(readers.begin(), readers.end(), [&](const why::SymbolReader& reader) {
    return reader.kind != why::SymbolReader::Kind::behavior || has_code[reader.index];
  });
}

}  // namespace

std::string lists_text(const tables::PlantTables& tables) {
  const auto names = tables::split_names(tables.list_names);
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kNamesShown; ++i) text.append(i == 0 ? "" : ", ").append(names[i]);
  if (names.size() > kNamesShown) text += fmt::format(" and {} more", names.size() - kNamesShown);
  return text;
}

std::string summary(const tables::PlantTables& tables, std::uint64_t model_hash, std::span<const std::string_view> more,
                    std::span<const engine::Behaviour> behaviours) {
  const why::SymbolUse use(tables);
  std::vector<bool> has_code(tables.units.size());
  for (const tables::BehaviourUnit& unit : tables.behaviour_units) has_code[unit.unit] = unit.name < behaviours.size();
  std::size_t operations = 0;
  std::size_t used_operations = 0;
  std::size_t undriven = 0;
  std::vector<std::size_t> undriven_shown;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const bool acts = has_effect(use, i, has_code);
    if (tables.symbols[i].direction() == tables::Direction::operation) {
      ++operations;
      if (acts) ++used_operations;
    } else if (!acts) {
      ++undriven;
      if (undriven_shown.size() < kNamesShown) undriven_shown.push_back(i);
    }
  }
  const std::size_t events = tables.symbols.size() - operations;
  std::vector<bool> moves(tables.units.size());
  for (const tables::SymbolRow& symbol : tables.symbols) {
    if (symbol.unit != tables::kNone && symbol.moved()) moves[symbol.unit] = true;
  }

  std::string text = fmt::format("plant {}: {} from {} ({}, {}), model {:016x}\n", shown(tables.name),
                                 plural(tables.symbols.size(), "I/O symbol"), shown(lists_text(tables)),
                                 plural(operations, "operation"), plural(events, "event"), model_hash);
  for (const std::string_view line : more) text.append(line).append("\n");
  text += fmt::format("can move: {} of {}, using {} of {}\n", std::count(moves.begin(), moves.end(), true),
                      plural(tables.units.size(), "device"), used_operations, plural(operations, "operation"));
  text += fmt::format("not driven: {} of {}", undriven, plural(events, "event"));
  const trace::NameIndex names(tables.symbol_names);
  for (std::size_t i = 0; i < undriven_shown.size(); ++i) {
    text += fmt::format("{} {}", i == 0 ? ":" : ",", shown(names[2 * undriven_shown[i]]));
  }
  if (undriven > kNamesShown) text += fmt::format(" and {} more", undriven - kNamesShown);
  return text + "\n";
}

std::string cut_link_lines(const tables::PlantTables& tables, const std::vector<bool>& with_program) {
  const auto names = tables::split_names(tables.malfunctions.names);
  std::string text;
  for (std::size_t m = 0; m < names.size(); ++m) {
    const auto effects = tables.malfunctions.effects_of(static_cast<std::uint32_t>(m));
    const bool cuts = std::any_of(effects.begin(), effects.end(), [&](const tables::EffectRow& effect) {
      return effect.kind == tables::MalfunctionKind::lose &&
             (effect.subject >= with_program.size() || !with_program[effect.subject]);
    });
    if (!cuts) continue;
    text +=
        fmt::format("malfunction `{}` has no effect in virtual time: it cuts a link, which runs in real time only\n",
                    shown(names[m]));
  }
  return text;
}

std::string behaviour_lines(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours) {
  const auto names = tables::split_names(tables.behaviour_names);
  std::string text;
  for (std::size_t b = 0; b < names.size(); ++b) {
    const auto devices = std::count_if(tables.behaviour_units.begin(), tables.behaviour_units.end(),
                                       [&](const tables::BehaviourUnit& unit) { return unit.name == b; });
    if (b < behaviours.size()) {
      if (behaviours[b].replaces == 0) continue;
      text += fmt::format("behavior `{}` replaces {} of {}\n", shown(names[b]), functions_text(behaviours[b].replaces),
                          plural(static_cast<std::size_t>(devices), "device"));
      continue;
    }
    text += fmt::format(
        "behavior `{}` of {} has no code in this program, the derived model applies; to include its code, use "
        "`symplant generate`\n",
        shown(names[b]), plural(static_cast<std::size_t>(devices), "device"));
  }
  return text;
}

std::string formula_lines(const tables::ValueTables& values) {
  const auto texts = tables::split_names(values.formula_texts);
  std::string text;
  for (std::size_t f = 0; f < values.compiled.size(); ++f) {
    if (values.compiled[f].replaced) text += fmt::format("formula `{}` is replaced by C++\n", shown(texts[f]));
  }
  return text;
}

}  // namespace symplant::host

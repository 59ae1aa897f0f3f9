// From a list as text to the results of each stage, in memory.
#pragma once

#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/pipeline.hpp"
#include "check/catalogue.hpp"
#include "findings/finish.hpp"
#include "lower/lower.hpp"
#include "model/derive.hpp"
#include "name/named_table.hpp"
#include "naming/load.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {

/// One row of a list. `address` is a vendor address, `iec` an IEC address.
struct Row {
  std::string name;
  std::string address = {};
  std::string type = "BOOL";
  std::string initial = "FALSE";
  std::string iec = {};
  std::string klass = "VAR_GLOBAL";
};

inline std::string list_text(const std::vector<Row>& rows) {
  std::string text = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  for (const Row& row : rows) {
    text += row.klass + "," + row.name + "," + row.address + "," + row.iec + "," + row.type + "," + row.initial + "\n";
  }
  return text;
}

/// BOOL rows of these names, each with a separate IEC address: `%QX` if the name contains `_O_`, else `%IX`. A `*`
/// after a name sets Initial TRUE.
inline std::vector<Row> bits(const std::vector<std::string>& names) {
  std::vector<Row> rows;
  for (std::string name : names) {
    const bool on = name.back() == '*';
    if (on) name.pop_back();
    const bool operation = name.find("_O_") != std::string::npos || name.find("_o_") != std::string::npos;
    rows.push_back(
        {name, "", "BOOL", on ? "TRUE" : "FALSE", (operation ? "%QX" : "%IX") + std::to_string(rows.size())});
  }
  return rows;
}

struct Analysed {
  std::optional<model::Derived> derived;
  diag::Diagnostics diagnostics;

  const model::PlantModel& model() const { return derived->plant; }
  const model::Evidence& evidence() const { return derived->evidence; }
  /// The number of findings of a rule.
  std::size_t count(std::string_view slug) const {
    std::size_t count = 0;
    for (const diag::Diagnostic& finding : diagnostics.all()) count += finding.rule->slug == slug ? 1U : 0U;
    return count;
  }
  /// Every rule that fired, in order, separated by blanks.
  std::string fired() const {
    std::string text;
    for (const diag::Diagnostic& finding : diagnostics.all()) {
      text += (text.empty() ? "" : " ") + std::string(finding.rule->slug);
    }
    return text;
  }
  /// The findings with at least this severity.
  std::string fired(diag::Severity least) const {
    std::string text;
    for (const diag::Diagnostic& finding : diagnostics.all()) {
      if (finding.severity < least) continue;
      text += (text.empty() ? "" : " ") + std::string(finding.rule->slug);
    }
    return text;
  }
};

inline Analysed analyse_text(const std::string& text, std::optional<address::Radix> xy = {},
                             const std::string& name = "symbols.csv") {
  MemoryFileSystem files;
  files.files[name] = text;
  std::ostringstream err;
  app::Progress progress(err, false);
  Analysed result;
  if (auto compiled = app::compile({name, {}, xy}, files, progress, result.diagnostics)) {
    result.derived = model::Derived{std::move(compiled->plant), std::move(compiled->evidence)};
  }
  return result;
}

inline Analysed analyse_rows(const std::vector<Row>& rows, std::optional<address::Radix> xy = {}) {
  return analyse_text(list_text(rows), xy);
}

/// One list of a plant with several lists.
struct GivenList {
  std::string file;
  std::string text;
  std::string controller = {};
  std::optional<address::Radix> xy = {};
};

/// Reads lists and their names, builds their plant with a description, checks it: compile() with what plant.json would
/// say.
inline Analysed analyse_lists(const std::vector<GivenList>& given, description::Description description = {},
                              std::string_view today = {}, const findings::Selection& selection = {},
                              std::shared_ptr<const name::CompiledNaming> naming = naming::strict_naming()) {
  MemoryFileSystem files;
  Analysed result;
  const auto reader = std::make_shared<name::SymbolReader>(std::move(naming));
  std::vector<model::ListInput> lists;
  for (const GivenList& list : given) {
    files.files[list.file] = list.text;
    auto read = read::read_symbol_list(list.file, {}, files, result.diagnostics);
    const auto table = std::make_shared<const read::SymbolTable>(std::move(read.value()));
    lists.push_back({table, name::read_names(*table, *reader), list.controller, list.xy});
  }
  const auto shared = std::make_shared<const description::Description>(std::move(description));
  result.derived = model::describe(model::derive(lists, "symbols", reader, shared.get()), shared);
  const model::PlantModel& plant = result.model();
  check::check_plant(plant, result.evidence(), result.diagnostics);
  result.diagnostics = findings::finish(std::move(result.diagnostics), plant.description->check, today, selection);
  result.diagnostics.sort_by_location(plant.sources());
  return result;
}

/// By a custom naming rule.
inline Analysed analyse_by_rule(name::Naming naming, const std::vector<GivenList>& given,
                                description::Description description = {}) {
  std::vector<name::NamingFault> faults;
  auto compiled = name::CompiledNaming::compile(std::move(naming), faults);
  if (compiled == nullptr) throw std::invalid_argument(faults.front().pointer + ": " + faults.front().message);
  return analyse_lists(given, std::move(description), {}, {}, compiled);
}

/// A list whose table `change` changes after it was read, such as to another notation of addresses.
template <class Change>
Analysed analyse_changed(const std::vector<Row>& rows, Change change, description::Description description = {}) {
  MemoryFileSystem files;
  files.files["symbols.csv"] = list_text(rows);
  Analysed result;
  auto table = read::read_symbol_list("symbols.csv", {}, files, result.diagnostics).value();
  change(table);
  const auto kept = std::make_shared<const read::SymbolTable>(std::move(table));
  const auto reader = std::make_shared<name::SymbolReader>(naming::strict_naming());
  result.derived = model::describe(model::derive({{kept, name::read_names(*kept, *reader)}}, "symbols", reader),
                                   std::make_shared<const description::Description>(std::move(description)));
  check::check_plant(result.model(), result.evidence(), result.diagnostics);
  return result;
}

/// A list in the notation of another vendor.
inline Analysed analyse_in(address::Notation notation, const std::vector<Row>& rows,
                           description::Description description = {}) {
  return analyse_changed(
      rows, [&](read::SymbolTable& table) { table.notation = notation; }, std::move(description));
}

inline Analysed analyse_described(const std::string& text, description::Description description) {
  return analyse_lists({{"symbols.csv", text}}, std::move(description));
}

inline Analysed analyse_described(const std::vector<Row>& rows, description::Description description) {
  return analyse_described(list_text(rows), std::move(description));
}

struct CompiledText {
  std::optional<app::Compiled> compiled;
  diag::Diagnostics diagnostics;

  const model::PlantModel& plant() const { return compiled->plant; }
  const lower::EngineTables& tables() const { return compiled->tables; }
};

inline CompiledText compile_text(const std::string& text, const std::string& name = "symbols.csv") {
  MemoryFileSystem files;
  files.files[name] = text;
  std::ostringstream err;
  app::Progress progress(err, false);
  CompiledText result;
  result.compiled = app::compile({name, {}, {}}, files, progress, result.diagnostics);
  if (check::has_stopping_errors(result.diagnostics)) result.compiled.reset();
  return result;
}

inline CompiledText compile_rows(const std::vector<Row>& rows) { return compile_text(list_text(rows)); }

/// The tables of a valid plant; empty for any other.
inline CompiledText lower_analysed(Analysed analysed) {
  CompiledText result;
  result.diagnostics = std::move(analysed.diagnostics);
  if (check::has_stopping_errors(result.diagnostics) || !analysed.evidence().faults.empty()) return result;
  lower::EngineTables tables = lower::lower(analysed.model());
  result.compiled =
      app::Compiled{std::move(analysed.derived->plant), std::move(analysed.derived->evidence), std::move(tables)};
  return result;
}

/// compile() with a description; nothing if the description or the list has a fault.
inline CompiledText compile_described(const std::vector<Row>& rows, description::Description description) {
  return lower_analysed(analyse_described(rows, std::move(description)));
}

inline CompiledText compile_lists(const std::vector<GivenList>& given, description::Description description = {}) {
  return lower_analysed(analyse_lists(given, std::move(description)));
}

}  // namespace symplant::test

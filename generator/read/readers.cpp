// The table of readers, and reading a symbol list of any known format.
#include "read/readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "read/formats.hpp"
#include "read/loading.hpp"
#include "read/parts.hpp"
#include "read/recognized.hpp"
#include "read/rules/cannot_read_file.hpp"
#include "read/rules/no_such_part.hpp"
#include "read/rules/recognized_format.hpp"
#include "read/rules/unknown_format.hpp"
#include "read/rules/unknown_input_format.hpp"
#include "read/rules/unreadable_workbook.hpp"
#include "read/types/expand_arrays.hpp"

namespace symplant::read {

namespace {

constexpr std::array kReaders{
    &kGxIec,             //
    &kGxWorksLabels,     //
    &kGxWorksComments,   //
    &kAutomationMl,      //
    &kBrIoMapping,       //
    &kCodesysExp,        //
    &kCodesysIoMapping,  //
    &kKepware,           //
    &kLsGlobals,         //
    &kLsTags,            //
    &kOmronCxt,          //
    &kPlcopen,           //
    &kRockwellCsv,       //
    &kRockwellL5k,       //
    &kRockwellL5x,       //
    &kSchneiderXsy,      //
    &kStep7Asc,          //
    &kStep7Sdf,          //
    &kStructuredText,    //
    &kSysmac,            //
    &kTiaOpenness,       //
    &kTiaSdf,            //
    &kTiaTagTable,       //
    &kTiaTags,           //
    &kTwincatGvl,        //
    &kOwnTable,          //
    &kAnyTable,          //
};

std::string known_names() {
  std::string names;
  for (const ReaderInfo* reader : kReaders) {
    names.append(names.empty() ? "`" : ", `").append(reader->name).append("`");
  }
  return names;
}

struct Choice {
  const ReaderInfo* reader = nullptr;
  int likelihood = 0;
};

/// The whole lines at the begin of a text, by which its format is recognized.
std::string_view beginning(std::string_view text) {
  constexpr std::size_t kExamined = 4 << 20;
  if (text.size() <= kExamined) return text;
  const std::size_t line_end = text.rfind('\n', kExamined);
  return text.substr(0, line_end == std::string_view::npos ? kExamined : line_end + 1);
}

/// The requested reader, or the likeliest; null if the text is of no known format.
Choice choose(const ReadOptions& options, std::string_view text) {
  Choice best;
  const std::string_view begin = beginning(text);
  if (options.input_format.empty() && options.columns.columns.empty() && recognize_table(begin)) return best;
  for (const ReaderInfo* reader : kReaders) {
    const bool asked_for = reader->name == options.input_format;
    if (!asked_for && !options.input_format.empty()) continue;
    const int mine = reader->likelihood(begin);
    if (asked_for) return {reader, std::max(mine, 1)};
    if (mine > best.likelihood) best = {reader, mine};
  }
  if (!options.columns.columns.empty() && options.input_format.empty())
    return {&kAnyTable, std::max(best.likelihood, 1)};
  return best;
}

void report_unknown(const LoadedText& text, diag::Diagnostics& diagnostics) {
  const diag::Location begin{text.source, text.source->span_of(text.source->line_at(0))};
  auto known = recognize_table(beginning(text.source->text()));
  if (!known) known = recognize_text(text.source->text());
  if (!known) known = recognize_bytes(text.source->path(), text.source->text());
  if (known) {
    diagnostics.add(kRecognizedFormat, fmt::format("this is {}; {}", known->what, known->advice), begin);
    return;
  }
  diagnostics.add(
      kUnknownFormat,
      "this is no known symbol list: found neither a column of names and one of addresses, nor a class such "
      "as `VAR_GLOBAL`; export the symbols as text or as a workbook, or give the columns with `--columns "
      "name=...,address=...`",
      begin);
}

/// The text with the likeliest list; null if an error was added: no list, or several sheets with one.
const LoadedText* choose_text(const std::vector<LoadedText>& texts, const ReadOptions& options, Choice& choice,
                              diag::Diagnostics& diagnostics) {
  const LoadedText* best = nullptr;
  const LoadedText* rival = nullptr;
  for (const LoadedText& text : texts) {
    const Choice mine = choose(options, text.source->text());
    if (mine.likelihood == 0 || mine.likelihood < choice.likelihood) continue;
    rival = mine.likelihood == choice.likelihood ? best : nullptr;
    best = &text;
    choice = mine;
  }
  if (best == nullptr) {
    report_unknown(texts.front(), diagnostics);
  } else if (rival != nullptr) {
    diagnostics.add(kUnreadableWorkbook,
                    fmt::format("the workbook has several sheets with symbols, such as `{}` and `{}`; choose one with "
                                "`--columns sheet=...`, or in plant.json with `\"columns\": {{ \"sheet\": ... }}`",
                                rival->sheet, best->sheet),
                    {best->source, best->source->span_of(best->source->line_at(0))});
    return nullptr;
  }
  return best;
}

/// False, with an error, if there is no such part.
bool select_part(SymbolTable& table, const ReadOptions& options, diag::Diagnostics& diagnostics) {
  const std::vector<std::size_t> begins = find_parts(table, options.xy.value_or(address::Radix::hexadecimal));
  if (keep_part(table, options.part, begins)) {
    table.decisions.push_back(
        fmt::format("part: {} of {}, {} rows", options.part, begins.size() + 1, table.rows.size()));
    return true;
  }
  diagnostics.add(
      kNoSuchPart,
      fmt::format("this text holds {} list{}, so it has no part {}; write a number up to {}, or omit `\"part\"`",
                  begins.size() + 1, begins.empty() ? "" : "s", options.part, begins.size() + 1),
      {table.source, table.source->span_of(table.source->line_at(0))});
  return false;
}

bool is_known_format(const ReadOptions& options, diag::Diagnostics& diagnostics) {
  const auto is_asked_for = [&](const ReaderInfo* reader) { return reader->name == options.input_format; };
  if (options.input_format.empty() || std::any_of(kReaders.begin(), kReaders.end(), is_asked_for)) return true;
  diagnostics.add(kUnknownInputFormat,
                  "unknown list format `" + options.input_format + "`; choose one of " + known_names(), {});
  return false;
}

}  // namespace

std::span<const ReaderInfo* const> readers() { return kReaders; }

std::optional<SymbolTable> read_symbol_list(const std::string& path, const ReadOptions& options,
                                            const base::FileSystem& files, diag::Diagnostics& diagnostics) {
  if (!is_known_format(options, diagnostics)) return std::nullopt;
  auto bytes = files.read(path);
  if (bytes) return read_symbol_list(path, std::move(*bytes), options, diagnostics);
  diagnostics.add(kCannotReadFile, bytes.error().message, whole_file(path));
  return std::nullopt;
}

std::optional<SymbolTable> read_symbol_list(const std::string& path, std::string bytes, const ReadOptions& options,
                                            diag::Diagnostics& diagnostics) {
  if (!is_known_format(options, diagnostics)) return std::nullopt;
  const std::vector<LoadedText> texts = load_texts(path, std::move(bytes), options, diagnostics);
  if (texts.empty()) return std::nullopt;
  Choice choice;
  const LoadedText* const text = choose_text(texts, options, choice, diagnostics);
  if (text == nullptr) return std::nullopt;
  const ReaderInfo& reader = *choice.reader;
  auto table = reader.read({text->source, options, diagnostics});
  if (!table) return std::nullopt;
  std::vector<std::string> decisions{fmt::format("format: {} ({})", reader.name, reader.title)};
  decisions.insert(decisions.end(), text->decisions.begin(), text->decisions.end());
  table->decisions.insert(table->decisions.begin(), decisions.begin(), decisions.end());
  if (options.part != 0 && !select_part(*table, options, diagnostics)) return std::nullopt;
  table->title = reader.title;
  table->io_words = options.io_words;
  expand_arrays(*table, options.xy.value_or(address::Radix::hexadecimal), diagnostics);
  return table;
}

}  // namespace symplant::read

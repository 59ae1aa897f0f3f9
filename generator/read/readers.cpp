// The table of readers, and reading a symbol list of any known format.
#include "read/readers.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "read/formats.hpp"
#include "read/rules/cannot_read_file.hpp"
#include "read/rules/empty_file.hpp"
#include "read/rules/undecodable_text.hpp"
#include "read/rules/unknown_format.hpp"
#include "read/rules/unknown_input_format.hpp"

namespace symplant::read {

namespace {

constexpr std::array kReaders{
    &kGxIec,           //
    &kOmronCxt,        //
    &kPlcopen,         //
    &kRockwellCsv,     //
    &kRockwellL5k,     //
    &kRockwellL5x,     //
    &kSchneiderXsy,    //
    &kStep7Asc,        //
    &kStep7Sdf,        //
    &kStructuredText,  //
    &kSysmac,          //
    &kTiaOpenness,     //
    &kTiaSdf,          //
    &kTiaTagTable,     //
    &kTwincatGvl,      //
};

std::string known_names() {
  std::string names;
  for (const ReaderInfo* reader : kReaders) {
    names.append(names.empty() ? "`" : ", `").append(reader->name).append("`");
  }
  return names;
}

/// A location in a file whose text cannot be shown.
diag::Location whole_file(const std::string& path) { return {std::make_shared<text::SourceFile>(path, ""), {}}; }

/// The requested reader, or the likeliest; null if an error was added.
const ReaderInfo* choose(const ReadOptions& options, const std::shared_ptr<const text::SourceFile>& source,
                         diag::Diagnostics& diagnostics) {
  const ReaderInfo* best = nullptr;
  int likelihood = 0;
  for (const ReaderInfo* reader : kReaders) {
    if (reader->name == options.input_format) return reader;
    const int mine = reader->likelihood(source->text());
    if (mine <= likelihood) continue;
    likelihood = mine;
    best = reader;
  }
  if (best == nullptr) {
    diagnostics.add(kUnknownFormat,
                    "found neither a header with a column of identifiers nor a class such as `VAR_GLOBAL`, so this is "
                    "not a known symbol list (" +
                        known_names() + "); export the global variables as text, or put a header above the rows",
                    {source, source->span_of(source->line_at(0))});
  }
  return best;
}

/// The file as text; null if an error was added.
std::shared_ptr<const text::SourceFile> load(const std::string& path, std::string bytes, const ReadOptions& options,
                                             diag::Diagnostics& diagnostics, text::Encoding& encoding) {
  auto decoded = decode_file(path, std::move(bytes), options, diagnostics);
  if (!decoded) return nullptr;
  if (decoded->text.find_first_not_of(" \t\r\n") == std::string::npos) {
    diagnostics.add(kEmptyFile, "the file `" + path + "` is empty; export the list again", whole_file(path));
    return nullptr;
  }
  encoding = decoded->encoding;
  return std::make_shared<text::SourceFile>(path, std::move(decoded->text));
}

bool is_known_format(const ReadOptions& options, diag::Diagnostics& diagnostics) {
  const auto is_asked_for = [&](const ReaderInfo* reader) { return reader->name == options.input_format; };
  if (options.input_format.empty() || std::any_of(kReaders.begin(), kReaders.end(), is_asked_for)) return true;
  diagnostics.add(kUnknownInputFormat,
                  "unknown list format `" + options.input_format + "`; choose one of " + known_names(), {});
  return false;
}

/// What to do about bytes that cannot be decoded: how the likely encodings would read them, if there are any.
std::string remedy_of(const text::DecodeError& fault, bool described) {
  const auto option = [&](text::Encoding encoding) {
    const std::string name(text::encoding_name(encoding));
    return described ? "`\"encoding\": \"" + name + "\"`" : "`--encoding " + name + "`";
  };
  if (fault.guesses.empty()) return fault.remedy;
  const text::EncodingGuess& first = fault.guesses.front();
  if (fault.guesses.size() == 1) {
    return option(first.encoding) + " would read `" + first.sample +
           "`; if that is wrong, give the encoding that the list was saved in, or save it as UTF-8";
  }
  std::string text;
  for (const text::EncodingGuess& guess : fault.guesses) {
    text.append(text.empty() ? "" : ", ").append(option(guess.encoding)).append(" (`" + guess.sample + "`)");
  }
  return "choose the encoding that reads this word correctly: " + text + ", or save the list as UTF-8";
}

}  // namespace

std::span<const ReaderInfo* const> readers() { return kReaders; }

std::optional<text::Decoded> decode_file(const std::string& path, std::string bytes, const ReadOptions& options,
                                         diag::Diagnostics& diagnostics, std::string_view remedy) {
  auto decoded = text::decode(std::move(bytes), options.encoding ? &*options.encoding : nullptr);
  if (decoded) return std::move(*decoded);
  const text::DecodeError& fault = decoded.error();
  const text::Span location{fault.shown_offset, std::min(fault.shown_offset + 1, fault.shown.size())};
  const std::string what_to_do = remedy.empty() ? remedy_of(fault, options.described) : std::string(remedy);
  diagnostics.add(kUndecodableText, fault.what + "; " + what_to_do,
                  {std::make_shared<text::SourceFile>(path, fault.shown), location});
  return std::nullopt;
}

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
  text::Encoding encoding{};
  const auto source = load(path, std::move(bytes), options, diagnostics, encoding);
  if (!source) return std::nullopt;
  const ReaderInfo* const reader = choose(options, source, diagnostics);
  if (reader == nullptr) return std::nullopt;
  auto table = reader->read({source, options, diagnostics});
  if (!table) return std::nullopt;
  const std::string_view why = options.encoding ? ", as requested" : "";
  table->decisions.insert(table->decisions.begin(),
                          {"format: " + std::string(reader->name) + " (" + std::string(reader->title) + ")",
                           "encoding: " + std::string(text::encoding_name(encoding)) + std::string(why)});
  return table;
}

}  // namespace symplant::read

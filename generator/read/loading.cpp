// From the bytes of a file to its text.
#include "read/loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "read/cells/workbook.hpp"
#include "read/recognized.hpp"
#include "read/rules/empty_file.hpp"
#include "read/rules/encoding_assumed.hpp"
#include "read/rules/recognized_format.hpp"
#include "read/rules/undecodable_text.hpp"
#include "read/rules/unreadable_workbook.hpp"
#include "read/xml/package.hpp"

namespace symplant::read {

namespace {

std::string encoding_option(text::Encoding encoding, bool described) {
  const std::string name(text::encoding_name(encoding));
  return described ? "`\"encoding\": \"" + name + "\"`" : "`--encoding " + name + "`";
}

/// "`--encoding cp949` (`차종`), `--encoding cp932` (`ﾂ﨨ｾ`)".
std::string choices(const std::vector<text::EncodingGuess>& guesses, bool described) {
  std::string text;
  for (const text::EncodingGuess& guess : guesses) {
    text +=
        fmt::format("{}{} (`{}`)", text.empty() ? "" : ", ", encoding_option(guess.encoding, described), guess.sample);
  }
  return text;
}

/// What to do about bytes that cannot be decoded: how the likely encodings would read them, if there are any.
std::string remedy_of(const text::DecodeError& fault, bool described) {
  if (fault.guesses.empty()) return fault.remedy;
  const text::EncodingGuess& first = fault.guesses.front();
  if (fault.guesses.size() == 1) {
    return fmt::format(
        "{} would read `{}`; if that is wrong, give the encoding that the list was saved in, or save it as UTF-8",
        encoding_option(first.encoding, described), first.sample);
  }
  return "choose the encoding that reads this word correctly: " + choices(fault.guesses, described) +
         ", or save the list as UTF-8";
}

diag::Location location_of(const std::string& path, const text::DecodeError& fault) {
  return {std::make_shared<text::SourceFile>(path, fault.shown),
          {fault.shown_offset, std::min(fault.shown_offset + 1, fault.shown.size())}};
}

void add_recognized(const std::string& path, const RecognizedFile& known, diag::Diagnostics& diagnostics) {
  diagnostics.add(kRecognizedFormat, fmt::format("this is {}; {}", known.what, known.advice), whole_file(path));
}

/// A text in a code page that its declaration names, or that its words show; nothing if neither does.
std::optional<LoadedText> in_code_page(const std::string& path, std::string& bytes, const text::DecodeError& fault,
                                       const ReadOptions& options, diag::Diagnostics& diagnostics) {
  const auto declared = text::declared_encoding(bytes);
  const bool recognized = !fault.guesses.empty() && fault.guesses.front().recognized;
  if (!declared && !recognized) return std::nullopt;
  const text::Encoding encoding = declared ? *declared : fault.guesses.front().encoding;
  auto decoded = text::decode(std::move(bytes), &encoding);
  if (!decoded) return std::nullopt;
  const bool few = !declared && fault.guesses.size() > 1;
  if (few) {
    diagnostics.add(kEncodingAssumed,
                    fmt::format("the encoding was recognized as {} by few words; choose the one that reads this word "
                                "correctly: {}",
                                text::encoding_name(encoding), choices(fault.guesses, options.described)),
                    location_of(path, fault));
  }
  const std::string decision = fmt::format("encoding: {}, {}", text::encoding_name(encoding),
                                           declared ? "as the file declares" : "recognized by its words");
  return LoadedText{std::make_shared<text::SourceFile>(path, std::move(decoded->text)), "", {decision}};
}

std::optional<LoadedText> load_text(const std::string& path, std::string bytes, const ReadOptions& options,
                                    diag::Diagnostics& diagnostics) {
  auto decoded = text::decode(std::move(bytes), options.encoding ? &*options.encoding : nullptr);
  if (decoded) {
    const std::string decision =
        fmt::format("encoding: {}{}", text::encoding_name(decoded->encoding), options.encoding ? ", as requested" : "");
    return LoadedText{std::make_shared<text::SourceFile>(path, std::move(decoded->text)), "", {decision}};
  }
  const text::DecodeError& fault = decoded.error();
  // NOLINTBEGIN(bugprone-use-after-move): decode() leaves the bytes as they are after an error
  if (!options.encoding) {
    if (auto loaded = in_code_page(path, bytes, fault, options, diagnostics)) return loaded;
  }
  if (const auto known = fault.guesses.empty() ? recognize_bytes(path, bytes) : std::nullopt) {
    // NOLINTEND(bugprone-use-after-move)
    add_recognized(path, *known, diagnostics);
  } else {
    diagnostics.add(kUndecodableText, fault.what + "; " + remedy_of(fault, options.described),
                    location_of(path, fault));
  }
  return std::nullopt;
}

std::vector<LoadedText> load_sheets(const std::string& path, std::string_view bytes, const ReadOptions& options,
                                    diag::Diagnostics& diagnostics) {
  auto sheets = read_workbook(bytes);
  if (!sheets) {
    diagnostics.add(kUnreadableWorkbook, sheets.error(), whole_file(path));
    return {};
  }
  const std::string& wanted = options.columns.sheet;
  std::vector<LoadedText> loaded;
  std::string names;
  for (Sheet& sheet : *sheets) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", sheet.name);
    if (!wanted.empty() && sheet.name != wanted) continue;
    const std::string decision = fmt::format("sheet: `{}`", sheet.name);
    loaded.push_back({std::make_shared<text::SourceFile>(path, std::move(sheet.text), text::Counted::cells),
                      std::move(sheet.name),
                      {decision}});
  }
  if (loaded.empty()) {
    diagnostics.add(kUnreadableWorkbook, fmt::format("the workbook has no sheet `{}`; choose one of {}", wanted, names),
                    whole_file(path));
  }
  return loaded;
}

std::optional<LoadedText> load_package(const std::string& path, std::string_view bytes, const ReadOptions& options,
                                       diag::Diagnostics& diagnostics) {
  auto document = xml::read_automationml_package(bytes);
  if (!document) {
    diagnostics.add(kUnreadableWorkbook,
                    document.error().what + "; export the project again, or as a plain AutomationML file (.aml)",
                    whole_file(path));
    return std::nullopt;
  }
  auto text = load_text(path, std::move(document->bytes), options, diagnostics);
  if (text) text->decisions.push_back(fmt::format("document: `{}` of the package", document->path));
  return text;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

}  // namespace

diag::Location whole_file(const std::string& path) { return {std::make_shared<text::SourceFile>(path, ""), {}}; }

std::vector<LoadedText> load_texts(const std::string& path, std::string bytes, const ReadOptions& options,
                                   diag::Diagnostics& diagnostics) {
  std::vector<LoadedText> texts;
  if (is_workbook(bytes)) {
    texts = load_sheets(path, bytes, options, diagnostics);
    if (texts.empty()) return {};
  } else if (xml::is_automationml_package(bytes)) {
    auto text = load_package(path, bytes, options, diagnostics);
    if (!text) return {};
    texts.push_back(std::move(*text));
  } else if (const auto known = has_magic(bytes) ? recognize_bytes(path, bytes) : std::nullopt) {
    add_recognized(path, *known, diagnostics);
    return {};
  } else if (auto text = load_text(path, std::move(bytes), options, diagnostics)) {
    texts.push_back(std::move(*text));
  } else {
    return {};
  }
  std::erase_if(texts, [](const LoadedText& text) { return is_blank(text.source->text()); });
  if (texts.empty()) {
    diagnostics.add(kEmptyFile, "the file `" + path + "` is empty; export the list again", whole_file(path));
  }
  return texts;
}

std::optional<text::Decoded> decode_file(const std::string& path, std::string bytes, diag::Diagnostics& diagnostics,
                                         std::string_view remedy) {
  auto decoded = text::decode(std::move(bytes));
  if (decoded) return std::move(*decoded);
  diagnostics.add(kUndecodableText, fmt::format("{}; {}", decoded.error().what, remedy),
                  location_of(path, decoded.error()));
  return std::nullopt;
}

}  // namespace symplant::read

// Writes workbooks (.xlsx) of text cells.
#include "convert/workbook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "convert/xml_text.hpp"
#include "convert/zip_package.hpp"
#include "text/ascii.hpp"

namespace symplant::convert {
namespace {

constexpr std::size_t kRowsOfPiece = 1000;
constexpr std::string_view kXmlHead = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";
constexpr std::string_view kMain = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
constexpr std::string_view kRelations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
constexpr std::string_view kPackage = "http://schemas.openxmlformats.org/package/2006";

std::function<std::string(std::size_t)> single_piece(std::string text) {
  return [text = std::move(text)](std::size_t number) { return number == 0 ? text : std::string(); };
}

std::string sheet_path(std::size_t number) { return fmt::format("worksheets/sheet{}.xml", number + 1); }

std::string content_types(std::size_t sheets) {
  constexpr std::string_view kType = "application/vnd.openxmlformats-officedocument.spreadsheetml.";
  std::string text = fmt::format("{}<Types xmlns=\"{}/content-types\">", kXmlHead, kPackage);
  text += "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>";
  text += "<Default Extension=\"xml\" ContentType=\"application/xml\"/>";
  const auto add = [&](std::string_view path, std::string_view type) {
    text += fmt::format("<Override PartName=\"/xl/{}\" ContentType=\"{}{}+xml\"/>", path, kType, type);
  };
  add("workbook.xml", "sheet.main");
  for (std::size_t i = 0; i < sheets; ++i) add(sheet_path(i), "worksheet");
  add("styles.xml", "styles");
  add("sharedStrings.xml", "sharedStrings");
  return text + "</Types>\n";
}

std::string root_relations() {
  return fmt::format(
      "{}<Relationships xmlns=\"{}/relationships\"><Relationship Id=\"rId1\" Type=\"{}/officeDocument\" "
      "Target=\"xl/workbook.xml\"/></Relationships>\n",
      kXmlHead, kPackage, kRelations);
}

std::string workbook_relations(std::size_t sheets) {
  std::string text = fmt::format("{}<Relationships xmlns=\"{}/relationships\">", kXmlHead, kPackage);
  std::size_t id = 0;
  const auto add = [&](std::string_view type, std::string_view target) {
    text += fmt::format("<Relationship Id=\"rId{}\" Type=\"{}/{}\" Target=\"{}\"/>", ++id, kRelations, type, target);
  };
  for (std::size_t i = 0; i < sheets; ++i) add("worksheet", sheet_path(i));
  add("styles", "styles.xml");
  add("sharedStrings", "sharedStrings.xml");
  return text + "</Relationships>\n";
}

std::string workbook_part(const std::vector<SheetTable>& sheets) {
  std::string text = fmt::format("{}<workbook xmlns=\"{}\" xmlns:r=\"{}\"><sheets>", kXmlHead, kMain, kRelations);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    text += fmt::format("<sheet name=\"{}\" sheetId=\"{}\" r:id=\"rId{}\"/>", sheets[i].name, i + 1, i + 1);
  }
  return text + "</sheets></workbook>\n";
}

/// One style: text, so that a spreadsheet takes no cell for a number or a formula.
std::string styles_part() {
  return fmt::format(
      "{}<styleSheet xmlns=\"{}\"><fonts count=\"1\"><font><sz val=\"11\"/><name val=\"Calibri\"/></font></fonts>"
      "<fills count=\"2\"><fill><patternFill patternType=\"none\"/></fill><fill><patternFill patternType=\"gray125\"/>"
      "</fill></fills><borders count=\"1\"><border><left/><right/><top/><bottom/><diagonal/></border></borders>"
      "<cellStyleXfs count=\"1\"><xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\"/></cellStyleXfs>"
      "<cellXfs count=\"1\"><xf numFmtId=\"49\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" "
      "applyNumberFormat=\"1\"/></cellXfs><cellStyles count=\"1\"><cellStyle name=\"Normal\" xfId=\"0\" "
      "builtinId=\"0\"/></cellStyles></styleSheet>\n",
      kXmlHead, kMain);
}

void append_row(std::string& text, const SheetTable& sheet, std::size_t row) {
  const std::string number = std::to_string(row + 1);
  text.append("<row r=\"").append(number).append("\">");
  for (std::size_t column = 0; column < sheet.columns; ++column) {
    text.append("<c r=\"").append(1, static_cast<char>('A' + column)).append(number).append("\" t=\"s\"><v>");
    text.append(std::to_string(sheet.cells[row * sheet.columns + column])).append("</v></c>");
  }
  text += "</row>\n";
}

std::string sheet_piece(const SheetTable& sheet, std::size_t number) {
  const std::size_t first = number * kRowsOfPiece;
  if (first >= sheet.rows()) return {};
  const std::size_t end = std::min(first + kRowsOfPiece, sheet.rows());
  std::string text;
  if (number == 0) text = fmt::format("{}<worksheet xmlns=\"{}\"><sheetData>\n", kXmlHead, kMain);
  for (std::size_t row = first; row < end; ++row) append_row(text, sheet, row);
  if (end == sheet.rows()) text += "</sheetData></worksheet>\n";
  return text;
}

bool is_escape(std::string_view text) {
  const auto is_hex = [](char c) { return text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'F'); };
  return text.size() >= 7 && text.starts_with("_x") && text[6] == '_' &&
         std::all_of(text.begin() + 2, text.begin() + 6, is_hex);
}

/// A spreadsheet reads `_x0041_` as `A`: such text gets its first character escaped.
void append_string(std::string& xml, std::string_view text) {
  xml += "<si><t xml:space=\"preserve\">";
  for (std::size_t at = text.find("_x"); at != text.npos; at = text.find("_x", at + 1)) {
    if (!is_escape(text.substr(at))) continue;
    append_xml(xml, text.substr(0, at));
    xml += "_x005F_";
    text.remove_prefix(at + 1);
    at = 0;
  }
  append_xml(xml, text);
  xml += "</t></si>\n";
}

std::string strings_piece(const SharedStrings& strings, std::size_t number) {
  const auto& all = strings.all();
  const std::size_t first = number * kRowsOfPiece;
  if (first >= all.size()) return {};
  const std::size_t end = std::min(first + kRowsOfPiece, all.size());
  std::string text;
  if (number == 0) text = fmt::format("{}<sst xmlns=\"{}\" uniqueCount=\"{}\">\n", kXmlHead, kMain, all.size());
  for (std::size_t i = first; i < end; ++i) append_string(text, all[i]);
  if (end == all.size()) text += "</sst>\n";
  return text;
}

}  // namespace

std::uint32_t SharedStrings::add(std::string_view text) {
  const auto index = static_cast<std::uint32_t>(all_.size());
  const std::uint32_t known = by_text_.find_or_add(std::hash<std::string_view>()(text), index,
                                                   [&](std::uint32_t other) { return all_[other] == text; });
  if (known == index) all_.push_back(text);
  return known;
}

std::uint32_t SharedStrings::keep(std::string text) {
  const std::uint32_t known =
      by_text_.find(std::hash<std::string_view>()(text), [&](std::uint32_t other) { return all_[other] == text; });
  return known != base::IndexTable::kNothing ? known : add(kept_.emplace_back(std::move(text)));
}

base::Result<std::string, WriteError> workbook_bytes(const std::vector<SheetTable>& sheets,
                                                     const SharedStrings& strings) {
  std::vector<PackagePart> parts{{"[Content_Types].xml", single_piece(content_types(sheets.size()))},
                                 {"_rels/.rels", single_piece(root_relations())},
                                 {"xl/workbook.xml", single_piece(workbook_part(sheets))},
                                 {"xl/_rels/workbook.xml.rels", single_piece(workbook_relations(sheets.size()))},
                                 {"xl/styles.xml", single_piece(styles_part())}};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const SheetTable& sheet = sheets[i];
    parts.push_back({"xl/" + sheet_path(i), [&sheet](std::size_t number) { return sheet_piece(sheet, number); }});
  }
  parts.push_back({"xl/sharedStrings.xml", [&](std::size_t number) { return strings_piece(strings, number); }});
  return zip_package(parts);
}

}  // namespace symplant::convert

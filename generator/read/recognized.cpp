// Files that are known and not read.
#include "read/recognized.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "read/formats/table_formats.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kTiaAdvice =
    "export the tags: in TIA Portal, open the PLC tag table, choose `Export` and write the workbook (.xlsx) or the XML";
constexpr std::string_view kTiaProject = "a TIA Portal project or archive";
constexpr std::string_view kLogixAdvice =
    "export the tags: in Logix Designer, Tools > Export > Tags and Logic Comments (CSV), or save the project as L5K or "
    "L5X";
constexpr std::string_view kGxAdvice =
    "export the labels or device comments: in GX Works, open the global labels or the device comments, then "
    "Edit > Export to file (CSV)";
constexpr std::string_view kCodesysAdvice =
    "export the variables: in CODESYS, Project > Export PLCopenXML, or save the global variable list as text (.st)";
constexpr std::string_view kStep7Advice =
    "export the symbol table: in the Symbol Editor, Symbol Table > Export, as .asc or .sdf";
constexpr std::string_view kSysmacAdvice =
    "export the variables: in Sysmac Studio, Tools > Export Global Variables > CX-Designer; in CX-Programmer, save the "
    "project as text (.cxt)";
constexpr std::string_view kSchneiderAdvice =
    "export the variables: in Control Expert, select `Variables & FB instances`, then File > Export (.xsy)";
constexpr std::string_view kSheetAdvice = "open it and save it as .xlsx or as CSV";
constexpr std::string_view kListAdvice = "export the symbols of the PLC program as text or as a workbook";

struct Signature {
  std::string_view bytes;      ///< what the file holds
  bool at_begin;               ///< at its beginning, or anywhere
  std::string_view extension;  ///< of its path, without the dot, in lower case; empty: any
  RecognizedFile file;
};

constexpr RecognizedFile kOldWorkbook{"a workbook in the old Excel format (.xls)", kSheetAdvice};

constexpr std::string_view kOleMagic = "\xD0\xCF\x11\xE0";
constexpr std::string_view kZipMagic = "PK\x03\x04";

/// The first that fits counts.
constexpr std::array kBinaries{
    Signature{"QuickInfo.XML", false, "", {"a Rockwell project (ACD, binary)", kLogixAdvice}},
    Signature{std::string_view("Q\0u\0i\0c\0k\0I\0n\0f\0o\0.\0X\0M\0L\0", 26),
              false,
              "",
              {"a Rockwell project (ACD, binary)", kLogixAdvice}},
    Signature{"", true, "acd", {"a Rockwell project (ACD, binary)", kLogixAdvice}},
    Signature{"",
              true,
              "rss",
              {"an RSLogix 500 project (RSS, binary)",
               "export its database as CSV: in RSLogix 500, Tools > Database > ASCII Export"}},
    Signature{"SQLite format 3", true, "", {"a database (SQLite)", kListAdvice}},
    Signature{"%PDF", true, "", {"a PDF document", kListAdvice}},
    Signature{"\x1F\x8B", true, "", {"a compressed file (gzip)", "unpack it and give the list in it"}},
    Signature{"7z\xBC\xAF", true, "", {"an archive (7-Zip)", "unpack it and give the list in it"}},
    Signature{"Rar!", true, "", {"an archive (RAR)", "unpack it and give the list in it"}},
    Signature{"\x89PNG", true, "", {"a picture (PNG)", kListAdvice}},
    Signature{"\xFF\xD8\xFF", true, "", {"a picture (JPEG)", kListAdvice}},
    Signature{kOleMagic, true, "xls", kOldWorkbook},
    Signature{kOleMagic, true, "gxw", {"a GX Works2 project", kGxAdvice}},
    Signature{kOleMagic, true, "project", {"a CODESYS project", kCodesysAdvice}},
    Signature{kOleMagic,
              true,
              "",
              {"a compound document of Windows (a workbook in the old Excel format, or a project)", kSheetAdvice}},
    Signature{"", true, "gx3", {"a GX Works3 project", kGxAdvice}},
    Signature{"", true, "gxw", {"a GX Works2 project", kGxAdvice}},
    Signature{"", true, "cxp", {"a CX-Programmer project (binary)", kSysmacAdvice}},
    Signature{"", true, "smc2", {"a Sysmac Studio project", kSysmacAdvice}},
    Signature{"", true, "stu", {"a Control Expert project (STU, binary)", kSchneiderAdvice}},
    Signature{"",
              true,
              "xgwx",
              {"an XG5000 project",
               "export the variables: in XG5000, open the global variables, then Edit > Export to file (CSV)"}},
    Signature{"content.xml", false, "ods", {"a spreadsheet of LibreOffice (.ods)", kSheetAdvice}},
    Signature{"xl/workbook.bin", false, "", {"a binary workbook (.xlsb)", kSheetAdvice}},
    Signature{"word/document.xml", false, "", {"a document of Word", kListAdvice}},
    Signature{kZipMagic, true, "zef", {"an archive of Control Expert (ZEF)", kSchneiderAdvice}},
    Signature{kZipMagic, true, "sta", {"an archive of Control Expert (STA)", kSchneiderAdvice}},
    Signature{kZipMagic, true, "projectarchive", {"an archive of a CODESYS project", kCodesysAdvice}},
    Signature{kZipMagic, true, "project", {"a CODESYS project", kCodesysAdvice}},
    Signature{kZipMagic, true, "library", {"a CODESYS library", kCodesysAdvice}},
    Signature{"TIA Portal", false, "", {kTiaProject, kTiaAdvice}},
    Signature{kZipMagic, true, "", {"a zip archive", "unpack it and give the list in it"}},
    Signature{"", true, "xls", kOldWorkbook},
};

/// Texts, by what their first part holds; the first that fits counts.
constexpr std::array kTexts{
    Signature{"TABLE\n0,1\n", true, "", {"a table in data interchange format (DIF)", kStep7Advice}},
    Signature{"TABLE\r\n0,1\r\n", true, "", {"a table in data interchange format (DIF)", kStep7Advice}},
    Signature{"#LimitAlarmDefinitions",
              true,
              "",
              {"a configuration of MX OPC Server", "export the labels of the PLC from GX Works instead"}},
    Signature{"<Symbolconfiguration",
              false,
              "",
              {"a symbol configuration of CODESYS, which has no addresses", kCodesysAdvice}},
    Signature{"<SW.Blocks.", false, "", {"a block of TIA Portal (Openness XML)", kTiaAdvice}},
    Signature{"<SW.Types.", false, "", {"a data type of TIA Portal (Openness XML)", kTiaAdvice}},
    Signature{"<LogFile titleName", false, "", {"a log of TIA Portal about an export or import", kTiaAdvice}},
    Signature{"<Hmi.", false, "", {"an HMI export of TIA Portal", kTiaAdvice}},
    Signature{"<TcSmProject",
              false,
              "",
              {"a project of TwinCAT", "give the global variable lists (.TcGVL) of its PLC project"}},
    Signature{"<TcSmItem",
              false,
              "",
              {"a part of a TwinCAT project", "give the global variable lists (.TcGVL) of its PLC project"}},
    Signature{"<TcModuleClass",
              false,
              "",
              {"a module description of TwinCAT (TMC)", "give the global variable lists (.TcGVL) of its PLC project"}},
    Signature{"<PlcProjectInfo",
              false,
              "",
              {"a symbol file of TwinCAT 2 (TPY)", "give the global variable lists (.TcGVL) of its PLC project"}},
    Signature{"<TcPlcObject",
              false,
              "",
              {"an object of TwinCAT without global variables",
               "give the global variable lists (.TcGVL) of its PLC project"}},
    Signature{"<FEFExchangeFile", false, "", {"an application of Control Expert (XEF)", kSchneiderAdvice}},
    Signature{"<UANodeSet", false, "", {"an OPC UA node set", kListAdvice}},
    Signature{"<ISO15745Profile", false, "", {"a device description (GSDML)", kListAdvice}},
    Signature{"<EtherCATInfo", false, "", {"a device description (EtherCAT ESI)", kListAdvice}},
    Signature{"<html", false, "", {"a web page", kListAdvice}},
    Signature{"<HTML", false, "", {"a web page", kListAdvice}},
    Signature{"{\\rtf", true, "", {"a document (RTF)", kListAdvice}},
    Signature{"FUNCTION_BLOCK ",
              false,
              "",
              {"a program text without I/O declarations",
               "give the file that declares the inputs and outputs (VAR_GLOBAL, or AT %I, %Q)"}},
    Signature{"ORGANIZATION_BLOCK ", false, "", {"a program text of STEP 7 (AWL or SCL source)", kStep7Advice}},
    Signature{"<?xml", true, "", {"an XML file of an unknown kind", kListAdvice}},
};

bool fits(const Signature& signature, std::string_view content, std::string_view extension) {
  if (!signature.extension.empty() && extension != signature.extension) return false;
  return signature.at_begin ? content.starts_with(signature.bytes)
                            : content.find(signature.bytes) != std::string_view::npos;
}

template <std::size_t N>
std::optional<RecognizedFile> first_of(const std::array<Signature, N>& signatures, std::string_view content,
                                       std::string_view extension) {
  const auto found = std::find_if(signatures.begin(), signatures.end(),
                                  [&](const Signature& signature) { return fits(signature, content, extension); });
  return found == signatures.end() ? std::nullopt : std::optional(found->file);
}

struct KnownTable {
  HeaderWords header;
  RecognizedFile file;
};

constexpr std::array kTables{
    KnownTable{
        {"modbusaddress", "functioncode", "nickname"},
        {"the address list of AutomationDirect CLICK",
         "give a table with the columns `Name` and `Address`, with the Modbus address of each row as a reference "
         "number of six digits: `100001` for an input, `008193` for a coil"}},
    KnownTable{{"rack", "slot", "point"},
               {"a table whose addresses are in several columns (rack, slot and point)",
                "add a column `Address` with the address as the PLC program has it, such as `Local:1:I.Data.0`, or a "
                "Modbus reference number"}},
    KnownTable{{"stepno", "instruction", "io(device)"}, {"a program of GX Works (ladder, CSV)", kGxAdvice}},
};

/// A project or an archive of TIA Portal by the end of its path: .ap16, .zap19.
bool is_tia_project(std::string_view extension) {
  if (extension.starts_with('z')) extension.remove_prefix(1);
  return extension.size() == 4 && extension.starts_with("ap") && text::is_digit(extension[2]) &&
         text::is_digit(extension[3]);
}

/// A line of a sequential symbol table of STEP 7 or STEP 5: TAB address TAB symbol TAB comment.
bool is_seq(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() > 3 && line[0] == '\t' && line[1] != '\t' && std::count(line.begin(), line.end(), '\t') == 3;
}

}  // namespace

bool has_magic(std::string_view bytes) {
  constexpr std::array<std::string_view, 9> kMagic{
      kOleMagic, kZipMagic, "%PDF", "\x1F\x8B", "7z\xBC\xAF", "Rar!\x1A", "\x89PNG", "\xFF\xD8\xFF", "SQLite format 3"};
  return std::any_of(kMagic.begin(), kMagic.end(), [&](std::string_view magic) { return bytes.starts_with(magic); });
}

std::optional<RecognizedFile> recognize_bytes(std::string_view path, std::string_view bytes) {
  const std::string extension = text::to_lower(path.substr(path.rfind('.') + 1));
  if (is_tia_project(extension)) return RecognizedFile{kTiaProject, kTiaAdvice};
  return first_of(kBinaries, bytes, extension);
}

std::optional<RecognizedFile> recognize_text(std::string_view text) {
  constexpr std::size_t kExamined = 64 * 1024;
  const std::string_view begin = text.substr(0, kExamined);
  if (is_seq(begin))
    return RecognizedFile{"a symbol table of STEP 7 or STEP 5 in sequential form (.seq)", kStep7Advice};
  return first_of(kTexts, begin, "");
}

std::optional<RecognizedFile> recognize_table(std::string_view text) {
  const auto found = std::find_if(kTables.begin(), kTables.end(), [&](const KnownTable& table) {
    return layout_in_any(text, std::span(&table.header, 1)).has_value();
  });
  return found == kTables.end() ? std::nullopt : std::optional(found->file);
}

}  // namespace symplant::read

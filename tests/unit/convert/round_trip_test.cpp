// Random lists come back from every format as they were, as far as the format holds them.
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "convert/types.hpp"
#include "convert_support.hpp"
#include "model/classify.hpp"

namespace symplant::convert {
namespace {

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  std::size_t below(std::size_t count) { return engine_() % count; }
  template <class Items>
  const auto& of(const Items& items) {
    return items[below(items.size())];
  }

 private:
  std::mt19937 engine_;
};

/// Pieces of names and comments, with everything that a format might take for something else.
const std::vector<std::string> kPieces{
    "VALVE", "a",   " ",  "  ", "_",   "__", "\"", "\"\"", "'",     ",",   ";",       "\t",  "밸브", "Gerät", "😀",
    "=",     "+1",  "-",  "@",  "*)",  "(*", "//", "<b>",  "&amp;", "]]>", "_x0041_", "%I1", "{x}",  "$N",    "\\",
    "1",     "007", "\n", ".",  "[3]", ":",  ":=", "END",  "VAR",   "#",   "\u00A0",  "%",   "`",    "|",     "?"};
const std::vector<std::string> kTypes{"BOOL", "BOOL", "BOOL", "WORD", "INT", "DINT", "REAL", "BYTE", "TIME"};

std::string random_text(Dice& dice, std::size_t most, bool lines) {
  std::string text;
  for (std::size_t i = dice.below(most + 1); i > 0; --i) {
    const std::string& piece = dice.of(kPieces);
    if (lines || piece != "\n") text += piece;
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::string random_initial(Dice& dice, const std::string& type) {
  if (dice.below(2) == 0) return "";
  if (type == "BOOL") return dice.of(std::vector<std::string>{"TRUE", "FALSE", "1", "0"});
  if (type == "REAL") return dice.of(std::vector<std::string>{"1.5", "E3.14", "5", "-1e-3"});
  if (type == "TIME") return dice.of(std::vector<std::string>{"T#5s", "TIME#1m_30s"});
  return dice.of(std::vector<std::string>{"K5", "16#1F", "7", "H7F"});
}

/// A row of a GX IEC list: both addresses, one or none.
std::string random_row(Dice& dice, std::size_t index) {
  const std::string type = dice.of(kTypes);
  const std::string number = std::to_string(dice.below(500));
  const char area = dice.below(2) == 0 ? 'I' : 'Q';
  std::string mitsubishi;
  std::string iec;
  if (type == "BOOL" && dice.below(3) != 0) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%c%zX", area == 'I' ? 'X' : 'Y',
                  static_cast<std::size_t>(std::stoul(number)));
    mitsubishi = dice.below(2) == 0 ? digits : "";
    iec = mitsubishi.empty() || dice.below(2) == 0 ? std::string("%") + area + "X" + number : "";
  } else if (type != "BOOL" && type != "TIME" && dice.below(2) == 0) {
    const char size = type == "BYTE" ? 'B' : type == "DINT" || type == "REAL" ? 'D' : 'W';
    iec = std::string("%") + area + size + number;
  } else if (dice.below(3) == 0) {
    mitsubishi = (type == "BOOL" ? "M" : "D") + number;
  }
  const std::string klass = dice.below(9) == 0 ? "VAR_GLOBAL_CONSTANT" : "VAR_GLOBAL";
  // The index makes names different; a constant has no address.
  const std::string name = "n" + std::to_string(index) + "x" + random_text(dice, 5, false);
  if (klass != "VAR_GLOBAL") mitsubishi = iec = "";
  return klass + "," + quoted(dice.below(2) == 0 ? name : random_text(dice, 4, false) + name) + "," + mitsubishi + "," +
         iec + "," + type + "," + random_initial(dice, type) + "," + quoted(random_text(dice, 6, true)) + "\n";
}

std::shared_ptr<const Symbols> random_list(std::uint32_t seed) {
  Dice dice(seed);
  std::string rows = "VAR_GLOBAL,first,X1F,%IX31,BOOL,,\n";  // proves how X and Y count
  for (std::size_t i = 0; i < 40; ++i) rows += random_row(dice, i);
  return gx_list(rows);
}

/// What a row means: in words that no format changes.
struct Meaning {
  std::string name;
  bool constant = false;
  bool is_io = false;
  std::string address;  ///< empty for memory
  std::string type;
  std::string initial;
  std::string comment;

  auto tied() const { return std::tie(name, constant, is_io, address, type, initial, comment); }
  friend bool operator==(const Meaning& a, const Meaning& b) { return a.tied() == b.tied(); }
  friend bool operator<(const Meaning& a, const Meaning& b) { return a.tied() < b.tied(); }
  friend std::ostream& operator<<(std::ostream& out, const Meaning& row) {
    return out << "{" << row.name << "|" << row.constant << "|" << row.address << "|" << row.type << "|" << row.initial
               << "|" << row.comment << "}";
  }
};

/// Blanks and line ends, each run as one blank.
std::string folded(std::string_view text) {
  std::string result;
  bool gap = false;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (gap && !is_blank && !result.empty()) result += ' ';
    gap = is_blank;
    if (!is_blank) result += c;
  }
  return result;
}

Meaning meaning_of(const Symbol& symbol) {
  const read::ListRow& row = *symbol.row;
  Meaning meaning;
  meaning.name = row.name;
  meaning.constant = symbol.kind == Kind::constant;
  meaning.is_io = symbol.kind == Kind::input || symbol.kind == Kind::output;
  if (symbol.address && symbol.address->area != address::Area::memory)
    meaning.address = address_in(symbol, kOpenPlcForm);
  meaning.type = iec_type(symbol).value_or(std::string(row.type));
  meaning.initial = iec_literal(row.initial, meaning.type).value_or("?");
  if (meaning.initial == "FALSE") meaning.initial = "";
  meaning.comment = row.comment;
  return meaning;
}

std::vector<Meaning> meanings(const Symbols& symbols) {
  std::vector<Meaning> rows;
  for (const Symbol& symbol : symbols.all) rows.push_back(meaning_of(symbol));
  return rows;
}

/// The rows as the report says that they are named now.
std::vector<Meaning> renamed(const Symbols& symbols, const Report& report) {
  std::map<std::string, std::string> names(report.renames().begin(), report.renames().end());
  std::vector<Meaning> rows = meanings(symbols);
  for (Meaning& row : rows) {
    if (const auto name = names.find(row.name); name != names.end()) row.name = name->second;
  }
  return rows;
}

/// The rows that only one of two lists has, after a change of all rows.
template <class Change>
std::vector<Meaning> differences(std::vector<Meaning> a, std::vector<Meaning> b, const Change& change) {
  for (std::vector<Meaning>* rows : {&a, &b}) {
    for (Meaning& row : *rows) change(row);
    std::sort(rows->begin(), rows->end());
  }
  std::vector<Meaning> only;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
  return only;
}

constexpr std::uint32_t kLists = 60;

}  // namespace

TEST_CASE("gx-iec and csv give every row back, exactly and in order") {
  for (std::uint32_t seed = 0; seed < kLists; ++seed) {
    INFO("seed " << seed);
    const auto symbols = random_list(seed);
    const Made gx = convert_to("gx-iec", symbols);
    CHECK(meanings(*symbols_of_text("a.txt", gx.text)) == meanings(*symbols));
    const Made csv = convert_to("csv", symbols);
    const auto back = symbols_of_text("a.csv", csv.text);
    CHECK(meanings(*back) == meanings(*symbols));
    CHECK(convert_to("csv", back).text == csv.text);
  }
}

TEST_CASE("st gives every variable back under its new name") {
  // The reader of declarations folds blanks and removes the frame of a comment; brackets of comments are changed.
  const auto fold = [](Meaning& row) {
    row.comment = folded(row.comment);
    std::erase_if(row.comment, [](char c) { return c == ' ' || c == '*' || c == '/' || c == '(' || c == ')'; });
  };
  for (std::uint32_t seed = 0; seed < kLists; ++seed) {
    INFO("seed " << seed);
    const auto symbols = random_list(seed);
    const Made made = convert_to("st", symbols);
    CHECK(differences(meanings(*symbols_of_text("a.st", made.text)), renamed(*symbols, made.report), fold) ==
          std::vector<Meaning>());
  }
}

TEST_CASE("plcopen gives every variable back under its new name") {
  const auto fold = [](Meaning& row) { row.comment = folded(row.comment); };
  for (std::uint32_t seed = 0; seed < kLists; ++seed) {
    INFO("seed " << seed);
    const auto symbols = random_list(seed);
    const Made made = convert_to("plcopen", symbols);
    CHECK(differences(meanings(*symbols_of_text("a.xml", made.text)), renamed(*symbols, made.report), fold) ==
          std::vector<Meaning>());
  }
}

TEST_CASE("tia-xlsx gives every tag back under its new name") {
  for (std::uint32_t seed = 0; seed < kLists; ++seed) {
    INFO("seed " << seed);
    const auto symbols = random_list(seed);
    const Made made = convert_to("tia-xlsx", symbols);
    const auto fold = [](Meaning& row) {
      row.comment = folded(row.comment);
      row.name = folded(row.name);
      row.initial = "";
    };
    std::vector<Meaning> tags = renamed(*symbols, made.report);
    std::erase_if(tags, [](const Meaning& row) { return row.constant; });  // on their own sheet
    CHECK(differences(meanings(*symbols_of_text("a.xlsx", made.text)), tags, fold) == std::vector<Meaning>());
  }
}

TEST_CASE("A list that went through every format has its inputs and outputs still") {
  for (std::uint32_t seed = 0; seed < kLists; ++seed) {
    INFO("seed " << seed);
    auto symbols = symbols_of_text("a.st", convert_to("st", random_list(seed)).text);
    const std::size_t inputs = convert_to("csv", symbols).written.inputs;
    const std::size_t outputs = convert_to("csv", symbols).written.outputs;
    for (const auto& [writer, path] : std::vector<std::pair<std::string, std::string>>{
             {"plcopen", "a.xml"}, {"csv", "a.csv"}, {"tia-xlsx", "a.xlsx"}, {"gx-iec", "a.txt"}, {"st", "a.st"}}) {
      symbols = symbols_of_text(path, convert_to(writer, symbols).text);
      INFO(writer);
      const Written written = convert_to("csv", symbols).written;
      CHECK(written.inputs == inputs);
      CHECK(written.outputs == outputs);
    }
  }
}

}  // namespace symplant::convert

// The columns of a table of symbols, and the words by which headers name them.
#include "read/cells/columns.hpp"

#include <algorithm>
#include <utility>

#include "text/ascii.hpp"

namespace symplant::read {

namespace {

struct Alias {
  Field field;
  int rank;               ///< of two columns for one field the higher rank counts
  std::string_view word;  ///< as header_word() makes it
};

/// Words of the tools in English, German, Japanese, Korean, Chinese, Russian, French, Italian, Spanish, Portuguese,
/// Polish and Czech.
constexpr std::array kAliases{Alias{Field::klass, 2, "class"},
                              Alias{Field::klass, 2, "클래스"},
                              Alias{Field::klass, 2, "クラス"},
                              Alias{Field::klass, 2, "类"},
                              Alias{Field::klass, 2, "klasse"},
                              Alias{Field::klass, 2, "변수종류"},
                              Alias{Field::klass, 2, "variablekind"},
                              Alias{Field::name, 3, "identifier"},
                              Alias{Field::name, 2, "labelname"},
                              Alias{Field::name, 2, "label"},
                              Alias{Field::name, 2, "variable"},
                              Alias{Field::name, 2, "variablename"},
                              Alias{Field::name, 2, "mappedvariable"},
                              Alias{Field::name, 2, "symbol"},
                              Alias{Field::name, 2, "symbolname"},
                              Alias{Field::name, 2, "signalname"},
                              Alias{Field::name, 2, "signal"},
                              Alias{Field::name, 2, "tag"},
                              Alias{Field::name, 2, "tagname"},
                              Alias{Field::name, 2, "bezeichner"},
                              Alias{Field::name, 2, "라벨명"},
                              Alias{Field::name, 2, "변수"},
                              Alias{Field::name, 2, "변수명"},
                              Alias{Field::name, 2, "ラベル名"},
                              Alias{Field::name, 2, "変数名"},
                              Alias{Field::name, 2, "变量名"},
                              Alias{Field::name, 2, "标签名"},
                              Alias{Field::name, 2, "信号名"},
                              Alias{Field::name, 2, "信号名称"},
                              Alias{Field::name, 2, "符号"},
                              Alias{Field::name, 1, "name"},
                              Alias{Field::name, 1, "이름"},
                              Alias{Field::name, 1, "名前"},
                              Alias{Field::name, 1, "名称"},
                              Alias{Field::name, 1, "Имя"},
                              Alias{Field::name, 1, "имя"},
                              Alias{Field::name, 1, "Название"},
                              Alias{Field::name, 1, "nazwa"},
                              Alias{Field::name, 1, "název"},
                              Alias{Field::name, 1, "nom"},
                              Alias{Field::name, 1, "nome"},
                              Alias{Field::name, 1, "nombre"},
                              Alias{Field::vendor_address, 3, "mitaddr"},
                              Alias{Field::vendor_address, 3, "mitadr"},
                              Alias{Field::vendor_address, 3, "mitaddress"},
                              Alias{Field::vendor_address, 2, "fpaddress"},
                              Alias{Field::vendor_address, 2, "logicaladdress"},
                              Alias{Field::vendor_address, 2, "assign(devicelabel)"},
                              Alias{Field::vendor_address, 1, "device"},
                              Alias{Field::vendor_address, 1, "devicename"},
                              Alias{Field::vendor_address, 1, "operand"},
                              Alias{Field::vendor_address, 1, "디바이스"},
                              Alias{Field::vendor_address, 1, "デバイス"},
                              Alias{Field::vendor_address, 1, "デバイス名"},
                              Alias{Field::vendor_address, 1, "软元件"},
                              Alias{Field::vendor_address, 1, "软元件名"},
                              Alias{Field::iec_address, 3, "iecaddr"},
                              Alias{Field::iec_address, 3, "iecadr"},
                              Alias{Field::iec_address, 3, "iecaddress"},
                              Alias{Field::iec_address, 1, "address"},
                              Alias{Field::iec_address, 1, "addr"},
                              Alias{Field::iec_address, 1, "ioaddress"},
                              Alias{Field::iec_address, 1, "plcaddress"},
                              Alias{Field::iec_address, 1, "adresse"},
                              Alias{Field::iec_address, 1, "logischeadresse"},
                              Alias{Field::iec_address, 1, "메모리할당"},
                              Alias{Field::iec_address, 1, "주소"},
                              Alias{Field::iec_address, 1, "アドレス"},
                              Alias{Field::iec_address, 1, "地址"},
                              Alias{Field::iec_address, 1, "io地址"},
                              Alias{Field::iec_address, 1, "plc地址"},
                              Alias{Field::iec_address, 1, "逻辑地址"},
                              Alias{Field::iec_address, 1, "Адрес"},
                              Alias{Field::iec_address, 1, "адрес"},
                              Alias{Field::iec_address, 1, "Логическийадрес"},
                              Alias{Field::iec_address, 1, "indirizzo"},
                              Alias{Field::iec_address, 1, "dirección"},
                              Alias{Field::iec_address, 1, "direccion"},
                              Alias{Field::iec_address, 1, "endereço"},
                              Alias{Field::iec_address, 1, "adres"},
                              Alias{Field::iec_address, 1, "adresa"},
                              Alias{Field::type, 2, "datatype"},
                              Alias{Field::type, 2, "datentyp"},
                              Alias{Field::type, 2, "데이터형"},
                              Alias{Field::type, 2, "データ型"},
                              Alias{Field::type, 2, "数据类型"},
                              Alias{Field::type, 2, "Типданных"},
                              Alias{Field::type, 2, "типданных"},
                              Alias{Field::type, 1, "type"},
                              Alias{Field::type, 1, "typ"},
                              Alias{Field::type, 1, "타입"},
                              Alias{Field::type, 1, "Тип"},
                              Alias{Field::type, 1, "тип"},
                              Alias{Field::type, 1, "tipo"},
                              Alias{Field::initial, 2, "initial"},
                              Alias{Field::initial, 2, "initialvalue"},
                              Alias{Field::initial, 2, "startvalue"},
                              Alias{Field::initial, 2, "anfangswert"},
                              Alias{Field::initial, 2, "startwert"},
                              Alias{Field::initial, 2, "초기값"},
                              Alias{Field::initial, 2, "初期値"},
                              Alias{Field::initial, 2, "初始值"},
                              Alias{Field::initial, 1, "constant"},
                              Alias{Field::initial, 1, "상수값"},
                              Alias{Field::initial, 1, "定数値"},
                              Alias{Field::comment, 3, "comment"},
                              Alias{Field::comment, 3, "devicecomment"},
                              Alias{Field::comment, 3, "kommentar"},
                              Alias{Field::comment, 3, "코멘트"},
                              Alias{Field::comment, 3, "설명문"},
                              Alias{Field::comment, 3, "コメント"},
                              Alias{Field::comment, 3, "注释"},
                              Alias{Field::comment, 3, "Комментарий"},
                              Alias{Field::comment, 3, "комментарий"},
                              Alias{Field::comment, 3, "commentaire"},
                              Alias{Field::comment, 3, "commento"},
                              Alias{Field::comment, 3, "observação"},
                              Alias{Field::comment, 3, "comentario"},
                              Alias{Field::comment, 3, "comentário"},
                              Alias{Field::comment, 3, "komentarz"},
                              Alias{Field::comment, 3, "poznámka"},
                              Alias{Field::comment, 3, "Poznámka"},
                              Alias{Field::comment, 3, "Примечание"},
                              Alias{Field::comment, 2, "description"},
                              Alias{Field::comment, 2, "desc"},
                              Alias{Field::comment, 2, "beschreibung"},
                              Alias{Field::comment, 2, "설명"},
                              Alias{Field::comment, 2, "説明"},
                              Alias{Field::comment, 1, "remark"},
                              Alias{Field::comment, 1, "remarks"},
                              Alias{Field::comment, 1, "bemerkung"},
                              Alias{Field::comment, 1, "anmerkung"},
                              Alias{Field::comment, 1, "비고"},
                              Alias{Field::comment, 1, "备注"},
                              Alias{Field::scope, 2, "scope"},
                              Alias{Field::scope, 1, "path"},
                              Alias{Field::scope, 1, "pfad"}};

constexpr std::array<std::string_view, kFields> kFieldNames{"class", "identifier", "vendor address", "IEC address",
                                                            "type",  "initial",    "comment",        "scope"};

/// First words of types, sorted.
constexpr std::array<std::string_view, 40> kTypes{
    "BIT",   "BOOL",     "BOOLEAN", "BYTE",  "CHANNEL", "CHAR",   "COUNTER", "DATE",   "DINT",   "DOUBLE",
    "DT",    "DWORD",    "EBOOL",   "FLOAT", "INT",     "LINT",   "LONG",    "LREAL",  "LTIME",  "LWORD",
    "QWORD", "REAL",     "S5TIME",  "SHORT", "SINT",    "STRING", "TIME",    "TIMER",  "TOD",    "UDINT",
    "UINT",  "UINT_BCD", "ULINT",   "USINT", "WCHAR",   "WORD",   "WSTRING", "ビット", "ワード", "비트"};

bool is_letter(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }

/// `Address Comment`, `IO Description`: of rank 0.
bool is_comment(std::string_view word) { return word.ends_with("comment") || word.ends_with("description"); }

/// Of these fields a wrong column makes a wrong plant, so two candidates are reported.
bool matters(Field field) {
  return field == Field::name || field == Field::vendor_address || field == Field::iec_address;
}

}  // namespace

bool Columns::holds(std::size_t column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t Columns::count() const {
  return static_cast<std::size_t>(
      std::count_if(columns_.begin(), columns_.end(), [](std::size_t c) { return c != kNoColumn; }));
}

std::string_view field_name(Field field) { return kFieldNames[static_cast<std::size_t>(field)]; }

std::string describe(const Columns& columns, std::span<const std::string> header) {
  std::string text;
  for (std::size_t i = 0; i < kFields; ++i) {
    const std::size_t column = columns[static_cast<Field>(i)];
    if (column == kNoColumn) continue;
    if (!text.empty()) text += ", ";
    text.append(kFieldNames[i]).append(" ").append(std::to_string(column + 1));
    if (column < header.size() && !header[column].empty()) text.append(" `").append(header[column]).append("`");
  }
  return text;
}

std::string summary_of(const Columns& columns, std::span<const std::string> header) {
  constexpr std::array<std::pair<std::string_view, Field>, 5> kShown{{{"name", Field::name},
                                                                      {"address", Field::vendor_address},
                                                                      {"address", Field::iec_address},
                                                                      {"type", Field::type},
                                                                      {"comment", Field::comment}}};
  std::string text;
  for (const auto& [word, field] : kShown) {
    const std::size_t column = columns[field];
    if (column == kNoColumn) continue;
    text.append(text.empty() ? "" : ", ").append(word).append(" ");
    if (column < header.size()) {
      text.append("`").append(header[column]).append("`");
    } else {
      text.append("in column ").append(std::to_string(column + 1));
    }
  }
  return text;
}

std::string header_word(std::string_view cell) {
  std::string word;
  if (cell.size() > 64) return word;
  if (cell.ends_with(']')) cell = cell.substr(0, cell.rfind('['));
  for (const char c : cell) {
    if (c != ' ' && c != '.' && c != '-' && c != '_' && c != '/')
      word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return word;
}

NamedColumns named_columns(const CsvRow& row) {
  NamedColumns named;
  std::array<int, kFields> ranks{};
  std::array<std::size_t, kFields> rivals{};
  rivals.fill(kNoColumn);
  for (std::size_t column = 0; column < row.cells.size(); ++column) {
    const std::string word = header_word(row.cells[column]);
    if (!named.columns.has(Field::comment) && is_comment(word)) named.columns.set(Field::comment, column);
    for (const Alias& alias : kAliases) {
      const auto field = static_cast<std::size_t>(alias.field);
      if (alias.word != word || alias.rank < ranks[field]) continue;
      if (alias.rank == ranks[field]) {
        if (rivals[field] == kNoColumn) rivals[field] = column;
        continue;
      }
      ranks[field] = alias.rank;
      rivals[field] = kNoColumn;
      named.columns.set(alias.field, column);
    }
  }
  for (std::size_t i = 0; i < kFields; ++i) {
    const auto field = static_cast<Field>(i);
    if (rivals[i] == kNoColumn || !matters(field) || named.rivals) continue;
    named.rivals = Rivals{field, named.columns[field], rivals[i]};
  }
  return named;
}

bool is_class(std::string_view cell) {
  if (cell.size() < 3 || cell.size() > 40) return false;
  const std::string word = text::to_upper(cell);
  return word == "VAR" || (word.starts_with("VAR_") && std::all_of(word.begin(), word.end(), [](char c) {
                             return is_letter(c) || c == '_' || c == ' ';
                           }));
}

bool is_type(std::string_view cell) {
  if (cell.empty() || cell.size() > 100) return false;
  const std::string word = text::to_upper(cell.substr(0, cell.find_first_of(" ([")));
  return word == "ARRAY" || std::find(kTypes.begin(), kTypes.end(), word) != kTypes.end();
}

bool looks_like_iec_address(std::string_view cell) {
  return cell.size() > 2 && cell[0] == '%' &&
         (text::upper(cell[1]) == 'I' || text::upper(cell[1]) == 'Q' || text::upper(cell[1]) == 'M');
}

bool looks_like_vendor_address(std::string_view cell) {
  if (cell.size() > 12) return false;
  std::size_t letters = 0;
  while (letters < cell.size() && is_letter(cell[letters])) ++letters;
  const std::string_view rest = cell.substr(std::min<std::size_t>(letters, 3));
  return letters > 0 && std::any_of(rest.begin(), rest.end(), text::is_digit) &&
         std::all_of(rest.begin(), rest.end(), [](char c) {
           return text::is_digit(c) || c == '.' || (text::upper(c) >= 'A' && text::upper(c) <= 'F');
         });
}

}  // namespace symplant::read

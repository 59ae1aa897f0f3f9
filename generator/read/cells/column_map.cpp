// What the user says about the columns of a table.
#include "read/cells/column_map.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace symplant::read {

namespace {

struct FieldWord {
  std::string_view word;
  Field field;
};
constexpr std::array<FieldWord, 8> kWords{{{"name", Field::name},
                                           {"address", Field::vendor_address},
                                           {"iec-address", Field::iec_address},
                                           {"type", Field::type},
                                           {"initial", Field::initial},
                                           {"comment", Field::comment},
                                           {"class", Field::klass},
                                           {"scope", Field::scope}}};

std::string known_words() {
  std::string words;
  for (const FieldWord& word : kWords) words.append("`").append(word.word).append("`, ");
  return words + "`sheet`";
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

base::Result<ColumnMap, std::string> with_column(ColumnMap map, std::string_view word, std::string_view column) {
  if (column.empty()) return "`" + std::string(word) + "` names no column; write its header or its number";
  if (word == "sheet") {
    map.sheet = column;
    return base::Result<ColumnMap, std::string>(std::move(map));
  }
  const auto known = std::find_if(kWords.begin(), kWords.end(), [&](const FieldWord& w) { return w.word == word; });
  if (known == kWords.end()) return "unknown column `" + std::string(word) + "`; choose one of " + known_words();
  const auto is_same = [&](const GivenColumn& given) { return given.field == known->field; };
  if (std::any_of(map.columns.begin(), map.columns.end(), is_same)) {
    return "`" + std::string(word) + "` is given twice; give it once";
  }
  GivenColumn given{known->field, std::string(column), 0};
  const auto [end, fault] = std::from_chars(column.data(), column.data() + column.size(), given.number);
  if (fault == std::errc() && end == column.data() + column.size()) {
    given.header.clear();
    if (given.number == 0) return "columns count from 1, but `" + std::string(word) + "` is column 0";
  } else {
    given.number = 0;
  }
  map.columns.push_back(std::move(given));
  return base::Result<ColumnMap, std::string>(std::move(map));
}

base::Result<ColumnMap, std::string> column_map_of(std::string_view text) {
  ColumnMap map;
  for (;;) {
    const std::size_t comma = text.find(',');
    const std::string_view entry = trimmed(text.substr(0, comma));
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) {
      return "`" + std::string(entry) + "` is not a column; write it as name=Tag or address=3";
    }
    auto next = with_column(std::move(map), trimmed(entry.substr(0, equals)), trimmed(entry.substr(equals + 1)));
    if (!next) return next.error();
    map = std::move(*next);
    if (comma == std::string_view::npos) return base::Result<ColumnMap, std::string>(std::move(map));
    text.remove_prefix(comma + 1);
  }
}

}  // namespace symplant::read

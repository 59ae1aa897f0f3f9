// Reads the expectation table.
#include "table.hpp"

#include <array>
#include <sstream>
#include <stdexcept>

#include "words.hpp"

namespace symplant::conformance {

namespace {

/// "A | B | C" as three texts.
std::array<std::string, 3> three(const std::string& text) {
  const std::vector<std::string> parts = split(text, " | ");
  if (parts.size() != 3) throw std::runtime_error("three texts with ` | ` between them are wanted");
  return {parts[0], parts[1], parts[2]};
}

class Reader {
 public:
  void line(const std::string& text) {
    if (text.empty() || text[0] == '#') return;
    if (text[0] == ' ') {
      indented(text);
    } else {
      head(text);
    }
  }
  std::vector<Row> rows;

 private:
  void head(const std::string& text) {
    const std::size_t blank = text.find(' ');
    if (blank == text.npos) throw std::runtime_error("`part`, `row` or `matrix`, and what of it, are wanted");
    const std::string verb = text.substr(0, blank);
    const std::string rest = text.substr(blank + 1);
    in_matrix_ = verb == "matrix";
    if (verb == "part") {
      part_ = rest;
    } else if (verb == "row") {
      const auto [id, source, what] = three(rest);
      rows.push_back(
          {.part = part_, .id = id, .source = source, .what = what, .steps = {}, .address = {}, .cells = {}});
    } else if (in_matrix_) {
      const auto [function, source, what] = three(rest);
      matrix_ = {
          .part = part_, .id = function, .source = source, .what = what, .steps = {}, .address = {}, .cells = {}};
      matrix_.function = std::stoi(function, nullptr, 16);
      matrix_.write_part = function.find("write") != function.npos;
      columns_.clear();
    } else {
      throw std::runtime_error("`" + verb + "` begins no line");
    }
  }

  void indented(const std::string& text) {
    if (!in_matrix_) {
      if (rows.empty()) throw std::runtime_error("a step of no row");
      rows.back().steps.push_back(text.substr(text.find_first_not_of(' ')));
      return;
    }
    std::vector<std::string> cells = words(text);
    const std::string first = cells.front();
    cells.erase(cells.begin());
    if (columns_.empty()) {
      for (const std::string& cell : cells) columns_.push_back(static_cast<std::uint32_t>(std::stoul(cell)));
      kind_ = first;
      return;
    }
    if (cells.size() != columns_.size()) throw std::runtime_error("a line of a matrix has a cell a column");
    Row row = matrix_;
    row.address = first;
    row.id += " at " + first;
    row.what += ", " + kind_ + " " + std::to_string(columns_.front());
    for (std::size_t i = 1; i < columns_.size(); ++i) row.what += ", " + std::to_string(columns_[i]);
    for (std::size_t i = 0; i < cells.size(); ++i) row.cells.emplace_back(columns_[i], cells[i]);
    rows.push_back(std::move(row));
  }

  std::string part_;
  bool in_matrix_ = false;
  Row matrix_;
  std::string kind_;
  std::vector<std::uint32_t> columns_;
};

}  // namespace

std::vector<Row> read_table(const std::string& text) {
  Reader reader;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    try {
      reader.line(line);
    } catch (const std::exception& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  return std::move(reader.rows);
}

}  // namespace symplant::conformance

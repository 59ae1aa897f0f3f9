// Writes docs/modbus-conformance.md from the results.
#include "page.hpp"

#include <algorithm>

namespace symplant::conformance {

namespace {

constexpr const char* kHead = R"(# Modbus TCP: what conforms

What a Modbus TCP server must do, row by row, and what three servers do: the plant's own, and for comparison small servers made with
two common libraries, in each library's plain way. Every row was typed from the specifications before a server was asked; the rows with all their
bytes are [a table](../tests/conformance/expectations.txt), which a program plays over plain sockets. A test plays it against
our server in every build, and another one writes this page.

After every row all coils and holding registers are read back: a refused request must have changed nothing.

AP is the Modbus Application Protocol Specification V1.1b3, TCP the Modbus Messaging on TCP/IP Implementation Guide V1.0b. Where a request is wrong in
two ways, the specification can be read in two ways: of others either answer counts, ours gives the one that the function's own diagram gives (value before
address; of mask write the address first). Function 43/14 may also be refused as a whole.

)";

constexpr const char* kTail = R"(
## To repeat it

```text
scripts/test --peers
```

or, with libmodbus and pymodbus installed, in the folder of a build:

```text
ctest -R 'peers: conformance'
```

`--update` of the program `tests/conformance/conformance` writes this page anew. What depends on how fast another's server happens to be (rows of the
stream and of connections) is not compared, nor are pages of other versions of the libraries.
)";

/// For cell contents only: a bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != text.npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

std::string verdict(const Result& result) {
  if (result.good()) return result.of == 1 ? "yes" : std::to_string(result.of) + " of " + std::to_string(result.of);
  const std::string count =
      result.of == 1 ? "**no**" : "**" + std::to_string(result.passed) + "** of " + std::to_string(result.of);
  return count + ": " + result.seen;
}

}  // namespace

std::string page(const std::vector<Row>& rows, const std::vector<Column>& columns) {
  std::string text = kHead;
  text += "| server | rows that conform |\n|---|---|\n";
  for (const Column& column : columns) {
    const auto good =
        std::count_if(column.results.begin(), column.results.end(), [](const Result& one) { return one.good(); });
    text += "| " + column.version + " | " + std::to_string(good) + " of " + std::to_string(rows.size()) + " |\n";
  }
  std::string part;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (row.part != part) {
      part = row.part;
      text += "\n## " + part + "\n\n| row | what | from |";
      for (const Column& column : columns) text += " " + column.name + " |";
      text += "\n|---|---|---|";
      for (std::size_t c = 0; c < columns.size(); ++c) text += "---|";
      text += '\n';
    }
    text += "| " + cell(row.id) + " | " + cell(row.what) + " | " + cell(row.source) + " |";
    for (const Column& column : columns) text += " " + cell(verdict(column.results[i])) + " |";
    text += '\n';
  }
  return text + kTail;
}

}  // namespace symplant::conformance

// Writes docs/modbus-conformance.md from the results.
#include "page.hpp"

#include <algorithm>

namespace symplant::conformance {

namespace {

constexpr const char* kHead = R"(# Modbus TCP: what conforms

What a Modbus TCP server must do, row by row, and what three servers do: the server of symplant and, for comparison, small servers made
with two common libraries as their documentation shows. The rows were written from the specifications, before any server was tested. [A
table](../tests/conformance/expectations.txt) has their bytes; a program sends them over plain sockets. A test does this with our server in
every build, and another one compares this page.

After every row the program reads all coils and holding registers: a refused request must not change any.

AP is the Modbus Application Protocol Specification V1.1b3, TCP the Modbus Messaging on TCP/IP Implementation Guide V1.0b. If a request has two
errors, the specification allows two answers. Either counts for the other servers; ours gives the one in the diagram of the function (value
before address; for mask write the address first). A server may also refuse function 43/14 altogether.

)";

constexpr const char* kTail = R"(
## Repeat the test

```text
scripts/test --peers --campaign
```

or, with libmodbus and pymodbus installed, in the folder of a build:

```text
ctest -R 'modbus-conformance'
```

With `--update`, the program `tests/conformance/conformance` regenerates this page. Rows of the stream and of connections depend on the speed
of the other servers and are not compared. Pages of other versions of the libraries are not compared either.
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

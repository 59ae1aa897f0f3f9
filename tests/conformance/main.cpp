// Plays the expectation table against servers, row by row.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "page.hpp"
#include "server_process.hpp"

namespace {

using namespace symplant::conformance;

constexpr const char* kUsage = R"(usage: conformance TABLE [--page FILE] [--update] [--only TEXT] NAME=COMMAND...

Starts each server by its COMMAND, whose first line must be `PORT COILS DISCRETE HOLDING INPUT VERSION`, and plays the
table against it on the loopback. The first server is ours: all that the table demands is demanded of it. Of the others
differences are reported and are not faults. A server that somebody else has started takes: a script as COMMAND that writes that line and sleeps

  --page FILE   compares docs/modbus-conformance.md with what came; --update writes it
  --only TEXT   plays only rows in whose id TEXT stands

exit code: 0 good, 1 our server fails a row, or the page is another, 2 usage, 77 the page is of other versions
)";

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read `" + path + "`");
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Arguments {
  std::string table, page, only;
  bool update = false;
  std::vector<std::pair<std::string, std::string>> servers;
};

bool read_arguments(int argc, char** argv, Arguments& arguments) {
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t equals = text.find('=');
    if (text == "--update") {
      arguments.update = true;
    } else if ((text == "--page" || text == "--only") && i + 1 < argc) {
      (text == "--page" ? arguments.page : arguments.only) = argv[++i];
    } else if (arguments.table.empty()) {
      arguments.table = text;
    } else if (equals != text.npos) {
      arguments.servers.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    } else {
      return false;
    }
  }
  return !arguments.servers.empty();
}

Column play_all(const std::vector<Row>& rows, const std::string& name, const std::string& command, bool ours) {
  Column column{.name = name, .version = {}, .results = {}};
  auto process = std::make_unique<ServerProcess>(command);
  column.version = process->version();
  for (const Row& row : rows) {
    Server server = process->server();
    server.strict = ours;
    if (!ours) server.patience = 3000;
    Result result = play(row, server);
    if (!result.good()) {
      std::cout << name << ": " << row.id << ": " << row.what << ": " << result.seen << '\n';
      // A fault of one row must not affect the next.
      process.reset();
      process = std::make_unique<ServerProcess>(command);
    }
    column.results.push_back(std::move(result));
  }
  const auto good =
      std::count_if(column.results.begin(), column.results.end(), [](const Result& one) { return one.good(); });
  std::cout << name << " (" << column.version << "): " << good << " of " << rows.size() << " rows" << std::endl;
  return column;
}

/// The lines whose contents do not depend on the speed of another server: no procedures, no totals.
std::vector<std::string> steady_lines(const std::string& page) {
  std::vector<std::string> lines;
  std::istringstream stream(page);
  bool in_sums = true;
  for (std::string line; std::getline(stream, line);) {
    in_sums = in_sums && line.rfind("## ", 0) != 0;
    const bool timed = line.rfind("| stream.", 0) == 0 || line.rfind("| connection.", 0) == 0 ||
                       line.rfind("| codes-", 0) == 0 || (in_sums && line.rfind("| ", 0) == 0);
    if (!timed) lines.push_back(line);
  }
  return lines;
}

/// The compared servers, as the totals name them.
std::vector<std::string> versions(const std::string& page) {
  std::vector<std::string> result;
  std::istringstream stream(page.substr(0, page.find("\n## ")));
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("| ", 0) == 0) result.push_back(line.substr(0, line.find(" | ")));
  }
  return result;
}

int check_page(const Arguments& arguments, const std::string& page) {
  if (arguments.update) {
    std::ofstream(arguments.page, std::ios::binary) << page;
    return 0;
  }
  const std::string there = text_of(arguments.page);
  if (steady_lines(there) == steady_lines(page)) return 0;
  std::ofstream("conformance.md", std::ios::binary) << page;
  std::cout << arguments.page
            << " differs from the results (conformance.md here has them): regenerate it with --update\n";
  return versions(there) == versions(page) ? 1 : 77;
}

int run(const Arguments& arguments) {
  std::vector<Row> rows = read_table(text_of(arguments.table));
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [&](const Row& row) { return row.id.find(arguments.only) == row.id.npos; }),
             rows.end());
  std::vector<Column> columns;
  for (const auto& [name, command] : arguments.servers) {
    columns.push_back(play_all(rows, name, command, columns.empty()));
  }
  const auto& ours = columns.front().results;
  if (!std::all_of(ours.begin(), ours.end(), [](const Result& one) { return one.good(); })) return 1;
  return arguments.page.empty() ? 0 : check_page(arguments, page(rows, columns));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!read_arguments(argc, argv, arguments)) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    std::cerr << "conformance: " << error.what() << '\n';
    return 2;
  }
}

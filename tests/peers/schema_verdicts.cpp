// Prints for each line of the standard input, a JSON value, how many faults it has under a schema.
// usage: schema_verdicts SCHEMA.json
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "symplant/json/schema.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ifstream file(arguments[1]);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const symplant::json::Schema schema(text);
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << schema.check(nlohmann::json::parse(line)).size() << "\n";
  }
  return 0;
}

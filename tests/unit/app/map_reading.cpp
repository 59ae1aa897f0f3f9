// Reads back what symplant map writes for other tools.
#include "map_reading.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace symplant::test {
namespace {

using nlohmann::json;

constexpr std::size_t kWordBits = 16;

/// Calls `use` with each match in the text.
template <typename Use>
void for_each_match(const std::string& text, const std::regex& pattern, Use use) {
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) use(*at);
}

std::size_t number_of(const std::ssub_match& text) { return std::stoul(text.str()); }

/// %IX3.4 is bit 28, %ID5 is word 10.
struct Place {
  bool written;
  bool bits;
  std::size_t at;
};
Place place_of(const std::smatch& match, std::size_t first) {
  const char size = match.str(first + 1)[0];
  const std::size_t number = number_of(match[first + 2]);
  const std::size_t words = size == 'L' ? 4 : size == 'D' ? 2 : 1;
  return {match.str(first) == "Q", size == 'X',
          size == 'X' ? 8 * number + number_of(match[first + 3]) : words * number};
}
const std::string kAddress = R"(%([IQ])([XWDL])(\d+)(?:\.(\d+))?)";

std::string table_of(const Place& place) {
  if (place.bits) return place.written ? "coil" : "discrete input";
  return place.written ? "holding register" : "input register";
}

std::size_t words_of_type(const std::string& type, const std::ssub_match& array) {
  if (array.matched) return number_of(array) + 1;
  if (type == "DINT" || type == "UDINT" || type == "DWORD" || type == "REAL") return 2;
  return type == "LINT" || type == "ULINT" || type == "LWORD" || type == "LREAL" ? 4 : 1;
}

struct ReadChannel {
  Place place;
  std::size_t start;
  std::size_t count;
};

}  // namespace

Registers registers_of(const json& link) {
  Registers found;
  for (const json& symbol : link.at("symbols")) {
    const json& at = symbol.at("on_link");
    if (!at.is_null()) found[symbol.at("symbol")] = {at.at("table"), at.at("number"), at.at("count")};
  }
  if (!link.at("status_block").is_null()) {
    for (const json& field : link.at("status_block")) {
      found[field.at("name")] = {"input register", field.at("number"), field.at("count")};
    }
  }
  if (!link.at("watchdog").is_null()) found["watchdog"] = {"holding register", link.at("watchdog"), 1};
  return found;
}

Registers renamed(const Registers& registers) {
  Registers result;
  for (const auto& [name, where] : registers) {
    std::string made = name;
    if (std::islower(static_cast<unsigned char>(name.front())) != 0) {
      made = "PLANT_";
      for (const char c : name) made += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    const std::string part = made.substr(0, made.find("_W"));
    if (part == "Füllstand") made = "Fu00FCllstand";
    if (part == "BOUND_") made = "BOUND_2";
    result[made] = where;
  }
  return result;
}

Registers words_of(const Registers& registers, const json& link) {
  Registers words;
  std::map<std::string, std::string> orders;
  for (const json& symbol : link.at("symbols")) {
    const json& at = symbol.at("on_link");
    if (!at.is_null() && !at.at("word_order").is_null()) orders[symbol.at("symbol")] = at.at("word_order");
  }
  for (const auto& [name, where] : registers) {
    if (where.count == 1) words[name] = where;
    const bool low = (orders.count(name) != 0 ? orders[name] : link.at("word_order").get<std::string>()) == "low-first";
    const std::string made = renamed({{name, where}}).begin()->first;
    for (std::size_t i = 0; where.count > 1 && i < where.count; ++i) {
      words[made + "_W" + std::to_string(low ? i : where.count - 1 - i)] = {where.table, where.first + i, 1};
    }
  }
  return words;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

Declarations declarations_of(const std::string& text, bool overlaid) {
  Declarations read;
  std::vector<ReadChannel> channels;
  for_each_match(text, std::regex(R"(function \d+ +start (\d+) +count (\d+) +from )" + kAddress),
                 [&](const auto& match) {
                   channels.push_back({place_of(match, 3), number_of(match[1]), number_of(match[2])});
                 });
  const auto begin = [&](const Place& place) { return place.at * (place.bits || !overlaid ? 1 : kWordBits); };
  const auto length = [&](const ReadChannel& c) { return c.count * (c.place.bits || !overlaid ? 1 : kWordBits); };
  for (const ReadChannel& a : channels) {
    for (const ReadChannel& b : channels) {
      if (&a == &b || a.place.written != b.place.written || (!overlaid && a.place.bits != b.place.bits)) continue;
      if (begin(a.place) < begin(b.place) + length(b) && begin(b.place) < begin(a.place) + length(a))
        read.overlap = true;
    }
  }
  const std::regex declaration(R"(\n  (\w+) AT )" + kAddress + R"( : (?:ARRAY \[0\.\.(\d+)\] OF )?(\w+);)");
  for_each_match(text, declaration, [&](const auto& match) {
    const Place place = place_of(match, 2);
    const std::size_t count = words_of_type(match.str(7), match[6]);
    if (!match[6].matched) read.addressed[match.str(1)] = {table_of(place), place.at, count};
    for (const ReadChannel& channel : channels) {
      if (channel.place.bits != place.bits || channel.place.written != place.written || place.at < channel.place.at ||
          place.at + count > channel.place.at + channel.count) {
        continue;
      }
      read.located[match.str(1)] = {table_of(place), channel.start + (place.at - channel.place.at), count};
    }
  });
  return read;
}

namespace {

/// What OpenPLC's parser finds between two quotes, for a buffer of this size.
std::string quoted_part(const std::string& line, std::size_t buffer) {
  const std::size_t first = line.find('"');
  if (first == std::string::npos) throw std::runtime_error("no quotes: " + line);
  const std::string part = line.substr(first + 1, line.find('"', first + 1) - first - 1);
  if (part.size() >= buffer) throw std::runtime_error("OpenPLC's buffer overflows: " + line);
  return part;
}

struct Slave {
  std::map<std::string, std::size_t> numbers;
};

std::vector<Slave> parse_config(const std::string& text) {
  constexpr std::array<const char*, 10> kBlocks{"Discrete_Inputs_Start",
                                                "Discrete_Inputs_Size",
                                                "Coils_Start",
                                                "Coils_Size",
                                                "Input_Registers_Start",
                                                "Input_Registers_Size",
                                                "Holding_Registers_Read_Start",
                                                "Holding_Registers_Read_Size",
                                                "Holding_Registers_Start",
                                                "Holding_Registers_Size"};
  std::vector<Slave> slaves;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() <= 1 || line[0] == '#') continue;
    if (line.starts_with("Num_Devices")) slaves.resize(std::stoul(quoted_part(line, 5)));
    if (line.starts_with("Polling_Period") || line.starts_with("Timeout")) quoted_part(line, 10);
    if (!line.starts_with("device")) continue;
    const std::size_t dot = line.find('.');
    Slave& slave = slaves.at(std::stoul(line.substr(6, dot - 6)));
    const std::string key = line.substr(dot + 1, line.find_first_of(" =(", dot) - dot - 1);
    const auto block = std::find(kBlocks.begin(), kBlocks.end(), key);
    if (block != kBlocks.end()) {
      slave.numbers[key] = std::stoul(quoted_part(line, 10));
    } else if (key == "protocol") {
      if (quoted_part(line, 5) != "TCP") throw std::runtime_error(line);
    } else if (key == "IP_Port") {
      quoted_part(line, 6);
    } else if (key == "slave_id") {
      quoted_part(line, 5);
    } else if (key == "name" || key == "address") {
      quoted_part(line, 100);
    } else {
      throw std::runtime_error("OpenPLC does not read this key: " + line);
    }
  }
  return slaves;
}

/// The numbers of a table in the order of OpenPLC's buffer.
std::vector<std::size_t> buffer_of(const std::vector<Slave>& slaves, const std::string& table, std::size_t limit) {
  std::vector<std::size_t> buffer;
  for (const Slave& slave : slaves) {
    const std::size_t size = slave.numbers.at(table + "_Size");
    if (size > limit) throw std::runtime_error("libmodbus refuses " + std::to_string(size) + " of " + table);
    for (std::size_t i = 0; i < size; ++i) buffer.push_back(slave.numbers.at(table + "_Start") + i);
  }
  constexpr std::size_t kMost = 400;
  if (buffer.size() > kMost) throw std::runtime_error("OpenPLC has 400 of " + table);
  return buffer;
}

}  // namespace

Registers openplc_registers(const std::string& text) {
  const std::vector<Slave> slaves = parse_config(text);
  const std::map<std::string, std::vector<std::size_t>> buffers{
      {"discrete input", buffer_of(slaves, "Discrete_Inputs", 2000)},
      {"coil", buffer_of(slaves, "Coils", 1968)},
      {"input register", buffer_of(slaves, "Input_Registers", 125)},
      {"holding register", buffer_of(slaves, "Holding_Registers", 123)}};
  Registers found;
  for_each_match(text, std::regex(R"(#   (\w+) AT )" + kAddress + R"( : (\w+);)"), [&](const auto& match) {
    const Place place = place_of(match, 2);
    const std::string table = table_of(place);
    found[match.str(1)] = {table, buffers.at(table).at(place.at - (place.bits ? 800 : 100)), 1};
  });
  return found;
}

std::vector<Numbers> openplc_blocks(const std::string& text) {
  std::vector<Numbers> blocks;
  for (const Slave& slave : parse_config(text)) {
    const auto add = [&](const std::string& table, const std::string& key) {
      blocks.push_back({table, slave.numbers.at(key + "_Start"), slave.numbers.at(key + "_Size")});
    };
    add("input register", "Input_Registers");
    add("holding register", "Holding_Registers");
  }
  return blocks;
}

}  // namespace symplant::test

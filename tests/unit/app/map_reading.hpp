// Reads back what symplant map writes for other tools.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace symplant::test {

/// Coils or registers of a link.
struct Numbers {
  std::string table;
  std::size_t first;
  std::size_t count;

  friend bool operator==(const Numbers&, const Numbers&) = default;
};
using Registers = std::map<std::string, Numbers>;

/// Symbols, fields of the status block and the watchdog, by name, of a link in the JSON form.
Registers registers_of(const nlohmann::json& link);

/// The same under the names of variables: `PLANT_` before parts of the status block, and names that identifiers can be.
Registers renamed(const Registers& registers);

/// A register each: a number of several becomes NAME_W1 and NAME_W0, in the word order of the link.
Registers words_of(const Registers& registers, const nlohmann::json& link);

/// The cells of a line of CSV.
std::vector<std::string> cells_of(const std::string& line);

/// Variables of structured text, by the channels in its first comment.
struct Declarations {
  Registers located;     ///< where the channels transfer each variable
  Registers addressed;   ///< the variables that have an elementary type, by their address: table and number
  bool overlap = false;  ///< two channels have a bit of the PLC's memory in common
};
Declarations declarations_of(const std::string& text, bool overlaid);

/// Where the variables in the comments of an mbconfig.cfg are. Reads the file by the rules of OpenPLC v3
/// (modbus_master.cpp), and throws where its parser or its memory would be overrun.
Registers openplc_registers(const std::string& text);

/// The blocks of input registers and of written holding registers of all devices.
std::vector<Numbers> openplc_blocks(const std::string& text);

}  // namespace symplant::test

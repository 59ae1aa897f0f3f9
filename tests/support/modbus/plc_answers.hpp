// The memory of a PLC that serves Modbus, and its answers to requests; written from the protocol alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <vector>

namespace symplant::test::modbus {

using Bytes = std::vector<std::uint8_t>;

/// An area; its value is the digit of its function for reading.
enum class PlcArea : std::uint8_t { coils = 1, discrete_inputs = 2, holding_registers = 3, input_registers = 4 };

/// The values of each area by address; bits are 0 or 1. Addresses in `holes` do not exist.
struct PlcMemory {
  std::vector<std::uint16_t> coils = std::vector<std::uint16_t>(1000);
  std::vector<std::uint16_t> discrete_inputs = std::vector<std::uint16_t>(1000);
  std::vector<std::uint16_t> holding_registers = std::vector<std::uint16_t>(1000);
  std::vector<std::uint16_t> input_registers = std::vector<std::uint16_t>(1000);
  std::set<std::pair<PlcArea, std::size_t>> holes = {};

  std::vector<std::uint16_t>& of(PlcArea area);
};

/// What a PLC of this kind can do.
struct PlcAbilities {
  std::set<int> functions = {1, 2, 3, 4, 15, 16, 43};  ///< others get exception 01
  std::set<int> silent_functions = {};                 ///< these get no answer
  std::string vendor = "Test PLC";                     ///< by function 43
  std::size_t most_registers = 125;                    ///< in one reading request; more gets exception 03
  int busy = 0;                                        ///< the next requests get exception 06
  std::deque<std::uint8_t> exceptions = {};            ///< the next requests get these
  std::set<int> closing_functions = {};                ///< these close the connection without an answer
  std::size_t closes_after = 0;                        ///< answers of a connection; 0: it stays open
};

/// A request to write that was executed.
struct Written {
  PlcArea area = PlcArea::coils;
  std::size_t first = 0;
  std::vector<std::uint16_t> values;
};

/// The answer to a PDU: the PDU of the reply, empty if there is none, and what was written.
struct PlcAnswer {
  Bytes reply;
  std::vector<Written> written;
};

PlcAnswer answer_of(const Bytes& request, PlcMemory& memory, PlcAbilities& abilities);

}  // namespace symplant::test::modbus

// Plays rows of the table against a server and tells what came of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/raw_client.hpp"
#include "table.hpp"
#include "words.hpp"

namespace symplant::conformance {

/// A server under test, which is on this machine.
struct Server {
  std::uint16_t port = 0;
  Sizes sizes{};
  int patience = 10'000;  ///< milliseconds to wait for what must come
  bool strict = true;     ///< what stands behind `/` in the table is a fault
};

/// What came of a row: `passed` of `of` checks, and of the first one that failed what was seen instead.
struct Result {
  int passed = 0;
  int of = 1;
  std::string seen;

  bool good() const { return passed == of; }
};

/// A frame, or why there is none.
struct Seen {
  enum class Kind { frame, closed, nothing, garbled } kind = Kind::nothing;
  int transaction = 0;
  int unit = 0;
  Bytes pdu;

  std::string text() const;
};

/// What the server's coils and holding registers must hold. Everything else of its memory stands still.
struct Memory {
  std::vector<bool> coils;
  std::vector<std::uint16_t> registers;

  explicit Memory(const Sizes& sizes);
  static bool discrete(std::uint32_t place) { return place % 5 < 2; }
  /// Input registers beyond those that every server of this test has are its own: `any` is set for them.
  static std::uint16_t input(std::uint32_t place) { return static_cast<std::uint16_t>(0xF000 + place); }
};

/// The next frame from a server, waited for as long as the client's patience lasts.
Seen next_frame(const test::RawClient& client);
test::RawClient connect_to(const Server& server);

/// Plays one row, on connections of its own. The server's memory is set before it and compared behind it.
Result play(const Row& row, const Server& server);

// --- parts of it, in files of their own

/// Steps and procedures return what was seen where it is not what must come, else nothing.
std::string play_steps(const Row& row, const Server& server, Memory& memory);
std::string play_procedure(const std::string& name, const Server& server, Memory& memory);
/// The request of a matrix's cell; `memory` becomes what it asks to write.
struct Cell {
  Bytes request;
  Bytes answer;  ///< where it is good
};
Cell cell_of(const Row& row, std::uint32_t value, const Sizes& sizes, Memory& memory);

/// Writes the whole memory; false where the server does not take it.
bool fill(const Server& server, const Memory& memory);
/// Reads the whole memory back on a new connection: nothing, or what is wrong.
std::string compare(const Server& server, const Memory& memory);

}  // namespace symplant::conformance

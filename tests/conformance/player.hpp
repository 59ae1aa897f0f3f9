// Plays rows of the table against a server and reports the results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/raw_client.hpp"
#include "table.hpp"
#include "words.hpp"

namespace symplant::conformance {

/// A server under test, on this machine.
struct Server {
  std::uint16_t port = 0;
  Sizes sizes{};
  int patience = 10'000;  ///< milliseconds to wait for an expected frame
  bool strict = true;     ///< the alternative after `/` in the table counts as a fault
};

/// The result of a row: `passed` of `of` checks passed; of the first failure, what was seen instead.
struct Result {
  int passed = 0;
  int of = 1;
  std::string seen;

  bool good() const { return passed == of; }
};

/// A frame, or why no frame came.
struct Seen {
  enum class Kind { frame, closed, nothing, garbled } kind = Kind::nothing;
  int transaction = 0;
  int unit = 0;
  Bytes pdu;

  std::string text() const;
};

/// What the server's coils and holding registers must hold. The rest of its memory does not change.
struct Memory {
  std::vector<bool> coils;
  std::vector<std::uint16_t> registers;

  explicit Memory(const Sizes& sizes);
  static bool discrete(std::uint32_t address) { return address % 5 < 2; }
  /// A server may have more input registers than this test uses: `any` is set for those.
  static std::uint16_t input(std::uint32_t address) { return static_cast<std::uint16_t>(0xF000 + address); }
};

/// The next frame from a server; waits as long as the client's patience lasts.
Seen next_frame(const test::RawClient& client);
test::RawClient connect_to(const Server& server);

/// Plays one row, on separate connections. Sets the server's memory before the row and compares it after.
Result play(const Row& row, const Server& server);

// --- parts of play(), in separate files

/// Steps and procedures return what was seen if it differs from the expected, else nothing.
std::string play_steps(const Row& row, const Server& server, Memory& memory);
std::string play_procedure(const std::string& name, const Server& server, Memory& memory);
/// The request of a matrix cell; sets `memory` to what the request writes.
struct Cell {
  Bytes request;
  Bytes answer;  ///< if it is valid
};
Cell cell_of(const Row& row, std::uint32_t value, const Sizes& sizes, Memory& memory);

/// Writes the whole memory; false if the server rejects it.
bool fill(const Server& server, const Memory& memory);
/// Reads the whole memory back on a new connection: returns nothing, or the difference.
std::string compare(const Server& server, const Memory& memory);

}  // namespace symplant::conformance

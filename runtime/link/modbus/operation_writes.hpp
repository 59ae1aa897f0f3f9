// Finds operations that came and went between two cycles, and those that several clients write.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/image/server_findings.hpp"
#include "symplant/link/modbus/io_map.hpp"

namespace symplant::link::modbus {

/// A client of a server.
struct ClientId {
  std::uint32_t connection = 0;  ///< a unique number of its connection; 0: unknown
  std::uint32_t ipv4 = 0;        ///< its address; 0: another kind of address
};

/// Used by the server's thread. A write costs one step for each 64 coils or 4 registers written, and more for what it
/// changes. Only the constructor allocates.
class OperationWrites {
 public:
  /// Call changed() with the initial tables before the first write.
  OperationWrites(const IoMap& map, image::ServerFindings& findings);

  /// A client wrote `count` coils, or holding registers, from `first` on; `words` is the table with them, which image
  /// `image` will publish.
  void wrote_coils(const ClientId& client, std::uint32_t first, std::uint32_t count,
                   std::span<const std::uint64_t> words, std::uint64_t image) noexcept;
  void wrote_registers(const ClientId& client, std::uint32_t first, std::uint32_t count,
                       std::span<const std::uint64_t> words, std::uint64_t image) noexcept;
  /// The tables have changed without a write of a client; takes their contents. O(tables).
  void changed(std::span<const std::uint64_t> coils, std::span<const std::uint64_t> registers) noexcept;
  /// A client has closed its connection: its writes no longer count as those of another client.
  void left(const ClientId& client) noexcept;

 private:
  using Clock = std::chrono::steady_clock;

  /// One of the two tables that clients write.
  struct Written {
    std::vector<std::uint64_t> words;    ///< as after the last write
    std::vector<std::uint32_t> symbols;  ///< by address: the first symbol; tables::kNone
  };
  /// The last change of a coil.
  struct Change {
    std::uint64_t image = 0;
    Clock::time_point time;
    bool returned = false;  ///< to the value that the cycle has taken
  };
  struct Write {
    ClientId client;
    std::uint64_t image = 0;
    const Written* table = nullptr;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  void note(const Write& write) noexcept;
  void find_unsampled(std::uint32_t coil, bool on, Clock::time_point now, std::uint64_t image) noexcept;
  void find_other_writer(const Write& write, std::uint32_t address) noexcept;

  image::ServerFindings& findings_;
  Written coils_;
  Written registers_;
  std::vector<Change> changes_;         ///< by coil
  std::vector<std::uint8_t> reported_;  ///< by symbol: several clients write it
  std::array<Write, 32> writes_{};      ///< the last ones, of all clients
  std::size_t next_ = 0;                ///< in writes_
};

}  // namespace symplant::link::modbus

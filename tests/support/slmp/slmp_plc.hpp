// A PLC that serves SLMP on the loopback: TCP and UDP, frames 3E and 4E, written from the SLMP reference alone.
//
//   SlmpPlc plc({.profile = profile_of(Family::q), .program = [](PlcMemory& memory) {
//                  memory.set_bit("Y", 0x20, memory.bit("X", 0x10));
//                }});
//   connect_to("127.0.0.1", plc.port());
//   plc.wait_until([&] { return plc.memory().bit("Y", 0x20); });
//   CHECK(plc.log().writes_outside({{"X", 0x10, 16}}).empty());
//   CHECK(plc.log().violations().empty());
//
// Requests are served between two scans, never within one. A read of 960 words takes about 13 us over TCP. All
// functions may be called from any thread, but not from the scan program or a delivery hook.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/slmp/plc_frames.hpp"
#include "support/slmp/plc_log.hpp"
#include "support/slmp/plc_memory.hpp"
#include "support/slmp/plc_profile.hpp"
#include "support/slmp/plc_sockets.hpp"

namespace symplant::test::slmp {

using ScanProgram = std::function<void(PlcMemory&)>;

struct PlcOptions {
  /// What the PLC can do; the members of a profile can be changed, for example `has_4e` of a Q CPU.
  PlcProfile profile = profile_of(Family::iqr);
  /// A request in the other code gets no reply.
  Code code = Code::binary;
  bool tcp = true;
  bool udp = true;
  std::uint16_t port = 0;  ///< 0: any that is free, the same for TCP and UDP
  /// Further ones are reset at once.
  std::size_t most_connections = 1;
  /// "Enable online change". If false, writes in RUN get 0055.
  bool writes_in_run = true;
  /// X that input modules own: before each scan they take the state of the terminals, see set_terminal().
  std::vector<DeviceRange> refreshed = {};
  ScanProgram program = {};
  /// 0: only scan_once() scans. Without a program and refreshed X there is no scan thread.
  std::chrono::milliseconds scan_interval{1};
  /// X becomes 0 at each change between RUN and STOP, as GX Simulator3 does.
  bool clears_x_at_run_change = false;
  /// Requests for other stations get C05F.
  Route route = {};
  std::string model = {};        ///< empty: one of the family
  std::uint16_t model_code = 0;  ///< 0: that of the family
  /// In ASCII, X and Y of an FX5 are octal; the reference has no proof of it.
  bool has_octal_ascii_on_fx5 = true;
};

/// A request that has a reply, as a delivery hook sees it.
struct Exchange {
  Peer peer;
  RequestFrame request;
  Code code;
  std::uint16_t end_code;
  Bytes reply;
};
/// Decides how a reply leaves. Called on the server's thread.
using DeliveryHook = std::function<Delivery(const Exchange&)>;

class SlmpPlc {
 public:
  /// Serves from now on. Throws std::runtime_error if the port is taken.
  explicit SlmpPlc(PlcOptions options = {}, DeliveryHook hook = {});
  ~SlmpPlc();
  SlmpPlc(const SlmpPlc&) = delete;
  SlmpPlc& operator=(const SlmpPlc&) = delete;

  std::uint16_t port() const;
  PlcMemory& memory();
  const PlcMemory& memory() const;
  PlcLog& log();
  const PlcLog& log() const;

  /// A silent PLC accepts connections and requests, executes nothing and does not reply.
  void set_silent(bool on);
  /// Ends every connection with a FIN, or a reset. Has done so on return.
  void close_connections(bool with_reset = false);
  /// While on, connection attempts are refused. Open connections stay.
  void refuse_connections(bool on);
  std::size_t connections() const;
  /// Attempts above `most_connections`.
  std::size_t refused_connections() const;

  /// One I/O refresh and one scan of the program, unless in STOP.
  void scan_once();
  std::uint64_t scans() const;
  /// RUN (as at first) or STOP: without scans, writes always allowed, SD203 is 2.
  void set_running(bool on);
  void set_writes_in_run(bool on);
  /// The state of an input terminal in `refreshed`; off at first.
  void set_terminal(std::uint32_t x_number, bool on);

  /// Waits until the condition holds; looks at it after each request, scan, and change of the connections. False after
  /// `patience`.
  bool wait_until(const std::function<bool()>& holds,
                  std::chrono::milliseconds patience = std::chrono::seconds(20)) const;

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace symplant::test::slmp

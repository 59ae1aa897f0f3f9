// Executes device requests on a PLC's memory.
#pragma once

#include <string>

#include "support/slmp/plc_log.hpp"
#include "support/slmp/plc_request.hpp"

namespace symplant::test::slmp {

/// The CPU as its commands see it.
struct Cpu {
  PlcProfile profile{};
  Code code = Code::binary;
  bool has_octal_input_output = false;  ///< X and Y are octal in ASCII
  bool accepts_writes = true;
  Route route;
  std::string model;
  std::uint16_t model_code = 0;
};

struct Outcome {
  std::uint16_t end_code = kOk;
  Bytes data;                  ///< of the reply, as on the wire
  LoggedRequest log;           ///< transport not filled in
  bool has_duplicate = false;  ///< a random or block write names a point twice
};

/// A random or block write that fails has applied the items before the one that failed, as some CPUs do.
Outcome execute(const RequestFrame& frame, const Cpu& cpu, PlcMemory& memory);

}  // namespace symplant::test::slmp

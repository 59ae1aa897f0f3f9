// The controller's input and output images, exchanged with the plant over Modbus TCP.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "program.hpp"

// The handle of libmodbus, declared here so that only io.cpp includes its header.
struct _modbus;

namespace excell {

class Io {
 public:
  /// Connects, trying again until `timeout` has passed. Check connected() afterwards.
  Io(const std::string& host, const std::string& port, std::chrono::milliseconds timeout);

  bool connected() const { return connected_; }
  /// Reads discrete inputs 1 to 4; false if the plant did not answer.
  bool read(Inputs& in);
  /// Writes coils 1 to 4; false if the plant did not answer.
  bool write(const Outputs& out);
  /// Why the last of these calls failed.
  std::string error() const;

 private:
  struct Close {
    void operator()(_modbus* context) const;
  };

  std::unique_ptr<_modbus, Close> context_;
  bool connected_ = false;
  int error_ = 0;
};

}  // namespace excell

// The controller's input and output images, exchanged with the plant over Modbus TCP.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "program.hpp"

// libmodbus' handle, so that its header stays in one file.
struct _modbus;

namespace excell {

class Io {
 public:
  /// Connects, trying again until `timeout` has passed. Check connected() afterwards.
  Io(const std::string& host, const std::string& port, std::chrono::milliseconds timeout);

  bool connected() const { return connected_; }
  /// Discrete inputs 1 to 4; false where the plant did not answer.
  bool read(Inputs& in);
  /// Coils 1 to 4; false where the plant did not answer.
  bool write(const Outputs& out);
  /// Why the last of these failed.
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

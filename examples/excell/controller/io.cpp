// The controller's images over Modbus TCP, by libmodbus.
#include "io.hpp"

#include <modbus/modbus.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <thread>

namespace excell {

namespace {

constexpr int kFirst = 1;  ///< X0001 is discrete input 1, Y0001 is coil 1
constexpr int kCount = 4;
constexpr std::chrono::milliseconds kRetry{50};
constexpr std::uint32_t kAnswerSeconds = 2;

}  // namespace

void Io::Close::operator()(_modbus* context) const {
  modbus_close(context);
  modbus_free(context);
}

Io::Io(const std::string& host, const std::string& port, std::chrono::milliseconds timeout)
    : context_(modbus_new_tcp_pi(host.c_str(), port.c_str())) {
  if (!context_) {
    error_ = errno;
    return;
  }
  modbus_set_response_timeout(context_.get(), kAnswerSeconds, 0);
  const auto end = std::chrono::steady_clock::now() + timeout;
  for (;;) {
    connected_ = modbus_connect(context_.get()) == 0;
    if (connected_) return;
    error_ = errno;
    if (std::chrono::steady_clock::now() >= end) return;
    std::this_thread::sleep_for(kRetry);
  }
}

bool Io::read(Inputs& in) {
  std::array<std::uint8_t, kCount> bits{};
  if (modbus_read_input_bits(context_.get(), kFirst, kCount, bits.data()) != kCount) {
    error_ = errno;
    return false;
  }
  in = {.agv_p1 = bits[0] != 0, .agv_p2 = bits[1] != 0, .mc_idle1 = bits[2] != 0, .mc_run2 = bits[3] != 0};
  return true;
}

bool Io::write(const Outputs& out) {
  const std::array<std::uint8_t, kCount> bits = {out.agv_p2, out.agv_p1, out.mc_idle1, out.mc_run2};
  if (modbus_write_bits(context_.get(), kFirst, kCount, bits.data()) == kCount) return true;
  error_ = errno;
  return false;
}

std::string Io::error() const { return modbus_strerror(error_); }

}  // namespace excell

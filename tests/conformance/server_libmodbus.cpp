// A server made with libmodbus, for comparison: the loop of the libmodbus example for many clients.
#include <arpa/inet.h>
#include <modbus/modbus.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <vector>

namespace {

constexpr int kBits = 2016;
constexpr int kRegisters = 160;

void serve(modbus_t* context, modbus_mapping_t* mapping, int listener) {
  std::vector<pollfd> polled = {{listener, POLLIN, 0}};
  for (;;) {
    if (::poll(polled.data(), polled.size(), -1) <= 0) continue;
    for (std::size_t i = polled.size(); i-- > 1;) {
      if (polled[i].revents == 0) continue;
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
      modbus_set_socket(context, polled[i].fd);
      const int size = modbus_receive(context, request.data());
      if (size > 0) modbus_reply(context, request.data(), size, mapping);
      if (size >= 0) continue;
      ::close(polled[i].fd);
      polled.erase(polled.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if ((polled[0].revents & POLLIN) == 0) continue;
    const int client = ::accept(listener, nullptr, nullptr);
    const int on = 1;
    ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);  // as libmodbus itself does when it accepts
    if (client >= 0) polled.push_back({client, POLLIN, 0});
  }
}

}  // namespace

int main() {
  modbus_t* context = modbus_new_tcp("127.0.0.1", 0);
  modbus_mapping_t* mapping = modbus_mapping_new(kBits, kBits, kRegisters, kRegisters);
  if (context == nullptr || mapping == nullptr) return 3;
  for (int i = 0; i < kBits; ++i) mapping->tab_input_bits[i] = i % 5 < 2 ? 1 : 0;
  for (int i = 0; i < kRegisters; ++i) mapping->tab_input_registers[i] = static_cast<std::uint16_t>(0xF000 + i);
  const int listener = modbus_tcp_listen(context, 64);
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (listener < 0 || ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 3;
  std::cout << ntohs(address.sin_port) << ' ' << kBits << ' ' << kBits << ' ' << kRegisters << ' ' << kRegisters
            << " libmodbus " << LIBMODBUS_VERSION_STRING << std::endl;
  serve(context, mapping, listener);
}

// A PLC that serves SLMP on the loopback.
#include "support/slmp/slmp_plc.hpp"

#include "support/slmp/plc_server.hpp"

namespace symplant::test::slmp {

SlmpPlc::SlmpPlc(PlcOptions options, DeliveryHook hook)
    : server_(std::make_unique<Server>(std::move(options), std::move(hook))) {}
SlmpPlc::~SlmpPlc() = default;

std::uint16_t SlmpPlc::port() const { return server_->sockets->port(); }
PlcMemory& SlmpPlc::memory() { return server_->memory; }
const PlcMemory& SlmpPlc::memory() const { return server_->memory; }
PlcLog& SlmpPlc::log() { return server_->log; }
const PlcLog& SlmpPlc::log() const { return server_->log; }

void SlmpPlc::set_silent(bool on) { server_->is_silent = on; }
void SlmpPlc::close_connections(bool with_reset) { server_->sockets->close_connections(with_reset); }
void SlmpPlc::refuse_connections(bool on) { server_->sockets->refuse_connections(on); }
std::size_t SlmpPlc::connections() const { return server_->sockets->connections(); }
std::size_t SlmpPlc::refused_connections() const { return server_->refused_connections; }

void SlmpPlc::scan_once() { server_->scan_once(); }
std::uint64_t SlmpPlc::scans() const { return server_->scans; }
void SlmpPlc::set_running(bool on) { server_->set_running(on); }
void SlmpPlc::set_writes_in_run(bool on) { server_->writes_in_run = on; }
void SlmpPlc::set_terminal(std::uint32_t x_number, bool on) { server_->set_terminal(x_number, on); }

bool SlmpPlc::wait_until(const std::function<bool()>& holds, std::chrono::milliseconds patience) const {
  return server_->wait_until(holds, patience);
}

}  // namespace symplant::test::slmp

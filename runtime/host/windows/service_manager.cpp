// Windows has no systemd: nothing listens.
#include "symplant/host/service_manager.hpp"

namespace symplant::host {

ServiceManager ServiceManager::of_environment() { return {std::string(), 0}; }

ServiceManager::ServiceManager(const std::string& /*socket*/, tables::Time /*watchdog*/) {}

ServiceManager::ServiceManager(ServiceManager&& other) noexcept = default;

ServiceManager::~ServiceManager() = default;

bool ServiceManager::report(const std::string& /*state*/) const noexcept { return false; }

}  // namespace symplant::host

// The settings of security that both links of OPC UA have.
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

Problem read_security(std::string_view text, SecuritySettings& settings) {
  constexpr std::array kNames = {std::pair{std::string_view("none"), Security::none},
                                 std::pair{std::string_view("sign"), Security::sign},
                                 std::pair{std::string_view("encrypt"), Security::encrypt}};
  return choose(kNames, text, settings.security);
}

Problem contradiction(const SecuritySettings& settings) {
  if (settings.security == Security::none) {
    if (!settings.user.empty() || !settings.password_file.empty()) {
      return "`user` and `password-file` need `security=sign` or `security=encrypt`: without security no password is "
             "sent";
    }
    if (!settings.certificate.empty() || !settings.key.empty() || !settings.trust.empty()) {
      return "`certificate`, `key` and `trust` need `security=sign` or `security=encrypt`";
    }
  }
  if (settings.user.empty() != settings.password_file.empty()) {
    return "`user` and `password-file` belong together: give both, or neither";
  }
  if (settings.certificate.empty() != settings.key.empty()) {
    return "`certificate` and `key` belong together: give both, or neither";
  }
  return {};
}

}  // namespace symplant::link::opc_ua

// Addresses of hosts in canonical form.
#include "description/ip_address.hpp"

#include <boost/asio/ip/address.hpp>

namespace symplant::description {

std::optional<std::string> canonical_ip_address(const std::string& text) {
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(text, error);
  if (error) return std::nullopt;
  if (address.is_v6() && address.to_v6().is_v4_mapped()) {
    return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6()).to_string();
  }
  return address.to_string();
}

}  // namespace symplant::description

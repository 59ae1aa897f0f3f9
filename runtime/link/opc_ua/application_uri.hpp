// The URI of the application in a certificate.
#pragma once

#include <string>
#include <string_view>

namespace symplant::link::opc_ua {

/// The first URI among the subject's alternative names of a certificate in DER, by which OPC UA knows an application;
/// empty if it has none, or is no such certificate. O(length).
std::string application_uri_of(std::string_view certificate);

}  // namespace symplant::link::opc_ua

// Status codes of OPC UA in plain words.
#include "symplant/link/opc_ua/status_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace symplant::link::opc_ua {

namespace {

struct Row {
  std::uint16_t code;
  std::string_view name;
  std::string_view meaning;
  std::string_view action;
};

constexpr std::string_view kNodes =
    "check the node ids (`nodes` of the link, `node` in plant.json) in a browser of OPC UA, and that the PLC offers "
    "the "
    "variable to OPC UA";
constexpr std::string_view kRights = "allow it for the variable in the PLC, or log in as a user that has the right";
constexpr std::string_view kLater = "the link tries it again";
constexpr std::string_view kOwnCertificate =
    "trust the certificate of this link in the server; give `certificate` and `key`, so that each run has the same one";
constexpr std::string_view kServer = "look at the state and the log of the server";

/// OPC 10000-6, annex A.2; ascending.
constexpr std::array kRows = {
    Row{0x8002, "BadInternalError", "an error in the server", kServer},
    Row{0x8003, "BadOutOfMemory", "the server lacks memory", kServer},
    Row{0x8004, "BadResourceUnavailable", "the server lacks something it needs", kServer},
    Row{0x8005, "BadCommunicationError", "the server does not reach the source of the value", kServer},
    Row{0x8008, "BadEncodingLimitsExceeded", "the message is too long for the server", kLater},
    Row{0x800A, "BadTimeout", "the server did not answer in time", "check its load, or give a longer `timeout`"},
    Row{0x800B, "BadServiceUnsupported", "the server does not have this service", kServer},
    Row{0x800C, "BadShutdown", "the server is shutting down", kLater},
    Row{0x800D, "BadServerNotConnected", "there is no connection to the server", kLater},
    Row{0x800E, "BadServerHalted", "the server has stopped", "start it"},
    Row{0x8010, "BadTooManyOperations", "more nodes in a request than the server takes", kLater},
    Row{0x8012, "BadCertificateInvalid", "a certificate is not valid for OPC UA", "make another certificate"},
    Row{0x8013, "BadSecurityChecksFailed", "the security checks failed, often since a certificate is not trusted",
        kOwnCertificate},
    Row{0x8014, "BadCertificateTimeInvalid", "a certificate has expired or is not valid yet",
        "check the clocks of both sides and the dates of the certificates"},
    Row{0x8016, "BadCertificateHostNameInvalid", "the certificate is of another host", "make another certificate"},
    Row{0x8017, "BadCertificateUriInvalid", "the certificate is of another application", "make another certificate"},
    Row{0x8018, "BadCertificateUseNotAllowed", "the certificate is not for this use", "make another certificate"},
    Row{0x801A, "BadCertificateUntrusted", "the server does not trust the certificate of this link", kOwnCertificate},
    Row{0x801D, "BadCertificateRevoked", "the certificate is revoked", "make another certificate"},
    Row{0x801F, "BadUserAccessDenied", "the user does not have the right", kRights},
    Row{0x8020, "BadIdentityTokenInvalid", "the server does not accept this kind of login", "check `user`"},
    Row{0x8021, "BadIdentityTokenRejected", "the server does not accept this user",
        "check `user` and the password in `password-file`"},
    Row{0x8022, "BadSecureChannelIdInvalid", "the secure channel has ended", kLater},
    Row{0x8025, "BadSessionIdInvalid", "the server does not know the session, perhaps since it was restarted", kLater},
    Row{0x8026, "BadSessionClosed", "the server has closed the session", kLater},
    Row{0x8031, "BadNoCommunication", "the server does not reach the source of the value", kServer},
    Row{0x8032, "BadWaitingForInitialData", "the server does not have a value yet", "wait until the PLC runs"},
    Row{0x8033, "BadNodeIdInvalid", "the node id is not valid in this server", kNodes},
    Row{0x8034, "BadNodeIdUnknown", "the server has no such node", kNodes},
    Row{0x8035, "BadAttributeIdInvalid", "the node is not a variable", kNodes},
    Row{0x803A, "BadNotReadable", "the node cannot be read", kRights},
    Row{0x803B, "BadNotWritable", "the node cannot be written", kRights},
    Row{0x803C, "BadOutOfRange", "the value is out of the range of the node", "check the range of the variable"},
    Row{0x8054, "BadSecurityModeRejected", "the server does not offer this security", "give another `security`"},
    Row{0x8055, "BadSecurityPolicyRejected", "the server does not offer this security", "give another `security`"},
    Row{0x8056, "BadTooManySessions", "the server has no session left", "close other clients, or allow more sessions"},
    Row{0x8073, "BadWriteNotSupported", "the server does not write this node", kRights},
    Row{0x8074, "BadTypeMismatch", "the node has another data type",
        "correct the type in the symbol list or in the PLC"},
    Row{0x8083, "BadTcpEndpointUrlInvalid", "the server does not know this address",
        "give the address that the server has for itself, with its path"},
    Row{0x8086, "BadSecureChannelClosed", "the secure channel has ended", kLater},
    Row{0x8089, "BadConfigurationError", "the configuration of the node is not complete", kServer},
    Row{0x808A, "BadNotConnected", "the source of the value is not connected", kServer},
    Row{0x808B, "BadDeviceFailure", "the device of the value has failed", kServer},
    Row{0x808C, "BadSensorFailure", "the sensor of the value has failed", kServer},
    Row{0x808D, "BadOutOfService", "the source of the value is out of service", kServer},
    Row{0x80AC, "BadConnectionRejected", "no server accepts the connection",
        "check the address, that the PLC runs, and that its OPC UA server is on"},
    Row{0x80AE, "BadConnectionClosed", "the server closed the connection", kLater},
    Row{0x80AF, "BadInvalidState", "the server does not allow it in its state", kServer},
    Row{0x80B8, "BadRequestTooLarge", "the request is too long for the server", kLater},
    Row{0x80B9, "BadResponseTooLarge", "the answer is too long", kLater},
    Row{0x80EE, "BadServerTooBusy", "the server is too busy", kLater},
};

constexpr std::uint32_t kCodeBits = 16;

const Row* row_of(Status status) {
  const auto code = static_cast<std::uint16_t>(status >> kCodeBits);
  const auto* const found = std::lower_bound(kRows.begin(), kRows.end(), code,
                                             [](const Row& row, std::uint16_t wanted) { return row.code < wanted; });
  return found != kRows.end() && found->code == code ? found : nullptr;
}

}  // namespace

std::string status_meaning(Status status) {
  std::array<char, 9> digits{};
  std::snprintf(digits.data(), digits.size(), "%08X", static_cast<unsigned>(status));
  const Row* const row = row_of(status);
  if (row == nullptr) return "status " + std::string(digits.data());
  return std::string(row->name) + " (" + digits.data() + ", " + std::string(row->meaning) + ")";
}

std::string status_text(Status status) {
  const Row* const row = row_of(status);
  return status_meaning(status) + ": " + std::string(row == nullptr ? kServer : row->action);
}

client::Answer answer_of(Status status) noexcept {
  constexpr std::array<std::uint16_t, 5> kBusy = {0x8003, 0x8004, 0x800A, 0x8010, 0x80EE};
  const auto code = static_cast<std::uint16_t>(status >> kCodeBits);
  return std::find(kBusy.begin(), kBusy.end(), code) == kBusy.end() ? client::Answer::refused : client::Answer::busy;
}

tables::Refusal refusal_of(bool writing, Status status) noexcept {
  return {tables::Refusal::Side::opc_ua_client, static_cast<std::uint8_t>(writing ? 1 : 0),
          static_cast<std::uint16_t>(status >> kCodeBits), 0};
}

std::string refusal_text(const tables::Refusal& refusal) {
  return (refusal.function != 0 ? "writing: " : "reading: ") + status_text(Status{refusal.code} << kCodeBits);
}

}  // namespace symplant::link::opc_ua

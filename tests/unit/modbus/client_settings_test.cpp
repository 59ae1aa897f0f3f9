// The parameters of a modbus-tcp URL.
#include "symplant/link/modbus/client_settings.hpp"

#include "support/catch.hpp"

using namespace symplant;
using namespace symplant::link::modbus;
using Catch::Matchers::ContainsSubstring;
using link::modbus::Table;

namespace {

ClientSettings client_settings(const std::string& rest) {
  auto read = read_client_settings(rest);
  if (const auto* error = std::get_if<link::LinkError>(&read)) FAIL(error->message);
  return std::get<ClientSettings>(std::move(read));
}

std::string client_settings_fault(const std::string& parameters) {
  const auto read = read_client_settings("//10.0.0.5:502?" + parameters);
  const auto* const error = std::get_if<link::LinkError>(&read);
  if (error == nullptr) return "";
  CHECK(error->kind == link::LinkError::Kind::usage);
  return error->message;
}

const Placement& placed(const ClientSettings& settings, Table table) {
  return settings.placements[static_cast<std::size_t>(table)].value();
}

}  // namespace

TEST_CASE("Without parameters operations are coils and holding registers from 0 on, and events have no area") {
  const ClientSettings read = client_settings("//10.0.0.5:502");
  CHECK(read.address.host == "10.0.0.5");
  CHECK(read.address.port == 502);
  CHECK(read.unit == 1);
  CHECK(placed(read, Table::coil).area == Area::coils);
  CHECK(placed(read, Table::coil).offset == 0);
  CHECK(placed(read, Table::holding_register).area == Area::holding_registers);
  CHECK_FALSE(read.placements[static_cast<std::size_t>(Table::discrete_input)].has_value());
  CHECK_FALSE(read.placements[static_cast<std::size_t>(Table::input_register)].has_value());
}

TEST_CASE("Every parameter of a modbus-tcp URL sets its value") {
  const ClientSettings read = client_settings(
      "//plc:1502?unit=17&operations=discrete-inputs:100&events=holding-registers:0x400&operation-values="
      "input-registers&event-values=holding-registers:2000&bit-order=high-first&poll=20ms&refresh=3s&read-back=0s&"
      "retry=100ms&timeout=500ms&at-end=zero");
  CHECK(read.unit == 17);
  CHECK(placed(read, Table::coil).area == Area::discrete_inputs);
  CHECK(placed(read, Table::coil).offset == 100);
  CHECK(placed(read, Table::discrete_input).area == Area::holding_registers);
  CHECK(placed(read, Table::discrete_input).offset == 1024);
  CHECK(placed(read, Table::holding_register).area == Area::input_registers);
  CHECK(placed(read, Table::input_register).offset == 2000);
  CHECK(read.bit_order == BitOrder::high_first);
  CHECK(read.times.poll == 20 * tables::kMillisecond);
  CHECK(read.times.refresh == 3 * tables::kSecond);
  CHECK(read.times.read_back == 0);
  CHECK(read.times.first_retry == 100 * tables::kMillisecond);
  CHECK(read.times.zero_at_end);
  CHECK(read.timeout == 500 * tables::kMillisecond);
}

TEST_CASE("By default an answer is late before the link is lost") {
  CHECK(ClientSettings().timeout < link::LinkSettings().loss_after);
}

TEST_CASE("Areas that cannot be written or have no registers are rejected with those that fit") {
  CHECK_THAT(client_settings_fault("events=discrete-inputs"),
             ContainsSubstring("`events=discrete-inputs`") &&
                 ContainsSubstring("here the area may be coils, holding-registers"));
  CHECK_THAT(client_settings_fault("event-values=coils"), ContainsSubstring("may be holding-registers"));
  CHECK_THAT(client_settings_fault("operation-values=coils"),
             ContainsSubstring("may be holding-registers, input-registers"));
  CHECK_THAT(client_settings_fault("operations=registers"),
             ContainsSubstring("coils, discrete-inputs, holding-registers"));
  CHECK_THAT(client_settings_fault("operations=coils:65536"), ContainsSubstring("a number from 0 to 65535"));
  CHECK_THAT(client_settings_fault("operations=coils:"), ContainsSubstring("after the colon"));
}

TEST_CASE("Invalid values of a modbus-tcp URL say what to write") {
  CHECK_THAT(client_settings_fault("unit=256"), ContainsSubstring("`unit=256`: write a number from 0 to 255"));
  CHECK_THAT(client_settings_fault("poll=0s"), ContainsSubstring("write a time such as"));
  CHECK_THAT(client_settings_fault("bit-order=first"), ContainsSubstring("low-first, high-first"));
  CHECK_THAT(client_settings_fault("at-end=off"), ContainsSubstring("keep, zero"));
  CHECK_THAT(client_settings_fault("bytes=low-first"), ContainsSubstring("normal, swapped"));
  CHECK_THAT(client_settings_fault("unit=1&unit=2"), ContainsSubstring("`unit` is set twice"));
  CHECK_THAT(client_settings_fault("unit"), ContainsSubstring("write KEY=VALUE"));
}

TEST_CASE("An unknown parameter of a modbus-tcp URL names the nearest one") {
  CHECK_THAT(client_settings_fault("event=coils"), ContainsSubstring("did you mean `events`?"));
  CHECK_THAT(client_settings_fault("operation-value=coils"), ContainsSubstring("did you mean `operation-values`?"));
  CHECK_THAT(client_settings_fault("colour=red"), ContainsSubstring("docs/links.md"));
}

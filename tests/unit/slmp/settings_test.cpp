// The parameters of an slmp URL.
#include "symplant/link/slmp/settings.hpp"

#include "support/catch.hpp"

using namespace symplant;
using namespace symplant::link::slmp;
using Catch::Matchers::ContainsSubstring;

namespace {

Settings settings(const std::string& parameters) {
  auto read = read_settings("//10.0.0.5:5000?" + parameters);
  if (const auto* error = std::get_if<link::LinkError>(&read)) FAIL(error->message);
  return std::get<Settings>(std::move(read));
}

/// The message of the usage error.
std::string fault(const std::string& rest) {
  const auto read = read_settings(rest);
  const auto* const error = std::get_if<link::LinkError>(&read);
  if (error == nullptr) return "";
  CHECK(error->kind == link::LinkError::Kind::usage);
  return error->message;
}

std::string parameter_fault(const std::string& parameters) { return fault("//10.0.0.5:5000?" + parameters); }

}  // namespace

TEST_CASE("The defaults are 3E, binary, TCP, commands of Q and L") {
  const Settings read = settings("family=q");
  CHECK(read.address.host == "10.0.0.5");
  CHECK(read.address.port == 5000);
  CHECK(read.transport == link::net::Transport::tcp);
  CHECK(read.framing.frame == FrameType::e3);
  CHECK(read.framing.code == Code::binary);
  CHECK(read.framing.commands == Commands::ql);
  CHECK(read.framing.route == Route{});
  CHECK(read.events == EventAccess::unset);
  CHECK(read.times.read_back == tables::kSecond);
  CHECK(read.timeout < link::LinkSettings().loss_after);
}

TEST_CASE("A family that has only 1E frames is explained") {
  for (const char* const family : {"fx3", "fx3u", "fx3g", "a"}) {
    CHECK_THAT(parameter_fault(std::string("family=") + family),
               ContainsSubstring("1E frames") && ContainsSubstring("modbus-tcp://"));
  }
}

TEST_CASE("Every parameter is read") {
  const Settings read = settings(
      "family=iqr&frame=4e&code=ascii&commands=iqr&transport=udp&events=dx&poll=20ms&refresh=3s&read-back=0s&timeout=5s"
      "&timer=500ms&network=1&station=2&module=0x3E0&multidrop=3&at-end=zero");
  CHECK(read.framing.family == Family::iqr);
  CHECK(read.framing.frame == FrameType::e4);
  CHECK(read.framing.code == Code::ascii);
  CHECK(read.framing.commands == Commands::iqr);
  CHECK(read.transport == link::net::Transport::udp);
  CHECK(read.events == EventAccess::dx);
  CHECK(read.times.poll == 20 * tables::kMillisecond);
  CHECK(read.times.refresh == 3 * tables::kSecond);
  CHECK(read.times.read_back == 0);
  CHECK(read.timeout == 5 * tables::kSecond);
  CHECK(read.framing.timer == 2);
  CHECK(read.framing.route == Route{1, 2, 0x3E0, 3});
  CHECK(read.times.zero_at_end);
}

TEST_CASE("A map moves ranges of devices and symbols, in the numbers of the family") {
  const Settings read = settings("family=fx5&map=X0-X17:M1000&map=X20:D100.4&map=LINE_S1_I_A:B1F");
  REQUIRE(read.moves.size() == 2);
  CHECK(read.moves[0].first.number == 0);
  CHECK(read.moves[0].last == 15);
  CHECK(read.moves[0].to.number == 1000);
  CHECK(read.moves[1].first.number == 16);
  CHECK(read.moves[1].to.bit == 4);
  REQUIRE(read.symbol_moves.size() == 1);
  CHECK(read.symbol_moves[0].symbol == "LINE_S1_I_A");
  CHECK(read.symbol_moves[0].to.number == 0x1F);
}

TEST_CASE("A wrong URL is a usage error in words") {
  CHECK_THAT(fault("10.0.0.5:5000"), ContainsSubstring("give //HOST:PORT"));
  CHECK_THAT(fault("//10.0.0.5:5000"), ContainsSubstring("no `family`"));
  CHECK_THAT(fault("//10.0.0.5:0?family=q"), ContainsSubstring("port 0"));
  CHECK_THAT(fault("//10.0.0.5?family=q"), ContainsSubstring("no port"));
  CHECK_THAT(parameter_fault("family=s7"), ContainsSubstring("`s7` is not a family: write one of q, l, iqr, fx5"));
  CHECK_THAT(parameter_fault("family=q&frame=5e"), ContainsSubstring("`frame=5e`: write one of 3e, 4e"));
  CHECK_THAT(parameter_fault("family=q&famly=q"), ContainsSubstring("did you mean `family`?"));
  CHECK_THAT(parameter_fault("family=q&timer=300ms"), ContainsSubstring("multiple of 250ms, or 0s"));
  CHECK_THAT(parameter_fault("family=q&timer=4s"), ContainsSubstring("`timeout` must be longer"));
  CHECK_THAT(parameter_fault("family=q&commands=iqr"), ContainsSubstring("only the family iqr"));
  CHECK_THAT(parameter_fault("family=fx5&events=dx"), ContainsSubstring("no DX"));
  CHECK_THAT(parameter_fault("family=q&poll=0s"), ContainsSubstring("`poll=0s`"));
  CHECK_THAT(parameter_fault("family=q&network=240"), ContainsSubstring("0 to 239"));
  CHECK_THAT(parameter_fault("family=q&events=direct&events=dx"), ContainsSubstring("set twice"));
  CHECK_THAT(parameter_fault("family=q&map=X0-X7F"), ContainsSubstring("map=X0-X3F:X800"));
  CHECK_THAT(parameter_fault("family=q&map=X0-Y7F:M0"), ContainsSubstring("not a range of devices"));
  CHECK_THAT(parameter_fault("family=q&map=X7-X0:M0"), ContainsSubstring("not a range of devices"));
  CHECK_THAT(parameter_fault("family=q&map=D0-D5:M0"), ContainsSubstring("words cannot be moved to bits"));
  CHECK_THAT(parameter_fault("family=q&map=X0:Q5"), ContainsSubstring("`Q5` is not a device"));
  CHECK_THAT(parameter_fault("family"), ContainsSubstring("write KEY=VALUE"));
  CHECK_THAT(parameter_fault("family=q%2"), ContainsSubstring("%25"));
}

// The settings of an SLMP link: the parameters of its URL.
#include "symplant/link/slmp/settings.hpp"

#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "symplant/link/url_values.hpp"

namespace symplant::link::slmp {

namespace {

constexpr tables::Time kTimerUnit = 250 * tables::kMillisecond;

Problem read_events(std::string_view text, EventAccess& out) {
  constexpr std::array kNames = {std::pair{std::string_view("direct"), EventAccess::direct},
                                 std::pair{std::string_view("dx"), EventAccess::dx}};
  return choose(kNames, text, out);
}

constexpr const char* kSpeaks1e =
    "an FX3 (or an A) with an Ethernet adapter speaks 1E frames only, and this link speaks 3E and 4E: use "
    "`modbus-tcp://` "
    "with an adapter that is a Modbus server";

bool is_of_1e(std::string_view family) {
  return family == "a" || family.starts_with("fx1") || family.starts_with("fx2") || family.starts_with("fx3");
}

constexpr const char* kMapForm =
    "write what is moved and where to: map=X0-X3F:X800, map=X0-X7F:M1000, map=X0-X3F:D100 or map=SYMBOL:M5";

class Reader {
 public:
  explicit Reader(std::vector<UrlParameter> parameters) : parameters_(std::move(parameters)) {}

  std::variant<Settings, LinkError> read(net::HostPort address) {
    settings_.address = std::move(address);
    if (Problem problem = read_family(); !problem.empty()) return usage(std::move(problem));
    for (const UrlParameter& parameter : parameters_) {
      Problem problem = read_one(parameter);
      if (!problem.empty()) return usage(std::move(problem));
    }
    if (Problem problem = contradiction(); !problem.empty()) return usage(std::move(problem));
    return std::move(settings_);
  }

 private:
  static LinkError usage(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

  /// First, since texts of devices depend on it.
  Problem read_family() {
    constexpr std::array kFamilies = {
        std::pair{std::string_view("q"), Family::q}, std::pair{std::string_view("l"), Family::l},
        std::pair{std::string_view("iqr"), Family::iqr}, std::pair{std::string_view("fx5"), Family::fx5}};
    for (const UrlParameter& parameter : parameters_) {
      if (parameter.key != "family") continue;
      if (is_of_1e(parameter.value)) return kSpeaks1e;
      Problem problem = choose(kFamilies, parameter.value, settings_.framing.family);
      return problem.empty() ? problem : ticked_text(parameter.value) + " is not a family: " + problem;
    }
    return "the link has no `family`: write `slmp://HOST:PORT?family=q`, or l, iqr, fx5; it decides whether X and Y "
           "are "
           "counted in hexadecimal or octal";
  }

  Problem read_one(const UrlParameter& parameter);
  Problem read_map(std::string_view text);
  Problem contradiction() const;

  std::vector<UrlParameter> parameters_;
  Settings settings_;
};

Problem read_frame(std::string_view text, Settings& settings) {
  constexpr std::array kFrames = {std::pair{std::string_view("3e"), FrameType::e3},
                                  std::pair{std::string_view("4e"), FrameType::e4}};
  return choose(kFrames, text, settings.framing.frame);
}

Problem read_code(std::string_view text, Settings& settings) {
  constexpr std::array kCodes = {std::pair{std::string_view("binary"), Code::binary},
                                 std::pair{std::string_view("ascii"), Code::ascii}};
  return choose(kCodes, text, settings.framing.code);
}

Problem read_commands(std::string_view text, Settings& settings) {
  constexpr std::array kCommands = {std::pair{std::string_view("ql"), Commands::ql},
                                    std::pair{std::string_view("iqr"), Commands::iqr}};
  return choose(kCommands, text, settings.framing.commands);
}

Problem read_transport(std::string_view text, Settings& settings) {
  constexpr std::array kTransports = {std::pair{std::string_view("tcp"), net::Transport::tcp},
                                      std::pair{std::string_view("udp"), net::Transport::udp}};
  return choose(kTransports, text, settings.transport);
}

template <class Field>
Problem read_field(std::string_view text, std::uint32_t most, Field& field) {
  std::uint32_t number = 0;
  Problem problem = read_number(text, most, number);
  if (problem.empty()) field = static_cast<Field>(number);
  return problem;
}

Problem read_timer(std::string_view text, Settings& settings) {
  tables::Time time = 0;
  Problem problem = read_time(text, time, true);
  if (!problem.empty()) return problem;
  if (time % kTimerUnit != 0) return "write a multiple of 250ms, or 0s for no limit";
  settings.framing.timer = static_cast<std::uint16_t>(time / kTimerUnit);
  return {};
}

Problem Reader::read_map(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return kMapForm;
  const Family family = settings_.framing.family;
  const auto to = parse_device(text.substr(colon + 1), family);
  if (!to) return ticked_text(text.substr(colon + 1)) + " is not a device of this family: " + kMapForm;
  const std::string_view from = text.substr(0, colon);
  const std::size_t dash = from.find('-');
  const auto first = parse_device(from.substr(0, dash), family);
  if (!first) {
    settings_.symbol_moves.push_back({std::string(from), *to});
    return from.empty() ? kMapForm : Problem();
  }
  const auto last = dash == std::string_view::npos ? first : parse_device(from.substr(dash + 1), family);
  const bool is_range = last && last->kind == first->kind && last->number >= first->number &&
                        first->bit == Device::kNoBit && last->bit == Device::kNoBit;
  if (!is_range) return ticked_text(from) + " is not a range of devices: " + kMapForm;
  if (!info_of(first->kind).bit && (info_of(to->kind).bit || to->bit != Device::kNoBit)) {
    return "words cannot be moved to bits: " + Problem(kMapForm);
  }
  settings_.moves.push_back({*first, last->number, *to});
  return {};
}

Problem Reader::read_one(const UrlParameter& parameter) {
  using Key = UrlKey<Settings>;
  constexpr std::array kKeys = {
      Key{"family", [](std::string_view, Settings&) { return Problem(); }},
      Key{"map", [](std::string_view, Settings&) { return Problem(); }},  // by read_map()
      Key{"frame", read_frame},
      Key{"code", read_code},
      Key{"commands", read_commands},
      Key{"transport", read_transport},
      Key{"events", [](std::string_view text, Settings& s) { return read_events(text, s.events); }},
      Key{"poll", [](std::string_view text, Settings& s) { return read_time(text, s.times.poll, false); }},
      Key{"refresh", [](std::string_view text, Settings& s) { return read_time(text, s.times.refresh, false); }},
      Key{"read-back", [](std::string_view text, Settings& s) { return read_time(text, s.times.read_back, true); }},
      Key{"retry", [](std::string_view text, Settings& s) { return read_time(text, s.times.first_retry, false); }},
      Key{"timeout", [](std::string_view text, Settings& s) { return read_time(text, s.timeout, false); }},
      Key{"timer", read_timer},
      Key{"network", [](std::string_view text, Settings& s) { return read_field(text, 239, s.framing.route.network); }},
      Key{"station", [](std::string_view text, Settings& s) { return read_field(text, 255, s.framing.route.station); }},
      Key{"module",
          [](std::string_view text, Settings& s) { return read_field(text, 65'535, s.framing.route.module); }},
      Key{"multidrop",
          [](std::string_view text, Settings& s) { return read_field(text, 31, s.framing.route.multidrop); }},
      Key{"at-end", [](std::string_view text, Settings& s) { return read_at_end(text, s.times.zero_at_end); }},
  };
  if (parameter.key == "map") return read_map(parameter.value);
  return read_parameter(parameter, kKeys, settings_, "an SLMP link", "docs/mitsubishi.md");
}

Problem Reader::contradiction() const {
  const Framing& framing = settings_.framing;
  if (framing.commands == Commands::iqr && framing.family != Family::iqr) {
    return "only the family iqr has `commands=iqr`: leave it out";
  }
  if (framing.family == Family::fx5 && settings_.events == EventAccess::dx) {
    return "an FX5 has no DX: use `events=direct` or `map`";
  }
  if (settings_.timeout <= framing.timer * kTimerUnit) {
    return "`timeout` must be longer than `timer`, which is the time that the PLC may take for an answer";
  }
  return {};
}

}  // namespace

std::variant<Settings, LinkError> read_settings(std::string_view rest) {
  auto url = parse_url(rest, "slmp");
  if (auto* error = std::get_if<LinkError>(&url)) return std::move(*error);
  auto& parsed = std::get<ParsedUrl>(url);
  return Reader(std::move(parsed.parameters)).read(std::move(parsed.address));
}

}  // namespace symplant::link::slmp

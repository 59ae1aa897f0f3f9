// The identity of a finding from one run to the next.
#include "diag/fingerprint.hpp"

#include <array>
#include <cstdio>

#include "text/ascii.hpp"

namespace symplant::diag {
namespace {

constexpr std::size_t kMostOfLocation = 200;  // bytes

/// FNV-1a over fields, each with an end mark.
class Digest {
 public:
  void add(std::string_view field) {
    for (const char c : field) add_byte(static_cast<unsigned char>(c));
    add_byte(0);
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x0000'0100'0000'01B3; }

  std::uint64_t value_ = 0xCBF2'9CE4'8422'2325;
};

/// A message without the numbers outside back-ticks: counts and lines change from run to run, the user's text does not.
std::string without_numbers(std::string_view message) {
  std::string text;
  bool quoted = false;
  for (const char c : message) {
    quoted = quoted != (c == '`');
    if (quoted || c < '0' || c > '9') text += c;
  }
  return text;
}

std::string_view text_at(const Location& location) {
  if (!location.source || !location.pointer.empty()) return {};
  return location.source->text().substr(location.span.begin,
                                        std::min(location.span.end - location.span.begin, kMostOfLocation));
}

}  // namespace

std::string Fingerprints::next(const Diagnostic& finding, std::string_view file) {
  Digest digest;
  digest.add(finding.rule->id);
  digest.add(file);
  if (finding.count > 1) {  // which of them is the first may change
    digest.add(text::to_upper(finding.subjects.shape));
  } else {
    for (const Subject& subject : finding.subjects.about) digest.add(text::to_upper(subject.name));
  }
  if (finding.subjects.about.empty()) {
    digest.add(without_numbers(finding.message));
    digest.add(text_at(finding.location));
  }
  std::array<char, 17> hex{};
  std::snprintf(hex.data(), hex.size(), "%016llx", static_cast<unsigned long long>(digest.value()));
  return std::string(hex.data()) + ":" + std::to_string(++seen_[digest.value()]);
}

}  // namespace symplant::diag

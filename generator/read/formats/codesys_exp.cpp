// Reads exports of CoDeSys 2.3 (.EXP): the channels of the PLC configuration that have a name, and declared variables.
#include <optional>
#include <string>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/st/declared_rows.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kExpSearchedBytes = 256 * 1024;
constexpr std::string_view kConfiguration = "PLC_CONFIGURATION";
constexpr std::string_view kConfigurationEnd = "PLC_END";

bool has_line(std::string_view text, std::string_view wanted) {
  LineReader lines(text);
  Line line;
  while (lines.next(line)) {
    if (without_blanks(line.text) == wanted) return true;
  }
  return false;
}

/// The value of `_KEY: value`, without the quotes of a text; nothing if the line has another key.
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
  if (!line.starts_with(key)) return std::nullopt;
  line = without_blanks(line.substr(key.size()));
  if (line.size() >= 2 && line.front() == '\'' && line.back() == '\'') line = line.substr(1, line.size() - 2);
  return line;
}

class ExpReading {
 public:
  explicit ExpReading(const Reading& reading)
      : builder_(reading, address::Notation::iec), declared_(builder_), lines_(builder_.text()) {}

  std::optional<SymbolTable> read() {
    Line line;
    std::size_t begin = 0;  // of the text that is no configuration
    while (lines_.next(line)) {
      if (without_blanks(line.text) != kConfiguration) continue;
      declared_.read({begin, line.begin}, {});
      read_configuration();
      begin = lines_.offset();
    }
    declared_.read({begin, builder_.text().size()}, {});
    builder_.decide("channels of the PLC configuration: " + std::to_string(named_) + " with a name, " +
                    std::to_string(nameless_) + " without, left out");
    return declared_.finish();
  }

 private:
  struct Channel {
    Line first;
    std::string_view name;
    std::string_view address;
    std::string_view comment;
  };

  void read_configuration() {
    Line line;
    Channel channel;
    while (lines_.next(line)) {
      const std::string_view text = without_blanks(line.text);
      if (text == kConfigurationEnd) return;
      if (text == "_CHANNEL") channel = {line, {}, {}, {}};
      if (const auto name = value_of(text, "_SYMBOLIC_NAME:")) channel.name = *name;
      if (const auto comment = value_of(text, "_COMMENT:")) channel.comment = *comment;
      if (const auto address = value_of(text, "_IECADR:")) channel.address = *address;
      if (text == "_END_CHANNEL") add(channel, line);
    }
  }

  void add(const Channel& channel, const Line& last) {
    if (channel.name.empty()) {
      ++nameless_;
      return;
    }
    ++named_;
    ListRow& row = builder_.add({channel.first.begin, last.span().end}, channel.first.number);
    row.klass = "VAR_GLOBAL";
    row.name = channel.name;
    row.vendor_address = channel.address;
    row.comment = channel.comment;
  }

  TableBuilder builder_;
  DeclaredRows declared_;
  LineReader lines_;
  std::size_t named_ = 0;
  std::size_t nameless_ = 0;
};

int codesys_exp_likelihood(std::string_view text) {
  const std::string_view begin = text.substr(0, kExpSearchedBytes);
  return begin.find(kConfiguration) != begin.npos && has_line(begin, kConfiguration) ? 98 : 0;
}

std::optional<SymbolTable> read_codesys_exp(const Reading& reading) { return ExpReading(reading).read(); }

}  // namespace

const ReaderInfo kCodesysExp{"codesys-exp", "CoDeSys 2.3 export", codesys_exp_likelihood, read_codesys_exp};

}  // namespace symplant::read

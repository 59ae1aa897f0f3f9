// A plant of the reference with values and signals.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"
#include "support/reference/lines.hpp"

namespace symplant::test {

inline constexpr tables::Time kSec = tables::kSecond;

/// A value with a step of 1 s, so that numbers are easy to compute by hand.
inline description::GivenValue value(const std::string& name, tables::ValueKind kind, const std::string& formula = "") {
  description::GivenValue given;
  given.name = name;
  given.kind = kind;
  given.formula = formula;
  if (kind != tables::ValueKind::parameter) given.step = kSec;
  return given;
}
inline description::GivenValue parameter(const std::string& name, double start = 0) {
  description::GivenValue given = value(name, tables::ValueKind::parameter);
  given.start = start;
  return given;
}
inline description::GivenValue is(const std::string& name, const std::string& formula) {
  return value(name, tables::ValueKind::is, formula);
}
inline description::GivenValue integral(const std::string& name, const std::string& formula, double start = 0) {
  description::GivenValue given = value(name, tables::ValueKind::integral, formula);
  given.start = start;
  return given;
}

/// A device A (HOME1, WORK2, 1 s between them), an operation `L_P_GO`, and what a test adds.
class Values {
 public:
  explicit Values(std::vector<description::GivenValue> values, Said said = {}, std::vector<Row> rows = {})
      : bench_(with(std::move(said), std::move(values)), all_rows(std::move(rows))) {}

  Bench& bench() { return bench_; }
  reference::Plant& plant() { return bench_.plant; }
  Values& at(tables::Time time) {
    plant().advance_to(time);
    return *this;
  }
  Values& set(const std::string& name, double number) {
    CHECK(plant().set_value(name, number));
    return *this;
  }
  double operator[](const std::string& name) const { return bench_.plant.value_output(name); }
  /// An integer that a signal writes, or a bit.
  std::int64_t symbol(const std::string& name) const {
    return static_cast<std::int64_t>(bench_.plant.value(bench_.symbol(name)));
  }
  /// The outputs at whole seconds, from 0 on.
  std::vector<double> seconds(const std::string& name, int count) {
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(at(i * kSec)[name]);
    return numbers;
  }
  /// The findings since the last call: "1:value not finite level".
  std::string findings() {
    std::string text;
    for (const reference::InstantRecord& instant : plant().instants()) {
      for (const tables::Finding& finding : instant.findings) {
        text += (text.empty() ? "" : " ") + std::to_string(instant.time / kSec) + ":" +
                std::string(reference::finding_name(finding.kind)) + " " + std::to_string(finding.of);
      }
    }
    plant().clear_instants();
    return text;
  }
  /// The lines of values since the last call: "100:level=20.4", with times in ms.
  std::string lines() {
    std::string text;
    for (const std::string& line : reference::trace_lines(bench_.analysed.model(), plant().instants())) {
      const std::size_t value = line.find(",\"value\":\"");
      const std::size_t is = line.find("\",\"is\":");
      if (is == std::string::npos) continue;
      const long time = std::stol(line.substr(5)) / 1'000'000;
      text += (text.empty() ? "" : " ") + std::to_string(time) + ":" + line.substr(value + 10, is - value - 10) + "=" +
              line.substr(is + 7, line.size() - is - 8);
    }
    plant().clear_instants();
    return text;
  }

 private:
  static Said with(Said said, std::vector<description::GivenValue> values) {
    said.description.values = std::move(values);
    return said;
  }
  static std::vector<Row> all_rows(std::vector<Row> more) {
    std::vector<Row> rows = bits({"L_P_A_I_HOME1", "L_P_A_I_WORK2", "L_P_A_O_HOME1", "L_P_A_O_WORK2", "L_P_GO_O_"});
    rows.back().name = "L_P_GO";
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
  }

  Bench bench_;
};

inline bool is_nan(double number) { return std::isnan(number); }

}  // namespace symplant::test

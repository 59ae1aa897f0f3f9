// Conditions that start and stop a recording.
#include "record/trigger.hpp"

#include <bit>

#include "support/catch.hpp"
#include "unit/record/record_support.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;

namespace {

struct TriggerBench {
  test::SymbolList list;
  tables::PlantTables tables;
  trace::PlantNames names;

  TriggerBench() : list(made()), tables(list.tables()), names(tables) {}

  static test::SymbolList made() {
    test::SymbolList list = test::three_symbols();
    list.add("R", test::SymbolList::kIn, 1, tables::DataType::real);
    return list;
  }
  bool holds(const std::string& text, const std::vector<std::uint64_t>& values) const {
    auto read = record::read_trigger(text, names, {true, true, true, true});
    if (const auto* fault = std::get_if<std::string>(&read)) FAIL(*fault);
    return std::get<record::Trigger>(read).holds(values);
  }
  std::string fault(const std::string& text, const std::vector<bool>& is_read) const {
    const auto read = record::read_trigger(text, names, is_read);
    const auto* const fault = std::get_if<std::string>(&read);
    return fault == nullptr ? "" : *fault;
  }
};

std::uint64_t signed_bits(std::int64_t value) { return static_cast<std::uint64_t>(value); }

}  // namespace

TEST_CASE("A condition is evaluated on what was read") {
  const TriggerBench bench;
  const auto real = std::bit_cast<std::uint64_t>(2.5);
  const std::vector<std::uint64_t> values{1, 0, signed_bits(-3), real};
  CHECK(bench.holds("O", values));
  CHECK_FALSE(bench.holds("I", values));
  CHECK(bench.holds("O and not I", values));
  CHECK_FALSE(bench.holds("O and I", values));
  CHECK(bench.holds("I or N < 0", values));
  CHECK(bench.holds("N = -3", values));
  CHECK_FALSE(bench.holds("N > -3", values));
  CHECK(bench.holds("N < 100000", values));  // always, since N is an INT
  CHECK(bench.holds("R = 2.4 +- 0.2", values));
  CHECK(bench.holds("N < R", values));
  CHECK_FALSE(bench.holds("R < N", values));
}

TEST_CASE("A condition with an error says where, and one of what is not read says that") {
  const TriggerBench bench;
  const std::vector<bool> all(4, true);
  CHECK_THAT(bench.fault("O and", all), ContainsSubstring("`O and`, character 6"));
  CHECK_THAT(bench.fault("O2", all), ContainsSubstring("not found"));
  CHECK_THAT(bench.fault("N", all), ContainsSubstring("compare it"));
  CHECK_THAT(bench.fault("O and N > 3", {true, true, false, true}), ContainsSubstring("does not read `N`"));
  CHECK_THAT(bench.fault("R > N", {true, true, false, true}), ContainsSubstring("does not read `N`"));
  CHECK_THAT(bench.fault("not N < 100000", {true, true, false, true}), ContainsSubstring("does not read `N`"));
}

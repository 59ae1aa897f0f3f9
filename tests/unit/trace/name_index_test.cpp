// Names by index.
#include "symplant/trace/name_index.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A name index finds the texts that a split of the blob gives, and empty ones after the last") {
  std::string all;
  for (int i = 0; i < 50; ++i)
    all.append(std::string(static_cast<std::size_t>(i % 7), 'x') + std::to_string(i % 3 == 0 ? i : 0)).push_back('\0');
  std::string with_empty("a\0\0b\0\0", 6);
  for (const std::string& blob : {all, with_empty, std::string("no end"), std::string("one\0two", 7), std::string()}) {
    const std::vector<std::string_view> names = tables::split_names(blob);
    const trace::NameIndex index(blob);
    for (std::size_t i = 0; i < names.size(); ++i) CHECK(index[i] == names[i]);
    for (std::size_t i = names.size(); i < names.size() + 40; ++i) CHECK(index[i].empty());
  }
}

}  // namespace
}  // namespace symplant::test

// The table of writers, and writing symbols in any of their formats.
#include "convert/writers.hpp"

#include <algorithm>
#include <array>

#include "convert/formats.hpp"
#include "text/ascii.hpp"

namespace symplant::convert {
namespace {

constexpr std::array<const WriterInfo*, 5> kWriters{&kGxIecWriter, &kCsvWriter, &kStWriter, &kPlcopenWriter,
                                                    &kTiaXlsxWriter};

constexpr Loss kOneList{"list is joined with lists of other controllers", "lists of different controllers are joined",
                        "a target declares one controller; convert each list to get a file for each"};
constexpr Loss kNoAlias{"alias is not written", "aliases are not written", "the address of its target is written"};
constexpr Loss kNoParentComment{"comment of a word or module is not written",
                                "comments of words or modules are not written",
                                "the target has one comment for each symbol"};

template <class Is>
const WriterInfo* find_if(const Is& is) {
  const auto found =
      std::find_if(kWriters.begin(), kWriters.end(), [&](const WriterInfo* writer) { return is(*writer); });
  return found == kWriters.end() ? nullptr : *found;
}

}  // namespace

std::span<const WriterInfo* const> writers() { return kWriters; }

const WriterInfo* find_writer(std::string_view name) {
  return find_if([&](const WriterInfo& writer) { return writer.name == name; });
}

const WriterInfo* writer_of_extension(std::string_view extension) {
  return find_if([&](const WriterInfo& writer) { return text::equal_ignoring_case(writer.extension, extension); });
}

base::Result<Output, WriteError> write(const WriterInfo& writer, const Writing& writing) {
  if (writing.symbols->controllers > 1) {
    for (const auto& table : writing.symbols->tables) writing.report.add(kOneList, table->source->path());
  }
  for (const Symbol& symbol : writing.symbols->all) {
    if (!symbol.extra->alias.empty()) writing.report.add(kNoAlias, symbol.row->name);
    if (!symbol.extra->parent_comment.empty()) writing.report.add(kNoParentComment, symbol.row->name);
  }
  return writer.write(writing);
}

}  // namespace symplant::convert

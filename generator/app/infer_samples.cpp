// Makes samples of the symbols of lists.
#include "app/infer_samples.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <utility>

#include "diag/visible_text.hpp"
#include "model/derive.hpp"
#include "read/readers.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

name::Direction side_of(tables::Direction direction) {
  return direction == tables::Direction::operation ? name::Direction::operation : name::Direction::event;
}

infer::Sample sample_of(const model::PlantModel& plant, const model::Symbol& symbol) {
  infer::Sample sample;
  sample.text.name = symbol.name();
  sample.text.comment = symbol.row->comment;
  sample.text.parent_comment = plant.lists[symbol.list].table->extra_of(*symbol.row).parent_comment;
  sample.side = side_of(symbol.direction);
  if (symbol.direction_by != model::DirectionBy::name) sample.text.address = sample.side;
  sample.boolean = symbol.type == tables::DataType::boolean;
  sample.controller = plant.lists[symbol.list].controller;
  return sample;
}

/// Whether the errors of a file say that it is something else than a list, or is empty.
bool is_no_list(const diag::Diagnostics& errors) {
  constexpr std::array<std::string_view, 5> kNoList{"SP102", "SP103", "SP104", "SP105", "SP124"};
  return std::ranges::all_of(errors.all(), [&](const diag::Diagnostic& error) {
    return std::ranges::find(kNoList, error.rule->id) != kNoList.end();
  });
}

/// A file itself; of a folder, the files directly in it that are symbol lists, sorted. Empty, with an error, if it has
/// none.
std::vector<std::string> lists_of(Context& context, const std::string& path, const PlantOptions& options) {
  const std::vector<std::string> names = context.files.list(path);
  if (names.empty()) return {path};
  std::vector<std::string> lists;
  for (const std::string& name : names) {
    const std::string file = (std::filesystem::path(path) / name).generic_string();
    diag::Diagnostics unread;
    if (name.starts_with('.') || !context.files.list(file).empty()) continue;
    if (read::read_symbol_list(file, options.read, context.files, unread) || !is_no_list(unread)) {
      lists.push_back(file);  // a list with an error is read again, and reported
    } else {
      context.err << "left out " << diag::visible(file) << ", which is no symbol list\n";
    }
  }
  std::sort(lists.begin(), lists.end());
  if (lists.empty()) {
    context.err << "error: no file in the folder `" << diag::visible(path) << "` is a symbol list\n";
    context.exit_code = host::kBadInput;
  }
  return lists;
}

}  // namespace

std::optional<InferInputs> read_samples(Context& context, const std::vector<std::string>& files,
                                        const PlantOptions& options) {
  InferInputs read;
  std::vector<ReadList> lists;
  name::IoRows io;
  for (const std::string& path : files) {
    const std::vector<std::string> of_path = lists_of(context, path, options);
    if (of_path.empty()) return std::nullopt;
    std::ranges::copy_if(of_path, std::back_inserter(read.plant), [&](const std::string& file) {
      return std::ranges::find(read.plant, file) == read.plant.end();
    });
  }
  for (const std::string& file : read.plant) {
    auto inputs = read_for(context, file, options);
    if (!inputs) return std::nullopt;
    if (inputs->source != nullptr) {
      const std::vector<std::string> described = inputs->source->paths();
      read.files.insert(read.files.end(), described.begin(), described.end());
    }
    if (inputs->naming_parts != nullptr) {
      const std::vector<std::string>& more = inputs->naming_parts->files;
      read.files.insert(read.files.end(), more.begin(), more.end());
      read.given.push_back(inputs->naming->naming());
    }
    io = inputs->io;
    for (const ReadList& list : inputs->lists) read.files.push_back(list.table->source->path());
    lists.insert(lists.end(), std::make_move_iterator(inputs->lists.begin()),
                 std::make_move_iterator(inputs->lists.end()));
  }
  const auto reader = std::make_shared<name::SymbolReader>(naming::strict_naming());
  read.derived = model::derive(parse_names(lists, *reader, io), read.plant.front(), reader);
  const model::PlantModel& plant = read.derived.plant;
  read.samples.reserve(plant.symbols.size());
  for (const model::Symbol& symbol : plant.symbols) read.samples.push_back(sample_of(plant, symbol));
  return read;
}

}  // namespace symplant::app

// The states of the plant that an operator keeps, and those that are kept automatically.
#include "symplant/panel/operate/snapshots.hpp"

#include <algorithm>
#include <filesystem>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::panel {

namespace {

constexpr std::string_view kEnding = ".snapshot";
constexpr std::size_t kMostFiles = 1000;  ///< that are listed

}  // namespace

Snapshots::Snapshots(std::string folder, std::size_t block)
    : folder_(std::move(folder)),
      most_backtracks_(std::clamp(kMostBytes / std::max<std::size_t>(block, 1), std::size_t{2}, kMostBacktracks)) {
  std::error_code unknown;
  if (!has_folder()) return;
  for (const auto& file : std::filesystem::directory_iterator(folder_, unknown)) {
    if (file.path().extension() == kEnding && entries_.size() < kMostFiles)
      has_file(file.path().stem().generic_string());
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
}

Snapshots::Entry* Snapshots::entry(const std::string& name) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

std::string Snapshots::keep(const std::string& name, std::shared_ptr<KeptState> state) {
  const tables::Time time = state->snapshot.time;
  ++version_;
  if (Entry* const known = entry(name)) {
    *known = {name, false, false, time, std::move(state)};
    return "";
  }
  const auto named = std::count_if(entries_.begin(), entries_.end(),
                                   [](const Entry& e) { return !e.is_backtrack && e.state != nullptr; });
  if (static_cast<std::size_t>(named) >= kMost) return "there are 100 snapshots; forget one first";
  entries_.push_back({name, false, false, time, std::move(state)});
  return "";
}

void Snapshots::keep_backtrack(std::shared_ptr<KeptState> state) {
  ++version_;
  const tables::Time time = state->snapshot.time;
  const std::string name = "backtrack " + trace::seconds(time);
  std::erase_if(entries_, [&](const Entry& e) { return e.name == name; });
  entries_.push_back({name, true, false, time, std::move(state)});
  const auto is_backtrack = [](const Entry& e) { return e.is_backtrack; };
  const auto count = std::count_if(entries_.begin(), entries_.end(), is_backtrack);
  if (static_cast<std::size_t>(count) <= most_backtracks_) return;
  entries_.erase(std::find_if(entries_.begin(), entries_.end(), is_backtrack));
}

bool Snapshots::forget(const std::string& name) {
  ++version_;
  return std::erase_if(entries_, [&](const Entry& e) { return e.name == name && e.state != nullptr; }) != 0;
}

std::string Snapshots::path(std::string_view name, std::string_view ending) const {
  return (std::filesystem::path(folder_) / std::string(name).append(ending)).generic_string();
}

std::shared_ptr<KeptState> Snapshots::find(const std::string& name, std::uint64_t model_hash, std::size_t block,
                                           std::string& error) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (found != entries_.end() && found->state != nullptr) return found->state;
  std::error_code unknown;
  if (!has_folder() || !std::filesystem::is_regular_file(path(name, kEnding), unknown)) {
    error = "there is no snapshot `" + name + "`";
    return nullptr;
  }
  trace::ReadSnapshot read = trace::read_snapshot(path(name, kEnding), model_hash, block);
  error = std::move(read.error);
  if (!error.empty()) return nullptr;
  return std::make_shared<KeptState>(KeptState{std::move(read.snapshot)});
}

void Snapshots::has_file(const std::string& name) {
  ++version_;
  if (entry(name) == nullptr) entries_.push_back({name, false, true, 0, nullptr});
}

void Snapshots::put_all(std::string& json) const {
  json += '[';
  for (const Entry& each : entries_) {
    put_comma(json);
    json += '{';
    put_member(json, "name", each.name);
    const std::string time = each.state == nullptr ? "null" : std::to_string(each.time);
    std::error_code unknown;
    const bool file = has_folder() && std::filesystem::exists(path(each.name, kEnding), unknown);
    put(json, R"(,"t":{},"kind":"{}","file":{}}})", time, each.is_backtrack ? "backtrack" : "snapshot", file);
  }
  json += ']';
}

}  // namespace symplant::panel

// Writes and reads the state of a plant.
#include "symplant/trace/snapshot_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "symplant/tables/digest.hpp"
#include "symplant/tables/version.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/trace/whole_file.hpp"

namespace symplant::trace {
namespace {

constexpr std::size_t kLongestHeader = std::size_t{1} << 16;

std::uint64_t digest(std::span<const std::byte> block) {
  tables::Fnv1a64 hash;
  for (const std::byte each : block) hash.byte(static_cast<std::uint8_t>(each));
  return hash.value();
}

std::string header(std::string_view plant_name, const Snapshot& snapshot) {
  return fmt::format(
      R"({{"symplant-snapshot":1,"version":"{}","plant":{},"model_hash":"{:016x}","t":{},"bytes":{},"digest":"{:016x}"}})"
      "\n",
      tables::version(), json_string(plant_name), snapshot.model_hash, snapshot.time, snapshot.block.size(),
      digest(snapshot.block));
}

/// What a header says; `error` if it is not one.
struct Header {
  std::string version;
  std::string plant;
  std::string model_hash;
  std::string digest;
  tables::Time time = 0;
  std::size_t bytes = 0;
  bool valid = false;
};

Header parse_header(const std::string& line) {
  Header header;
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || json.value("symplant-snapshot", nlohmann::json()) != 1) return header;
  const auto text = [&](const char* key, std::string& into) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) return false;
    into = found->get<std::string>();
    return true;
  };
  const auto number = [&](const char* key, auto& into) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_unsigned()) return false;
    into = found->get<std::remove_reference_t<decltype(into)>>();
    return true;
  };
  header.valid = text("version", header.version) && text("plant", header.plant) &&
                 text("model_hash", header.model_hash) && text("digest", header.digest) && number("t", header.time) &&
                 number("bytes", header.bytes);
  return header;
}

/// Why a snapshot with this header is of no use for a plant; empty if it is.
std::string refusal(const std::string& path, const Header& header, std::uint64_t model_hash, std::size_t block) {
  if (!header.valid) return fmt::format("`{}` is not a snapshot of symplant; give a file of `--save`", path);
  if (header.version != tables::version()) {
    return fmt::format("the snapshot `{}` is of symplant {}, and this is {}: make it again", path, header.version,
                       tables::version());
  }
  if (header.model_hash != fmt::format("{:016x}", model_hash)) {
    return fmt::format(
        "the snapshot `{}` is of another model: its model_hash is {} (plant {}), that of this plant {:016x}; use the "
        "description and lists with which it was made",
        path, header.model_hash, header.plant, model_hash);
  }
  if (header.bytes != block)
    return fmt::format("the snapshot `{}` is of another build of symplant: make it again", path);
  return "";
}

}  // namespace

Snapshot Snapshot::of(const plant::Plant& plant) {
  const std::span<const std::byte> block = plant.save();
  return {{block.begin(), block.end()}, plant.model_hash(), plant.now()};
}

std::string snapshot_bytes(std::string_view plant_name, const Snapshot& snapshot) {
  std::string bytes = header(plant_name, snapshot);
  return bytes.append(reinterpret_cast<const char*>(snapshot.block.data()), snapshot.block.size());
}

std::string write_snapshot(const std::string& path, std::string_view plant_name, const Snapshot& snapshot) {
  const std::string failure = write_whole_file(path, snapshot_bytes(plant_name, snapshot));
  return failure.empty() ? "" : fmt::format("cannot write the snapshot `{}`: {}", path, failure);
}

ReadSnapshot read_snapshot(const std::string& path, std::uint64_t model_hash, std::size_t block) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return {{}, fmt::format("cannot read the snapshot `{}`: {}", path, std::strerror(errno))};
  std::string line(kLongestHeader, '\0');
  file.getline(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount() - 1, 0)));
  const Header header = file ? parse_header(line) : Header{};
  if (std::string error = refusal(path, header, model_hash, block); !error.empty()) return {{}, std::move(error)};
  Snapshot snapshot{std::vector<std::byte>(block), model_hash, header.time};
  file.read(reinterpret_cast<char*>(snapshot.block.data()), static_cast<std::streamsize>(block));
  const bool whole =
      file.gcount() == static_cast<std::streamsize>(block) && file.peek() == std::ifstream::traits_type::eof();
  if (!whole || header.digest != fmt::format("{:016x}", digest(snapshot.block))) {
    return {{}, fmt::format("the snapshot `{}` is damaged: make it again", path)};
  }
  return {std::move(snapshot), ""};
}

}  // namespace symplant::trace

// The state of an instance as bytes: a head, the plant's block, numbers, a digest of all.
#include "symplant/fmi/state_bytes.hpp"

#include <cstring>

#include "symplant/tables/digest.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::fmi {
namespace {

/// In the byte order of the machine: a plant's block has that, too.
struct Head {
  std::uint64_t version;  ///< of symplant and of its tables
  std::uint64_t model_hash;
  std::uint64_t plant;    ///< bytes
  std::uint64_t numbers;  ///< how many
  std::uint64_t extra;
};

std::uint64_t own_version() {
  tables::Fnv1a64 digest;
  digest.text("symplant FMU state ");
  digest.text(tables::version());
  digest.u32(static_cast<std::uint32_t>(tables::kTablesVersion));
  return digest.value();
}

}  // namespace

std::string state_bytes(const InstanceState& state, std::uint8_t extra, std::uint64_t model_hash) {
  const Head head{own_version(), model_hash, state.plant.size(), state.numbers.size(), extra};
  std::string bytes;
  const auto append = [&](const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); };
  append(&head, sizeof head);
  append(state.plant.data(), state.plant.size());
  append(state.numbers.data(), state.numbers.size() * sizeof(std::uint64_t));
  const std::uint64_t digest = tables::digest_of(bytes);
  append(&digest, sizeof digest);
  return bytes;
}

std::optional<ReadState> read_state(std::string_view bytes, std::uint64_t model_hash) {
  Head head{};
  std::uint64_t digest = 0;
  if (bytes.size() < sizeof head + sizeof digest) return std::nullopt;
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::string_view digested = bytes.substr(0, bytes.size() - sizeof digest);
  std::memcpy(&digest, bytes.data() + digested.size(), sizeof digest);
  const std::size_t rest = digested.size() - sizeof head;
  if (head.version != own_version() || head.model_hash != model_hash || digest != tables::digest_of(digested)) {
    return std::nullopt;
  }
  if (head.plant > rest || (rest - head.plant) != head.numbers * sizeof(std::uint64_t)) return std::nullopt;
  ReadState read{{std::vector<std::byte>(head.plant), std::vector<std::uint64_t>(head.numbers)},
                 static_cast<std::uint8_t>(head.extra)};
  std::memcpy(read.state.plant.data(), digested.data() + sizeof head, head.plant);
  std::memcpy(read.state.numbers.data(), digested.data() + sizeof head + head.plant, rest - head.plant);
  return read;
}

}  // namespace symplant::fmi

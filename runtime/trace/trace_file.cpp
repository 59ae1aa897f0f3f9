// The trace as a file.
#include "symplant/trace/trace_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>

#include "symplant/core/names.hpp"

namespace symplant::trace {
namespace {

constexpr std::uint64_t kExactInDouble = std::uint64_t{1} << 53;

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_signed(core::DataType type) {
  return type == core::DataType::sint || type == core::DataType::int_ || type == core::DataType::dint ||
         type == core::DataType::lint;
}

}  // namespace

std::string json_value(core::DataType type, std::uint64_t value) {
  if (type == core::DataType::boolean) return value != 0 ? "true" : "false";
  if (type == core::DataType::real || type == core::DataType::lreal) {
    const double number = std::bit_cast<double>(value);
    const std::string text =
        type == core::DataType::real ? fmt::format("{}", static_cast<float>(number)) : fmt::format("{}", number);
    return std::isfinite(number) ? text : '"' + text + '"';
  }
  const auto as_signed = static_cast<std::int64_t>(value);
  const bool negative = is_signed(type) && as_signed < 0;
  const std::uint64_t magnitude = negative ? ~value + 1 : value;
  const std::string text = negative ? fmt::format("{}", as_signed) : fmt::format("{}", value);
  return magnitude > kExactInDouble ? '"' + text + '"' : text;
}

TraceFile::TraceFile(const std::string& path, const core::PlantTables& tables, std::uint64_t model_hash,
                     std::uint64_t seed)
    : tables_(tables), path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) {
    fail();
    return;
  }
  const auto texts = core::split_names(tables.symbol_names);
  names_.reserve(tables.symbols.size());
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) names_.push_back(json_string(texts[i]));
  put(fmt::format("{{\"symplant-trace\":1,\"plant\":{},\"model_hash\":\"{:016x}\",\"seed\":{}}}\n",
                  json_string(tables.name), model_hash, seed));
}

void TraceFile::fail() {
  error_ = fmt::format("cannot write the trace `{}`: {}", path_, std::strerror(errno));
  file_.reset();
}

void TraceFile::put(const std::string& text) {
  if (file_ && std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void TraceFile::write(const Change& change) {
  if (!file_) return;
  line_.clear();
  fmt::format_to(std::back_inserter(line_), "{{\"t\":{},\"symbol\":{},\"value\":{}}}\n", change.time,
                 names_[change.symbol], json_value(tables_.symbols[change.symbol].type(), change.value));
  put(line_);
}

void TraceFile::flush() {
  if (file_ && std::fflush(file_.get()) != 0) fail();
}

}  // namespace symplant::trace

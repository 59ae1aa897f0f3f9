// The bytes of answers, shared by all connections that send them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "symplant/panel/web/gzip.hpp"

namespace symplant::panel {

/// Immutable, so that any thread may read them.
using Bytes = std::shared_ptr<const std::string>;

/// An answer that is the same for all clients. For one thread.
class Content {
 public:
  /// `type`: its Content-Type, which must outlive it.
  Content(std::string_view type, std::string text, Packing packing = Packing::quick)
      : type_(type), packing_(packing), plain_(std::make_shared<const std::string>(std::move(text))) {}

  std::string_view type() const { return type_; }
  const Bytes& plain() const { return plain_; }
  /// As gzip; compressed at the first call.
  const Bytes& packed();

 private:
  std::string_view type_;
  Packing packing_;
  Bytes plain_;
  Bytes packed_;
};

/// Counts the bytes that wait to be sent: each text once, however many connections send it. For one thread.
class Outgoing {
 public:
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  /// The text is counted until no connection has it any more.
  Bytes share(std::string text);
  std::size_t size() const { return *size_; }

 private:
  std::shared_ptr<std::size_t> size_ = std::make_shared<std::size_t>(0);
};

}  // namespace symplant::panel

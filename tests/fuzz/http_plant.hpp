// The panel over a small plant, and over a recording of it, from the bytes of a request to its answer, without a
// network.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace symplant::fuzz {

/// The seeds have these, so that they are valid.
inline constexpr std::string_view kSeedHost = "localhost:8137";
inline constexpr std::string_view kSeedToken = "0123456789abcdef0123456789abcdef";
inline constexpr std::string_view kTraineeToken = "fedcba9876543210fedcba9876543210";
inline constexpr std::string_view kSeedRun = "run";

/// A seed as it is sent: the lines of its head end with CR and LF, and it has the length of its body unless it says how
/// long that is.
std::string sent_text(std::string_view seed);

class HttpPlant {
 public:
  HttpPlant();
  ~HttpPlant();
  HttpPlant(const HttpPlant&) = delete;
  HttpPlant& operator=(const HttpPlant&) = delete;

  /// The status of an answer; 200 of a stream, 0 of bytes that are not a whole request of HTTP.
  struct Statuses {
    int live = 0;
    int recording = 0;
  };
  /// Asks a plant at its start, and a recording. Throws what a handler throws.
  Statuses play(std::string_view request);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::fuzz

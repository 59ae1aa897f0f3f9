// How long it takes to encode a request for 1,000 bit points in words and to decode its reply.
#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "support/slmp/golden_vectors.hpp"
#include "symplant/link/slmp/framing.hpp"

namespace symplant::bench {
namespace {

using namespace link::slmp;

constexpr std::uint16_t kWords = 63;  ///< of 1,000 bits
constexpr std::uint16_t kSerial = 0x1234;

std::string hexadecimal(std::size_t number) {
  std::string text;
  for (int shift = 12; shift >= 0; shift -= 4) text += "0123456789ABCDEF"[number >> shift & 0xF];
  return text;
}

/// The reply to a request with the serial number kSerial.
std::vector<std::uint8_t> reply_with(const Framing& framing, std::size_t words) {
  const bool ascii = framing.code == Code::ascii;
  const bool e4 = framing.frame == FrameType::e4;
  const std::size_t length = (ascii ? 2 : 1) * (2 + 2 * words);
  std::string text = e4 ? (ascii ? "D40012340000" : "D40034120000") : "D000";
  text += ascii ? "00FF03FF00" : "00FFFF0300";
  text += hexadecimal(ascii ? length : (length << 8 | length >> 8) & 0xFFFF) + "0000";
  for (std::size_t i = 0; i < words; ++i) text += hexadecimal(i * 0x0101);
  return test::slmp::golden_bytes(text, ascii);
}

void read_words(benchmark::State& state, const Framing& framing) {
  RequestWriter writer(framing);
  const auto bytes = reply_with(framing, kWords);
  std::array<std::uint16_t, kWords> words{};
  for (auto _ : state) {
    writer.begin(Command::read, false, kSerial);
    writer.put_device(*kind_of("M"), 16);
    writer.put_16(kWords);
    benchmark::DoNotOptimize(writer.finish().data());
    const Reply reply = parse_reply(bytes, framing, kSerial, false);
    DataReader data(reply.data, framing.code);
    if (reply.kind != Reply::Kind::complete || !data.holds(kWords) || !data.words(words)) state.SkipWithError("broken");
    benchmark::DoNotOptimize(words.data());
    benchmark::ClobberMemory();
  }
}

void write_words(benchmark::State& state, const Framing& framing) {
  RequestWriter writer(framing);
  const auto bytes = reply_with(framing, 0);
  std::array<std::uint16_t, kWords> words{};
  for (auto _ : state) {
    benchmark::DoNotOptimize(words.data());
    writer.begin(Command::write, false, kSerial);
    writer.put_device(*kind_of("M"), 16);
    writer.put_16(kWords);
    for (const std::uint16_t word : words) writer.put_16(word);
    benchmark::DoNotOptimize(writer.finish().data());
    const Reply reply = parse_reply(bytes, framing, kSerial, false);
    if (reply.kind != Reply::Kind::complete) state.SkipWithError("broken");
    benchmark::ClobberMemory();
  }
}

const bool kCodecRegistered = [] {
  for (const FrameType frame : {FrameType::e3, FrameType::e4}) {
    for (const Code code : {Code::binary, Code::ascii}) {
      const Framing framing{.frame = frame, .code = code};
      const std::string name =
          std::string(frame == FrameType::e4 ? "4e/" : "3e/") + (code == Code::ascii ? "ascii" : "binary");
      benchmark::RegisterBenchmark(("codec/read/" + name).c_str(),
                                   [=](benchmark::State& state) { read_words(state, framing); });
      benchmark::RegisterBenchmark(("codec/write/" + name).c_str(),
                                   [=](benchmark::State& state) { write_words(state, framing); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace symplant::bench

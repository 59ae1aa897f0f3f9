// Watches a plant over a link that only reads.
#include "app/watch_live.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "app/read_link.hpp"
#include "diag/visible_text.hpp"
#include "record/recorder.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/net/no_signals.hpp"
#include "symplant/link/record/read_loop.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/trace/value_text.hpp"
#include "watch/shadow.hpp"

namespace symplant::app {
namespace {

using record::Batch;
using tables::Time;

/// These images only measure the interval of reading, which is longer than wanted if the PLC is slow.
constexpr std::size_t kMeasured = 10;
constexpr auto kLookForImages = std::chrono::milliseconds(20);
/// With --until: how long a PLC is waited for at least, as in `record`.
constexpr Time kLeastPatience = 5 * tables::kSecond;

/// Reads on a separate thread, which never waits for the terminal.
class LiveReader final : private link::record::ImageSink {
 public:
  /// Parts and tables must outlive it. Throws std::system_error if there is no thread left.
  LiveReader(link::client::ClientParts& parts, const tables::PlantTables& tables, Time every)
      : dialog_(*parts.dialog), changes_(parts.map.points.size()), loop_(parts, tables, every, clock_, *this, meter_) {
    const link::net::NoSignals blocked;
    reading_ = std::jthread([this] { loop_.run(); });
  }
  LiveReader(const LiveReader&) = delete;
  LiveReader& operator=(const LiveReader&) = delete;
  ~LiveReader() override {
    clock_.stop();
    dialog_.interrupt();
    reading_.join();
  }

  /// What was read since the last call.
  std::vector<Batch> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(batches_, {});
  }
  std::vector<std::string> take_messages() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(messages_, {});
  }

 private:
  class Clock final : public link::record::LoopClock {
   public:
    Time now() override { return link::client::steady_now(); }
    bool sleep_until(Time time) override {
      std::unique_lock lock(mutex_);
      const std::chrono::steady_clock::time_point until{std::chrono::nanoseconds(time)};
      wake_.wait_until(lock, until, [this] { return stopped_; });
      return !stopped_;
    }
    void stop() {
      const std::scoped_lock lock(mutex_);
      stopped_ = true;
      wake_.notify_all();
    }

   private:
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stopped_ = false;
  };

  void image(const link::record::Image& image) override {
    Batch batch = changes_.of(image);
    changes_.accept(image);
    const std::scoped_lock lock(mutex_);
    batches_.push_back(std::move(batch));
  }
  void lost() override {}
  void message(std::string text) override {
    const std::scoped_lock lock(mutex_);
    messages_.push_back(std::move(text));
  }

  link::client::Dialog& dialog_;
  Clock clock_;
  link::record::LoopMeter meter_;
  record::Changes changes_;  ///< of the reading thread
  link::record::ReadLoop loop_;
  std::mutex mutex_;
  std::vector<Batch> batches_;
  std::vector<std::string> messages_;
  std::jthread reading_;  // the last member: it uses the others
};

double number_of(tables::DataType type, std::uint64_t value) {
  using tables::NumberKind;
  return tables::number_of(trace::is_real(type)     ? NumberKind::real
                           : trace::is_signed(type) ? NumberKind::signed_integer
                                                    : NumberKind::unsigned_integer,
                           value);
}

/// By symbol: whether it is in the images. The first one has a line for each symbol.
std::vector<bool> symbols_of(const std::vector<Batch>& batches, std::size_t symbols) {
  std::vector<bool> read(symbols);
  for (const Batch& batch : batches) {
    for (const record::Line& line : batch.lines) read[line.symbol] = true;
  }
  return read;
}

/// Passes images to a shadow, with times from the first one on.
class LiveFeed {
 public:
  LiveFeed(const tables::PlantTables& tables, watch::Shadow& shadow, Time begin, Time resolution)
      : tables_(tables), shadow_(shadow), begin_(begin), resolution_(resolution) {}

  void add(const Batch& batch) {
    const Time first = batch.first - begin_;
    if (last_ >= 0 && (batch.reconnected || first - last_ >= 3 * resolution_)) shadow_.gap(last_, first - last_);
    Time time = std::max(first, last_);
    for (const record::Line& line : batch.lines) {
      if (line.time - begin_ > time) shadow_.close(time);
      time = std::max(line.time - begin_, time);
      shadow_.set(line.symbol, number_of(tables_.symbols[line.symbol].type(), line.value));
    }
    last_ = std::max(batch.last - begin_, time);
    if (last_ > time) shadow_.close(time);
    shadow_.close(last_);
  }
  /// Nothing came since the last image.
  void end(Time now) {
    if (now - begin_ - last_ >= 3 * resolution_) shadow_.gap(last_, now - begin_ - last_);
  }
  Time last() const { return last_; }

 private:
  const tables::PlantTables& tables_;
  watch::Shadow& shadow_;
  const Time begin_;
  const Time resolution_;
  Time last_ = -1;
};

/// The median interval of images, at least `every`.
Time measured_interval(const std::vector<Batch>& batches, Time every) {
  std::vector<Time> intervals;
  for (std::size_t i = 1; i < batches.size(); ++i) {
    if (!batches[i].reconnected) intervals.push_back(batches[i].first - batches[i - 1].first);
  }
  if (intervals.empty()) return every;
  std::nth_element(intervals.begin(), intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2),
                   intervals.end());
  const Time median = intervals[intervals.size() / 2];
  return median - median / 32 > every ? median : every;
}

class LiveWatch {
 public:
  LiveWatch(const Compiled& compiled, const tables::PlantTables& tables, const std::vector<watch::Statistic>& learned,
            const LiveOptions& options, LiveReader& reader, Context& context)
      : compiled_(compiled),
        tables_(tables),
        learned_(learned),
        options_(options),
        reader_(reader),
        context_(context) {}

  void run(const WatchFiles& files, const std::string& url, const std::vector<std::string>& inputs) {
    std::vector<Batch> batches = first_images();
    if (batches.empty()) {
      context_.err
          << "error: nothing was watched: there was no complete reading of the PLC; `symplant doctor` examines "
             "the link\n";
      context_.exit_code = host::kEnvironment;
      return;
    }
    const watch::Margin margin{options_.margin, measured_interval(batches, options_.every)};
    WatchOutput output(compiled_.plant, margin, files, context_);
    if (!output.open(inputs)) return;
    const std::vector<bool> is_read = symbols_of(batches, tables_.symbols.size());
    output.begin(url, watch::kUnknown, is_read);
    watch::Shadow shadow(compiled_.plant, is_read, margin, learned_, [&](const watch::Anomaly& anomaly) {
      output.add(anomaly);
      output.flush();
    });
    LiveFeed feed(tables_, shadow, batches.front().first, margin.resolution);
    for (;;) {
      for (const Batch& batch : batches) feed.add(batch);
      report();
      if (host::stop_requested().load() || (options_.until && feed.last() >= *options_.until)) break;
      std::this_thread::sleep_for(kLookForImages);
      batches = reader_.take();
    }
    feed.end(link::client::steady_now());
    output.end(shadow.counts(), feed.last(), inputs);
  }

 private:
  std::vector<Batch> first_images() {
    const Time begin = link::client::steady_now();
    const Time patience = std::max(options_.until.value_or(0), kLeastPatience);
    std::vector<Batch> batches;
    while (batches.size() < kMeasured && !host::stop_requested().load()) {
      std::this_thread::sleep_for(kLookForImages);
      for (Batch& batch : reader_.take()) batches.push_back(std::move(batch));
      report();
      if (options_.until && link::client::steady_now() - begin > patience) break;
    }
    return batches;
  }

  void report() {
    for (const std::string& message : reader_.take_messages()) {
      context_.err << diag::visible("link: " + message) << "\n" << std::flush;
    }
  }

  const Compiled& compiled_;
  const tables::PlantTables& tables_;
  const std::vector<watch::Statistic>& learned_;
  const LiveOptions& options_;
  LiveReader& reader_;
  Context& context_;
};

}  // namespace

void watch_live(const Compiled& compiled, const std::vector<watch::Statistic>& learned, const LiveOptions& options,
                const WatchFiles& files, const std::vector<std::string>& inputs, Context& context) {
  const tables::PlantTables tables = compiled.tables.tables();
  const auto fail = [&](const link::LinkError& error) {
    context.err << "error: " << diag::visible(error.message) << "\n";
    context.exit_code = error.kind == link::LinkError::Kind::usage ? host::kBadInput : host::kEnvironment;
  };
  const auto chosen = link_to_read(options.links, compiled.plant, tables);
  if (const auto* error = std::get_if<link::LinkError>(&chosen)) return fail(*error);
  const auto& choice = std::get<link::LinkChoice>(chosen);
  auto opened = link::client_parts(choice, tables);
  if (const auto* error = std::get_if<link::LinkError>(&opened)) return fail(*error);
  auto& parts = std::get<link::client::ClientParts>(opened);
  host::catch_signals();
  try {
    LiveReader reader(parts, tables, options.every);
    LiveWatch(compiled, tables, learned, options, reader, context).run(files, choice.url, inputs);
  } catch (const std::system_error& error) {
    fail({link::LinkError::Kind::environment, std::string("cannot start a thread: ") + error.what()});
  }
}

}  // namespace symplant::app

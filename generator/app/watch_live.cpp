// Watches a plant over a link that only reads.
#include "app/watch_live.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <ostream>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "app/read_link.hpp"
#include "diag/visible_text.hpp"
#include "record/interval.hpp"
#include "record/reader.hpp"
#include "recording/is_gap.hpp"
#include "recording/of_run.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/trace/words.hpp"
#include "watch/shadow.hpp"

namespace symplant::app {
namespace {

using record::Batch;
using tables::Time;

/// These images only measure the interval of reading, which is longer than wanted if the PLC is slow.
constexpr std::size_t kMeasured = 10;
constexpr auto kLookForImages = std::chrono::milliseconds(20);
/// A machine that is busy for so long is no silence of the PLC.
constexpr Time kLeastSilence = 40 * tables::kMillisecond;
/// With --until: how long a PLC is waited for at least, as in `record`.
constexpr Time kLeastPatience = 5 * tables::kSecond;

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
      : tables_(tables), shadow_(shadow), begin_(begin), interval_(resolution) {}

  /// How long nothing was read before this image, if it ends a silence that look() has shown; else 0.
  Time add(const Batch& batch) {
    const Time first = batch.first - begin_;
    const Time silence = std::exchange(is_silent_, false) ? first - last_ : 0;
    if (last_ >= 0) {
      if (!batch.after_loss) interval_.add(first - begun_);
      if (silence > 0) {
        shadow_.gap(first, 0);  // it is shown already; what was before it still does not count
      } else if (batch.after_loss || recording::is_gap(first - last_, interval_.now())) {
        shadow_.gap(last_, first - last_);
      }
    }
    begun_ = first;
    Time time = std::max(first, last_);
    for (const record::Line& line : batch.lines) {
      if (line.time - begin_ > time) shadow_.close(time);
      time = std::max(line.time - begin_, time);
      shadow_.set(line.symbol, recording::number_of(tables_.symbols[line.symbol], line.value));
    }
    last_ = std::max(batch.last - begin_, time);
    if (last_ > time) shadow_.close(time);
    shadow_.close(last_);
    return silence;
  }
  /// All images that were complete at `now` are added: shows a silence as soon as it is one.
  void look(Time now) {
    const Time silence = now - begin_ - last_;
    if (is_silent_ || silence < kLeastSilence || !recording::is_gap(silence, interval_.now())) return;
    is_silent_ = true;
    shadow_.gap(last_, silence);
  }

 private:
  const tables::PlantTables& tables_;
  watch::Shadow& shadow_;
  const Time begin_;
  record::Interval interval_;
  Time begun_ = -1;  ///< when the latest image began
  Time last_ = -1;   ///< when it ended
  bool is_silent_ = false;
};

Time measured_interval(const std::vector<Batch>& batches, Time every) {
  record::Interval interval(every);
  for (std::size_t i = 1; i < batches.size(); ++i) {
    if (!batches[i].after_loss) interval.add(batches[i].first - batches[i - 1].first);
  }
  return record::Interval::reached(every, interval.now());
}

class LiveWatch {
 public:
  LiveWatch(const Compiled& compiled, const tables::PlantTables& tables, const std::vector<watch::Statistic>& learned,
            const LiveOptions& options, record::Reader& reader, Context& context)
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
    const Time begin = batches.front().first;
    const Time until = options_.until.value_or(tables::kNever);
    Time now = batches.back().last;
    for (LiveFeed feed(tables_, shadow, begin, margin.resolution);;) {
      for (const Batch& batch : batches) {
        if (const Time silence = feed.add(batch); silence > 0) {
          context_.err << "link: read again after " << trace::seconds(silence) << "\n" << std::flush;
        }
      }
      feed.look(now);
      if (host::stop_requested().load() || now - begin >= until) break;
      std::this_thread::sleep_for(kLookForImages);
      now = link::client::steady_now();  // before take(): each image that was complete then is in it
      batches = take();
    }
    output.end(shadow.counts(), std::min(now - begin, until), inputs);
  }

 private:
  std::vector<Batch> first_images() {
    const Time begin = link::client::steady_now();
    const Time patience = std::max(options_.until.value_or(0), kLeastPatience);
    std::vector<Batch> batches;
    while (batches.size() < kMeasured && !host::stop_requested().load()) {
      std::this_thread::sleep_for(kLookForImages);
      const Time now = link::client::steady_now();
      for (Batch& batch : take()) batches.push_back(std::move(batch));
      if (options_.until && now - begin > patience) break;
      if (!batches.empty() && now - batches.back().last > kLeastPatience) break;  // that is what is shown
    }
    return batches;
  }

  /// What was read since the last call; shows the messages.
  std::vector<Batch> take() {
    record::ImageQueue::Taken taken = reader_.take();
    for (const std::string& message : taken.messages) {
      context_.err << diag::visible("link: " + message) << "\n" << std::flush;
    }
    return std::move(taken.batches);
  }

  const Compiled& compiled_;
  const tables::PlantTables& tables_;
  const std::vector<watch::Statistic>& learned_;
  const LiveOptions& options_;
  record::Reader& reader_;
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
  const auto chosen = link_to_read("watch", options.links, compiled.plant, tables);
  if (const auto* error = std::get_if<link::LinkError>(&chosen)) return fail(*error);
  const auto& choice = std::get<link::LinkChoice>(chosen);
  auto opened = link::client_parts(choice, tables);
  if (const auto* error = std::get_if<link::LinkError>(&opened)) return fail(*error);
  auto& parts = std::get<link::client::ClientParts>(opened);
  host::catch_signals();
  try {
    record::Reader reader(parts, tables, options.every);
    LiveWatch(compiled, tables, learned, options, reader, context).run(files, choice.url, inputs);
  } catch (const std::system_error& error) {
    fail({link::LinkError::Kind::environment, std::string("cannot start a thread: ") + error.what()});
  }
}

}  // namespace symplant::app

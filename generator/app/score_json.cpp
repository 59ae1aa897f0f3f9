// The score of a plant, for programs.
#include "app/score_json.hpp"

#include <algorithm>
#include <span>

#include "base/text_source.hpp"
#include "score/levels.hpp"
#include "score/questions.hpp"
#include "view/json_writer.hpp"

namespace symplant::app {
namespace {

using name::Account;
using score::Level;
using score::Part;

constexpr std::size_t kMostShapesInJson = 1'000;

class ScoreWriter {
 public:
  ScoreWriter(base::TextSink& sink, const model::PlantModel& plant, const score::PlantScore& score)
      : json_(sink, view::JsonWriter::Form::compact), plant_(plant), score_(score) {}

  void write(const std::string& file) {
    json_.begin_object();
    json_.member("plant", file);
    json_.key("score");
    json_.begin_object();
    json_.member("rule", plant_.rule_text());
    json_.key("total");
    json_.begin_object();
    write_counts(score_.total);
    json_.end_object();
    write_parts("lists", Level::list);
    write_parts("lines", Level::line);
    write_parts("stations", Level::station);
    write_parts("devices", Level::device);
    json_.key("left_over");
    write_shapes(score::left_over_shapes(plant_, score_));
    write_questions();
    json_.end_object();
    json_.end_object();
    json_.finish();
  }

 private:
  /// The members of an open object.
  void write_counts(const score::Counts& counts) {
    json_.member("symbols", counts.counted());
    json_.member("paired", counts.paired());
    for (const Account account : {Account::constant, Account::operator_panel, Account::data, Account::interlock,
                                  Account::senses_parts, Account::follows, Account::condition}) {
      json_.member(name::account_key(account), counts.of(account));
    }
    json_.member("accounted", counts.accounted());
    json_.key("left_over");
    json_.begin_object();
    for (std::size_t v = 0; v < name::kAccounts; ++v) {
      const auto account = static_cast<Account>(v);
      if (name::is_left_over(account) && counts.of(account) != 0) {
        json_.member(name::account_key(account), counts.of(account));
      }
    }
    json_.end_object();
  }

  void write_parts(std::string_view key, Level level) {
    json_.key(key);
    json_.array(score::parts_of(plant_, score_, level), [&](const Part& part) {
      json_.begin_object();
      if (level == Level::list) json_.member("list", plant_.lists[part.list].table->source->path());
      if (level == Level::device) json_.member("device", part.path());
      if (level != Level::list) json_.member("line", part.line);
      if (level == Level::station || level == Level::device) json_.member("process", part.process);
      write_counts(part.counts);
      json_.end_object();
    });
  }

  void write_shapes(const std::vector<score::Shape>& shapes) {
    json_.array(std::span(shapes).first(std::min(shapes.size(), kMostShapesInJson)), [&](const score::Shape& shape) {
      json_.begin_object();
      json_.member("shape", shape.text);
      json_.member("reason", name::account_key(shape.account));
      json_.member("symbols", shape.count);
      json_.member("example", plant_.symbols[shape.first].name());
      json_.end_object();
    });
  }

  void write_questions() {
    const score::Questions questions = score::questions_of(plant_, score_);
    json_.key("questions");
    json_.begin_object();
    json_.key("shapes");
    write_shapes(questions.shapes);
    if (plant_.levels() == nullptr && !questions.shapes.empty()) json_.member("rest", questions.rule());
    json_.end_object();
  }

  view::JsonWriter json_;
  const model::PlantModel& plant_;
  const score::PlantScore& score_;
};

}  // namespace

std::string score_json(const std::string& file, const model::PlantModel& plant, const score::PlantScore& score) {
  return base::text_of([&](base::TextSink& sink) { ScoreWriter(sink, plant, score).write(file); });
}

}  // namespace symplant::app

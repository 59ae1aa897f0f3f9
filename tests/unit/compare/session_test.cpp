// How an expert and a trainee did one exercise: their sessions at the panel, by hand-computed times.
#include "compare/session.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

constexpr std::int64_t kSecond = 1'000'000'000;

Json step(const std::string& text, const std::string& state, const Json& at) {
  return {{"text", text}, {"does", "set X"}, {"state", state}, {"t", at}};
}

Json act(std::int64_t t, const Json& done, const std::string& by = "hand") {
  return {{"n", 0}, {"t", t}, {"by", by}, {"act", done}};
}

/// An exercise from 100 s on: a step that acts at once, then two waits.
Json session_of(std::int64_t first, std::int64_t second, std::int64_t score) {
  return {{"symplant-session", 1},
          {"plant", "cell"},
          {"model_hash", "00000000000000aa"},
          {"seed", 0},
          {"t", 500 * kSecond},
          {"acts", Json::array({act(3 * kSecond, {{"set", {{"EARLY", true}}}}), act(0, {{"exercise", "air"}}),
                                act(100 * kSecond, {{"state", {{"AIR", "NOT_GOOD"}}}}, "scenario"),
                                act(101 * kSecond, {{"join", true}}),
                                act(first, {{"set", {{"VALVE", true}, {"LAMP", false}}}})})},
          {"findings", Json::array({{{"t", 50 * kSecond}, {"severity", "warning"}, {"text", "before"}},
                                    {{"t", first}, {"severity", "note"}, {"text", "only a note"}},
                                    {{"t", first}, {"severity", "warning"}, {"text", "lost command"}}})},
          {"exercise",
           {{"name", "air"},
            {"title", "No air"},
            {"text", ""},
            {"state", "over"},
            {"steps", Json::array({step("", "done", 100 * kSecond), step("Bring the air back", "done", first),
                                   step("Close the clamp", "done", second)})},
            {"score", score},
            {"most", 20},
            {"since", 100 * kSecond},
            {"took", second - 100 * kSecond}}}};
}

compare::Session read(const Json& json, const std::string& file = "a.json") {
  compare::ReadSession read = compare::read_session(json.dump(), file);
  INFO(read.error);
  REQUIRE(read.error.empty());
  return std::move(read.session);
}

std::string shown(const compare::SessionComparison& comparison,
                  void (*write)(const compare::SessionComparison&, base::TextSink&) = compare::write_text) {
  return base::text_of([&](base::TextSink& sink) { write(comparison, sink); });
}

Json with_reactions(Json session, const Json& malfunctions) {
  session["training"] = {{"trainees", Json::array()}, {"malfunctions", malfunctions}};
  return session;
}

Json malfunction(const std::string& name, std::int64_t start, const Json& reactions) {
  return {{"n", 0}, {"name", name}, {"start", start}, {"effect", start}, {"end", nullptr}, {"reactions", reactions}};
}

TEST_CASE("A session is known by its first key") {
  CHECK(compare::is_session(R"({"symplant-session":1})"));
  CHECK(compare::is_session("\xEF\xBB\xBF { \"symplant-session\" : 1"));
  CHECK_FALSE(compare::is_session(R"({"symplant-trace":1})"));
  CHECK_FALSE(compare::is_session("t,X\n0,1"));
  CHECK_FALSE(compare::is_session(""));
}

TEST_CASE("Times of a session begin with its exercise, and only acts by hand within it count") {
  const compare::Session session = read(session_of(110 * kSecond, 130 * kSecond, 15));
  CHECK(session.end == 30 * kSecond);
  CHECK(session.is_over);
  REQUIRE(session.steps.size() == 3);
  CHECK(session.steps[0].words == "set X");
  CHECK(session.steps[0].took == 0);
  CHECK(session.steps[1].took == 10 * kSecond);
  CHECK(session.steps[2].took == 20 * kSecond);
  REQUIRE(session.acts.size() == 1);
  CHECK(session.acts[0].at == 10 * kSecond);
  CHECK(session.acts[0].words == "set LAMP off, VALVE on");
  REQUIRE(session.findings.size() == 1);
  CHECK(session.findings[0].words == "lost command");
}

TEST_CASE("What a restore took back does not count") {
  Json json = session_of(110 * kSecond, 130 * kSecond, 15);
  json["acts"].push_back(act(120 * kSecond, {{"force", {{"X", true}}}}));
  json["acts"].push_back(act(115 * kSecond, {{"restore", "back"}}));
  json["acts"].push_back(act(125 * kSecond, {{"release", "all"}}));
  const compare::Session session = read(json);
  REQUIRE(session.acts.size() == 2);
  CHECK(session.acts[1].words == "released all");
}

TEST_CASE("If trainees acted by name, only their acts count, with their names if there are several") {
  Json json = session_of(110 * kSecond, 130 * kSecond, 15);
  const auto add = [&](std::int64_t second, const std::string& name) {
    json["acts"].push_back(act(second * kSecond, {{"release", "all"}}));
    json["acts"].back()["name"] = name;
  };
  add(112, "Anna");
  add(113, "Anna");
  compare::Session session = read(json);
  CHECK(session.names == std::vector<std::string>{"Anna"});
  REQUIRE(session.acts.size() == 2);
  CHECK(session.acts[0].words == "released all");
  add(114, "Ben");
  session = read(json);
  CHECK(session.names == std::vector<std::string>{"Anna", "Ben"});
  CHECK(session.acts.back().words == "Ben: released all");
}

TEST_CASE("The table has the time of each step, the difference and the ratio") {
  const compare::Session expert = read(session_of(110 * kSecond, 130 * kSecond, 20), "expert.session.json");
  compare::Session trainee = read(session_of(125 * kSecond, 135 * kSecond, 12), "anna.session.json");
  trainee.steps[2].state = "failed";
  const compare::SessionComparison comparison = compare::compare_sessions(expert, trainee);
  CHECK(comparison.error.empty());
  CHECK(comparison.warning.empty());
  CHECK(shown(comparison) ==
        "expert : expert.session.json, No air\n"
        "trainee: anna.session.json, No air\n"
        "\n"
        "          expert    trainee   difference  ratio\n"
        "score     20 of 20  12 of 20  -8\n"
        "time      30 s      35 s      +5 s        1.17\n"
        "acts      1         1         +0\n"
        "findings  1         1         +0\n"
        "\n"
        "step                   expert  trainee        difference  ratio\n"
        "2: Bring the air back  10 s    25 s           +15 s       2.50\n"
        "3: Close the clamp     20 s    10 s (failed)  -10 s       0.50\n");
  CHECK(compare::summary(comparison) == "expert 30 s and 20 points, trainee 35 s and 12 points");
}

TEST_CASE("A step that was not reached has no time") {
  const compare::Session expert = read(session_of(110 * kSecond, 130 * kSecond, 20));
  Json json = session_of(125 * kSecond, 135 * kSecond, 0);
  json["exercise"]["steps"][2] = step("Close the clamp", "active", nullptr);
  json["exercise"]["took"] = nullptr;
  json["t"] = 200 * kSecond;
  const compare::Session trainee = read(json);
  CHECK_FALSE(trainee.is_over);
  CHECK(trainee.end == 100 * kSecond);
  const std::string text = shown(compare::compare_sessions(expert, trainee));
  CHECK(contains(text, "3: Close the clamp     20 s    -\n"));
  CHECK(contains(text, "time      30 s      100 s, not over  +70 s       3.33\n"));
}

TEST_CASE("Reaction times are compared malfunction by malfunction, in their order") {
  const auto at = [](std::int64_t seconds) { return seconds * kSecond; };
  const compare::Session expert =
      read(with_reactions(session_of(at(110), at(130), 20),
                          Json::array({malfunction("jam", at(10), Json::array({Json::array({0, at(1)})})),  // before
                                       malfunction("jam", at(105), Json::array({Json::array({0, at(2)})})),
                                       malfunction("jam", at(115), Json::array({Json::array({0, at(3)})})),
                                       malfunction("eye blind", at(116), Json::array())})));
  const compare::Session trainee = read(with_reactions(
      session_of(at(110), at(130), 20),
      Json::array({malfunction("jam", at(105), Json::array({Json::array({1, at(9)}), Json::array({0, at(6)})})),
                   malfunction("cable", at(106), Json::array({Json::array({0, at(4)})}))})));
  const std::string text = shown(compare::compare_sessions(expert, trainee));
  CHECK(contains(text, "expert : a.json, No air\ntrainee: a.json, No air\n"));
  CHECK(contains(text,
                 "reaction to  expert  trainee  difference  ratio\n"
                 "jam          2 s     6 s      +4 s        3.00\n"
                 "jam          3 s     -\n"
                 "eye blind    -       -\n"
                 "cable        -       4 s\n"));
}

TEST_CASE("Sessions of two plants are an error, those of two exercises a warning") {
  const Json json = session_of(110 * kSecond, 130 * kSecond, 20);
  Json other = json;
  other["model_hash"] = "00000000000000bb";
  CHECK(contains(compare::compare_sessions(read(json), read(other, "b.json")).error, "the sessions are of two plants"));
  Json another = json;
  another["exercise"]["title"] = "Start <up>";
  const compare::Session expert = read(json);
  const compare::Session trainee = read(another);
  const compare::SessionComparison comparison = compare::compare_sessions(expert, trainee);
  CHECK(comparison.error.empty());
  CHECK(comparison.warning ==
        "the sessions are of different exercises: the expert's of `No air` with 3 steps, the trainee's of `Start <up>` "
        "with 3 steps");
  CHECK(contains(shown(comparison, compare::write_html), "`Start &lt;up&gt;`"));
  Json none = json;
  none["exercise"] = nullptr;
  const compare::Session free = read(none);
  const compare::SessionComparison mixed = compare::compare_sessions(expert, free);
  CHECK(contains(mixed.warning, "the trainee's of no exercise"));
  CHECK(mixed.totals[0].trainee == "-");
  CHECK(free.end == 500 * kSecond);
}

TEST_CASE("What is not a whole session is an error that says so") {
  for (const std::string text :
       {R"({"symplant-session":1})", R"({"symplant-session":1)", R"({"symplant-session":2})"}) {
    INFO(text);
    CHECK(contains(compare::read_session(text, "x.json").error, "`x.json` is"));
  }
  for (const char* const key : {"acts", "findings", "t", "model_hash"}) {
    Json json = session_of(110 * kSecond, 130 * kSecond, 20);
    json[key] = Json::object({{"a", 1}});
    INFO(key);
    CHECK_FALSE(compare::read_session(json.dump(), "x.json").error.empty());
  }
  Json late = session_of(110 * kSecond, 130 * kSecond, 20);
  late["exercise"]["took"] = std::numeric_limits<std::int64_t>::max();
  CHECK(contains(compare::read_session(late.dump(), "x.json").error, "a time is not valid"));
  late["exercise"]["took"] = -1;
  CHECK(contains(compare::read_session(late.dump(), "x.json").error, "a time is not valid"));
}

TEST_CASE("Acts are in words") {
  const auto words = [](const char* json) { return compare::act_words(Json::parse(json)); };
  CHECK(words(R"({"state":{"DOOR":"OPEN"},"set":{"A":1,"B":true,"C":false,"D":2.5}})") ==
        "set A 1, B on, C off and 1 more, put DOOR into OPEN");
  CHECK(words(R"({"put":{"at":"BELT@1 m","kind":"raw"}})") == "put raw at BELT@1 m");
  CHECK(words(R"({"put":[{"at":"A","kind":"x"},{"at":"B","kind":"y"}],"take":["C"]})") ==
        "put x at A, y at B, took a part from C");
  CHECK(words(R"({"start":"jam"})") == "started jam");
  CHECK(compare::is_on_plant(Json::parse(R"({"take":"C"})")));
  CHECK_FALSE(compare::is_on_plant(Json::parse(R"({"message":"Look"})")));
  CHECK_FALSE(compare::is_on_plant(Json::parse(R"({"start":"jam"})")));
  CHECK(words(R"({"unknown":[1]})") == "unknown [1]");
}

TEST_CASE("The page shows both sessions on one time axis, without a script, and names as text") {
  const compare::Session expert = read(session_of(110 * kSecond, 130 * kSecond, 20), "expert.session.json");
  compare::Session trainee = read(session_of(125 * kSecond, 150 * kSecond, 12), "<script>.json");
  trainee.acts[0].words = "set <b>\"X\"</b> on";
  trainee.steps[1].state = "failed";
  const std::string html = shown(compare::compare_sessions(expert, trainee), compare::write_html);
  CHECK_FALSE(contains(html, "<script"));
  CHECK_FALSE(contains(html, "<b>"));
  CHECK(contains(html, "<title>Expert and trainee: No air</title>"));
  CHECK(contains(html, "<strong>&lt;script&gt;.json</strong>"));
  // The axis has 910 units for 50 s: 10 s are 182 of them.
  CHECK(contains(html, "<rect class=\"step\" x=\"74.0\" y=\"36\" width=\"182.0\""));
  CHECK(contains(html, "<rect class=\"step\" x=\"256.0\" y=\"36\" width=\"364.0\""));
  CHECK(contains(html, "<rect class=\"step failed\" x=\"74.0\" y=\"154\" width=\"455.0\""));
  CHECK(contains(html, "<a href=\"#trainee-act-1\"><title>25 s: set &lt;b&gt;"));
  CHECK(contains(html, "<li id=\"trainee-act-1\"><span class=\"time\">25 s</span> set &lt;b&gt;"));
  CHECK(contains(html, "<path class=\"finding\" d=\"M529.0 220l5 9h-10z\"/>"));
}

}  // namespace
}  // namespace symplant::test

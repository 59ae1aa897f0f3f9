// Trainees at the panel: their names, the table of what they did, and messages of the trainer.
#include "support/malfunction_bench.hpp"
#include "symplant/panel/training/characters.hpp"
#include "symplant/panel/training/trainees.hpp"
#include "symplant/trace/csv_text.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

/// A plant with malfunctions, and a panel with a link for trainees.
PanelPlan of_two_faults() {
  PanelPlan plan;
  plan.options.trainees = true;
  plan.reported = with_malfunctions(R"({"name":"jam","of":"L_P_AGV","stuck":true},
                                       {"name":"eye blind","force":{"L_P_EYE_I_ON":true}})");
  return plan;
}

/// A request that the trainees' link sends.
std::string as_trainee(const PanelBench& bench, std::string request) {
  return request.replace(request.find(bench.token), bench.token.size(), bench.tokens[1]);
}

/// The answer to acts of a trainee with this header `X-Symplant-Name`.
HttpAnswer post_as(const PanelBench& bench, const std::string& name, const std::string& acts) {
  std::string request = as_trainee(bench, bench.request("POST", "/api/v1/acts", "{\"acts\":[" + acts + "]}"));
  request.insert(request.find("Content-Type"), "X-Symplant-Name: " + name + "\r\n");
  return bench.send(request);
}

tables::Time act_as(const PanelBench& bench, const std::string& name, const std::string& acts) {
  const HttpAnswer answer = post_as(bench, name, acts);
  INFO(answer.body);
  REQUIRE(answer.status == 200);
  return Json::parse(answer.body).at("t");
}

Json training(const PanelBench& bench) { return bench.picture().at("training"); }

std::string file(const PanelBench& bench, const std::string& name) {
  const HttpAnswer answer = bench.send(bench.request("GET", "/api/v1/" + name));
  CHECK(answer.status == 200);
  CHECK(contains(answer.head, "Content-Type: text/csv; charset=utf-8"));
  CHECK(contains(answer.head, "filename=\"" + name + "\""));
  return answer.body;
}

/// A time in seconds as a cell, without a rounding.
std::string seconds(const Json& time) { return trace::csv_seconds(time.get<tables::Time>()); }

TEST_CASE("Two trainees join, and the table has what each did") {
  const PanelBench bench(of_two_faults());
  CHECK(training(bench) == Json::parse(R"({"trainees":[],"malfunctions":[]})"));
  const tables::Time joined = act_as(bench, "Anna", R"({"join":true})");
  act_as(bench, "%EB%AF%BC%EC%A4%80", R"({"join":true})");
  act_as(bench, "Anna", R"({"set":{"L_P_EYE_I_ON":true}})");
  const tables::Time last = act_as(bench, "Anna", R"({"set":{"L_P_EYE_I_ON":false}})");
  CHECK(post_as(bench, "Anna", R"({"set":{"L_P_AGV_O_P2":true}})").status == 403);
  CHECK(post_as(bench, "Anna", "{}").status == 422);
  CHECK(post_as(bench, "Anna", R"({"forse":{}})").status == 400);  // not readable: not counted
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");                   // of a client without a name
  const Json trainees = training(bench).at("trainees");
  REQUIRE(trainees.size() == 2);
  CHECK(trainees.at(0).at("name") == "Anna");
  CHECK(trainees.at(0).at("since").get<tables::Time>() <= joined);
  CHECK(trainees.at(0).at("last") == last);
  CHECK(trainees.at(0).at("acts") == 2);
  CHECK(trainees.at(0).at("refused") == 2);
  CHECK(trainees.at(0).at("reactions") == 0);
  CHECK(trainees.at(0).at("mean").is_null());
  CHECK(trainees.at(1).at("name") == "민준");
  CHECK(trainees.at(1).at("last").is_null());
  const Json acts = bench.picture().at("acts");
  CHECK(acts.at(0).at("act") == Json::parse(R"({"join":true})"));
  CHECK(acts.at(0).at("name") == "Anna");
  CHECK(acts.at(0).at("by") == "trainee");
  CHECK_FALSE(acts.back().contains("name"));
  const HttpAnswer scenario = bench.send(bench.request("GET", "/api/v1/session/scenario"));
  CHECK_FALSE(contains(scenario.body, "join"));
  CHECK_FALSE(contains(scenario.body, "Anna"));
}

TEST_CASE("The reaction of each trainee is the time from the first effect to the first act") {
  const PanelBench bench(of_two_faults());
  act_as(bench, "Anna", R"({"join":true})");
  act_as(bench, "Ben", R"({"join":true})");
  const tables::Time effect = bench.act(R"({"start":"eye blind"})");
  const tables::Time anna = act_as(bench, "Anna", R"({"state":{"L_P_DOOR":"OPEN2"}})");
  act_as(bench, "Anna", R"({"state":{"L_P_DOOR":"SHUT1"}})");
  CHECK(post_as(bench, "Ben", R"({"set":{"L_P_AGV_O_P2":true}})").status == 403);  // refused: no reaction
  Json run = training(bench).at("malfunctions").at(0);
  CHECK(run == Json({{"n", 0},
                     {"name", "eye blind"},
                     {"start", effect},
                     {"effect", effect},
                     {"end", nullptr},
                     {"reactions", Json::array({Json::array({0, anna - effect})})}}));
  bench.act(R"({"start":"jam"})");
  const tables::Time command = bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  CHECK(training(bench).at("malfunctions").at(1).at("effect") == command);
  CHECK(training(bench).at("malfunctions").at(1).at("reactions").empty());
  const tables::Time ben = act_as(bench, "Ben", R"({"state":{"L_P_DOOR":"OPEN2"}})");
  const tables::Time end = bench.act(R"({"stop":"eye blind"})");
  const tables::Time again = bench.act(R"({"start":"eye blind"})");
  const tables::Time second = act_as(bench, "Anna", R"({"state":{"L_P_DOOR":"SHUT1"}})");
  run = training(bench);
  CHECK(run.at("malfunctions").at(0).at("end") == end);
  const Json row = run.at("trainees").at(0);
  const tables::Time times[] = {anna - effect, second - again, second - command};
  CHECK(row.at("reactions") == 3);
  CHECK(row.at("least") == *std::min_element(times, times + 3));
  CHECK(row.at("greatest") == *std::max_element(times, times + 3));
  CHECK(row.at("mean") == (times[0] + times[1] + times[2]) / 3);
  const std::string reactions = file(bench, "reactions.csv");
  CHECK(contains(reactions, "malfunction,start [s],first effect [s],end [s],trainee,reaction [s]\r\n"));
  CHECK(contains(reactions, "eye blind," + seconds(effect) + "," + seconds(effect) + "," + seconds(end) + ",Ben," +
                                seconds(ben - effect) + "\r\n"));
  CHECK(contains(reactions, "jam," + seconds(run.at("malfunctions").at(1).at("start")) + "," + seconds(command) +
                                ",-,Ben," + seconds(ben - command) + "\r\n"));
  const std::string table = file(bench, "training.csv");
  CHECK(contains(table,
                 "name,first seen [s],last act [s],acts,refused,reactions,least reaction [s],mean reaction "
                 "[s],greatest reaction [s]\r\nAnna,"));
  CHECK(contains(table, "," + seconds(second) + ",3,0,3," + seconds(row.at("least")) + ","));
  const Json session = bench.get("/api/v1/session/session");
  CHECK(session.at("training") == run);
}

TEST_CASE("To acknowledge an alarm is a reaction, to silence the horn, and to acknowledge nothing, is not") {
  const PanelBench bench(of_two_faults());
  const tables::Time effect = bench.act(R"({"start":"eye blind"})");
  act_as(bench, "Anna", R"({"silence":true})");
  act_as(bench, "Anna", R"({"acknowledge":"all"})");  // there is nothing to acknowledge
  CHECK(training(bench).at("malfunctions").at(0).at("reactions").empty());
  bench.act(R"({"set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return !bench.picture().at("alarms").at("list").empty(); });
  const tables::Time at = act_as(bench, "Anna", R"({"acknowledge":"all"})");
  CHECK(training(bench).at("malfunctions").at(0).at("reactions") == Json::array({Json::array({0, at - effect})}));
}

TEST_CASE("A reset keeps the trainees, and forgets what they did") {
  const PanelBench bench(of_two_faults());
  bench.wait_for([&] { return bench.picture().at("t").get<tables::Time>() > 10 * kMs; });
  bench.act(R"({"start":"eye blind"})");
  act_as(bench, "Anna", R"({"set":{"L_P_EYE_I_ON":true}})");
  act_as(bench, "Anna", R"({"set":{"L_P_EYE_I_ON":false}})");
  CHECK(training(bench).at("trainees").at(0).at("acts") == 2);
  bench.act(R"({"reset":true})");
  const Json after = training(bench);
  CHECK(after.at("malfunctions").empty());
  CHECK(after.at("trainees").at(0).at("since") == 0);
  CHECK(after.at("trainees").at(0).at("acts") == 0);
  CHECK(after.at("trainees").at(0).at("reactions") == 0);
}

TEST_CASE("A name is percent-encoded UTF-8 of at most 64 bytes, once") {
  const PanelBench bench(of_two_faults());
  const auto status = [&](const std::string& name) { return post_as(bench, name, R"({"join":true})").status; };
  CHECK(status("J%C3%BCrgen%20M.") == 200);
  CHECK(status(std::string(64, 'a')) == 200);
  CHECK(status("%3Cimg%20src=x%20onerror=alert(1)%3E") == 200);  // a text, as any other
  for (const std::string& name :
       {std::string(65, 'a'), std::string("%"), std::string("%0A"), std::string("a%00b"), std::string("%7F"),
        std::string("%C2%85"), std::string("%FF"), std::string("%C0%AF"), std::string("%ED%A0%80"),
        std::string("%E2%80%AE"), std::string("%E2%80%A8"), std::string("%20"), std::string("%F5%80%80%80"),
        std::string("%E2%82"), std::string("a\r\nX-Symplant-Name: b")}) {
    INFO(name);
    CHECK(status(name) == 400);
  }
  CHECK(bench.post(R"({"join":true})").status == 422);
  CHECK(training(bench).at("trainees").size() == 3);
}

TEST_CASE("At most 100 trainees join") {
  const PanelBench bench(of_two_faults());
  for (int i = 0; i < 100; ++i) {
    const std::string name = "T" + std::to_string(i);
    bench.wait_for([&] { return post_as(bench, name, R"({"join":true})").status == 200; });  // 100 a second
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  const HttpAnswer answer = post_as(bench, "one more", R"({"join":true})");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "100 trainees have joined already"));
  CHECK(post_as(bench, "T7", R"({"join":true})").status == 200);
  CHECK(training(bench).at("trainees").size() == 100);
}

TEST_CASE("Of a trainee's times the last 1000 are kept, and those before stay counted") {
  panel::Times times;
  for (tables::Time t = 1; t <= 1005; ++t) times.add(t);
  CHECK(times.count() == 1005);
  CHECK(times.last() == 1005);
  times.forget_after(1000);
  CHECK(times.count() == 1000);
  times.forget_after(0);
  CHECK(times.count() == 5);
  CHECK_FALSE(times.last());
}

TEST_CASE("A name that begins like a formula is not one in the table") {
  const PanelBench bench(of_two_faults());
  act_as(bench, "%3DHYPERLINK(%22http://x%22)", R"({"join":true})");
  CHECK(contains(file(bench, "training.csv"), "\r\n\"'=HYPERLINK(\"\"http://x\"\")\","));
  CHECK(trace::csv_cell("+1") == "'+1");
  CHECK(trace::csv_cell("-1") == "'-1");
  CHECK(trace::csv_cell("@SUM") == "'@SUM");
  CHECK(trace::csv_cell("a,b") == "\"a,b\"");
  CHECK(trace::csv_cell("Anna") == "Anna");
  CHECK(trace::csv_seconds(1'500'000'000) == "1.5");
  CHECK(trace::csv_seconds(-1) == "-");
}

TEST_CASE("Messages are in the stream and in the log, not in the scenario") {
  const PanelBench bench(of_two_faults());
  CHECK(bench.picture().at("messages").empty());
  const tables::Time at = bench.act(R"({"message":"Look at the pump.\nThen say what you see."})");
  CHECK(bench.picture().at("messages") ==
        Json::array({{{"n", 0}, {"t", at}, {"text", "Look at the pump.\nThen say what you see."}}}));
  CHECK(bench.picture().at("acts").back().at("act").at("message") == "Look at the pump.\nThen say what you see.");
  CHECK_FALSE(contains(bench.send(bench.request("GET", "/api/v1/session/scenario")).body, "pump"));
  CHECK(contains(bench.send(bench.request("GET", "/api/v1/session/session")).body, "Look at the pump."));
  bench.act(R"({"reset":true})");
  CHECK(bench.picture().at("messages").size() == 1);
  for (int i = 1; i <= 50; ++i) bench.act("{\"message\":\"" + std::to_string(i) + "\"}");
  const Json messages = bench.picture().at("messages");
  CHECK(messages.size() == 50);
  CHECK(messages.at(0).at("n") == 1);
}

TEST_CASE("A message has 1 to 500 characters") {
  const PanelBench bench(of_two_faults());
  const auto status = [&](const std::string& text) { return bench.post("{\"message\":" + text + "}").status; };
  std::string longest;
  for (int i = 0; i < 500; ++i) longest += "가";
  CHECK(status("\"" + longest + "\"") == 200);
  CHECK(status("\"" + longest + "x\"") == 422);
  for (const std::string text : {"\"\"", "\" \\n \"", "\"a\\u0007\"", "\"a\\tb\"", "\"\\u202e\"", "7", "[]"}) {
    INFO(text);
    CHECK(status(text) == 422);
  }
  CHECK(bench.post(R"({"message":"a","run":true})").status == 400);
}

TEST_CASE("The table and the messages to all are the trainer's, and only a trainee joins") {
  const PanelBench bench(of_two_faults());
  act_as(bench, "Anna", R"({"join":true})");
  bench.act(R"({"message":"Look"})");
  CHECK(bench.post(R"({"join":true})").status == 422);
  CHECK(post_as(bench, "Anna", R"({"message":"I look"})").status == 403);
  CHECK(training(bench).at("trainees").at(0).at("refused") == 1);
  const HttpAnswer answer = bench.send(as_trainee(bench, bench.request("GET", "/api/v1/picture")));
  const Json seen = Json::parse(answer.body);
  CHECK_FALSE(seen.contains("training"));
  CHECK(seen.at("messages").at(0).at("text") == "Look");
  CHECK(seen.at("acts").at(0).at("act") == Json::parse(R"({"join":true})"));
  CHECK_FALSE(seen.at("acts").at(0).contains("name"));
  for (const std::string name : {"training.csv", "reactions.csv"}) {
    CHECK(bench.send(as_trainee(bench, bench.request("GET", "/api/v1/" + name))).status == 403);
  }
}

TEST_CASE("Characters are counted, and only text is a character") {
  CHECK(panel::characters_of("", false) == 0);
  CHECK(panel::characters_of("a\xC3\xBC\xEA\xB0\x80\xF0\x9F\x98\x80", false) == 4);
  CHECK_FALSE(panel::characters_of("\n", false));
  CHECK(panel::characters_of("a\nb", true) == 3);
  CHECK_FALSE(panel::characters_of("\r", true));
  CHECK_FALSE(panel::characters_of("\xEF\xBF\xBF", false));
  CHECK_FALSE(panel::characters_of("\xF4\x90\x80\x80", false));
}

}  // namespace
}  // namespace symplant::test

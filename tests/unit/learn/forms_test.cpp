// The forms in which learned times are shown.
#include <nlohmann/json.hpp>

#include "learn/formats.hpp"
#include "learn_support.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

LearnedFrom learned_clamp() {
  return {kClamp,
          kBistable,
          {bit_trace(clamp_moves({{800, 600}, {850, 600}, {3200, 650}, {800, 600}}), "L_P_CL_", kEvery50)}};
}

std::string shown(const LearnedFrom& from, void (*write)(const learn::Learned&, base::TextSink&)) {
  return base::text_of([&](base::TextSink& sink) { write(from.learned, sink); });
}

TEST_CASE("Text has a table, then outliers") {
  const std::string text = shown(learned_clamp(), learn::write_text);
  CHECK(contains(text,
                 "folder/line1.jsonl: 8.9 s, resolution 0.05 s\n"
                 "8 moves of 1 device\n"
                 "\n"
                 "CL: 1 device\n"
                 "  device  transition    time   learned  model  moves  min    median  p95     max\n"
                 "  L_P_CL  OPEN->CLOSED  takes  0.82 s   1 s    3      0.8 s  0.8 s   0.85 s  0.85 s  1 outlier, few "
                 "moves\n"
                 "  L_P_CL  CLOSED->OPEN  takes  0.61 s   1 s    4      0.6 s  0.6 s   0.65 s  0.65 s  few moves, far "
                 "from the model\n"
                 "\n"
                 "Outliers, not used:\n"
                 "  L_P_CL OPEN->CLOSED takes: 3.2 s at 3.35 s in line1.jsonl\n"));
}

TEST_CASE("JSON has all figures and each sample") {
  const Json json = Json::parse(shown(learned_clamp(), learn::write_json));
  CHECK(json["symplant-learn"] == 1);
  CHECK(json["recordings"][0] ==
        Json({{"file", "folder/line1.jsonl"}, {"end", 8'900 * kMilli}, {"resolution", 50 * kMilli}}));
  REQUIRE(json["times"].size() == 2);
  const Json& time = json["times"][0];
  CHECK(time["name"] == "L_P_CL");
  CHECK(time["devices"] == Json({"L_P_CL"}));
  CHECK(time["transition"] == "OPEN->CLOSED");
  CHECK(time["time"] == "takes");
  CHECK(time["learned"] == 820 * kMilli);
  CHECK(time["model"] == 1000 * kMilli);
  CHECK(time["n"] == 3);
  CHECK(time["median"] == 800 * kMilli);
  CHECK(time["groups"] == Json::array({{{"n", 3}, {"min", 800 * kMilli}, {"max", 850 * kMilli}}}));
  CHECK(time["outliers"] == Json({3}));
  CHECK(time["samples"][3] == Json({3200 * kMilli, 3350 * kMilli, 0, "L_P_CL"}));
  CHECK(json["not_seen"]["devices"].empty());
}

/// The data of the page.
Json page_data(const std::string& page) {
  const std::string open = "id=\"data\">";
  const std::size_t begin = page.find(open) + open.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST_CASE("The page shows what is odd first, in one file without a network") {
  const std::string page = shown(learned_clamp(), learn::write_html);
  CHECK(contains(page, "default-src 'none'"));
  CHECK(!contains(page, "http://"));
  CHECK(!contains(page, "https://"));
  CHECK(!contains(page, "@data@"));
  const Json data = page_data(page);
  REQUIRE(data["times"].size() == 2);
  CHECK(data["times"][0]["odd"] == "1 outlier, few moves");
  CHECK(data["times"][0]["of"] == "OPEN->CLOSED takes");
  CHECK(data["times"][0]["outliers"] == Json({"3.2 s at 3.35 s in line1.jsonl"}));
  const Json& histogram = data["times"][0]["histogram"];
  int moves = 0;
  for (const int count : histogram["counts"]) moves += count;
  CHECK(moves == 3);
  CHECK(histogram["outliers"].back() == 1);
}

TEST_CASE("The file of times says where each is from") {
  CHECK(learn::learned_file(learned_clamp().learned) ==
        "{\n"
        "  \"symplant\": 1,\n"
        "  \"times\": {\n"
        "    \"L_P_CL\": {\n"
        "      // 3 moves in line1.jsonl, resolution 0.05 s, without 1 outlier; few moves: others may differ\n"
        "      \"OPEN->CLOSED\": { \"takes\": \"0.82s\" },\n"
        "      // 4 moves in line1.jsonl, resolution 0.05 s; few moves: others may differ\n"
        "      \"CLOSED->OPEN\": { \"takes\": \"0.61s\" }\n"
        "    }\n"
        "  },\n"
        "  // means that `symplant watch` compares with\n"
        "  \"learned\": {\n"
        "    \"devices\": {\n"
        "      \"L_P_CL\": {\n"
        "        \"OPEN->CLOSED\": { \"takes\": { \"n\": 3, \"mean\": \"0.816666667s\", \"sd\": \"0.028867513s\" } },\n"
        "        \"CLOSED->OPEN\": { \"takes\": { \"n\": 4, \"mean\": \"0.6125s\", \"sd\": \"0.025s\" } }\n"
        "      }\n"
        "    }\n"
        "  }\n"
        "}\n");
}

TEST_CASE("The long text and JSON have the moves that are not used, by device") {
  const LearnedFrom from(
      kClamp, kBistable,
      {bit_trace("0 O_OPEN 0; 0 O_CLOSED 0; 0 I_OPEN 1; 0 I_CLOSED 0; 9000 I_OPEN 0; 9500 I_CLOSED 1", "L_P_CL_",
                 kEvery50)});
  const std::string line = "  not used: L_P_CL 1 of 1 (1 without a cause, 0 turned round)\n";
  CHECK(contains(shown(from, learn::write_long_text), line));
  CHECK(!contains(shown(from, learn::write_text), line));
  const Json json = Json::parse(shown(from, learn::write_json));
  CHECK(json["not_used"] == Json::array({{{"device", "L_P_CL"}, {"moves", 1}, {"uncaused", 1}, {"turned", 0}}}));
}

TEST_CASE("The long text has all names that are no symbol") {
  std::string changes = "0 I_OPEN 1";
  for (int i = 10; i < 40; ++i) changes += "; 0 NOTHING_" + std::to_string(i) + " 1";
  const LearnedFrom from(kClamp, kBistable, {bit_trace(changes, "L_P_CL_", kEvery50)});
  CHECK(contains(shown(from, learn::write_text), " and 10 more\n"));
  const std::string all = shown(from, learn::write_long_text);
  CHECK(!contains(all, " more\n"));
  CHECK(contains(all, "L_P_CL_NOTHING_39"));
}

}  // namespace
}  // namespace symplant::test

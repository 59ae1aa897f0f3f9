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
        "      // 3 moves in line1.jsonl, resolution 0.05 s, without 1 outlier\n"
        "      \"OPEN->CLOSED\": { \"takes\": \"0.82s\" },\n"
        "      // 4 moves in line1.jsonl, resolution 0.05 s\n"
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

}  // namespace
}  // namespace symplant::test

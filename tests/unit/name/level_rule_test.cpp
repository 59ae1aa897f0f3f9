// Names of levels: five of them, each fault at its exact bytes.
#include "name/level_rule.hpp"

#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "text/source_file.hpp"

namespace symplant::name {
namespace {

const LevelRule& strict() {
  static const LevelRule rule{"LINE_PROC_DEV_I|O_TASK",
                              '_',
                              true,
                              {Level::line, Level::process, Level::device, Level::direction, Level::task},
                              {{"I", Direction::event}, {"O", Direction::operation}}};
  return rule;
}

struct Read {
  std::string name;  ///< the views of the result point into it
  LevelReading reading;

  explicit Read(std::string text) : name(std::move(text)), reading(read_levels(strict(), name)) {}
  std::string line() const { return std::string(reading.of(Level::line)); }
  std::string process() const { return std::string(reading.of(Level::process)); }
  std::string device() const { return std::string(reading.of(Level::device)); }
  std::string task() const { return std::string(reading.of(Level::task)); }
  Direction direction() const { return reading.direction->says.value(); }
  std::size_t begin() const { return static_cast<std::size_t>(reading.where.data() - name.data()); }
  std::string faulty() const { return std::string(reading.where); }
  /// As an editor counts: from 1, in characters.
  std::size_t column() const { return text::SourceFile("list", name).position(begin()).column; }
};

TEST_CASE("A name that follows the rule gives its levels") {
  const Read read("EXLINE_MB_AGV_I_P1");
  CHECK(read.reading.fault == NameFault::none);
  CHECK(read.reading.levels == 5);
  CHECK(read.line() == "EXLINE");
  CHECK(read.process() == "MB");
  CHECK(read.device() == "AGV");
  CHECK(read.task() == "P1");
  CHECK(read.direction() == Direction::event);
  CHECK(Read("BB_S301_RBT3_O_WELD").direction() == Direction::operation);
}

TEST_CASE("A name with a fault has no direction, and levels only if they are all there") {
  for (const char* name : {"LEVEL", "A__C_I_P1", "A_B-_C_I_P1", "A_B_C_D_I_P1"}) {
    const Read read(name);
    INFO(name);
    REQUIRE(read.reading.fault != NameFault::none);
    CHECK(read.reading.direction == nullptr);
    CHECK(read.task().empty());
  }
  const Read read("A_B_C_X_P1");
  CHECK(read.reading.direction == nullptr);
  CHECK(read.process() == "B");
}

TEST_CASE("The direction is read in any case") {
  CHECK(Read("A_B_C_i_P1").direction() == Direction::event);
  CHECK(Read("A_B_C_o_P1").direction() == Direction::operation);
  CHECK(Read("A_B_C_o_P1").reading.fault == NameFault::none);
}

TEST_CASE("A word that begins with I or O is no direction") {
  for (const char* word : {"OPEN", "IN", "OUT", "II", "IO", "O1", "X", "1", "0"}) {
    const Read read("EXLINE_MB_DOOR_" + std::string(word) + "_P1");
    INFO(read.name);
    CHECK(read.reading.fault == NameFault::direction_unknown);
    CHECK(read.faulty() == word);
    CHECK(read.column() == 16);
  }
}

TEST_CASE("Words like OPEN are ordinary tasks and devices") {
  const Read task("EXLINE_MB_DOOR_O_OPEN");
  CHECK(task.reading.fault == NameFault::none);
  CHECK(task.task() == "OPEN");
  const Read levels("I_O_I_O_I");
  CHECK(levels.reading.fault == NameFault::none);
  CHECK(levels.direction() == Direction::operation);
  CHECK(levels.task() == "I");
}

TEST_CASE("A letter that only looks like I or O is no direction") {
  for (const char* word : {"\xCE\x99", "\xD0\x9E", "\xEF\xBC\xA9", "\xC4\xB1", "\xC3\x96"}) {  // Ι О Ｉ ı Ö
    const Read read("A_B_C_" + std::string(word) + "_P1");
    INFO(read.name);
    CHECK(read.reading.fault == NameFault::direction_unknown);
    CHECK(read.faulty() == word);
  }
}

TEST_CASE("Letters and digits of every script make levels") {
  for (const char* word : {"Ä", "ß", "Łódź", "設備", "공정", "Конвейер", "Ωμέγα", "١٢", "日本語2"}) {
    const Read read("LINE_" + std::string(word) + "_" + word + "_I_" + word);
    INFO(read.name);
    CHECK(read.reading.fault == NameFault::none);
    CHECK(read.process() == word);
    CHECK(read.task() == word);
  }
}

TEST_CASE("A character that is neither letter nor digit is the fault, complete and alone") {
  struct Case {
    const char* name;
    const char* part;
    std::size_t begin;
    std::size_t column;
  };
  for (const Case& c : {Case{"EXLINE-MB_AGV_I_P1", "-", 6, 7}, Case{"EXLINE_MB_AGV_I_P 1", " ", 17, 18},
                        Case{"EXLINE_MB_AGV_I_P1.", ".", 18, 19}, Case{"Ä_MB-AGV_I_P1", "-", 5, 5},
                        Case{"공정_MB_AGV.I_P1", ".", 13, 10}, Case{"L_🤖_AGV_I_P1", "🤖", 2, 3},
                        Case{"Ä공🤖_MB_AGV_I_P1", "🤖", 5, 3}, Case{".", ".", 0, 1},
                        Case{"A_B_C_I_P\xE2\x80\xAE"
                             "1",
                             "\xE2\x80\xAE", 9, 10},
                        Case{"A_B_C_I_P1\t", "\t", 10, 11}}) {
    const Read read(c.name);
    INFO(c.name);
    CHECK(read.reading.fault == NameFault::illegal_character);
    CHECK(read.begin() == c.begin);
    CHECK(read.faulty() == c.part);
    CHECK(read.column() == c.column);
  }
}

TEST_CASE("The first of several illegal characters is reported") { CHECK(Read("A.B-C_I_P1").begin() == 1); }

TEST_CASE("The whole name is the fault if it has too few levels") {
  for (const char* name : {"EXLINE_AGV_I_P1", "START", "A_B", "A_B_C", "Ä_I_P1"}) {
    const Read read(name);
    INFO(name);
    CHECK(read.reading.fault == NameFault::wrong_number_of_levels);
    CHECK(read.faulty() == name);
  }
  CHECK(Read("EXLINE_AGV_I_P1").reading.levels == 4);
  CHECK(Read("START").reading.levels == 1);
}

TEST_CASE("The surplus levels are the fault if there are too many, and the direction shows which") {
  const Read behind("EXLINE_MB_AGV_I_P1_OLD_X");
  CHECK(behind.reading.fault == NameFault::wrong_number_of_levels);
  CHECK(behind.reading.levels == 7);
  CHECK(behind.faulty() == "OLD_X");
  const Read before("EXLINE_MB_AGV_FAST_O_P2");
  CHECK(before.faulty() == "FAST");
  CHECK(before.column() == 15);
  const Read multi_byte("공정_MB_Ä_빠른_O_P2");
  CHECK(multi_byte.faulty() == "빠른");
  CHECK(multi_byte.column() == 9);
  CHECK(Read("A_B_C_D_E_F").faulty() == "F");  // no direction anywhere: the levels after the last
}

TEST_CASE("An empty level is reported at its location") {
  struct Case {
    const char* name;
    std::size_t begin;
  };
  for (const Case& c : {Case{"EXLINE__AGV_I_P1", 7}, Case{"_MB_AGV_I_P1", 0}, Case{"EXLINE_MB_AGV_I_", 16},
                        Case{"EXLINE_MB_AGV__P1", 14}, Case{"_EXLINE_MB_AGV_I_P1", 0}, Case{"EXLINE_MB_AGV_I_P1_", 19},
                        Case{"EXLINE_MB__AGV_I_P1", 10}, Case{"Ä__AGV_I_P1", 3}, Case{"____", 0}}) {
    const Read read(c.name);
    INFO(c.name);
    CHECK(read.reading.fault == NameFault::empty_level);
    CHECK(read.begin() == c.begin);
    CHECK(read.faulty().empty());
  }
}

TEST_CASE("An empty name and separators alone are faults, not crashes") {
  CHECK(Read("").reading.fault == NameFault::wrong_number_of_levels);
  CHECK(Read("_").reading.fault == NameFault::wrong_number_of_levels);
  CHECK(Read("________________").reading.fault != NameFault::none);
}

TEST_CASE("Names of 20,000 characters are read") {
  const std::string word(19'990, 'W');
  const Read read("A_B_" + word + "_I_P1");
  CHECK(read.reading.fault == NameFault::none);
  CHECK(read.device() == word);
  const Read levels(std::string(20'000, '_'));
  CHECK(levels.reading.fault != NameFault::none);
  std::string many;
  for (int i = 0; i < 10'000; ++i) many += "A_";
  CHECK(Read(many + "A").reading.levels == 10'001);
  std::string wide = "A_B_";
  for (int i = 0; i < 20'000; ++i) wide += "공";
  const Read dot(wide + "._I_P1");
  CHECK(dot.reading.fault == NameFault::illegal_character);
  CHECK(dot.column() == 20'005);
}

TEST_CASE("Every single ASCII character is checked") {
  for (int c = 1; c < 128; ++c) {
    const Read read("A_B_C_I_P" + std::string(1, static_cast<char>(c)));
    INFO("character " << c);
    const bool alnum = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (c == '_') {
      CHECK(read.reading.fault == NameFault::empty_level);
    } else {
      CHECK(read.reading.fault == (alnum ? NameFault::none : NameFault::illegal_character));
    }
  }
}

TEST_CASE("Plain names are cut as their separators say") {
  std::mt19937 random(1);
  const std::vector<std::string> parts{"A", "b9", "I", "o", "_", "__", "", "-", " ", "\xC3\xA4", "\xEC\x98\x88", "."};
  std::size_t plain = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string name;
    const bool well_formed = random() % 2 == 0;
    for (int level = 0; level < (well_formed ? 5 : static_cast<int>(random() % 8)); ++level) {
      if (level != 0) name += '_';
      name += well_formed && level != 3 ? parts[random() % 3] : parts[random() % (well_formed ? 4 : parts.size())];
    }
    CAPTURE(name);
    const LevelReading one = read_levels(strict(), name);
    // An umlaut instead of each A takes the general path, and must give the same reading.
    std::string wide;
    for (const char c : name) wide += c == 'A' ? std::string("\xC3\x84") : std::string(1, c);
    const LevelReading other = read_levels(strict(), wide);
    REQUIRE(one.fault == other.fault);
    REQUIRE(one.levels == other.levels);
    REQUIRE(one.direction == other.direction);
    for (std::size_t level = 0; level < kLevels; ++level) {
      std::string expected;
      for (const char c : one.text[level]) expected += c == 'A' ? std::string("\xC3\x84") : std::string(1, c);
      REQUIRE(other.text[level] == expected);
    }
    plain += one.fault == NameFault::none ? 1 : 0;
  }
  CHECK(plain > 1000);
}

}  // namespace
}  // namespace symplant::name

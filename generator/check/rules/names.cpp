// Rules: names against the naming rule and the limits of tools, and names and comments in a row.
#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "check/rule.hpp"
#include "convert/identifiers.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

using name::NameFault;

/// What is wrong with a name, and what to do.
std::string fault_text(const name::LevelRule& rule, const Symbol& symbol, const name::LevelReading& reading) {
  const std::string_view name = symbol.name();
  if (reading.fault == NameFault::wrong_number_of_levels) {
    return fmt::format("`{}` has {} level{}, and `{}` {}; {}", name, reading.levels, reading.levels == 1 ? "" : "s",
                       rule.pattern, rule.levels.size(),
                       reading.levels > rule.levels.size() ? "remove a level or join two" : "add what is missing");
  }
  if (reading.fault == NameFault::empty_level) {
    return fmt::format("`{}` has an empty level; write the missing word or remove the surplus `{}`", name,
                       rule.separator);
  }
  if (reading.fault == NameFault::illegal_character) {
    return fmt::format(
        "`{0}` has `{1}`, which is neither letter nor digit nor `{2}`; replace it with `{2}`, or remove it", name,
        reading.where, rule.separator);
  }
  const auto word = std::ranges::find(rule.directions, std::optional(symbol.direction), &name::DirectionWord::says);
  return fmt::format("`{}` has `{}` where its direction belongs; write or insert `{}`, as its address `{}` says", name,
                     reading.where, word == rule.directions.end() ? "" : word->word, symbol.address_cell());
}

/// How a name breaks the levels of the naming rule; nothing if it does not, or if the rule has no levels.
name::LevelReading broken_levels(const PlantModel& plant, const Symbol& symbol) {
  if (plant.levels() == nullptr || symbol.reading.is_named() || symbol.account == name::Account::plain) return {};
  return name::read_levels(*plant.levels(), symbol.name().substr(plant.list_of(symbol).prefix.size()));
}

template <NameFault fault>
void broken_names(const Find& find, const Symbol& symbol) {
  const name::LevelReading reading = broken_levels(find.plant, symbol);
  if (reading.fault != fault || find.named_otherwise[symbol.list]) return;
  const auto begin = static_cast<std::size_t>(reading.where.data() - symbol.name().data());
  Finding finding = find.at(symbol);
  text::Span& span = finding.as.location.span;
  if (span.end - span.begin == symbol.name().size()) {
    span = {span.begin + begin, span.begin + begin + reading.where.size()};
  }
  finding.explains(Kind::name, symbol.name());
  const char separator = find.plant.levels()->separator;
  std::size_t path = symbol.name().find(separator);
  for (int level = 1; level < 3 && path < begin; ++level) path = symbol.name().find(separator, path + 1);
  // The device is known if the fault is behind it.
  const bool known = find.plant.levels()->has_path && fault != NameFault::wrong_number_of_levels && path < begin;
  if (known) finding.explains(Kind::model, symbol.name().substr(0, path));
  if (fault == NameFault::illegal_character) {
    finding.rename(symbol, std::string(symbol.name()).replace(begin, reading.where.size(), 1, separator));
  }
  finding.say("{}", fault_text(*find.plant.levels(), symbol, reading));
}

/// The I/O names of a list, and how many have each fault. Without levels of names the score counts what no rule
/// matches.
struct NameCount {
  std::size_t all = 0;
  std::array<std::size_t, 5> broken{};  ///< by NameFault

  /// The fault of more than a third of at least four names; `none` if there is no such fault.
  NameFault common() const {
    const auto most = std::ranges::max_element(broken);
    return *most < 4 || *most * 3 <= all ? NameFault::none : static_cast<NameFault>(most - broken.begin());
  }
};

std::vector<NameCount> count_names(const PlantModel& plant) {
  std::vector<NameCount> counts(plant.lists.size());
  for (const Symbol& symbol : plant.symbols) {
    ++counts[symbol.list].all;
    const NameFault fault = broken_levels(plant, symbol).fault;
    if (fault != NameFault::none) ++counts[symbol.list].broken[static_cast<std::size_t>(fault)];
  }
  return counts;
}

void named_otherwise(const Find& find) {
  if (nothing_is_driven(find.plant)) return;  // SP415 reports it
  std::vector<NameCount> counts = count_names(find.plant);
  for (const Symbol& symbol : find.symbols) {
    const NameCount count = counts[symbol.list];
    const NameFault fault = count.common();
    if (fault == NameFault::none || broken_levels(find.plant, symbol).fault != fault) continue;
    counts[symbol.list] = {};  // reported
    const std::string file = find.plant.lists[symbol.list].name();
    find.at(location_of(find.plant, *symbol.row, symbol.name()))
        .say(
            "{} of {} I/O names in `{}` do not follow `{}`, such as `{}`; `symplant infer {} -o naming.json` proposes "
            "a rule",
            count.broken[static_cast<std::size_t>(fault)], count.all, file, find.plant.rule_text(), symbol.name(),
            file);
  }
}

void naming_ambiguous(const Find& find) {
  if (find.plant.pairing == nullptr) return;
  for (const pairing::Remark& remark : find.plant.pairing->remarks) {
    const bool of_path = remark.kind == pairing::Remark::Kind::path_ambiguous;
    if (!of_path && remark.kind != pairing::Remark::Kind::role_taken) continue;
    const Symbol& symbol = find.symbols[remark.input];
    find.at(symbol)
        .see(find.symbols[remark.other], "the one that comes first")
        .say("`{}` {}", of_path ? symbol.reading.device_path() : symbol.name(),
             of_path ? "is also the path of another device: conditions and plant.json mean the first one; make the "
                       "paths different"
                     : "fits the same role of an archetype as another symbol; make the text of the role more specific");
  }
}

struct Limit {
  std::string_view tool;  ///< the beginning of SymbolTable::title
  std::size_t characters;
};
constexpr std::array kLimits{Limit{"GX IEC Developer", 32}, Limit{"Logix Designer", 40}, Limit{"TIA Portal", 128}};

void name_too_long(const Find& find, const Symbol& symbol) {
  const std::string_view title = find.plant.lists[symbol.list].table->title;
  const auto* limit = std::ranges::find_if(kLimits, [&](const Limit& known) { return title.starts_with(known.tool); });
  if (limit == kLimits.end() || symbol.name().size() <= limit->characters) return;
  const std::size_t length = text::count_code_points(symbol.name());
  // A part of a structure or array has a longer path than its tag.
  if (length <= limit->characters || symbol.name().find_first_of(".[") != std::string_view::npos) return;
  find.at(symbol).say("`{}` has {} characters, and {} accepts {}; shorten it", symbol.name(), length, limit->tool,
                      limit->characters);
}

void reserved_word(const Find& find, const Symbol& symbol) {
  if (!convert::is_iec_reserved(symbol.name())) return;
  find.at(symbol)
      .rename(symbol, convert::iec_identifier(symbol.name()))
      .say("`{}` is a reserved word of IEC 61131-3: programs cannot use it as a name; rename it", symbol.name());
}

/// A symbol with an address, by the last number of its name, or of its comment where that is its name.
struct Numbered {
  const Symbol* symbol;
  std::string_view before;
  std::string_view digits;
  std::string_view after;

  std::uint64_t number() const {
    std::uint64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  }
  bool continues(const Numbered& last) const {
    return symbol->address->number == last.symbol->address->number + 1 && after == last.after && before == last.before;
  }
};

/// Reports the one symbol whose number does not continue a series of six or more, if all others do. The first two
/// numbers are its beginning: the next ones rise by one or double.
void end_run(const Find& find, std::vector<Numbered>& run) {
  for (const bool doubling : {false, true}) {
    std::size_t odd = 0;
    std::uint64_t expected = 0;
    bool fits = run.size() >= 6;
    std::uint64_t next = fits ? run.front().number() : 0;
    for (std::size_t i = 0; fits && i < run.size(); ++i, next = doubling ? 2 * next : next + 1) {
      if (run[i].number() == next) continue;
      fits = odd == 0 && i >= 2;
      odd = i;
      expected = next;
    }
    if (!fits || odd == 0) continue;
    find.at(*run[odd].symbol, run[odd].digits)
        .see(*run[odd - 1].symbol, "the one before")
        .say(
            "`{}` breaks the series of {} symbols from `{}` on: its number is {}, but the series continues with {}; "
            "correct it",
            run[odd].symbol->name(), run.size(), run.front().symbol->name(), run[odd].number(), expected);
  }
  run.clear();
}

void series_broken(const Find& find) {
  std::map<std::pair<std::uint32_t, address::Area>, std::vector<const Symbol*>> sides;  // of each list
  for (const Symbol& symbol : find.symbols) {
    if (!symbol.address || symbol.type != tables::DataType::boolean || symbol.leader != kNone) continue;
    sides[{symbol.list, symbol.address->area}].push_back(&symbol);
  }
  const auto number = [](const Symbol* symbol) { return symbol->address->number; };
  for (auto& [where, side] : sides) {
    if (!std::ranges::is_sorted(side, {}, number)) std::ranges::stable_sort(side, {}, number);
    std::vector<Numbered> run;
    for (const Symbol* symbol : side) {
      const std::string_view text = symbol->row->is_named_by_address() ? symbol->row->comment : symbol->name();
      const std::size_t end = text.find_last_of("0123456789") + 1;
      const std::size_t begin = text.substr(0, end).find_last_not_of("0123456789") + 1;
      const Numbered each{symbol, text.substr(0, begin), text.substr(begin, end - begin), text.substr(end)};
      if (!run.empty() && !each.continues(run.back())) end_run(find, run);
      run.push_back(each);
    }
    end_run(find, run);
  }
}

void comment_twice(const Find& find) {
  using Points = std::vector<const Symbol*>;
  std::vector<std::map<std::pair<std::string_view, Direction>, Points>> lists(find.plant.lists.size());
  for (const Symbol& symbol : find.symbols) {
    const std::string_view comment = symbol.row->comment;
    if (!symbol.row->is_named_by_address() || comment.size() < 8 || symbol.leader != kNone) continue;
    lists[symbol.list][{comment, symbol.direction}].push_back(&symbol);
  }
  for (const auto& comments : lists) {
    std::size_t unique = 0;
    Points twice;  // more than two are spares, or mean one thing
    for (const auto& [comment, points] : comments) {
      unique += points.size() == 1 ? 1U : 0U;
      if (points.size() == 2) twice.insert(twice.end(), points.begin(), points.end());
    }
    if (twice.empty() || unique < 20 || (comments.size() - unique) * 20 > comments.size()) continue;
    Finding finding = find.at(*twice[1], twice[1]->row->comment);
    for (const Symbol* point : twice) {
      if (point != twice[1]) finding.see(*point->row, point->row->comment, std::string(point->name()));
    }
    finding.say("`{}` and `{}` have the same comment `{}`{}; number or correct them", twice[1]->name(),
                twice[0]->name(), twice[1]->row->comment,
                twice.size() == 2 ? "" : fmt::format("; so do {} more pairs of points", twice.size() / 2 - 1));
  }
}

constexpr Rule kNameRules[] = {
    {"SP201", "wrong-number-of-levels", kWarning, broken_names<NameFault::wrong_number_of_levels>,
     "a name has more or fewer levels than the rule",
     "The built-in rule is `LINE_PROC_DEV_I|O_TASK`: five levels of letters and digits, separated by `_`.",
     "The symbol is served, but its device is unknown: it is in no device.",
     "Add a level or join words: `LINE_MB_AGV_FAST_O_P2` becomes `LINE_MB_AGVFAST_O_P2`.", Rank::name, For::levels},
    {"SP202", "empty-level", kWarning, broken_names<NameFault::empty_level>, "a level of a name is empty",
     "A name has two adjacent separators, or one at its beginning or end: `EXLINE__AGV_I_P1`.",
     "The symbol is served, but in no device.", "Write the missing word, or remove a `_`.", Rank::name, For::levels},
    {"SP203", "direction-not-io", kWarning, broken_names<NameFault::direction_unknown>,
     "the direction level is neither I nor O", "`I` is an input of the PLC (an event), `O` an output (an operation).",
     "The symbol is served in the direction of its address, but is in no device.",
     "Write `I` or `O`, or insert it: `L_P_DOOR_OPEN_P1` becomes `L_P_DOOR_I_OPENP1`.", Rank::name, For::levels},
    {"SP204", "illegal-character", kWarning, broken_names<NameFault::illegal_character>,
     "a name has an illegal character",
     "A name has a blank, `-`, `.` or bracket. Letters (of any script), digits and the separator are legal.",
     "The symbol is served, but is in no device: its name has no levels.",
     "Remove it or write the separator: `LINE_MB-AGV_I_P1` becomes `LINE_MB_AGV_I_P1`.", Rank::name, For::levels},
    {"SP206", "naming-ambiguous", kWarning, naming_ambiguous, "two devices have one path, or two symbols one role",
     "Names differ in words that a custom naming rule leaves out, or two texts match the pattern of one role.",
     "A path in a condition or in plant.json means the first device, and a second symbol is paired by its words.",
     "Divide both names into the same levels, or add `\"fixed\": { \"line\": \"PLC2\" }`; make the texts of roles more "
     "specific."},
    {"SP208", "named-otherwise", kWarning, named_otherwise, "many names of a list do not follow the naming rule",
     "More than a third of the I/O names do. Neither single names nor devices are reported then.",
     "The symbols are served, but in no device.", "`symplant infer LIST -o naming.json` proposes a rule.", Rank::name},
    {"SP213", "name-too-long", kWarning, name_too_long, "a name is longer than its engineering tool accepts",
     "GX IEC Developer accepts 32 characters, Logix Designer 40, TIA Portal 128.",
     "Nothing here, but an import into the tool refuses or cuts the name.", "Shorten it."},
    {"SP214", "reserved-word", kWarning, reserved_word, "a name is a word of IEC 61131-3",
     "A name is a keyword, an elementary type or a standard function: `STEP`, `TIME`, `LIMIT`.",
     "Nothing here, but programs in structured text cannot use the name.",
     "Rename the symbol. `symplant convert` writes `_STEP`."},
    {"SP321", "series-broken", kWarning, series_broken, "one number of a series of names does not fit",
     "Names or comments on addresses in a row differ only in their last number, which rises by one or doubles (1, 2, 4 "
     "... 64), except for one: `CODE_64` and then `CODE_12`.",
     "That symbol is paired with another one, or with none.", "Write the number that continues the series."},
    {"SP322", "comment-twice", kWarning, comment_twice, "two points have one comment",
     "Two inputs, or two outputs, have one comment in a list that names its points by comments, nearly all unique. "
     "Most often a row was copied. There is one finding for each list.",
     "A naming rule that reads comments cannot distinguish the two.",
     "Correct the wrong comment, or number both: `LIMIT 1`, `LIMIT 2`."},
};

}  // namespace

std::vector<bool> lists_named_otherwise(const PlantModel& plant) {
  std::vector<bool> otherwise;
  for (const NameCount& count : count_names(plant)) otherwise.push_back(count.common() != NameFault::none);
  return otherwise;
}

std::span<const Rule> name_rules() { return kNameRules; }

}  // namespace symplant::check

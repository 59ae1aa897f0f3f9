// Which symbols the variables of a program are bound to.
#include "symplant/program/binding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "symplant/condition/compare.hpp"
#include "symplant/program/address.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/pattern.hpp"

namespace symplant::program {
namespace {

using tables::kNone;

std::string_view text_of(const char* text) { return text == nullptr ? std::string_view() : std::string_view(text); }

/// Finds symbols of one controller.
class Symbols {
 public:
  Symbols(const trace::PlantNames& names, std::uint32_t controller) : names_(names) {
    const tables::PlantTables& tables = names.tables();
    for (const tables::SharedAddress& shared : tables.shared_addresses)
      followers_.emplace(shared.symbol, shared.leader);
    for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
      if (tables::controller_of(tables, i) != controller) continue;
      rows_.push_back(i);
      const tables::SymbolRow& row = tables.symbols[i];
      by_name_.emplace(tables::to_upper(names.symbol(i)), i);
      if (!names.address(i).empty()) by_text_.emplace(key(row.direction(), tables::to_upper(names.address(i))), i);
      if (row.form() == tables::AddressForm::number) {
        by_number_.emplace(std::pair(row.direction(), std::pair(bits_of(row.type()), row.number)), i);
      }
    }
  }

  std::optional<std::uint32_t> named(std::string_view name) const { return found(by_name_, tables::to_upper(name)); }

  /// A symbol at an address; of a direction, as an address of memory does not say one.
  std::optional<std::uint32_t> at(std::string_view address, tables::Direction direction) const {
    if (const auto by_text = found(by_text_, key(direction, tables::to_upper(address)))) return by_text;
    const auto read = parse_address(address);
    if (!read) return std::nullopt;
    return found(by_number_, std::pair(read->direction, std::pair(read->bits, read->number)));
  }

  std::string nearest_name(std::string_view wanted) const {
    tables::NearestName nearest(wanted);
    for (const std::uint32_t row : rows_) nearest.offer(names_.symbol(row));
    return std::string(nearest.name());
  }

  /// The symbol whose address has the nearest number, of this size and direction.
  std::optional<std::uint32_t> nearest_at(const Address& address) const {
    const auto wanted = std::pair(address.direction, std::pair(address.bits, address.number));
    auto after = by_number_.lower_bound(wanted);
    const auto fits = [&](auto at) {
      return at != by_number_.end() && at->first.first == address.direction && at->first.second.first == address.bits;
    };
    if (fits(after)) return after->second;
    if (after == by_number_.begin() || !fits(--after)) return std::nullopt;
    return after->second;
  }

  /// The symbol that decides the value on its address.
  std::uint32_t leader(std::uint32_t symbol) const { return found(followers_, symbol).value_or(symbol); }
  std::span<const std::uint32_t> rows() const { return rows_; }

 private:
  template <class Map, class Key>
  static std::optional<std::uint32_t> found(const Map& map, const Key& key) {
    const auto at = map.find(key);
    return at == map.end() ? std::nullopt : std::optional(at->second);
  }
  static std::string key(tables::Direction direction, std::string address) {
    return (direction == tables::Direction::operation ? "o" : "e") + std::move(address);
  }

  const trace::PlantNames& names_;
  std::vector<std::uint32_t> rows_;
  std::unordered_map<std::string, std::uint32_t> by_name_;
  std::unordered_map<std::string, std::uint32_t> by_text_;
  std::map<std::pair<tables::Direction, std::pair<std::uint8_t, std::uint32_t>>, std::uint32_t> by_number_;
  std::unordered_map<std::uint32_t, std::uint32_t> followers_;
};

std::string bits_words(std::uint32_t bits) { return fmt::format("{} {}", bits, bits == 1 ? "bit" : "bits"); }

class Binder {
 public:
  Binder(const symplant_program& program, const trace::PlantNames& names, std::uint32_t controller,
         const std::vector<std::string>& ignore)
      : program_(program), names_(names), symbols_(names, controller), ignore_(ignore) {}

  Binding run() {
    for (std::uint32_t i = 0; i < program_.count; ++i) binding_.symbols.push_back(bound(i));
    for (const std::uint32_t row : symbols_.rows()) {
      if (names_.is_operation(row) && writers_.count(symbols_.leader(row)) == 0) ++binding_.unwritten;
    }
    return std::move(binding_);
  }

 private:
  /// The symbol of a variable; kNone after an error, and if the variable is ignored.
  std::uint32_t bound(std::uint32_t index) {
    const symplant_variable& variable = program_.variables[index];
    const std::string_view name = text_of(variable.symbol);
    const std::string_view address = text_of(variable.address);
    const bool ignored = std::any_of(ignore_.begin(), ignore_.end(), [&](const std::string& pattern) {
      return (!name.empty() && tables::matches_pattern(name, pattern)) ||
             (!address.empty() && tables::matches_pattern(address, pattern));
    });
    const auto direction = variable.writes != 0 ? tables::Direction::operation : tables::Direction::event;
    const auto symbol = !name.empty()      ? symbols_.named(name)
                        : !address.empty() ? symbols_.at(address, direction)
                                           : std::nullopt;
    if (!symbol) {
      if (!ignored) missing(index, name, address);
      return kNone;
    }
    const tables::SymbolRow& row = names_.tables().symbols[*symbol];
    const std::string words = variable_words(variable);
    const std::uint8_t bits = bits_of(row.type());
    if (ignored && (row.direction() != direction || variable.bits != bits)) return kNone;
    if (row.direction() != direction) {
      error("{} is {}, and `{}` is {}: a program {}", words, variable.writes != 0 ? "written" : "read",
            names_.symbol(*symbol), variable.writes != 0 ? "an event" : "an operation",
            variable.writes != 0 ? "reads events" : "writes operations");
    } else if (variable.bits != bits) {
      error("{} has {}, and `{}` is {}, which has {}", words, bits_words(variable.bits), names_.symbol(*symbol),
            condition::type_name(row.type()), bits_words(bits));
    } else if (variable.writes != 0 && !writers_.emplace(symbols_.leader(*symbol), index).second) {
      error("{} and {} both write `{}`: remove one of them",
            variable_words(program_.variables[writers_[symbols_.leader(*symbol)]]), words, names_.symbol(*symbol));
    } else {
      return *symbol;
    }
    return kNone;
  }

  void missing(std::uint32_t index, std::string_view name, std::string_view address) {
    if (name.empty() && address.empty()) {
      error("variable {} has neither a symbol nor an address", index + 1);
    } else if (!name.empty()) {
      const std::string nearest = symbols_.nearest_name(name);
      error("symbol `{}` not found{}", name, nearest.empty() ? "" : "; did you mean `" + nearest + "`?");
    } else {
      const auto read = parse_address(address);
      const auto nearest = read ? symbols_.nearest_at(*read) : std::nullopt;
      error("no {} has the address `{}`{}", program_.variables[index].writes != 0 ? "operation" : "event", address,
            nearest ? fmt::format("; the nearest is `{}` at `{}`", names_.symbol(*nearest), names_.address(*nearest))
            : read  ? std::string()
                    : std::string(", which is not an address of inputs or outputs as in `%IX3.2`"));
    }
  }

  template <class... Values>
  void error(fmt::format_string<Values...> text, Values&&... values) {
    binding_.errors.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  const symplant_program& program_;
  const trace::PlantNames& names_;
  Symbols symbols_;
  const std::vector<std::string>& ignore_;
  Binding binding_;
  std::unordered_map<std::uint32_t, std::uint32_t> writers_;  ///< by leader: the variable
};

}  // namespace

Binding bind(const symplant_program& program, const trace::PlantNames& names, std::uint32_t controller,
             const std::vector<std::string>& ignore) {
  return Binder(program, names, controller, ignore).run();
}

std::vector<bool> written_symbols(const symplant_program& program, const Binding& binding,
                                  const tables::PlantTables& tables) {
  std::vector<bool> written(tables.symbols.size());
  for (std::uint32_t i = 0; i < program.count; ++i) {
    if (program.variables[i].writes != 0 && binding.symbols[i] != kNone) written[binding.symbols[i]] = true;
  }
  for (int pass = 0; pass < 2; ++pass) {  // first to the leader, then from it
    for (const tables::SharedAddress& shared : tables.shared_addresses) {
      const bool both = written[shared.symbol] || written[shared.leader];
      const auto direction = [&](std::uint32_t symbol) { return tables.symbols[symbol].direction(); };
      if (both && direction(shared.symbol) == direction(shared.leader))
        written[shared.symbol] = written[shared.leader] = true;
    }
  }
  return written;
}

std::string variable_words(const symplant_variable& variable) {
  return fmt::format("`{}`", variable.symbol != nullptr    ? variable.symbol
                             : variable.address != nullptr ? variable.address
                                                           : "");
}

}  // namespace symplant::program

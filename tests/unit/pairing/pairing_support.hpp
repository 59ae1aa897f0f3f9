// Reads and pairs a few symbols, and writes the facets as text.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "name/symbol_reader.hpp"
#include "pairing/pairing.hpp"
#include "support/catch.hpp"

namespace symplant::pairing {

inline name::SymbolRule rule_of(std::string pattern) {
  name::SymbolRule rule;
  rule.patterns.push_back({name::Source::name_then_comment, std::move(pattern)});
  return rule;
}

inline name::Naming naming_of(std::string pattern) {
  name::Naming naming;
  naming.rules.push_back(rule_of(std::move(pattern)));
  return naming;
}

/// The pairing of symbols: `Q name` is an operation, `I name` an event, `W name` an event that is not BOOL, and `1` in
/// front puts it into another controller.
class Paired {
 public:
  Paired(name::Naming naming, const std::vector<std::string>& symbols, Extent extent = Extent::linked) {
    std::vector<name::NamingFault> faults;
    compiled_ = name::CompiledNaming::compile(std::move(naming), faults);
    for (const name::NamingFault& fault : faults) UNSCOPED_INFO(fault.pointer << ": " << fault.message);
    REQUIRE(compiled_ != nullptr);
    reader_ = std::make_unique<name::SymbolReader>(compiled_);
    for (const std::string& symbol : symbols) add(symbol);
    pairing = pair(*compiled_, inputs_, extent);
  }

  /// "DEVICE.FACET: SYMBOL>STATE SYMBOL<STATE", `>` for operations, `?` behind events that make no state, `#`
  /// behind numbers, with ` | ` between facets.
  std::string facets() const {
    std::string all;
    for (const Facet& facet : pairing.facets) {
      all.append(all.empty() ? "" : " | ").append(facet.unit_path()).append(":");
      for (const Member& member : facet.members) {
        const Input& input = inputs_[member.input];
        all.append(" ")
            .append(input.name)
            .append(input.side == name::Direction::operation ? ">" : "<")
            .append(member.task);
        if (!member.makes_state) all.append("?");
      }
      for (const std::uint32_t number : facet.numbers) all.append(" ").append(inputs_[number].name).append("#");
    }
    return all;
  }

  /// The names of the symbols of one account.
  std::string of(name::Account account) const {
    std::string all;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (pairing.accounts[i] == account) all.append(all.empty() ? "" : " ").append(inputs_[i].name);
    }
    return all;
  }

  const Facet& facet(std::size_t index) const { return pairing.facets.at(index); }

  Pairing pairing;

 private:
  void add(const std::string& symbol) {
    const bool other = symbol.front() == '1';
    const std::string_view kind = std::string_view(symbol).substr(other ? 1 : 0);
    names_.push_back(std::string(kind.substr(2)));
    const name::Direction side = kind.front() == 'Q' ? name::Direction::operation : name::Direction::event;
    readings_.push_back(reader_->read({names_.back(), {}, {}, side}));
    inputs_.push_back({&readings_.back(), names_.back(), side, kind.front() != 'W', other ? 1U : 0U});
  }

  std::shared_ptr<const name::CompiledNaming> compiled_;
  std::unique_ptr<name::SymbolReader> reader_;
  std::deque<std::string> names_;
  std::deque<name::Reading> readings_;
  std::vector<Input> inputs_;
};

}  // namespace symplant::pairing

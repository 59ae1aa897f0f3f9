// Joins symbols by archetypes.
#include "pairing/archetypes.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index_table.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

/// A text of an archetype that a task matches.
struct Match {
  std::uint32_t text;  ///< index in Archetype::texts
  std::uint32_t x;     ///< index of what `{x}` is
};

/// The symbols that one archetype claims in one device for one `{x}`.
struct Claim {
  std::uint32_t device = kNone;
  std::uint32_t x = 0;
  RoleInputs roles{};
};

struct Refused {
  std::uint32_t claim;
  std::uint32_t input;
  std::uint32_t other;
};

bool by_claim(const Refused& a, const Refused& b) { return a.claim < b.claim; }

class ArchetypePairing {
 public:
  explicit ArchetypePairing(Work& work) : work_(work) {}

  void run() {
    collect_texts();
    for (std::uint32_t a = 0; a < work_.naming.archetypes.size(); ++a) {
      match_texts(a);
      claims_.clear();
      refused_.clear();
      by_key_ = base::IndexTable();
      for (std::size_t i = 0; i < candidates_.size(); ++i) claim(a, candidates_[i], text_of_[i]);
      std::stable_sort(refused_.begin(), refused_.end(), by_claim);
      for (std::uint32_t c = 0; c < claims_.size(); ++c) settle(a, claims_[c], c);
    }
  }

 private:
  /// Devices repeat their texts, so that each text is matched once.
  void collect_texts() {
    base::IndexTable by_text;
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (!work_.is_free(i)) continue;
      const std::string_view text = work_.reading(i).task->text;
      const auto next = static_cast<std::uint32_t>(texts_.size());
      const std::uint32_t index = by_text.find_or_add(text::hash_ignoring_case(text), next,
                                                      [&](std::uint32_t other) { return texts_[other] == text; });
      if (index == next) texts_.push_back(text);
      candidates_.push_back(i);
      text_of_.push_back(index);
    }
    matches_.resize(texts_.size());
  }

  void match_texts(std::uint32_t archetype) {
    for (std::vector<Match>& matches : matches_) matches.clear();
    const auto& texts = work_.naming.archetypes[archetype].texts;
    std::string x;
    for (std::uint32_t t = 0; t < texts.size(); ++t) {
      const name::ArchetypeText text(work_.compiled, archetype, t);
      for (std::size_t i = 0; i < texts_.size(); ++i) {
        if (text.matches(texts_[i], x)) matches_[i].push_back({t, index_of(x)});
      }
    }
  }

  std::uint32_t index_of(const std::string& x) {
    const auto next = static_cast<std::uint32_t>(xs_.size());
    const std::uint32_t index =
        by_x_.find_or_add(text::hash_ignoring_case(x), next, [&](std::uint32_t other) { return xs_[other] == x; });
    if (index == next) xs_.push_back(x);
    return index;
  }

  void claim(std::uint32_t archetype, std::uint32_t input, std::uint32_t text) {
    if (matches_[text].empty() || !work_.is_free(input)) return;
    const name::Archetype& of = work_.naming.archetypes[archetype];
    for (const Match& match : matches_[text]) {
      const name::ArchetypeRole role = of.texts[match.text].first;
      if (is_operation_role(role) != work_.is_operation(input)) continue;
      if (of.model == name::ArchetypeModel::constant) {
        work_.result.accounts[input] = Account::constant;
        work_.result.constant_on[input] = of.value;
        return;
      }
      const std::uint32_t index = claim_of(work_.device[input], match.x);
      std::uint32_t& taken = claims_[index].roles[static_cast<std::size_t>(role)];
      if (taken == kNone) {
        taken = input;
      } else if (taken != input) {
        refused_.push_back({index, input, taken});
      }
    }
  }

  std::uint32_t claim_of(std::uint32_t device, std::uint32_t x) {
    const auto next = static_cast<std::uint32_t>(claims_.size());
    const std::uint64_t hash = (std::uint64_t{x} << 32U | device) * 0x9E37'79B9'7F4A'7C15U;
    const std::uint32_t index = by_key_.find_or_add(
        hash, next, [&](std::uint32_t other) { return claims_[other].device == device && claims_[other].x == x; });
    if (index == next) {
      Claim& added = claims_.emplace_back();
      added.device = device;
      added.x = x;
      added.roles.fill(kNone);
    }
    return index;
  }

  /// Makes a facet of a claim with an operation and an event.
  void settle(std::uint32_t archetype, Claim& claim, std::uint32_t index) {
    bool operation = false;
    bool event = false;
    for (std::size_t r = 0; r < claim.roles.size(); ++r) {
      std::uint32_t& input = claim.roles[r];
      if (input != kNone && !work_.is_free(input)) input = kNone;  // a claim with another {x} has it
      if (input != kNone) (is_operation_role(static_cast<name::ArchetypeRole>(r)) ? operation : event) = true;
    }
    if (!operation || !event) return;
    const name::Archetype& of = work_.naming.archetypes[archetype];
    Facet facet = archetype_facet(of, claim.roles, work_.inputs);
    facet.by = FacetBy::archetype;
    facet.archetype = archetype;
    facet.name = xs_[claim.x].empty() ? of.name : of.name + "_" + text::to_upper(xs_[claim.x]);
    work_.add(std::move(facet), claim.device);
    for (const Refused& refused : refused_of(index)) {
      work_.result.remarks.push_back({Remark::Kind::role_taken, refused.input, refused.other, 0});
    }
  }

  std::span<const Refused> refused_of(std::uint32_t claim) const {
    const auto [begin, end] = std::equal_range(refused_.begin(), refused_.end(), Refused{claim, 0, 0}, by_claim);
    return {begin, end};
  }

  Work& work_;
  std::vector<std::uint32_t> candidates_;
  std::vector<std::uint32_t> text_of_;       ///< of each candidate, index in `texts_`
  std::vector<std::string_view> texts_;      ///< different ones
  std::vector<std::vector<Match>> matches_;  ///< of each text, under the archetype at hand
  std::deque<std::string> xs_;
  base::IndexTable by_x_;
  std::vector<Claim> claims_;  ///< of the archetype at hand
  base::IndexTable by_key_;
  std::vector<Refused> refused_;
};

}  // namespace

void pair_by_archetypes(Work& work) {
  if (!work.naming.archetypes.empty()) ArchetypePairing(work).run();
}

}  // namespace symplant::pairing

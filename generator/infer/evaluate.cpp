// Applies a naming rule to samples.
#include "infer/evaluate.hpp"

namespace symplant::infer {

Score score_of(const pairing::Pairing& pairing, std::span<const Sample> samples) {
  Score score;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const pairing::Account account = pairing.accounts[i];
    if (!samples[i].boolean || account == pairing::Account::ignored) continue;
    ++score.counted;
    if (account == pairing::Account::paired) ++score.paired;
    if (account <= pairing::Account::data) ++score.accounted;
  }
  return score;
}

Applied apply_rule(const std::shared_ptr<const name::CompiledNaming>& naming, std::span<const Sample> samples) {
  Applied applied;
  applied.reader = std::make_unique<name::SymbolReader>(naming);
  applied.readings.reserve(samples.size());
  std::vector<pairing::Input> inputs;
  inputs.reserve(samples.size());
  for (const Sample& sample : samples) {
    const name::RuleReading& reading = applied.readings.emplace_back(applied.reader->read(sample.text));
    inputs.push_back(
        {&reading, sample.text.name, reading.side.value_or(sample.side), sample.boolean, sample.controller});
  }
  applied.pairing = pairing::pair(*naming, inputs);
  applied.score = score_of(applied.pairing, samples);
  return applied;
}

}  // namespace symplant::infer

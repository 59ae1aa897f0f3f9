// Applies a naming rule to samples.
#include "infer/evaluate.hpp"

namespace symplant::infer {

name::Counts score_of(const pairing::Pairing& pairing, std::span<const Sample> samples) {
  name::Counts score;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].boolean) score.add(pairing.accounts[i]);
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
    const name::Reading& reading = applied.readings.emplace_back(applied.reader->read(sample.text));
    inputs.push_back(
        {&reading, sample.text.name, reading.direction.value_or(sample.side), sample.boolean, sample.controller});
  }
  applied.pairing = pairing::pair(*naming, inputs, pairing::Extent::linked);
  applied.score = score_of(applied.pairing, samples);
  return applied;
}

}  // namespace symplant::infer

// The horn: a tone of the browser, once the user has switched it on. No browser sounds before.

const kTone = 740;    // Hz
const kBeats = 1.5;   // per second: the tone is on for a half of each
const kVolume = .06;

export class Horn {
  /// `makeContext()` makes an AudioContext.
  constructor(makeContext = () => new AudioContext()) { Object.assign(this, {makeContext, context: null, sources: [], wanted: false}); }

  get isOn() { return this.context !== null; }
  get sounds() { return this.sources.length > 0; }

  /// Call it in a gesture of the user.
  switch(on) {
    if (on === this.isOn) return;
    this.end();
    if (on) this.context = this.makeContext();
    else {
      this.context.close();
      this.context = null;
    }
    this.update(this.wanted);
  }

  /// Whether there is a reason to sound.
  update(wanted) {
    this.wanted = wanted;
    if (wanted && this.isOn && !this.sounds) this.begin();
    if (!wanted) this.end();
  }

  /// A tone whose volume a second, slow oscillator switches.
  begin() {
    const {context} = this;
    const gain = context.createGain();
    gain.gain.value = kVolume;
    gain.connect(context.destination);
    const depth = context.createGain();
    depth.gain.value = kVolume;
    depth.connect(gain.gain);
    this.sources = [["triangle", kTone, gain], ["square", kBeats, depth]].map(([type, frequency, to]) => {
      const source = context.createOscillator();
      source.type = type;
      source.frequency.value = frequency;
      source.connect(to);
      source.start();
      return source;
    });
  }

  end() {
    for (const source of this.sources) source.stop();
    this.sources = [];
  }
}

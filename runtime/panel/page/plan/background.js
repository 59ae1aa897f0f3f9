// The picture behind the plan: an SVG or PNG of the folder of --panel-files.

export class Background {
  /// `open(blob)` makes the bitmap. `loaded()` is called when it has come, `failed(text)` if it cannot be shown.
  constructor(app, open, {loaded, failed}) { Object.assign(this, {app, open, loaded, failed, spec: null, file: null, image: null, asked: 0}); }

  /// `spec`: `background` of a plan, or undefined.
  show(spec) {
    this.spec = spec ?? null;
    const file = spec?.file ?? null;
    if (file === this.file) return;
    this.file = file;
    this.load();
  }

  /// Loads the picture, also again after it failed.
  async load() {
    const asked = ++this.asked;
    const {file} = this;
    this.image = null;
    this.failed("");
    if (file === null) return;
    try {
      const image = await this.open(await this.app.api.file("files/" + encodeURIComponent(file)));
      if (asked !== this.asked) return;
      this.image = image;
      this.loaded();
    } catch (error) {
      if (asked === this.asked) this.failed("The picture " + file + " is not shown: " + error.message + ".");
    }
  }

  /// What is drawn: the spec with its `image`; null without.
  shown() { return this.spec && this.image ? {...this.spec, image: this.image} : null; }
}

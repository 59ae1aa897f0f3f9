// The picture behind the plan: an SVG or PNG of the folder of --panel-files, shown as an image only.

export class Background {
  /// `loaded()` is called when a picture has come.
  constructor(app, loaded) { Object.assign(this, {app, loaded, spec: null, file: null, image: null}); }

  /// `spec`: `background` of a plan, or undefined.
  show(spec) {
    this.spec = spec ?? null;
    const file = spec?.file ?? null;
    if (file === this.file) return;
    Object.assign(this, {file, image: null});
    if (file !== null) this.load(file);
  }

  async load(file) {
    const blob = await this.app.api.file("files/" + encodeURIComponent(file)).catch(() => null);
    if (blob === null || file !== this.file) return;
    const url = URL.createObjectURL(blob);
    const image = new Image();
    image.onload = () => {
      if (file !== this.file) return URL.revokeObjectURL(url);
      this.image = image;
      this.loaded();
    };
    image.onerror = () => URL.revokeObjectURL(url);
    image.src = url;
  }

  /// What is drawn: the spec with its `image`; null without.
  shown() { return this.spec && this.image ? {...this.spec, image: this.image} : null; }
}

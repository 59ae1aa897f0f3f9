// The tiles of a station. Only tiles that can be seen are in the document, so that a station may have thousands.
import {make} from "./dom.js";
import {neighbor, placeTiles} from "./layout.js";
import {Tile} from "./tile.js";

const kWidth = 184;   // of a cell, with the gap; as in panel.css
const kHeight = 92;
const kGap = 8;
const kMargin = 200;  // pixels around what can be seen

export class TileGrid {
  /// `scroller` is the element whose scrolling shows and hides tiles.
  constructor(app, devices, label, scroller) {
    Object.assign(this, {app, devices, scroller, tiles: new Map(), dirty: new Set(), current: 0, width: 0});
    this.element = make("div", {class: "tiles", role: "group", "aria-label": label, onkeydown: (event) => this.key(event),
      onfocusin: (event) => this.focused(event)});
    this.rankOf = new Map(devices.map((device, rank) => [device, rank]));
    this.views = devices.map((device) => app.plant.devices[device].view);
    this.size = new ResizeObserver(() => this.resize());
    this.size.observe(this.element);
    this.scrolled = () => this.mount();
    scroller.addEventListener("scroll", this.scrolled, {passive: true});
  }

  close() {
    this.size.disconnect();
    this.scroller.removeEventListener("scroll", this.scrolled);
  }

  resize() {
    const width = this.element.clientWidth;
    if (width === this.width) return this.mount();
    this.width = width;
    const fits = Math.max(1, Math.floor((width + kGap) / kWidth));
    this.layout = placeTiles(this.views, fits);
    this.element.style.height = this.layout.rows * kHeight + "px";
    // Only places of plant.json may need more than there is: otherwise the grid shrinks with its frame.
    this.element.style.minWidth = this.layout.columns > fits ? this.layout.columns * kWidth - kGap + "px" : "";
    for (const [rank, tile] of this.tiles) this.move(rank, tile);
    this.mount();
    this.element.querySelector(".tile[aria-current]")?.scrollIntoView({block: "nearest", inline: "nearest"});
  }

  move(rank, tile) {
    const [x, y] = this.layout.cells[rank];
    tile.box.style.left = x * kWidth + "px";
    tile.box.style.top = y * kHeight + "px";
  }

  /// Brings tiles that can be seen into the document, and removes others; the one with the focus stays.
  mount() {
    if (!this.layout) return;
    const top = this.scroller.getBoundingClientRect().top - this.element.getBoundingClientRect().top;
    const from = top - kMargin - kHeight;
    const until = top + this.scroller.clientHeight + kMargin;
    const added = [];
    this.layout.cells.forEach(([, y], rank) => {
      const isSeen = y * kHeight > from && y * kHeight < until;
      const tile = this.tiles.get(rank);
      if (isSeen && !tile) added.push(this.make(rank).box);
      else if (!isSeen && tile && !tile.box.contains(document.activeElement) && rank !== this.current) this.remove(rank, tile);
    });
    this.element.append(...added);
    if (added.length > 0) this.app.frames.request();
  }

  make(rank) {
    const tile = new Tile(this.app, this.devices[rank]);
    this.tiles.set(rank, tile);
    this.move(rank, tile);
    tile.setTab(rank === this.current ? 0 : -1);
    tile.select(tile.device.name === this.app.selectedDevice());
    return tile;
  }

  remove(rank, tile) {
    tile.box.remove();
    this.tiles.delete(rank);
  }

  key(event) {
    if (!event.key.startsWith("Arrow") || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.focus(neighbor(this.layout.cells, this.current, event.key));
  }

  focused(event) {
    for (const [rank, tile] of this.tiles) if (tile.box.contains(event.target)) this.setCurrent(rank);
  }

  setCurrent(rank) {
    this.tiles.get(this.current)?.setTab(-1);
    this.current = rank;
    this.tiles.get(rank)?.setTab(0);
  }

  focus(rank) {
    if (!this.tiles.has(rank)) this.element.append(this.make(rank).box);
    this.setCurrent(rank);
    this.tiles.get(rank).element.focus();
  }

  /// Marks devices whose tiles must be drawn again.
  touch(device) {
    const rank = this.rankOf.get(device);
    if (rank !== undefined && this.tiles.has(rank)) this.dirty.add(rank);
  }

  /// Writes the values of a device again, and nothing else.
  touchValues(device) { this.tiles.get(this.rankOf.get(device))?.updateValues(); }

  touchAll() { for (const rank of this.tiles.keys()) this.dirty.add(rank); }

  selected() {
    const name = this.app.selectedDevice();
    for (const tile of this.tiles.values()) tile.select(tile.device.name === name);
  }

  /// Returns whether something moves.
  draw(now) {
    for (const rank of this.dirty) this.tiles.get(rank)?.update();
    this.dirty.clear();
    let again = false;
    for (const tile of this.tiles.values()) if (tile.moving) again = tile.draw(now) || again;
    return again;
  }
}

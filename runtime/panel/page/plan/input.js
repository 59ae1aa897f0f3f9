// How pointers, the wheel and keys move the plan. What a click, a drag of things or a key beyond that does is up to the view.

const kClick = 5;  // pixels that a pointer may move in a click
const kWheel = 1.0015;
const kPan = 60;   // pixels of an arrow key

const kArrows = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
const kZooms = {"+": 1, "=": 1, "-": -1};

export class PlanInput {
  /// `view` has camera, moved(), clicked(point, event), hovered(point), and may take a drag: grab(point, event) returns null or { move(point), end() }.
  constructor(element, view) {
    Object.assign(this, {element, view, pointers: new Map(), grabbed: null, far: false});
    element.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) element.addEventListener(name, (event) => this.up(event));
    element.addEventListener("keydown", (event) => this.key(event));
  }

  at(event) {
    const {left, top} = this.element.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  wheel(event) {
    event.preventDefault();
    this.view.camera.zoom(kWheel ** -(event.deltaMode === 1 ? event.deltaY * 33 : event.deltaY), this.at(event));
    this.view.moved();
  }

  down(event) {
    if (event.button !== 0) return;
    this.element.setPointerCapture(event.pointerId);
    const at = this.at(event);
    this.pointers.set(event.pointerId, at);
    if (this.pointers.size > 1) {
      this.far = true;
      return this.drop();
    }
    Object.assign(this, {start: at, far: false, grabbed: this.view.grab?.(this.view.camera.toPlan(at), event) ?? null});
  }

  /// Ends a drag of things, or a rubber band.
  drop(event) {
    const grabbed = this.grabbed;
    this.grabbed = null;
    grabbed?.end(event);
  }

  move(event) {
    const at = this.at(event);
    const last = this.pointers.get(event.pointerId);
    if (!last) return this.view.hovered(this.view.camera.toPlan(at));
    if (this.pointers.size === 2) this.pinch(event.pointerId, last, at);
    else if (Math.hypot(at[0] - this.start[0], at[1] - this.start[1]) > kClick || this.far) {
      this.far = true;
      if (this.grabbed) this.grabbed.move(this.view.camera.toPlan(at));
      else {
        this.view.camera.pan(at[0] - last[0], at[1] - last[1]);
        this.view.moved();
      }
    } else return;
    this.pointers.set(event.pointerId, at);
  }

  pinch(id, last, at) {
    const [, other] = [...this.pointers].find(([key]) => key !== id);
    const gap = (point) => Math.max(10, Math.hypot(point[0] - other[0], point[1] - other[1]));
    const middle = [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2];
    this.view.camera.zoom(gap(at) / gap(last), middle);
    this.view.camera.pan((at[0] - last[0]) / 2, (at[1] - last[1]) / 2);
    this.view.moved();
  }

  up(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.pointers.size > 0) return;
    if (!this.far && event.type === "pointerup") this.view.clicked(this.view.camera.toPlan(this.start), event);
    this.drop(event);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const {camera} = this.view;
    if (event.key in kZooms) camera.step(kZooms[event.key]);
    else if (event.key === "0") this.view.toWhole();
    else if (event.shiftKey && event.key in kArrows) camera.pan(...kArrows[event.key].map((part) => part * kPan));
    else return;
    event.preventDefault();
    this.view.moved();
  }
}

export const kPlanKeys = [["+ -", "closer, further away; also the wheel, at the pointer"], ["0", "the whole plant"], ["← → ↑ ↓", "to the next device, track or place"],
  ["Shift + ← → ↑ ↓", "move the view; also by dragging"], ["Enter", "open the details of what has the focus"]];

// Wheel, pointer and keys of the chart.

const kClick = 4;  // pixels: a shorter drag is a click

export const kChartKeys = [["+ and -", "zoom in and out"], ["← and →", "earlier and later"], ["Shift + ← and →", "move the cursor to the change before or after"],
  ["a and b", "put cursor A or B into the middle"], ["c", "remove the cursors"], ["f", "follow the plant"], ["y", "axes from min to max, or what is in view"], ["Home", "show everything that is known"]];

/// `chart` is the ChartView: zoom, pan, setCursor, stepCursor, follow, showAll.
export const listenToChart = (element, chart) => {
  let drag = null;
  const timeAt = (event) => {
    const box = element.getBoundingClientRect();
    return chart.view.from + (event.clientX - box.left) / box.width * (chart.view.to - chart.view.from);
  };
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) chart.pan((event.deltaX || event.deltaY) / 1000);
    else chart.zoom(Math.exp(event.deltaY / 400), timeAt(event));
  }, {passive: false});
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    drag = {x: event.clientX, from: chart.view.from, to: chart.view.to, moved: false};
  });
  element.addEventListener("pointermove", (event) => {
    if (!drag) return;
    const by = event.clientX - drag.x;
    drag.moved ||= Math.abs(by) > kClick;
    if (!drag.moved) return;
    const t = -by / element.getBoundingClientRect().width * (drag.to - drag.from);
    chart.setView(drag.from + t, drag.to + t);
  });
  element.addEventListener("pointerup", (event) => {
    if (drag && !drag.moved) chart.setCursor(event.shiftKey ? "B" : "A", timeAt(event));
    drag = null;
  });
  element.addEventListener("pointercancel", () => { drag = null; });
  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const middle = () => (chart.view.from + chart.view.to) / 2;
    const side = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (side !== undefined) event.shiftKey ? chart.stepCursor(side) : chart.pan(side / 10);
    else if (event.key === "+" || event.key === "=") chart.zoom(1 / 1.5, middle());
    else if (event.key === "-") chart.zoom(1.5, middle());
    else if (event.key === "a" || event.key === "b") chart.setCursor(event.key.toUpperCase(), middle());
    else if (event.key === "c") chart.clearCursors();
    else if (event.key === "f") chart.follow(true);
    else if (event.key === "y") chart.model.showWhole(!chart.model.whole);
    else if (event.key === "Home") chart.showAll();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
};

// Colors of the style sheet, for what is drawn on a canvas.

const kNames = ["back", "side", "text", "soft", "line", "accent", "belt", "ink", "on", "stop", "moving", "finding", "blocked",
  "hatch", "mark", "transfer", "waits", "stopped", "disabled", "malfunction", "moving-tint", "stopped-tint", "disabled-tint", "blocked-tint", "malfunction-tint",
  "finding-tint", "trend0", "trend1", "trend2", "trend3", "trend4", "trend5",
  "kind0", "kind1", "kind2", "kind3", "kind4", "kind5", "kind6", "kind7", "on-kind"];

/// `matches`: nothing moves that is only decoration.
export const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

let colors = null;
const listeners = new Set();

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  colors = null;
  for (const listener of listeners) listener();
});

/// theme().text is the color of texts, and so on.
export const theme = () => {
  if (colors === null) {
    const style = getComputedStyle(document.documentElement);
    colors = Object.fromEntries(kNames.map((name) => [name, style.getPropertyValue("--" + name).trim()]));
  }
  return colors;
};

/// Called when light changes to dark or back. Returns what ends it.
export const onTheme = (listener) => {
  listeners.add(listener);
  return () => listeners.delete(listener);
};

export const kFont = 'system-ui, "Segoe UI", Roboto, "Noto Sans", sans-serif';

/// Fits a canvas to a size in CSS pixels, and returns its context, scaled for the screen (`ratio` pixels for a CSS pixel). Setting a size clears it.
export const fitCanvas = (canvas, width, height, ratio = window.devicePixelRatio || 1) => {
  const wide = Math.round(width * ratio);
  const high = Math.round(height * ratio);
  if (canvas.width !== wide || canvas.height !== high) {
    canvas.width = wide;
    canvas.height = high;
    canvas.style.width = width + "px";
    canvas.style.height = height + "px";
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
};

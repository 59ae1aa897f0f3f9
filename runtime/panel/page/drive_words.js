// The drives of a track in words. Without elements.
import {speed as speedText} from "./words.js";

/// "runs forward, 0.5 m/s", of a speed in micrometers per second.
export const driveText = (speed) => speed === 0 ? "stopped" : "runs " + (speed > 0 ? "forward" : "backward") + ", " + speedText(Math.abs(speed));

const mark = (speed, short) => speed === 0 ? (short ? "■" : "■ stopped") : (speed > 0 ? "→ " : "← ") + speedText(Math.abs(speed));

/// All drives of a track in a few letters: "→ 0.5 m/s", or one after the other if they differ; `short` without words.
export const drivesText = (speeds, short = false) => {
  const shown = speeds.every((speed) => speed === speeds[0]) ? speeds.slice(0, 1) : speeds;
  return shown.map((speed) => mark(speed, short)).join(" | ");
};

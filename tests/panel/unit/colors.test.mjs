// Colors of lines and of kinds of parts: contrast, and distances for readers who see colors differently. Drives in words.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";
import {bandText} from "../../../runtime/panel/page/band.js";
import {drivesText, driveText} from "../../../runtime/panel/page/drive_words.js";
import {kindColor, kKindColors} from "../../../runtime/panel/page/kinds.js";

const css = readFileSync(new URL("../../../runtime/panel/page/panel.css", import.meta.url), "utf8");
const [light, dark] = [css.slice(0, css.indexOf("@media")), css.slice(css.indexOf("@media"))];
const colorOf = (name, scheme) => scheme.match(new RegExp("--" + name + ": (#[0-9a-f]{6})"))?.[1] ?? light.match(new RegExp("--" + name + ": (#[0-9a-f]{6})"))[1];

const linear = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255).map((part) => part <= .04045 ? part / 12.92 : ((part + .055) / 1.055) ** 2.4);
const times = (matrix, color) => matrix.map((row) => row.reduce((sum, factor, i) => sum + factor * color[i], 0));
const luminance = (hex) => linear(hex).reduce((sum, part, i) => sum + part * [.2126, .7152, .0722][i], 0);
const contrast = (a, b) => {
  const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (high + .05) / (low + .05);
};
/// Machado, Oliveira and Fernandes 2009, severity 1: how a color looks to readers with each kind of color blindness.
const kSights = {
  normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[.152286, 1.052583, -.204868], [.114503, .786281, .099216], [-.003882, -.048116, 1.051998]],
  deuteranopia: [[.367322, .860646, -.227968], [.280085, .672501, .047413], [-.01182, .04294, .968881]],
  tritanopia: [[1.255528, -.076749, -.178779], [-.078411, .930809, .147602], [.004733, .691367, .3039]],
};
/// CIE L*a*b* of linear sRGB.
const lab = (color) => {
  const [x, y, z] = times([[.4124, .3576, .1805], [.2126, .7152, .0722], [.0193, .1192, .9505]], color.map((part) => Math.min(1, Math.max(0, part))))
    .map((part, i) => part / [.9505, 1, 1.089][i]).map((part) => part > .008856 ? Math.cbrt(part) : 7.787 * part + 16 / 116);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
};
const assertDistances = (colors, least) => {
  for (const [sight, matrix] of Object.entries(kSights)) {
    const seen = colors.map((hex) => lab(times(matrix, linear(hex))));
    seen.forEach((a, i) => seen.slice(0, i).forEach((b, k) => {
      const distance = Math.hypot(...a.map((part, at) => part - b[at]));
      assert.ok(distance >= least, colors[k] + " and " + colors[i] + " have the distance " + distance.toFixed(1) + " with " + sight);
    }));
  }
};

for (const [scheme, text] of [["light", light], ["dark", dark]]) {
  test("The colors of lines can be told apart in the " + scheme + " scheme, by all readers", () => {
    const colors = Array.from({length: 6}, (_, i) => colorOf("trend" + i, text));
    for (const color of colors) for (const back of ["back", "side"]) assert.ok(contrast(color, colorOf(back, text)) >= 3, color + " on " + back);
    assertDistances(colors, 20);
  });

  test("Names on the colors of kinds can be read in the " + scheme + " scheme, and the colors can be told apart by all readers", () => {
    const colors = Array.from({length: kKindColors}, (_, i) => colorOf(kindColor(i), text));
    for (const color of colors) assert.ok(contrast(color, colorOf("on-kind", text)) >= 4.5, color);
    assertDistances(colors, 14);
  });
}

test("A kind keeps its color, and the ninth has that of the first", () => assert.deepEqual([0, 3, 7, 8].map(kindColor), ["kind0", "kind3", "kind7", "kind0"]));

test("Drives are in words and in a few letters, with direction and speed", () => {
  assert.deepEqual([0, 5e5, -2e5].map(driveText), ["stopped", "runs forward, 0.5 m/s", "runs backward, 0.2 m/s"]);
  assert.deepEqual([[5e5], [5e5, 5e5], [5e5, 0], [-2e5], []].map((speeds) => drivesText(speeds)), ["→ 0.5 m/s", "→ 0.5 m/s", "→ 0.5 m/s | ■ stopped", "← 0.2 m/s", ""]);
  assert.deepEqual([[0], [5e5, 0]].map((speeds) => drivesText(speeds, true)), ["■", "→ 0.5 m/s | ■"]);
});

test("The band says why plant time does not pass, and nothing while it does", () => {
  assert.deepEqual([bandText("running", false, "0:00:01.0"), bandText("frozen", false, "0:00:01.0"), bandText("ended", false, "0:00:01.0"), bandText("running", true, "0:00:01.0")],
    ["", "FROZEN at 0:00:01.0", "ENDED at 0:00:01.0", "NO CONNECTION, the state of 0:00:01.0"]);
});

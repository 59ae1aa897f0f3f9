// Pointer and keys of the 3D view. OrbitControls has the drags and the wheel.

const kClick = 4;  // pixels: a longer drag turns the camera

export const kView3dKeys = [["arrow keys", "move along the floor"], ["Shift + arrow keys", "turn"], ["+ and -", "nearer and farther"], ["0", "everything"],
  ["[ and ]", "to the previous, to the next device"], ["Enter", "open its details"], ["t", "see through housings"]];

/// What a screen reader says of the picture.
export const kView3dLabel = "The plant in 3D. " + kView3dKeys.map(([key, act]) => key + ": " + act).join("; ") + ".";

const kSteps = {"[": -1, "]": 1};
const kSides = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

/// `scene` is the View3dScene.
export const listenToScene = (canvas, scene) => {
  let from = null;
  canvas.addEventListener("pointerdown", ({button, clientX, clientY}) => { from = button === 0 ? [clientX, clientY] : null; });
  canvas.addEventListener("pointerup", ({clientX, clientY}) => {
    if (from && Math.hypot(clientX - from[0], clientY - from[1]) < kClick) scene.pick(clientX, clientY);
    from = null;
  });
  canvas.addEventListener("keydown", (event) => {
    const isBracket = event.key in kSteps;  // with AltGr on some keyboards
    if (!isBracket && (event.ctrlKey || event.altKey || event.metaKey)) return;
    const side = kSides[event.key];
    if (side) event.shiftKey ? scene.stage.turn(side[0] * 10, side[1] * 10) : scene.stage.pan(side[0] / 10, side[1] / 10);
    else if (event.key === "+" || event.key === "=") scene.stage.zoom(1 / 1.25);
    else if (event.key === "-") scene.stage.zoom(1.25);
    else if (isBracket) scene.step(kSteps[event.key]);
    else if (event.key === "Enter") scene.openFocused();
    else if (event.key === "0") scene.goTo("");
    else if (event.key === "t") scene.setTranslucent(!scene.isTranslucent);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
};

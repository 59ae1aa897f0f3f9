// Plant time between two events of the stream.
import assert from "node:assert/strict";
import {test} from "node:test";
import {PlantClock} from "../../../runtime/panel/page/time.js";

const running = (speed = 1) => ({state: "running", speed, real_speed: speed});
const clockAt = () => {
  const wall = {ms: 0};
  return [new PlantClock(() => wall.ms), wall];
};

test("A running plant's time goes on at its real speed, a frozen one's does not", () => {
  const [clock, wall] = clockAt();
  clock.set(1e9, running(2));
  wall.ms = 100;
  assert.equal(clock.now(), 1.2e9);
  clock.set(1.2e9, {state: "frozen", speed: 2, real_speed: 2});
  wall.ms = 500;
  assert.equal(clock.now(), 1.2e9);
  assert.equal(clock.runs, false);
});

test("A slower speed counts at once, although the measured one is still that of before", () => {
  const [clock, wall] = clockAt();
  clock.set(1e9, {state: "running", speed: 0.5, real_speed: 100});
  wall.ms = 100;
  assert.equal(clock.now(), 1.05e9);
});

test("Without events plant time stops after a while", () => {
  const [clock, wall] = clockAt();
  clock.set(0, running());
  wall.ms = 60000;
  assert.equal(clock.now(), 1.5e9);
});

test("A late event does not set the shown time back at once", () => {
  const [clock, wall] = clockAt();
  clock.set(0, running());
  wall.ms = 60;
  clock.set(4e7, running());
  assert.equal(clock.now(), 6e7);
  wall.ms = 460;
  assert.equal(clock.now(), 4.4e8);
});

test("A restored plant's time jumps", () => {
  const [clock, wall] = clockAt();
  clock.set(9e9, running());
  wall.ms = 10;
  clock.set(8.95e9, running(), true);
  assert.equal(clock.now(), 8.95e9);
});

// Where a device is during a move. A move that is diverted to another state goes on from where it was shown, not from the state that it left. Pure
// functions, without elements; a pose is whatever `mix(a, b, part)` can mix: a number, or positions and angles.

const kMostSteps = 8;

/// How much of the move on a path is done; a path begins at `begun`, which is what was done when it was taken.
const doneOn = (path, done) => !path ? done : path.begun < 1 ? Math.max(0, (done - path.begun) / (1 - path.begun)) : 1;

/// The path of a device's move after an event: { start, steps: [[target, part]], begun }; null if the move began in its state. `path` is the one before, `before`
/// and `after` are { state, target, done }, both at the time of the event.
export const pathAfter = (path, before, after) => {
  const wasBetween = before.target >= 0 && before.target !== before.state && before.done < 1;
  if (!wasBetween || after.target < 0 || after.target === after.state) return null;
  const isSame = after.state === before.state;
  if (isSame && after.target === before.target) return path;
  if (!isSame && (after.state !== before.target || after.target !== before.state)) return null;
  const steps = [...path?.steps ?? [], [before.target, doneOn(path, before.done)]];
  const start = steps.length > kMostSteps ? steps.shift()[0] : path?.start ?? before.state;
  return {start, steps, begun: after.done};
};

/// The pose of a device at plant time `now`. `poseOf(state)`: that of a state; `mix(a, b, part)`: what is between two poses.
export const poseAt = (store, index, now, poseOf, mix) => {
  const [state, target] = [store.state[index], store.target[index]];
  if (target < 0 || target === state) return poseOf(state);
  const path = store.paths[index];
  let pose = poseOf(path ? path.start : state);
  for (const [to, part] of path?.steps ?? []) pose = mix(pose, poseOf(to), part);
  return mix(pose, poseOf(target), doneOn(path, store.progress(index, now).done));
};

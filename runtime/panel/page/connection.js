// Keeps a stream of the plant open, and reports if it is lost.
import {EventReader} from "./events.js";

const kSilence = 6000;  // ms: the stream sends an event each second
const kMostWait = 4000;

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/// Reads one stream until it ends, or `abort` is aborted. `receive(event, data)` gets each event with the text of its data.
/// Returns whether it was given up because nothing came.
const readStream = async (api, receive, abort) => {
  let silent = false;
  const giveUp = () => {
    silent = true;
    abort.abort();
  };
  let watch = setTimeout(giveUp, kSilence);
  const body = (await api.stream(abort.signal)).pipeThrough(new TextDecoderStream()).getReader();
  const reader = new EventReader();
  try {
    for (;;) {
      const {value, done} = await body.read();
      if (done) return false;
      clearTimeout(watch);
      watch = setTimeout(giveUp, kSilence);
      for (const {event, data} of reader.read(value)) receive(event, data);
    }
  } catch (error) {
    if (silent) return true;
    throw error;
  } finally {
    clearTimeout(watch);
  }
};

/// Returns only after another run answered, or `ended`, an AbortSignal, is aborted. `report(state, text)`: "open", "lost" with
/// what is wrong, or "restarted" if another run answers.
export const keepStream = async (api, receive, report, ended = null) => {
  let wait = 250;
  while (!ended?.aborted) {
    let wrong = "the connection to the plant is lost";
    const abort = new AbortController();
    ended?.addEventListener("abort", () => abort.abort(), {signal: abort.signal});
    try {
      const silent = await readStream(api, (event, data) => {
        wait = 250;
        report("open", "");
        receive(event, data);
      }, abort);
      if (silent) continue;  // reported only if the plant does not answer again
    } catch (error) {
      if (error.status) wrong = error.message;
    } finally {
      abort.abort();
    }
    if (ended?.aborted) return;
    report("lost", wrong);
    await pause(wait);
    wait = Math.min(2 * wait, kMostWait);
    const plant = await api.plant().catch(() => null);
    if (plant && plant.run !== api.run) {
      report("restarted", "");
      return;
    }
  }
};

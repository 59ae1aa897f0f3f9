// Keeps the stream of the plant open, and reports if it is lost.
import {EventReader} from "./events.js";

const kSilence = 6000;  // ms: the stream sends an event each second
const kMostWait = 4000;

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/// Reads one stream until it ends. `receive(event, data)` gets each event with its parsed data.
const readStream = async (api, receive) => {
  const abort = new AbortController();
  let watch = setTimeout(() => abort.abort(), kSilence);
  const body = (await api.stream(abort.signal)).pipeThrough(new TextDecoderStream()).getReader();
  const reader = new EventReader();
  try {
    for (;;) {
      const {value, done} = await body.read();
      if (done) return;
      clearTimeout(watch);
      watch = setTimeout(() => abort.abort(), kSilence);
      for (const {event, data} of reader.read(value)) receive(event, JSON.parse(data));
    }
  } finally {
    clearTimeout(watch);
    abort.abort();
  }
};

/// Never returns. `report(state, text)`: "open", "lost" with what is wrong, or "restarted" if another run answers.
export const keepStream = async (api, receive, report) => {
  let wait = 250;
  for (;;) {
    let wrong = "the connection to the plant is lost";
    try {
      await readStream(api, (event, data) => {
        wait = 250;
        report("open", "");
        receive(event, data);
      });
    } catch (error) {
      if (error.status) wrong = error.message;
    }
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

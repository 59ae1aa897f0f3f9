// How a tab gets the state of the plant: over the stream that all tabs of the browser share, or over one for this tab alone.
import {keepStream} from "./connection.js";

const kSilence = 6000;  // ms: the worker sends a report each 2 s

/// Joins the shared stream until its worker fails or is silent. Resolves to whether it ever sent something.
const followShared = (api, receive, report) => new Promise((done) => {
  const worker = new SharedWorker(new URL("./stream_worker.js", import.meta.url), {type: "module", name: api.run});
  const {port} = worker;
  const listening = new AbortController();
  let heard = false;
  let watch = null;
  const leave = () => {
    clearTimeout(watch);
    port.postMessage({leave: true});
  };
  const end = () => {
    leave();
    port.close();
    listening.abort();
    done(heard);
  };
  const watchOn = () => {
    clearTimeout(watch);
    watch = setTimeout(end, kSilence);
  };
  worker.onerror = end;
  port.onmessage = ({data}) => {
    heard = true;
    watchOn();
    port.postMessage({read: true});
    if (data.report) report(...data.report);
    else receive(data.event, data.data);
  };
  addEventListener("pagehide", leave, {signal: listening.signal});
  addEventListener("pageshow", ({persisted}) => { if (persisted) end(); }, {signal: listening.signal});
  port.postMessage({join: {token: api.token, run: api.run}});
  watchOn();
});

/// `receive` and `report` as for keepStream().
export const followPlant = async (api, receive, report) => {
  let isShared = "SharedWorker" in globalThis;
  while (isShared) isShared = await followShared(api, receive, report);
  await keepStream(api, receive, report);
};

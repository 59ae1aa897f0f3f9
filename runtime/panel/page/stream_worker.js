// The shared worker of the tabs of one run: its name is the run, so that tabs of another run have another worker.
import {Api} from "./api.js";
import {SharedStreams} from "./shared_streams.js";

const streams = new SharedStreams(({token, run}) => Object.assign(new Api(token), {run}));

globalThis.onconnect = ({ports: [port]}) => streams.connect(port);

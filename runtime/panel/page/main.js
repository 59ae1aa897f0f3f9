// Starts the page: reads the description of the plant, makes the views, and keeps them up to date.
import {perform, refreshActs} from "./acts.js";
import {AlarmBanner} from "./alarm_banner.js";
import {Announcer} from "./announce.js";
import {Api} from "./api.js";
import {Band} from "./band.js";
import {ChartModel} from "./chart_model.js";
import {ControlBar} from "./control.js";
import {Details} from "./details.js";
import {askToken} from "./dialog.js";
import {make} from "./dom.js";
import {ExerciseStrip} from "./exercise_strip.js";
import {followPlant} from "./follow_plant.js";
import {Frames} from "./frames.js";
import {refreshHolds} from "./hold_button.js";
import {Holds} from "./holds.js";
import {LayoutState} from "./plan/layout_state.js";
import {MessageBand} from "./message_band.js";
import {Names} from "./names.js";
import {Notice} from "./notice.js";
import {Player, RecordingBar} from "./recording.js";
import {mayOperate, operates, rightsOf} from "./rights.js";
import {Router} from "./router.js";
import {ScenarioLine} from "./scenario_line.js";
import {makeSearch} from "./search.js";
import {Shortcuts} from "./shortcuts.js";
import {Statuses} from "./status.js";
import {Store} from "./store.js";
import {PlantClock} from "./time.js";
import {followLinks, keepToken, takeToken} from "./token.js";
import {joinAgain, keptName} from "./trainee_name.js";
import {makeViews, Views} from "./views.js";

const kTick = 200;  // ms between two updates of texts that depend on plant time
const kRestarted = "The plant was restarted. This page shows the new run.";
const kDenied = "The token of this page is not valid: open the link that symplant printed, or enter its token.";

const byId = (id) => document.getElementById(id);
const notice = new Notice(byId("notice"));

const enterToken = async () => {
  const token = await askToken("symplant printed a link when it started. Enter that link, or its part after #token=.");
  if (!token) return;
  keepToken(token);
  location.reload();
};
const denied = (text) => notice.show("token", text, false, {label: "Enter the token", run: enterToken});

/// What a description need not have.
const kDefaults = {stations: [], devices: [], symbols: [], locations: [], transfers: [], part_kinds: [], requirements: [], values: [], malfunctions: [], ordinary: {},
  exercises: [], links: [], programs: [], begin: 0, end: 0};

/// The description, as soon as the plant answers.
const loadPlant = async (api) => {
  for (;;) {
    try {
      const plant = await api.plant();
      notice.show("lost", "");
      return {...kDefaults, ...plant};
    } catch (error) {
      if (error.status === 401) {
        denied("This panel needs a token to be seen: open the link that symplant printed.");
        await new Promise(() => {});
      }
      notice.show("lost", error.message + "; the page tries again");
      await new Promise((done) => setTimeout(done, 1000));
    }
  }
};

/// `rights`: see rights.js. `canAct`: everything; `may(kind, name)`: whether the page may operate a thing.
const makeApp = (api, plant, rights) => {
  const app = {api, plant, rights, canAct: rights === "all", may: (kind, index) => mayOperate(app, kind, index), lost: false, store: new Store(plant), names: new Names(plant), clock: new PlantClock(), frames: new Frames(),
    main: byId("main"), deniedText: kDenied, deniedNote: () => "Only shows: there is no valid token."};
  app.statuses = new Statuses(app.store, app.names);
  app.router = new Router((route) => app.routed(route));
  app.selectedDevice = () => {
    const selection = app.router.selection();
    return selection?.kind === "device" ? selection.name : null;
  };
  app.chart = new ChartModel(app);
  app.layout = new LayoutState(app);
  app.holds = new Holds(app, notice, sessionStorage);
  app.holds.changed = refreshHolds;
  app.holds.listen(window);
  return app;
};

/// Shows a found station, device, symbol ..., and gives it the focus: so keys of one letter act again.
const choose = (app, {kind, name}) => {
  const before = location.hash;
  const isStation = kind === "station";
  if (isStation) app.router.view("plan", {station: name});
  else app.router.select(kind, name);
  const focus = () => document.querySelector(isStation ? "#main .board" : "#details h2")?.focus();
  if (location.hash === before) focus();
  else addEventListener("hashchange", focus, {once: true});
};

const makeKeys = (app, bar, search, views) => new Shortcuts([
  ["/", "search", () => search.input.focus()],
  ["Escape", "close the details", () => app.router.deselect()],
  ...views.keys.slice(0, 9).map((key, i) => [String(i + 1), "view " + views.title(key), () => app.router.view(key)]),
  ...(app.canAct || app.player ? [["p", app.player ? "play and pause" : "run and freeze", () => bar.toggle()]] : []),
  ...(app.canAct ? [["s", "one cycle", () => perform(app, bar.result, () => ({step: "cycle"}))],
    ["n", "to the next change", () => perform(app, bar.result, () => ({step: "change"}))]] : [])]);

/// What each event of the stream leads to.
const makeReceiver = (app, parts) => {
  app.store.listen((change) => {
    app.clock.set(app.store.t, app.store.clock, change.jumped);
    app.layout.change(change);
    const statusChanged = app.statuses.update(change);
    if (change.all || change.keys.has("allowed")) refreshActs();
    for (const part of parts) part.change?.(change, statusChanged);
    parts[0].update();
    app.frames.request();
  });
  return (event, data) => {
    if (event === "picture") app.store.picture(data);
    if (event === "changes") app.store.changes(data);
    if (document.body.dataset.ready !== "1") performance.mark("first picture");
    document.body.dataset.ready = "1";
  };
};

/// `parts` have texts that depend on plant time.
const animate = (app, bar, parts, views) => {
  let last = 0;
  app.frames.add(() => {
    const now = app.clock.now();
    const wall = performance.now();
    bar.tick();
    if (wall - last > kTick) {
      last = wall;
      for (const part of parts) part.tick();
    }
    const plays = app.player?.frame(wall) ?? false;
    return views.frame(now) || plays || app.clock.runs;
  });
};

const connect = (app, plant, bar, band) => {
  if (app.player) return app.player.seek(plant.begin);
  app.api.stale = () => Notice.reload(kRestarted);
  const receive = (event, text) => {
    const data = JSON.parse(text);
    app.api.clock.hear(data, event === "picture");
    app.receive(event, data);
  };
  followPlant(app.api, receive, (state, text) => {
    document.body.dataset.connection = state;
    if (state === "restarted") return Notice.reload(kRestarted);
    if (app.lost !== (state === "lost")) {
      app.lost = state === "lost";
      bar.update();
      band.update();
      refreshActs();
      if (app.lost) app.holds.disconnected();
      else app.holds.connected();
    }
    notice.show("lost", state === "open" ? "" : text + "; the page shows the state of then and tries again");
  });
};

const start = async () => {
  followLinks();
  const api = new Api(takeToken());
  const plant = await loadPlant(api);
  Object.assign(api, {run: plant.run, name: keptName()});
  document.title = plant.plant + " - symplant";
  const rights = await rightsOf(api, plant);
  const app = makeApp(api, plant, rights);
  if (rights === "denied") denied(kDenied);
  if (plant.mode === "recording") app.player = new Player(app);
  const bar = app.player ? new RecordingBar(app, app.player) : new ControlBar(app);
  const search = makeSearch(app, {label: "Search", choose: (found) => choose(app, found)});
  const details = new Details(app, byId("details"));
  const views = new Views(app, makeViews(app), byId("views"));
  byId("title").append(make("h1", {class: "name", title: plant.plant}, plant.plant), search, make("span", {class: "grow"}), ...[bar.marks].filter(Boolean));
  const scenario = new ScenarioLine(app);
  const strip = new ExerciseStrip(app);
  const alarms = app.player ? [] : [new AlarmBanner(app)];
  byId("bar").append(bar.element, scenario.element, strip.element, ...alarms.map(({element}) => element));
  const band = new Band(app, bar.result);
  if (!app.player) byId("band").append(band.element);
  const announcer = new Announcer(app, byId("footer"), byId("live"));
  const messages = new MessageBand(app);
  byId("notice").after(messages.element);
  app.receive = makeReceiver(app, [bar, band, scenario, strip, ...alarms, views, details, announcer, messages]);
  app.routed = (route) => {
    views.show(route);
    details.show(app.router.selection());
  };
  const keys = makeKeys(app, bar, search, views);
  byId("help").addEventListener("click", () => keys.help());
  byId("skip").addEventListener("click", () => app.main.focus());
  app.router.read();
  animate(app, bar, [details, strip, views], views);
  connect(app, plant, bar, band);
  joinAgain(app);
  if (operates(app)) app.holds.recover();
  globalThis.symplant = app;  // for tests and the console
};

start();

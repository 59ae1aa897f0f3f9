// Shows the model of the JSON in #data: a tree of devices, and the device that the address names. A user's texts become
// text nodes and attributes only, by functions of the DOM.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const main = document.getElementById("main");
  const tree = document.getElementById("tree");
  const search = document.getElementById("search");
  const count = document.getElementById("count");
  const mostFound = 200;
  const [NAME, ROW, LIST, DIRECTION, TYPE, ADDRESS, IEC, INITIAL, UNIT, WHY, LEADER] = Array(11).keys();
  const locations = data.material ? data.material.locations : [];
  const values = data.values ? data.values.list : [];
  const unitOfPath = new Map(data.units.map((unit, index) => [unit.path, index]));

  // Elements: make("p", {class: "x"}, "text", otherElement)
  const fill = (element, attributes, children) => {
    for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
    element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
    return element;
  };
  const make = (name, attributes, ...children) => fill(document.createElement(name), attributes, children);
  const draw = (name, attributes, ...children) =>
    fill(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
  const code = (text) => make("code", {}, text);
  const lines = (items) => items.map((item) => make("div", {}, item));
  const table = (heads, rows) => make("div", {class: "wide"}, make("table", {},
    heads ? make("thead", {}, make("tr", {}, heads.map((head) => make("th", {scope: "col"}, head)))) : null,
    make("tbody", {}, rows.map((row) => make("tr", {}, row.map((cell, i) =>
      make(i === 0 && !heads ? "th" : "td", i === 0 && !heads ? {scope: "row"} : {}, cell)))))));
  const section = (title, ...content) => [make("h2", {}, title), ...content];
  const deviceLink = (path) => unitOfPath.has(path)
    ? make("a", {href: "#d" + unitOfPath.get(path), class: "code"}, path) : code(path);

  // The tree: lines, their processes, their devices. The content of a branch is made when it is first opened.
  const lineMap = new Map();
  data.units.forEach((unit, index) => {
    if (!lineMap.has(unit.line)) lineMap.set(unit.line, new Map());
    const processes = lineMap.get(unit.line);
    if (!processes.has(unit.process)) processes.set(unit.process, []);
    processes.get(unit.process).push(index);
  });
  const treeLink = (index, text) => make("a", {href: "#d" + index}, text);
  const branch = (title, size, makeContent) => {
    const element = make("details", {}, make("summary", {}, title, " ", make("span", {class: "soft"}, String(size))));
    element.fillNow = () => {
      if (element.filled) return;
      element.filled = true;
      element.append(...makeContent());
    };
    element.addEventListener("toggle", () => { if (element.open) element.fillNow(); });
    return element;
  };
  const branches = new Map();
  const processBranch = (line, process, indices) => {
    const made = branch(process, indices.length,
      () => indices.map((index) => treeLink(index, data.units[index].device)));
    branches.set(line + "\n" + process, made);
    return made;
  };
  const lineBranch = (line, processes) => {
    let size = 0;
    for (const indices of processes.values()) size += indices.length;
    const made = branch(line, size, () => [...processes].map(([process, indices]) => processBranch(line, process, indices)));
    branches.set(line, made);
    return made;
  };
  const showTree = () => {
    branches.clear();
    tree.replaceChildren(...[...lineMap].map(([line, processes]) => lineBranch(line, processes)));
    count.textContent = data.units.length + " devices, " + data.symbols.length + " I/O symbols";
    markCurrent(true);
  };
  const markCurrent = (open) => {
    const index = currentDevice();
    if (open && index !== null && !search.value) {
      const unit = data.units[index];
      for (const key of [unit.line, unit.line + "\n" + unit.process]) {
        const made = branches.get(key);
        if (!made) continue;
        made.fillNow();
        made.open = true;
      }
    }
    for (const link of tree.querySelectorAll("a[aria-current]")) link.removeAttribute("aria-current");
    const link = index === null ? null : tree.querySelector('a[href="#d' + index + '"]');
    if (link) {
      link.setAttribute("aria-current", "page");
      if (open) link.scrollIntoView({block: "nearest"});
    }
  };

  const showFound = (wanted) => {
    const found = [];
    const fits = (text) => text.toLowerCase().includes(wanted);
    const rows = [];
    data.units.forEach((unit, index) => { if (fits(unit.path)) rows.push(["#d" + index, unit.path]); });
    locations.forEach(({name, shapes}, index) => {
      if (fits(name) || shapes.some(([shape, , , , text]) => shape === "text" && fits(text))) rows.push(["#m" + index, name]);
    });
    values.forEach(([name, , text], index) => { if (fits(name) || fits(text)) rows.push(["#v" + index, name]); });
    for (const symbol of data.symbols) {
      if (fits(symbol[NAME]) || fits(symbol[ADDRESS]) || fits(symbol[IEC])) {
        rows.push([symbol[UNIT] < 0 ? "#none" : "#d" + symbol[UNIT], symbol[NAME] + "  " + (symbol[ADDRESS] || symbol[IEC])]);
      }
    }
    for (const [href, text] of rows.slice(0, mostFound)) found.push(make("a", {href}, text));
    tree.replaceChildren(...found);
    count.textContent = rows.length > mostFound ? "the first " + mostFound + " of " + rows.length + " found"
                                                : rows.length + " found";
    markCurrent(false);
  };
  search.addEventListener("input", () => {
    const wanted = search.value.trim().toLowerCase();
    if (wanted) showFound(wanted); else showTree();
  });

  // The chart of a device: the layout of its kind, and its initial state.
  const drawText = (x, y, text, name) => draw("text", {x, y, class: name || ""}, text);
  const arrowHead = () => draw("defs", {}, draw("marker", {id: "head", viewBox: "0 0 8 8", refX: 8, refY: 4,
    markerUnits: "userSpaceOnUse", markerWidth: 8, markerHeight: 8, orient: "auto"}, draw("path", {class: "head", d: "M0 0L8 4L0 8z"})));
  const drawChart = (unit, kind) => {
    const layout = data.layouts[kind.layout];
    const svg = draw("svg", {width: layout.width, height: layout.height, role: "img",
      viewBox: "0 0 " + layout.width + " " + layout.height, "aria-label": "state chart of " + unit.path}, arrowHead());
    kind.edges.forEach(([from, , automatic], i) => {
      const [x0, y0, x1, y1, x2, y2] = layout.arrows[i];
      svg.append(draw("path", {class: automatic ? "way automatic" : "way", "marker-end": "url(#head)",
        d: "M" + x0 + " " + y0 + "Q" + x1 + " " + y1 + " " + x2 + " " + y2}));
      if (from < 0) svg.append(draw("circle", {class: "dot", cx: x0, cy: y0, r: 3}));
    });
    kind.edges.forEach(([, , , label], i) => {
      const [x, y, width] = layout.arrows[i].slice(6);
      const height = label.length * 14;
      const group = draw("g", {}, draw("rect", {class: "label", x: x - width / 2, y: y - height / 2, width, height}));
      label.forEach((line, n) => group.append(drawText(x, y - height / 2 + 11 + n * 14, line)));
      const named = label.join(" ").match(/\[c\d+\]/g) || [];
      const conditions = named.map((name) => name.slice(1, -1) + ": " + unit.conditions[Number(name.slice(2, -1)) - 1]);
      if (conditions.length) group.append(draw("title", {}, conditions.join("\n")));
      svg.append(group);
    });
    kind.states.forEach(([name, symbols], s) => {
      const [x, y] = layout.states[s];
      const left = x - layout.box[0] / 2;
      const top = y - layout.box[1] / 2;
      if (s === unit.initial) {
        svg.append(draw("circle", {class: "dot", cx: left + 14, cy: top - 18, r: 5}), draw("path", {class: "way",
          "marker-end": "url(#head)", d: "M" + (left + 14) + " " + (top - 18) + "V" + top}));
      }
      svg.append(draw("rect", {class: s === kind.rest && kind.actuation === "spring" ? "state rest" : "state", x: left,
        y: top, width: layout.box[0], height: layout.box[1], rx: 7}));
      svg.append(drawText(x, symbols ? y - 3 : y + 4, name, "name"));
      if (symbols) svg.append(drawText(x, y + 12, symbols));
    });
    return make("div", {class: "wide"}, svg);
  };

  const place = (symbol) => data.lists[symbol[LIST]] + ":" + symbol[ROW];
  const signalRow = (element, index, task) => {
    const symbol = data.symbols[index];
    return [element, code(symbol[NAME]), symbol[DIRECTION] ? "event" : "operation", task, code(symbol[ADDRESS] || "-"),
      code(symbol[IEC] || "-"), data.types[symbol[TYPE]], symbol[INITIAL] || "-", place(symbol)
        + (symbol[LEADER] ? ", follows " + symbol[LEADER] : "")];
  };
  const wayText = (kind, [from, to, on, when, after, takes, once, origin, during, numbers]) =>
    "(" + kind.states[from][0] + ", " + on + ") → " + kind.states[to][0] + (when ? ", when c" + when : "")
      + (after ? ", " + after : "") + (takes ? ", " + takes : "") + (during ? ", while c" + during : "")
      + (numbers ? ", " + numbers : "") + "  [" + origin + "]";
  const outputs = (kind, side) => kind[side].flatMap((events, s) => events.length
    ? [kind.states[s][0] + ": " + events.map(([event, on]) => "I_" + kind.events[event] + (on ? " on" : " off")).join(", ")]
    : []);
  const orNone = (items, otherwise) => items.length ? lines(items) : make("span", {class: "soft"}, otherwise || "none");

  const showDevice = (index) => {
    const unit = data.units[index];
    const kind = data.kinds[unit.kind];
    const symbolName = (i) => data.symbols[i][NAME];
    const content = [make("h1", {}, unit.path), make("p", {}, make("b", {}, kind.actuation), ", starts in ",
      make("b", {}, kind.states[unit.initial][0]), " (" + unit.why + ")",
      kind.actuation === "spring" ? ", returns to " + kind.states[kind.rest][0] : "",
      unit.type ? ", class " + unit.type : "")];
    for (const sentence of kind.inferences) content.push(make("p", {class: "soft"}, "Inferred: " + sentence + "."));
    content.push(drawChart(unit, kind));
    content.push(section("Signals", table(["", "symbol", "direction", "task", "address", "IEC", "type", "initial", "row"], [
      ...unit.operations.map((i, n) => signalRow("I", i, kind.operations[n])),
      ...unit.events.map((i, n) => signalRow("O", i, kind.events[n])),
      ...(unit.values || []).map((i) => signalRow("", i, "value")),
    ])));
    const disables = (unit.disables || []).map(([state, path]) => [kind.states[state][0] + ": ", deviceLink(path)]);
    content.push(section("The eight elements", table(null, [
      ["I", orNone(unit.operations.map(symbolName))],
      ["O", orNone(unit.events.map(symbolName))],
      ["S", lines(kind.states.map(([name, symbols]) => name + (symbols ? ": " + symbols : ": no symbol")))],
      ["d_int", orNone(kind.internal.map((way) => wayText(kind, way)))],
      ["d_ext", orNone(kind.external.map((way) => wayText(kind, way)))],
      ["l_enter", orNone(outputs(kind, "enter"), "nothing")],
      ["l_leave", orNone(outputs(kind, "leave"), "nothing")],
      ["l_disable", orNone(disables)],
    ].map(([name, cell]) => [code(name), cell]))));
    if (unit.disabledBy) {
      content.push(section("Disabled by", lines(unit.disabledBy.map(([path, state]) => [deviceLink(path), " in " + state]))));
    }
    if (unit.conditions) {
      content.push(section("Conditions", table(null, unit.conditions.map((text, i) => ["c" + (i + 1), code(text)]))));
    }
    if (unit.behaviour) {
      content.push(section("Custom behavior", make("p", {}, "The class ", code(unit.behaviour), "."),
        unit.inputs.length ? table(["input", "condition"], unit.inputs.map(([name, text]) => [name, code(text)])) : null));
    }
    if (unit.requirements) {
      content.push(section("Requirements that name it", requirementTable(unit.requirements.map((i) => data.requirements[i]))));
    }
    return content;
  };

  const requirementTable = (rows) => table(["name", "must hold"], rows.map(([name, text]) => [name, code(text)]));
  const showRequirements = () => [make("h1", {}, "Requirements"), data.requirements.length
    ? requirementTable(data.requirements) : make("p", {}, "The description has no requirements.")];

  const showMalfunctions = () => [make("h1", {}, "Malfunctions"),
    table(["name", "what it does"], data.malfunctions.map(([name, text]) => [name, code(text)]))];

  const showNone = () => {
    const rows = data.symbols.filter((symbol) => symbol[UNIT] < 0);
    return [make("h1", {}, "Symbols in no device"), make("p", {}, "They are nevertheless in the images, on the links and in traces."),
      rows.length ? table(["symbol", "direction", "address", "IEC", "type", "row", "why"], rows.map((symbol) => [
        code(symbol[NAME]), symbol[DIRECTION] ? "event" : "operation", code(symbol[ADDRESS] || "-"),
        code(symbol[IEC] || "-"), data.types[symbol[TYPE]], place(symbol), data.reasons[symbol[WHY]]]))
        : make("p", {}, "There are no such symbols.")];
  };

  // The material flow: tracks to scale and places, drawn as shapes, and lists.
  const drawShape = ([shape, style, x, y, a, b]) => {
    if (shape === "rect") return draw("rect", {class: style, x, y, width: a, height: b});
    if (shape === "line") return draw("path", {class: style, d: "M" + x + " " + y + "L" + a + " " + b});
    if (shape === "dot") return draw("circle", {class: style, cx: x, cy: y, r: a});
    return drawText(x, y, a, style);
  };
  const drawLocation = ({title, width, height, shapes}, index) => [make("h2", {id: "drawing" + index}, title),
    make("div", {class: "wide"}, draw("svg", {width, height, role: "img", viewBox: "0 0 " + width + " " + height,
      "aria-label": title}, shapes.map(drawShape)))];
  const locationLink = (text) => {
    const index = locations.findIndex((shown) => shown.name === text.split("@")[0]);
    return index < 0 ? code(text) : make("a", {href: "#m" + index, class: "code"}, text);
  };
  const materialHeads = {
    transfers: ["name", "from", "to", "when", "moves"],
    work: ["name", "at", "from", "to", "when"],
    sources: ["name", "at", "kinds", "first", "every", "when", "at most"],
  };
  const linked = {transfers: ["from", "to"], work: ["at"], sources: ["at"]};
  const materialList = (key) => key === "kinds" ? lines(data.material.kinds.map(code)) : table(materialHeads[key],
    data.material[key].map((row) => row.map((text, i) => {
      const head = materialHeads[key][i];
      return linked[key].includes(head) ? locationLink(text) : head === "when" && text ? code(text) : text;
    })));
  const showMaterial = () => [make("h1", {}, "Material flow"),
    locations.map(drawLocation),
    [["Kinds of parts", "kinds"], ["Transfers", "transfers"], ["Work", "work"], ["Sources", "sources"]].map(([title, key]) =>
      data.material[key].length ? section(title, materialList(key)) : null)];

  // The signal flow: values, what they read, what reads them. The value chosen and its arrows are marked.
  const drawFlow = (chosen) => {
    const {width, height, boxes, arrows} = data.values;
    const isChosen = (box) => chosen !== null && boxes[box][7] === chosen;
    const svg = draw("svg", {width, height, role: "group", viewBox: "0 0 " + width + " " + height,
      "aria-label": "signal flow of the values"}, arrowHead());
    const drawArrow = ([, , inCondition, path], marked) => svg.append(draw("path", {class: "way"
      + (inCondition ? " automatic" : "") + (marked ? " chosen" : ""), d: path, "marker-end": "url(#head)"}));
    const marked = ([from, to]) => isChosen(from) || isChosen(to);
    arrows.filter((arrow) => !marked(arrow)).forEach((arrow) => drawArrow(arrow, false));
    arrows.filter(marked).forEach((arrow) => drawArrow(arrow, true));
    boxes.forEach(([x, y, width, height, style, texts, whole, value, unit], index) => {
      const href = value >= 0 ? "#v" + value : unit >= 0 ? "#d" + unit : "";
      const attributes = isChosen(index) ? {class: "chosen", id: "chosen"} : {};
      if (href) attributes.href = href;
      svg.append(draw(href ? "a" : "g", attributes, whole.length ? draw("title", {}, whole.join("\n")) : null,
        draw("rect", {class: style, x, y, width, height, rx: style === "flow-value" ? 2 : 12}),
        texts.map((text, n) => drawText(x + 10, y + 16 + 14 * n, text, n ? "start" : "name start"))));
    });
    return make("div", {class: "wide"}, svg);
  };
  const showValues = (chosen) => [make("h1", {}, "Values"),
    make("p", {class: "soft"}, "At the left is what formulas read, at the right what reads values. A dashed arrow: only conditions read it."),
    drawFlow(chosen),
    values.length ? section("Values", table(["name", "unit", "what it is"], values.map(([name, unit, text], index) =>
      [make("a", {href: "#v" + index, class: "code"}, name), unit, code(text)]))) : null,
    data.values.signals.length ? section("Signals", table(["symbol", "shows"],
      data.values.signals.map(([symbol, text]) => [code(symbol), code(text)]))) : null];

  const showAbout = () => [make("h1", {}, data.plant),
    table(null, [
      ["devices", String(data.units.length)], ["I/O symbols", String(data.symbols.length)],
      ["in no device", make("a", {href: "#none"}, String(data.symbols.filter((symbol) => symbol[UNIT] < 0).length))],
      ["requirements", make("a", {href: "#requirements"}, String(data.requirements.length))],
      ...(data.material ? [["tracks and places", make("a", {href: "#material"}, String(locations.length))]] : []),
      ...(data.values ? [["values", make("a", {href: "#values"}, String(values.length))]] : []),
      ...(data.malfunctions ? [["malfunctions", make("a", {href: "#malfunctions"}, String(data.malfunctions.length))]] : []),
      ["symbol lists", data.lists.join(", ")], ["model hash", code(data.hash)],
      ...data.internal.map(([reason, rows]) => ["rows: " + reason, String(rows)]),
    ]),
    section("How to read it", lines([
      "Choose a device at the left, or search: / moves to the search box, the arrow keys move through the tree.",
      "In a chart a dot marks the initial state, a thick border the rest state of a spring, a dashed arrow an automatic transition. An arrow from a dot outside means a transition from every other state. [c1] is condition c1 of the device.",
      "I are the commands from the PLC (operations), O is the feedback to it (events).",
    ])),
    section("What this page cannot show", lines([
      "It is a view, not the model. Commands are levels, not edges. What a moving device does when commands change depends on the actuation. An automatic transition disarms the command that led there. Of several transitions that are ready, the first in the table fires. See the manual page of the model.",
    ]))];

  const currentDevice = () => {
    const match = /^#d(\d+)$/.exec(location.hash);
    return match && Number(match[1]) < data.units.length ? Number(match[1]) : null;
  };
  const currentLocation = () => {
    const match = /^#m(\d+)$/.exec(location.hash);
    return match && Number(match[1]) < locations.length ? Number(match[1]) : null;
  };
  const currentValue = () => {
    const match = /^#v(\d+)$/.exec(location.hash);
    return match && Number(match[1]) < values.length ? Number(match[1]) : null;
  };
  const pages = {"#requirements": showRequirements, "#none": showNone, "#about": showAbout};
  if (data.material) {
    pages["#material"] = showMaterial;
    document.getElementById("parts").hidden = false;
  }
  if (data.values) {
    pages["#values"] = () => showValues(null);
    document.getElementById("numbers").hidden = false;
  }
  if (data.malfunctions) {
    pages["#malfunctions"] = showMalfunctions;
    document.getElementById("faults").hidden = false;
  }
  const show = () => {
    if (location.hash === "#main") return;
    const index = currentDevice();
    const shown = currentLocation();
    const value = currentValue();
    const content = index !== null ? showDevice(index) : shown !== null ? showMaterial()
      : value !== null ? showValues(value) : (pages[location.hash] || showAbout)();
    main.replaceChildren(...content.flat(Infinity).filter((child) => child !== null));
    main.scrollTop = 0;
    if (shown !== null) document.getElementById("drawing" + shown).scrollIntoView();
    if (value !== null) document.getElementById("chosen").scrollIntoView({block: "center", inline: "center"});
    document.title = (index !== null ? data.units[index].path + " - " : "") + data.plant;
    markCurrent(true);
  };
  addEventListener("hashchange", show);
  addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== search) {
      event.preventDefault();
      search.focus();
    }
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    const stops = [search, ...tree.querySelectorAll("summary, a")].filter((stop) => stop.offsetParent !== null);
    const at = stops.indexOf(document.activeElement);
    if (at < 0) return;
    event.preventDefault();
    stops[Math.min(stops.length - 1, Math.max(0, at + (event.key === "ArrowDown" ? 1 : -1)))].focus();
  });
  document.getElementById("plant").textContent = data.plant;
  showTree();
  show();
  if (currentDevice() === null && lineMap.size === 1) tree.querySelector("details").open = true;
})();

// Reads server-sent events from pieces of text.

export class EventReader {
  constructor() {
    this.rest = "";
    this.event = "";
    this.data = [];
  }

  /// The events that are complete with this piece, as { event, data }. A piece may end anywhere, also within a line.
  read(piece) {
    const events = [];
    const lines = (this.rest + piece).split("\n");
    this.rest = lines.pop();
    for (const line of lines) this.readLine(line.endsWith("\r") ? line.slice(0, -1) : line, events);
    return events;
  }

  readLine(line, events) {
    if (line === "") {
      if (this.data.length > 0) events.push({event: this.event || "message", data: this.data.join("\n")});
      this.event = "";
      this.data = [];
      return;
    }
    const colon = line.indexOf(":");
    if (colon === 0) return;  // a comment
    const field = colon < 0 ? line : line.slice(0, colon);
    const begin = colon < 0 ? line.length : colon + (line[colon + 1] === " " ? 2 : 1);
    if (field === "event") this.event = line.slice(begin);
    if (field === "data") this.data.push(line.slice(begin));
  }
}

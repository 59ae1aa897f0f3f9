// The requests of the panel's interface, docs/panel-interface.md.

const kTokenKey = "symplant token";

/// An answer that is not 200, or none: `status` is then 0.
export class ApiError extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

/// The token of the link that opened the page, or of an earlier page in this tab. Removes it from the address bar.
export const takeToken = () => {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const token = fragment.get("token");
  if (token !== null) {
    fragment.delete("token");
    const rest = fragment.toString();
    history.replaceState(null, "", location.pathname + location.search + (rest ? "#" + rest : ""));
    keepToken(token);
  }
  return sessionStorage.getItem(kTokenKey);
};

export const keepToken = (token) => sessionStorage.setItem(kTokenKey, token);

export class Api {
  constructor(token) {
    this.token = token;
    this.run = null;  // the `run` of the description, once it is known
    this.stale = () => {};  // called when the answer is that the program was restarted
  }

  headers(more = {}) {
    return this.token ? {Authorization: "Bearer " + this.token, ...more} : more;
  }

  async request(path, options = {}) {
    let response;
    try {
      response = await fetch(path, {cache: "no-store", ...options, headers: this.headers(options.headers)});
    } catch (error) {
      if (error.name === "AbortError") throw error;
      throw new ApiError(0, "the plant does not answer");
    }
    if (response.ok) return response;
    const answer = await response.json().catch(() => ({}));
    if (response.status === 409) this.stale();
    throw new ApiError(response.status, answer.error ?? "the answer is " + response.status);
  }

  async get(path, signal) {
    const response = await this.request("/api/v1/" + path, {signal});
    return response.json();
  }

  async post(path, body) {
    const response = await this.request("/api/v1/" + path, {method: "POST", body: JSON.stringify(body),
      headers: {"Content-Type": "application/json", "X-Symplant-Run": this.run ?? ""}});
    return response.json();
  }

  /// Acts that take effect in one instant; the answer is { t }.
  acts(...acts) { return this.post("acts", {acts}); }
  /// Whether the token may act: rejected with the status 401 if not.
  check(...acts) { return this.post("check", {acts}); }

  plant() { return this.get("plant"); }
  why(name, signal) { return this.get("why?name=" + encodeURIComponent(name), signal); }
  at(t) { return this.get("at?t=" + Math.round(t)); }

  async session(kind) {
    const response = await this.request("/api/v1/session/" + kind);
    return response.blob();
  }

  /// The body of the stream.
  async stream(signal) {
    const response = await this.request("/api/v1/stream", {signal, headers: {Accept: "text/event-stream"}});
    return response.body;
  }
}

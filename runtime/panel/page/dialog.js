// Questions and help in dialogs.
import {button, make} from "./dom.js";

/// Asks before an act that loses something. Resolves to whether the user agrees.
export const ask = (title, texts, yes) => new Promise((done) => {
  const dialog = make("dialog", {"aria-labelledby": "dialog-title"});
  const close = (agreed) => {
    done(agreed);
    dialog.close();
    dialog.remove();
  };
  dialog.append(make("h2", {id: "dialog-title"}, title), ...texts.map((text) => make("p", {}, text)),
    make("div", {class: "row end"}, button("Cancel", () => close(false)), button(yes, () => close(true), {class: "primary"})));
  dialog.addEventListener("cancel", () => close(false));
  document.body.append(dialog);
  dialog.showModal();
});

/// Shows what has no room on the page. A link in it closes it.
export const tell = (title, content) => {
  const dialog = make("dialog", {"aria-labelledby": "dialog-title"});
  const close = () => {
    dialog.close();
    dialog.remove();
  };
  dialog.append(make("h2", {id: "dialog-title"}, title), ...content, make("div", {class: "row end"}, button("Close", close, {class: "primary"})));
  dialog.addEventListener("click", ({target}) => { if (target.closest("a")) close(); });
  dialog.addEventListener("cancel", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
};

/// Asks for the token of the link. Resolves to its text, or null.
export const askToken = (text) => new Promise((done) => {
  const input = make("input", {type: "text", "aria-label": "Token, or the whole link", size: 40, autocomplete: "off", spellcheck: "false"});
  const dialog = make("dialog", {"aria-labelledby": "dialog-title"});
  const close = (token) => {
    done(token);
    dialog.close();
    dialog.remove();
  };
  const form = make("form", {onsubmit: (event) => {
    event.preventDefault();
    close(input.value.trim().replace(/^.*token=/, "").replace(/&.*$/, "") || null);
  }}, make("h2", {id: "dialog-title"}, "Token"), make("p", {}, text), input,
    make("div", {class: "row end"}, button("Cancel", () => close(null)), make("button", {type: "submit", class: "primary"}, "Use it")));
  dialog.append(form);
  dialog.addEventListener("cancel", () => close(null));
  document.body.append(dialog);
  dialog.showModal();
});

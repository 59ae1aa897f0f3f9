// The token of the link that opened the page. It is kept for this tab, and leaves the address bar as soon as it is read.

const kKey = "symplant token";

const prefixed = (mark, query) => query.toString() ? mark + query : "";

/// Takes the token out of the address; null if there is none.
const takeFromAddress = () => {
  const search = new URLSearchParams(location.search);
  const fragment = new URLSearchParams(location.hash.slice(1));
  const token = fragment.get("token") ?? search.get("token");
  if (token === null) return null;
  for (const part of [search, fragment]) part.delete("token");
  history.replaceState(null, "", location.pathname + prefixed("?", search) + prefixed("#", fragment));
  return token;
};

export const keepToken = (token) => sessionStorage.setItem(kKey, token);

/// The token of the link, or of an earlier page in this tab; null if there is none.
export const takeToken = () => {
  const token = takeFromAddress();
  if (token !== null) keepToken(token);
  return sessionStorage.getItem(kKey);
};

/// A link that is pasted into the address bar of this page changes only the fragment. The page then begins again with its
/// token, and with the run that answers now. To be called before others listen to the fragment.
export const followLinks = () => addEventListener("hashchange", (event) => {
  const token = takeFromAddress();
  if (token === null) return;
  event.stopImmediatePropagation();
  keepToken(token);
  location.reload();
});

// What the page may do: by the role of its link, and by what an exercise allows a trainee.

const kRights = {trainer: "all", trainee: "allowed"};

/// "all": a trainer. "allowed": a trainee, who operates what the exercise allows. "none": the page only shows. "denied": it
/// only shows, since its token is not valid, or it has none.
export const rightsOf = async (api, plant) => {
  if (!plant.acts || plant.mode !== "live") return "none";
  if (!api.token) return "denied";
  try {
    await api.check({run: true});
    return "all";
  } catch (error) {
    if (error.status === 401) return "denied";
    if (error.status === 403) return plant.role === "trainee" ? "allowed" : "none";
  }
  return kRights[plant.role] ?? "none";  // too many requests, or no answer
};

/// Whether the page shows malfunctions: a trainer's, and a recording.
export const seesMalfunctions = ({plant}) => plant.mode === "recording" || plant.role === "trainer";

/// Whether the page may operate anything: what exactly, `app.may` says, and an exercise may change it.
export const operates = (app) => app.canAct || app.rights === "allowed";

const kNothing = [];
const sets = new WeakMap();  // by list of indexes
const setOf = (list = kNothing) => {
  if (!sets.has(list)) sets.set(list, new Set(list));
  return sets.get(list);
};

/// Whether the page may set or put by hand: `kind` is symbols, devices, values or locations.
export const mayOperate = (app, kind, index) => app.canAct || (app.rights === "allowed" && setOf(app.store.allowed?.[kind]).has(index));

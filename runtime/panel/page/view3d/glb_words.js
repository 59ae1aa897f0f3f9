// Words and small checks that all checks of a GLB file share.

export const refuse = (text) => { throw new Error(text); };

/// 12,345
export const whole = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, ",");

export const isIndex = (value, end) => Number.isInteger(value) && value >= 0 && value < end;

/// The list of this key of a glTF file: objects, at most `most`.
export const listOf = (json, key, most) => {
  const list = json[key] ?? [];
  if (!Array.isArray(list)) refuse("its `" + key + "` are not a list");
  if (list.length > most) refuse("it has " + whole(list.length) + " " + key + ", and " + whole(most) + " are possible");
  if (list.some((each) => typeof each !== "object" || each === null || Array.isArray(each))) refuse("its `" + key + "` are not all objects");
  return list;
};

/// An index of another list, or absent.
export const checkIndex = (value, list, what) => {
  if (value !== undefined && !isIndex(value, list.length)) refuse(what + " names " + JSON.stringify(value) + " of " + whole(list.length));
};

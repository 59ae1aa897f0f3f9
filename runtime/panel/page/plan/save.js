// Saves an edited layout. Without elements.

const kMeanwhile = /^another layout was saved meanwhile/;

/// `revision`: the one on which the plan is based. Resolves to { file }, or to { error, revision }: `error` is the one of the server, `revision` the one that a second
/// attempt replaces.
export const savePlan = async ({api, layout}, plan, revision) => {
  try {
    const {file} = await api.saveLayout(plan, revision);
    await layout.load();
    return {file};
  } catch (error) {
    if (!kMeanwhile.test(error.message)) return {error, revision};
    await layout.load();
    return {error, revision: layout.revision};
  }
};

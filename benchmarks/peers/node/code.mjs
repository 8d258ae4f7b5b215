// Guards and actions of a behaviour as functions, with nothing in them but what they say.

/** A function that says whether a guard holds. */
export function guardFunction(guard, bb) {
  const condition = guard.map(([flag, wanted]) => `${there(flag)}${wanted ? "" : "!"}bb.${flag}`).join(" && ");
  return new Function("bb", `return () => ${condition};`)(bb);
}

/** What asks first whether a message is there, for a member of one. */
function there(flag) {
  const [message, member] = flag.split(".");
  return member === undefined ? "" : `bb.${message} !== null && `;
}

/** A function that does actions. */
export function actionFunction(actions, bb) {
  const statements = actions.map(([kind, name, value]) => (kind === "count" ? `bb.${name} += 1;` : `bb.${name} = ${value};`));
  return new Function("bb", `return () => { ${statements.join(" ")} };`)(bb);
}

/** A page on which scripts may make elements of which nobody looks at anything. */

export const element = () => ({ setAttribute() {}, appendChild() {}, replaceChildren() {} });

globalThis.document = {
  documentElement: { dataset: {}, lang: "en" },
  createElement: element,
  createTextNode: element,
};
globalThis.location = new URL("https://example.org/");

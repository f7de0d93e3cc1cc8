/** What a lecturer can do about a score that has not arrived. */

/** Which advice fits a stable code. @param {{ problem: string, dead: boolean }} entry */
export function adviceFor({ problem, dead }) {
  if (problem === "line_item_gone") return "column";
  if (problem === "http_404") return "gone";
  if (["http_401", "http_403", "token_refused"].includes(problem)) return "forbidden";
  if (/^http_4(?!08|25|29)/.test(problem)) return "refused";
  return dead ? "silent" : "busy";
}

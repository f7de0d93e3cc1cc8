/** Times of the service in the browser's fields, which know neither a zone nor which of two hours is meant when clocks are put back. */

/** A time as the service writes it, as the browser's field takes it. @param {string | null | undefined} text */
export function local(text) {
  if (!text) return "";
  const time = new Date(text);
  const written = new Date(time.getTime() - time.getTimezoneOffset() * 60000).toISOString();
  return written.slice(0, time.getSeconds() ? 19 : 16);
}

/**
 * What a field says, as the service takes it; if nobody has changed it, the time that it was made from.
 * @param {string} value @param {string | null | undefined} before
 */
export function instant(value, before) {
  if (!value) return null;
  return before && value === local(before) ? before : new Date(value).toISOString();
}

/** What a platform keeps for this tool where cookies are blocked (LTI Platform Storage 0.1, by postMessage). */

const PATIENCE = 2000;

/** @typedef {{frame: string, origin: string}} Place the frame that answers, and the only origin it may have */

/** @param {Place} place @param {string} key @param {string} value */
export function storeAt(place, key, value) {
  return ask(place, { subject: "lti.put_data", key, value });
}

/** @param {Place} place @param {string} key @returns {Promise<string>} */
export async function readFrom(place, key) {
  const { value } = await ask(place, { subject: "lti.get_data", key });
  return String(value ?? "");
}

/**
 * @param {Place} place @param {Record<string, string>} message
 * @returns {Promise<any>} the answer
 */
function ask({ frame, origin }, message) {
  const id = crypto.randomUUID();
  const host = window.opener ?? window.parent;
  let target = host;
  try {
    if (frame !== "_parent") target = host.frames[/** @type {any} */ (frame)] ?? host;
  } catch {
    target = host;
  }
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => done(reject, new Error("no answer")), PATIENCE);
    /** @param {(value: any) => void} settle @param {any} value */
    function done(settle, value) {
      clearTimeout(timer);
      window.removeEventListener("message", hear);
      settle(value);
    }
    /** @param {MessageEvent} event */
    function hear(event) {
      if (event.origin !== origin || event.data?.message_id !== id) return;
      if (event.data.subject !== `${message.subject}.response`) return;
      if (event.data.error) done(reject, new Error(String(event.data.error.code)));
      else done(resolve, event.data);
    }
    window.addEventListener("message", hear);
    target.postMessage({ ...message, message_id: id }, origin);
  });
}

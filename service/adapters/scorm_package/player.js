/**
 * Connects an exercise in a frame with the LMS that holds this package (SCORM 1.2 or 2004).
 *
 * The LMS's data model stays in this page; the exercise is told the learner's seed and earlier answer, and tells its
 * verdicts. Messages are taken from the exercise's origin and frame alone. What a browser reports can be forged by
 * the person who holds it: the receipt, signed by the service, cannot.
 */
(() => {
  "use strict";
  const settings = JSON.parse(document.getElementById("settings").textContent);
  const service = new URL(settings.url).origin;
  const frame = document.getElementById("exercise");
  const started = Date.now();
  const lms = findLms();

  const NAMES = {
    1.2: {
      learner: "cmi.core.student_id",
      entry: "cmi.core.entry",
      exit: "cmi.core.exit",
      time: "cmi.core.session_time",
      score: "cmi.core.score",
      receipt: "cmi.comments",
      suspendLimit: 4096,
    },
    2004: {
      learner: "cmi.learner_id",
      entry: "cmi.entry",
      exit: "cmi.exit",
      time: "cmi.session_time",
      score: "cmi.score",
      receipt: "cmi.comments_from_learner.0.comment",
      suspendLimit: 64000,
    },
  }[lms ? lms.version : 1.2];

  /** The LMS's adapter: in a window above this one, or in the one that opened it. */
  function findLms() {
    for (const start of [window, window.opener]) {
      let above = start;
      for (let level = 0; above && level < 10; level += 1) {
        const found = adapterOf(above);
        if (found) return found;
        if (above.parent === above) break;
        above = above.parent;
      }
    }
    return null;
  }

  function adapterOf(holder) {
    try {
      if (settings.version === "2004" && holder.API_1484_11) {
        const api = holder.API_1484_11;
        return {
          version: 2004,
          start: () => api.Initialize(""),
          get: (name) => api.GetValue(name),
          set: (name, value) => api.SetValue(name, String(value)),
          commit: () => api.Commit(""),
          end: () => api.Terminate(""),
        };
      }
      if (settings.version === "1.2" && holder.API) {
        const api = holder.API;
        return {
          version: 1.2,
          start: () => api.LMSInitialize(""),
          get: (name) => api.LMSGetValue(name),
          set: (name, value) => api.LMSSetValue(name, String(value)),
          commit: () => api.LMSCommit(""),
          end: () => api.LMSFinish(""),
        };
      }
    } catch {
      // A window of another origin: not the LMS's.
    }
    return null;
  }

  /** What the learner's values are drawn from: no LMS hands on more of the learner than this digest. */
  async function seedOf(learner) {
    if (!settings.per_student || !learner) return "";
    const text = `${settings.salt}:${learner}`;
    if (!crypto.subtle) return `s${fold(text)}`;
    const digest = await crypto.subtle.digest("SHA-256", new TextEncoder().encode(text));
    return [...new Uint8Array(digest)].slice(0, 12).map((byte) => byte.toString(16).padStart(2, "0")).join("");
  }

  /** FNV-1a, for pages without a secure context, where a digest is not to be had. */
  function fold(text) {
    let hash = 0x811c9dc5;
    for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
    return hash.toString(16).padStart(8, "0");
  }

  let restored = null;
  let best = null;
  let pending = null;

  async function run() {
    document.getElementById("no-lms").hidden = lms !== null;
    if (lms) {
      lms.start();
      best = number(lms.get(`${NAMES.score}.raw`));
      restored = parsed(lms.get("cmi.suspend_data"));
      lms.set(NAMES.exit, "suspend");
      if (lms.version === 1.2 && ["", "not attempted"].includes(lms.get("cmi.core.lesson_status"))) {
        lms.set("cmi.core.lesson_status", "incomplete");
      }
      if (lms.version === 2004 && ["", "unknown", "not attempted"].includes(lms.get("cmi.completion_status"))) {
        lms.set("cmi.completion_status", "incomplete");
      }
      lms.commit();
    }
    const seed = await seedOf(lms ? lms.get(NAMES.learner) : "");
    const url = new URL(settings.url);
    if (seed) url.searchParams.set("seed", seed);
    window.addEventListener("message", hear);
    window.addEventListener("pagehide", leave);
    frame.src = url.href;
  }

  function hear(event) {
    if (event.origin !== service || event.source !== frame.contentWindow || !event.data) return;
    const message = event.data;
    if (message.subject === "framewise.ready") {
      frame.contentWindow.postMessage({ subject: "framewise.restore", state: restored }, service);
    } else if (message.subject === "framewise.draft") {
      pending = message.state ?? null;
      save();
    } else if (message.subject === "framewise.verdict") {
      pending = message.state ?? null;
      take(message);
    }
  }

  /** The best verdict counts: a student who goes on trying loses nothing. */
  function take({ points, max_points: most, complete, receipt }) {
    if (!lms || ![points, most].every(Number.isFinite) || !(points >= 0 && most >= points && most > 0)) return;
    const percent = Math.round(1e4 * (points / most)) / 100;
    save();
    if (best === null || percent >= best) {
      best = percent;
      lms.set(`${NAMES.score}.min`, 0);
      lms.set(`${NAMES.score}.max`, 100);
      lms.set(`${NAMES.score}.raw`, percent);
      const passed = points >= settings.pass * most - 1e-9;
      if (lms.version === 2004) {
        lms.set("cmi.score.scaled", Math.round(1e4 * (points / most)) / 1e4);
        lms.set("cmi.success_status", passed ? "passed" : "failed");
        lms.set("cmi.completion_status", complete ? "completed" : "incomplete");
      } else {
        lms.set("cmi.core.lesson_status", passed ? "passed" : complete ? "failed" : "incomplete");
      }
      if (receipt && typeof receipt === "string") lms.set(NAMES.receipt, receipt);
    }
    clock();
    lms.commit();
  }

  function save() {
    if (!lms || pending === null) return;
    for (const state of [pending, { table: pending.table }]) {
      const text = written(state);
      if (text.length <= NAMES.suspendLimit) {
        lms.set("cmi.suspend_data", text);
        return;
      }
    }
  }

  /** A state as JSON; "" of what has none. */
  function written(state) {
    try {
      return JSON.stringify(state) ?? "";
    } catch {
      return "";
    }
  }

  function leave() {
    if (!lms) return;
    save();
    clock();
    lms.commit();
    lms.end();
  }

  /** The session's time, as each version writes it. */
  function clock() {
    const seconds = Math.floor((Date.now() - started) / 1000);
    const [h, m, s] = [Math.floor(seconds / 3600), Math.floor((seconds % 3600) / 60), seconds % 60];
    const two = (value) => String(value).padStart(2, "0");
    lms.set(NAMES.time, lms.version === 2004 ? `PT${h}H${m}M${s}S` : `${String(h).padStart(4, "0")}:${two(m)}:${two(s)}`);
  }

  function number(text) {
    const value = parseFloat(text);
    return Number.isFinite(value) ? value : null;
  }

  function parsed(text) {
    try {
      return JSON.parse(text);
    } catch {
      return null;
    }
  }

  run();
})();

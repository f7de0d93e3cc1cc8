/** Where an exercise goes: a folder, the service's store, a SCORM package, a course, a link; and where one comes from. */

import { copyText } from "../clipboard.js";
import { Problem } from "../api.js";
import { announce, el, fill, VERBATIM } from "../dom.js";
import { language, t } from "../i18n.js";
import { pageAddress, root } from "../page.js";
import { problemNotice } from "../problem.js";
import { saveFile } from "../save-file.js";
import { linkTo } from "./draft-store.js";
import { field, refill, textField } from "./fields.js";

/** @param {import("../api.js").Api} api @param {import("./draft-store.js").DraftStore} store */
export function takeAlong(api, store) {
  const name = el("div", {});
  const told = el("div", { class: "stack", role: "status" });
  const choice = new URLSearchParams(location.hash.slice(1)).get("choice");

  const open = document.getElementById("author")?.dataset.publishing;
  const publishes = open === "anyone" || (open === "staff" && Boolean(choice ?? api.token));

  /** @param {() => Promise<any>} work */
  const attempt = (work) => async () => {
    try {
      fill(told, await work());
    } catch (error) {
      fill(told, problemNotice(error));
    }
  };

  const download = attempt(async () => {
    saveFile(await api.file("author/folder.zip", { draft: store.draft }), `${store.draft?.id}.zip`);
    return el("p", { text: t("author-downloaded") });
  });

  const publish = attempt(async () => {
    const { id } = await api.post("author/publish", { draft: store.draft, ...(choice ? { choice } : {}) });
    return publishedView(id, choice);
  });

  const share = attempt(async () => {
    const address = await linkTo(location.href, { draft: store.draft, source: store.source });
    history.replaceState(history.state, "", address);
    const text = t((await copyText(address)) ? "author-link-copied" : "form-copy-failed");
    announce(text);
    return el("p", { text });
  });

  const button = (/** @type {string} */ id, /** @type {any} */ onclick, /** @type {string} */ kind = "") =>
    el("button", { type: "button", class: kind, onclick, text: t(id) });
  const actions = el(
    "div",
    { class: "row" },
    button("author-download", download, "primary"),
    publishes ? button("author-publish", publish) : null,
    button("author-link", share),
  );
  const element = el(
    "div",
    { class: "stack" },
    name,
    actions,
    publishes ? null : el("p", { class: "hint", text: t("author-publish-closed") }),
    told,
  );
  return {
    element,
    fill: () => refill(name, textField(store, t("author-id"), ["id"], { ...VERBATIM, maxlength: "48" })),
    show: () => undefined,
  };
}

/**
 * A field that opens a folder as it was downloaded; it is there before there is a draft.
 * @param {import("../api.js").Api} api @param {import("./draft-store.js").DraftStore} store @param {() => void} opened
 */
export function folderField(api, store, opened) {
  const told = el("div", { role: "status" });
  const file = el("input", {
    type: "file",
    accept: ".zip,application/zip",
    onchange: async (event) => {
      const [archive] = event.target.files;
      if (!archive) return;
      try {
        store.load((await imported(api, archive)).draft, null);
        opened();
        fill(told, el("p", { text: t("author-imported") }));
      } catch (error) {
        fill(told, problemNotice(error, { placeOf: placeInFolder }));
      }
      event.target.value = "";
    },
  });
  return el("div", { class: "stack" }, field(t("author-import"), file, t("author-import-hint")), told);
}

/** The file of a folder, and the key in it, that a fault of the draft concerns. @param {string} pointer */
function placeInFolder(pointer) {
  const [, draft, file, ...keys] = pointer.split("/");
  if (draft !== "draft") return "";
  if (file === "statements") return keys.length ? `statement.${keys[0]}.md` : "";
  return file === "definition" ? ["exercise.toml", keys.join(".")].filter(Boolean).join(", ") : "";
}

/** @param {string} id @param {string | null} choice the code of a platform that asked for a link */
function publishedView(id, choice) {
  const scorm = (/** @type {string} */ version) =>
    el("a", {
      href: `${root}api/v1/exercises/${id}/scorm.zip?version=${version}&lang=${language}`,
      text: `SCORM ${version}`,
    });
  const insert = choice ? `${root}lti/choose?lang=${language}#choice=${encodeURIComponent(choice)}&exercise=${id}` : "";
  return el(
    "div",
    { class: "stack author-published" },
    el("p", { class: "notice notice-good", text: t("author-published") }),
    el(
      "p",
      {},
      el("a", { href: pageAddress(`exercises/${id}`), text: t("author-open") }),
      " · ",
      scorm("1.2"),
      " · ",
      scorm("2004"),
    ),
    insert ? el("p", {}, el("a", { class: "button primary", href: insert, text: t("author-insert") })) : null,
    el("p", { class: "hint", text: t("author-lti-hint") }),
    el("p", {}, el("code", { text: `exercise=${id}` })),
  );
}

/** What a folder holds. @param {import("../api.js").Api} api @param {File} archive */
async function imported(api, archive) {
  const headers = { "Content-Type": "application/zip", "Accept-Language": language };
  const address = api.address("author/import");
  const answer = await fetch(address, { method: "POST", headers, body: archive, credentials: "omit" });
  if (!answer.ok) throw new Problem(answer.status, await answer.json().catch(() => ({})));
  return answer.json();
}

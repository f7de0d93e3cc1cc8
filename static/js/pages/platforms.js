/** The administrator's page: the platforms that may launch, and invitations to register one. */

import { Problem } from "../api.js";
import { dataTable, LiveTable, liveButtons } from "../data-table.js";
import { announce, arrange, el, fill } from "../dom.js";
import { dates, named, ownDirection, t } from "../i18n.js";
import { api, root, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

const $ = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** The invitations; the form beside them stays, with the address that is told only once. */
const invited = el("div");
/** The platforms; what stands where there are none. @type {LiveTable<any> | null} */
let listed = null;
const none = el("p", { class: "hint" });
const FIELDS = ["issuer", "client_id", "authorization_endpoint", "token_endpoint", "jwks_uri"];

/** The code of the address that the command printed. */
const codeOfAddress = () => new URLSearchParams(location.hash.slice(1)).get("code");

async function run() {
  // An address that is opened where this page stands already loads nothing: only its fragment is another.
  window.addEventListener("hashchange", () => void enter());
  if (codeOfAddress()) await enter();
  else showTheWay();
}

async function enter() {
  const code = codeOfAddress();
  if (!code) return;
  history.replaceState(null, "", location.pathname + location.search);
  await attempt(async () => {
    api.token = (await api.post("administration/open", { code })).token;
    $("invite-card").hidden = $("add-card").hidden = false;
    fill($("add"), addForm());
    fill($("invite"), inviteForm(), invited);
    await refresh();
  });
}

/** How one comes here: nobody is signed in, or no longer. */
function showTheWay() {
  const command = `framewise lti administer ${root.replace(/\/$/, "")}`;
  fill($("list"), el("p", { text: t("platforms-come") }), el("code", { text: command }));
  $("invite-card").hidden = $("add-card").hidden = true;
}

/** @param {() => Promise<void>} work */
async function attempt(work) {
  fill($("platforms-problem"));
  try {
    await work();
  } catch (error) {
    const isOver = error instanceof Problem && error.status === 401;
    if (isOver) showTheWay();
    const over = el("p", { class: "notice notice-problem", role: "alert", text: t("platforms-over") });
    fill($("platforms-problem"), isOver ? over : problemNotice(error));
    $("platforms-problem").scrollIntoView({ block: "nearest" });
  }
}

async function refresh() {
  const { platforms, invitations } = await api.get("administration/platforms");
  listed ??= listedPlatforms();
  if (!listed.element.isConnected) fill($("list"), listed.element, none);
  none.hidden = platforms.length > 0;
  listed.show(platforms);
  fill(invited, invitationTable(invitations));
}

function listedPlatforms() {
  const headings = ["platform", "status", "deployments", "names", "actions"].map((name) => t(`platforms-${name}`));
  none.textContent = t("platforms-none");
  return new LiveTable(t("platforms-list"), headings, ({ id }) => id, platformLine, $("list-heading"));
}

/** The row of a platform, whose elements stay while the platform is changed. @returns {(platform: any) => import("../dom.js").Child[]} */
function platformLine() {
  /** @type {any} */
  let platform;
  const change = (/** @type {any} */ told) =>
    attempt(async () => {
      await api.put(`administration/platforms/${platform.id}`, told);
      if (told.deployment) deployment.value = "";
      announce(t("platforms-saved"));
      await refresh();
    });
  const remove = () =>
    confirm(t("platforms-remove-sure", { issuer: platform.issuer })) &&
    attempt(async () => {
      await api.remove(`administration/platforms/${platform.id}`);
      announce(t("platforms-saved"));
      await refresh();
    });
  const [told, deployments, actions] = [el("div"), el("p"), el("div", { class: "row" })];
  const button = liveButtons();
  const deployment = el("input", { size: 12, required: true });
  const add = (/** @type {Event} */ event) => (event.preventDefault(), change({ deployment: deployment.value }));
  const more = el(
    "form",
    { class: "row", onsubmit: add },
    deployment,
    el("button", { type: "submit", class: "quiet small", text: t("platforms-add-deployment") }),
  );
  const added = el("div", {}, deployments, more);
  return (now) => {
    platform = now;
    const who = now.name || now.issuer;
    const turn = now.status === "active" ? ["disable", "disabled"] : ["activate", "active"];
    const called = (/** @type {string} */ text) => ({ label: named(text, who) });
    fill(told, platformText(now));
    deployments.textContent = now.deployments.join(", ") || "–";
    deployment.setAttribute("aria-label", named(t("platforms-deployment"), who));
    const turning = t(`platforms-${turn[0]}`);
    const buttons = [
      button("turn", turning, () => change({ status: turn[1] }), called(turning)),
      button("remove", t("platforms-remove"), remove, called(t("platforms-remove"))),
    ];
    arrange(actions, buttons);
    const names = t(`platforms-names-${now.names_shared ? "yes" : "no"}`);
    return [told, t(`platforms-status-${now.status}`), added, names, actions];
  };
}

/** @param {any} platform */
function platformText({ issuer, client_id: client, name, not_fetched: unread }) {
  return [
    el(
      "span",
      {},
      name ? `${ownDirection(name)} · ` : "",
      el("code", { text: issuer }),
      " · ",
      el("code", { text: client }),
    ),
    unread.map((/** @type {string} */ address) =>
      el("p", { class: "notice notice-warn", text: t("platforms-not-fetched", { address }) }),
    ),
  ];
}

function inviteForm() {
  const note = /** @type {HTMLInputElement} */ (el("input", { maxlength: 200 }));
  const made = el("div", { role: "status" });
  const make = async (/** @type {Event} */ event) => {
    event.preventDefault();
    await attempt(async () => {
      const { address } = await api.post("administration/invitations", { note: note.value });
      note.value = "";
      fill(made, el("p", { text: t("platforms-invite-made") }), el("p", {}, el("code", { text: address })));
      await refresh();
    });
  };
  return el(
    "form",
    { class: "row", onsubmit: make },
    el("label", {}, t("platforms-note"), note),
    el("button", { type: "submit", class: "primary", text: t("platforms-invite-make") }),
    made,
  );
}

/** @param {any[]} invitations */
function invitationTable(invitations) {
  if (!invitations.length) return null;
  const when = dates({ dateStyle: "medium" });
  const headings = ["note", "created", "expires", "status"].map((name) => t(`platforms-${name}`));
  return dataTable(
    t("platforms-invitations"),
    headings,
    invitations.map(({ note, created, expires, used, open }) => [
      note || "–",
      when.format(new Date(created)),
      when.format(new Date(expires)),
      t(`platforms-${used ? "used" : open ? "open" : "expired"}`),
    ]),
  );
}

function addForm() {
  /** @param {string} name @param {any} attributes */
  const field = (name, attributes) =>
    el("label", {}, t(`platforms-${name.replaceAll("_", "-")}`), el("input", { name, ...attributes }));
  const form = /** @type {HTMLFormElement} */ (
    el(
      "form",
      {
        class: "lecturer-form",
        onsubmit: (/** @type {Event} */ event) => {
          event.preventDefault();
          const told = Object.fromEntries(new FormData(form));
          attempt(async () => {
            await api.post("administration/platforms", { ...told, names_shared: told.names_shared === "on" });
            form.reset();
            announce(t("platforms-saved"));
            await refresh();
          });
        },
      },
      FIELDS.map((name) => field(name, { required: true, type: name === "client_id" ? "text" : "url" })),
      field("deployment", {}),
      field("name", {}),
      el(
        "label",
        { class: "row" },
        el("input", { type: "checkbox", name: "names_shared" }),
        t("platforms-names-shared"),
      ),
      el("p", { class: "wide" }, el("button", { type: "submit", class: "primary", text: t("platforms-save") })),
    )
  );
  return form;
}

startPage(run);

/** The administrator's page: the platforms that may launch, and invitations to register one. */

import { Problem } from "../api.js";
import { dataTable } from "../data-table.js";
import { announce, el, fill } from "../dom.js";
import { dates, named, t } from "../i18n.js";
import { api, root, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

const $ = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** The invitations; the form beside them stays, with the address that is told only once. */
const invited = el("div");
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
  const headings = ["platform", "status", "deployments", "names", "actions"].map((name) => t(`platforms-${name}`));
  fill(
    $("list"),
    platforms.length
      ? dataTable(t("platforms-list"), headings, platforms.map(platformRow))
      : el("p", { class: "hint", text: t("platforms-none") }),
  );
  fill(invited, invitationTable(invitations));
}

/** @param {any} platform */
function platformRow({ id, issuer, client_id: client, name, status, names_shared: names, deployments, not_fetched }) {
  const change = (/** @type {any} */ told) =>
    attempt(async () => {
      await api.put(`administration/platforms/${id}`, told);
      announce(t("platforms-saved"));
      await refresh();
    });
  const remove = () =>
    confirm(t("platforms-remove-sure", { issuer })) &&
    attempt(async () => {
      await api.remove(`administration/platforms/${id}`);
      await refresh();
    });
  /** @param {string} text @param {any} onclick */
  const button = (text, onclick) =>
    el("button", { type: "button", class: "quiet small", onclick, text, "aria-label": named(text, name || issuer) });
  const deployment = /** @type {HTMLInputElement} */ (
    el("input", { size: 12, required: true, "aria-label": named(t("platforms-deployment"), name || issuer) })
  );
  const more = el(
    "form",
    {
      class: "row",
      onsubmit: (/** @type {Event} */ event) => {
        event.preventDefault();
        change({ deployment: deployment.value });
      },
    },
    deployment,
    el("button", { type: "submit", class: "quiet small", text: t("platforms-add-deployment") }),
  );
  return [
    el(
      "div",
      {},
      el("span", {}, name ? `${name} · ` : "", el("code", { text: issuer }), " · ", el("code", { text: client })),
      not_fetched.map((/** @type {string} */ address) =>
        el("p", { class: "notice notice-warn", text: t("platforms-not-fetched", { address }) }),
      ),
    ),
    t(`platforms-status-${status}`),
    el("div", {}, el("p", { text: deployments.join(", ") || "–" }), more),
    t(`platforms-names-${names ? "yes" : "no"}`),
    el(
      "div",
      { class: "row" },
      status === "active"
        ? button(t("platforms-disable"), () => change({ status: "disabled" }))
        : button(t("platforms-activate"), () => change({ status: "active" })),
      button(t("platforms-remove"), remove),
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

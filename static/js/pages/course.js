/** The lecturers' page: the class, one link's numbers, and the attempts behind every number. */

import { el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { AttemptView } from "../lecturer/attempt-view.js";
import { ClassView, UndeliveredView } from "../lecturer/class-view.js";
import { LinkView } from "../lecturer/link-view.js";
import { api, startPage } from "../page.js";
import { problemNotice, telling } from "../problem.js";
import "../scene/robot-scene.js";
import { openSession, signedIn } from "../session/session.js";

const $ = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

async function run() {
  try {
    const session = await openSession(api);
    if (session === null) {
      fill($("class"), el("p", { text: t("lecturer-come-from-course") }));
      return;
    }
    $("course-title").after(el("p", { class: "hint", text: signedIn(session) }));
    const { exercises } = await api.get("exercises");
    const link = new LinkView(
      api,
      exercises,
      { card: $("link-card"), heading: $("link-heading"), body: $("link") },
      { openAttempt, changed: refresh },
    );
    const view = new ClassView($("class"), $("class-heading"), {
      openLink: (chosen) => link.show(chosen),
      openStudent: (chosen, student) => link.showStudent(chosen, student),
      openState: (chosen, state, students) => link.showState(chosen, state, students),
    });
    const undelivered = new UndeliveredView($("undelivered-card"), $("undelivered"), $("class-heading"), (id) =>
      telling($("course-problem"), async () => {
        await api.post(`course/links/${id}/resend`, {});
        await refresh();
      })(),
    );
    const { link: current, links } = await refresh();
    const own = links.find((/** @type {any} */ { id }) => id === current);
    if (own) await link.show(own);

    async function refresh() {
      const found = await api.get("course");
      $("course-title").textContent = found.course.title || t("lecturer-title");
      view.show(found);
      undelivered.show(found.undelivered);
      return found;
    }
  } catch (error) {
    fill($("course-problem"), problemNotice(error));
  }
}

const attempt = new AttemptView(api, $("attempt-card"), $("attempt"));

/** @param {number} id */
async function openAttempt(id) {
  try {
    await attempt.open(id);
  } catch (error) {
    fill($("course-problem"), problemNotice(error));
  }
}

startPage(run);

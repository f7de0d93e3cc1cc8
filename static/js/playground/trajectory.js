/** From one posture to another: a plot of the joints over time, the path of the tip, and the motion itself. */

import { el, fill, segmented, setValid, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { numberIn, plain, shown } from "../numbers.js";
import { CURVES, DASHES, figure } from "../plots.js";
import { pathModel } from "../scene/figures.js";
import { asked, sameRobot, Tool } from "./tool.js";

const QUANTITIES = ["positions", "velocities", "accelerations"];
/** Letters that fit into a choice on a phone; what is longer stands below it, too. */
const SHORT = 30;
const SCALINGS = ["quintic", "cubic"];
const SAMPLES = 61;
/** Every so many instants a row of the table. */
const STRIDE = 6;

/** @typedef {import("./tool.js").Subject} Subject */
/** @typedef {{name: string, joints: number[]}} Posture in the table's units */

/**
 * @param {import("../api.js").Api} api @param {import("./tool.js").Picture} picture
 * @param {{show: (joints: number[]) => void}} options brings the robot to joint values in the table's units
 */
export function trajectoryTool(api, picture, { show }) {
  const plan = new Plan(() => tool.refresh());
  const motion = new Motion(show);
  let found = { asked: "", nodes: /** @type {Node[]} */ ([]), path: /** @type {Wire.Vector[]} */ ([]) };
  /** @type {Subject | null} */
  let of = null;
  const tool = new Tool(
    t("playground-trajectory"),
    async (subject) => {
      if (subject.joints.length === 0) return [el("p", { class: "hint", text: t("playground-no-joints") })];
      if (!sameRobot(subject, of)) plan.forget(subject);
      of = subject;
      plan.present(subject);
      const { start, end, duration, quantity, scaling } = plan;
      if (!start || !end || duration === null) return [];
      const request = { ...asked(subject), start, end, duration, scaling, samples: SAMPLES };
      const question = JSON.stringify([request, quantity, subject.limits]);
      if (question !== found.asked) {
        const answer = await api.post("trajectory", request);
        motion.take(answer, duration);
        found = { asked: question, nodes: [motion.element, ...plots(answer, quantity, subject)], path: answer.path };
      }
      const size = picture.robot()?.size ?? 1;
      picture.layer("path", pathModel(found.path, size));
      return found.nodes;
    },
    {
      controls: [plan.element],
      closed: () => {
        motion.pause();
        picture.layer("path", null);
      },
    },
  );
  return Object.assign(tool, {
    /** Postures that can be chosen besides the present one. @param {string} group @param {Posture[]} postures */
    offer: (group, postures) => plan.offer(group, postures),
  });
}

/** What is asked for: from where, to where, how long, which polynomial, which curves. */
class Plan {
  /** @type {number[] | null} */
  start = null;
  /** @type {number[] | null} */
  end = null;
  /** @type {number | null} */
  duration = 2;
  quantity = QUANTITIES[0];
  scaling = SCALINGS[0];
  /** @type {Map<string, Posture[]>} */
  #offers = new Map();
  /** @type {number[]} */
  #now = [];

  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.ends = el("div", { class: "trajectory-ends" });
    const id = uniqueId("duration");
    const fault = el("div", { role: "status", id: `${id}-fault` });
    const duration = el("input", {
      id,
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      value: String(this.duration),
      "aria-describedby": fault.id,
      oninput: (event) => {
        const value = numberIn(event.target.value);
        this.duration = value !== null && value >= 0.001 && value <= 1e6 ? value : null;
        setValid(event.target, this.duration !== null);
        fill(
          fault,
          this.duration === null
            ? el("p", { class: "notice notice-problem", text: t("playground-duration-needed") })
            : null,
        );
        this.changed();
      },
    });
    /** @param {string[]} values @param {"quantity" | "scaling"} property @param {(value: string) => string} told */
    const choice = (values, property, told) =>
      segmented({
        name: uniqueId(property),
        label: t(property === "quantity" ? "playground-quantity" : "playground-scaling"),
        value: this[property],
        options: values.map((value) => ({ value, label: told(value) })),
        onchange: (value) => {
          this[property] = value;
          this.changed();
        },
      });
    this.element = el(
      "div",
      { class: "stack" },
      this.ends,
      el(
        "div",
        { class: "row" },
        el("label", { for: id, text: t("playground-duration") }),
        el("span", { class: "joint-number" }, duration, el("span", { class: "hint", text: "s" })),
        choice(SCALINGS, "scaling", (value) => t(`playground-scaling-${value}`)),
      ),
      fault,
      choice(QUANTITIES, "quantity", (value) => t(`playground-quantity-${value}`)),
    );
    this.#show();
  }

  /** Another robot: from its zero to where it stands, until something else is chosen. @param {Subject} subject */
  forget({ joints }) {
    this.#now = joints;
    const first = this.#offers.get("configurations") ?? [];
    this.start = first[0]?.joints.length === joints.length ? first[0].joints : joints.map(() => 0);
    const last = first.at(-1);
    this.end = first.length > 1 && last?.joints.length === joints.length ? last.joints : joints;
    this.#show();
  }

  /** @param {Subject} subject where the joints stand now */
  present({ joints }) {
    this.#now = joints;
  }

  /** @param {string} group @param {Posture[]} postures */
  offer(group, postures) {
    this.#offers.set(group, postures);
    this.#show();
  }

  #show() {
    fill(this.ends, this.#end("start"), this.#end("end"));
  }

  /** @param {"start" | "end"} which */
  #end(which) {
    const id = uniqueId(which);
    const joints = this[which];
    const options = [...this.#offers.values()].flat();
    const chosen = options.findIndex((each) => JSON.stringify(each.joints) === JSON.stringify(joints));
    const take = (/** @type {string} */ value) => {
      this[which] = value === "now" ? this.#now : (options[Number(value)]?.joints ?? joints);
      const { activeElement } = document;
      const back = this.ends.contains(activeElement) ? activeElement?.closest("[data-end]") : null;
      this.#show();
      const select = back instanceof HTMLElement && this.ends.querySelector(`[data-end="${back.dataset.end}"] select`);
      if (select instanceof HTMLElement) select.focus();
      this.changed();
    };
    return el(
      "div",
      { class: "field", dataset: { end: which } },
      el("label", { for: id, text: t(`playground-trajectory-${which}`) }),
      el(
        "select",
        { id, onchange: (event) => take(event.target.value) },
        joints && chosen < 0
          ? el("option", { value: "kept", selected: true, text: joints.map((q) => shown(q, 2)).join("; ") })
          : null,
        el("option", { value: "now", text: t("playground-trajectory-now") }),
        options.map(({ name }, i) => el("option", { value: i, selected: i === chosen, text: name })),
      ),
      (options[chosen]?.name.length ?? 0) > SHORT && el("p", { class: "hint", text: options[chosen].name }),
    );
  }
}

/** Moves the robot along a trajectory: by hand with a slider, or by itself where motion is welcome. */
class Motion {
  #running = 0;
  /** @type {{times: number[], positions: number[][]}} */
  #answer = { times: [0], positions: [] };

  /** @param {(joints: number[]) => void} show */
  constructor(show) {
    this.show = show;
    const id = uniqueId("instant");
    this.slider = /** @type {HTMLInputElement} */ (
      el("input", {
        id,
        type: "range",
        min: 0,
        value: "0",
        oninput: () => (this.pause(), this.#at(Number(this.slider.value))),
      })
    );
    this.play = el("button", { type: "button", class: "small", onclick: () => this.#toggle(), text: t("form-play") });
    this.time = el("output", { for: id });
    this.element = el(
      "div",
      { class: "lesson-slider" },
      this.play,
      el("label", { for: id, class: "visually-hidden", text: t("playground-instant") }),
      this.slider,
      this.time,
    );
  }

  /** @param {any} answer @param {number} duration [s] */
  take(answer, duration) {
    this.pause();
    this.#answer = answer;
    this.duration = duration;
    this.slider.max = String(answer.times.length - 1);
    this.slider.value = "0";
    this.time.textContent = "0 s";
  }

  pause() {
    cancelAnimationFrame(this.#running);
    this.#running = 0;
    this.play.textContent = t("form-play");
  }

  #toggle() {
    if (this.#running) return this.pause();
    const last = this.#answer.times.length - 1;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      const next = Number(this.slider.value) >= last ? 0 : Math.min(last, Number(this.slider.value) + STRIDE);
      return this.#at(next);
    }
    const begin = performance.now();
    const tick = (/** @type {number} */ now) => {
      const share = Math.min(1, (now - begin) / 1000 / Math.min(10, Math.max(1, this.duration ?? 1)));
      this.#at(Math.round(share * last));
      if (share >= 1) return this.pause();
      this.#running = requestAnimationFrame(tick);
    };
    this.#running = requestAnimationFrame(tick);
    this.play.textContent = t("form-pause");
  }

  /** @param {number} index of an instant */
  #at(index) {
    const { times, positions } = this.#answer;
    this.slider.value = String(index);
    this.time.textContent = `${shown(times[index], 2)} s`;
    this.slider.setAttribute("aria-valuetext", this.time.textContent);
    this.show(positions[index]);
  }
}

/** One plot for turning joints and one for sliding ones: their units differ. @param {any} answer @param {string} quantity @param {Subject} subject */
function plots(answer, quantity, { types, ranges, units, limits }) {
  return ["revolute", "prismatic"].flatMap((kind) => {
    const members = types.flatMap((type, i) => (type === kind ? [i] : []));
    if (!members.length) return [];
    const unit = `${kind === "prismatic" ? units.length : units.angle === "deg" ? "°" : "rad"}${{ positions: "", velocities: "/s", accelerations: "/s²" }[quantity]}`;
    const curves = members.flatMap((i) =>
      answer.times.map((/** @type {number} */ time, /** @type {number} */ k) => ({
        time,
        value: answer[quantity][k][i],
        joint: ranges[i].name,
        i,
      })),
    );
    const ends = quantity === "positions" ? limitRules(members, limits, answer) : [];
    const label = t(`playground-plot-${quantity}-${kind}`);
    return [
      figure(
        label,
        (plot) => ({
          marginRight: 34,
          marginBottom: 42,
          x: { label: "t [s]", labelOffset: 38 },
          y: { label: `[${unit}]`, grid: true },
          marks: [
            plot.ruleY([0], { stroke: "currentColor", strokeOpacity: 0.4 }),
            plot.ruleY(ends, {
              y: "value",
              stroke: (end) => CURVES[end.i % CURVES.length],
              strokeDasharray: "2 4",
            }),
            plot.text(ends, {
              y: "value",
              frameAnchor: "left",
              textAnchor: "start",
              dx: 4,
              dy: -6,
              text: (end) => `${ranges[end.i].name} ${end.sign} ${shown(end.value, 2)}`,
              fill: (end) => CURVES[end.i % CURVES.length],
            }),
            ...members.map((i) =>
              plot.line(
                curves.filter((point) => point.i === i),
                {
                  x: "time",
                  y: "value",
                  stroke: CURVES[i % CURVES.length],
                  strokeDasharray: DASHES[i % DASHES.length],
                  strokeWidth: 2,
                },
              ),
            ),
            plot.text(names(curves, members), {
              x: "time",
              y: "value",
              text: "joint",
              dx: 6,
              textAnchor: "start",
              fill: (point) => CURVES[point.i % CURVES.length],
              fontWeight: "bold",
            }),
          ],
        }),
        {
          caption: label,
          head: ["t [s]", ...members.map((i) => `${ranges[i].name} [${unit}]`)],
          rows: answer.times
            .map((/** @type {number} */ time, /** @type {number} */ k) => [
              plain(time, 3),
              ...members.map((i) => shown(answer[quantity][k][i], 3)),
            ])
            .filter((/** @type {any} */ _, /** @type {number} */ k) => k % STRIDE === 0),
        },
      ),
    ];
  });
}

/** Limits that a joint's own curve comes near: within a tenth of its range. @param {number[]} members @param {import("../joint-ranges.js").Limits} limits @param {any} answer */
function limitRules(members, limits, answer) {
  return members.flatMap((i) => {
    const [least, greatest] = limits?.[i] ?? [null, null];
    const near = least !== null && greatest !== null ? (greatest - least) / 10 : 0;
    const values = answer.positions.map((/** @type {number[]} */ row) => row[i]);
    const ends = [
      { sign: "≥", value: least, away: Math.min(...values) - (least ?? -Infinity) },
      { sign: "≤", value: greatest, away: (greatest ?? Infinity) - Math.max(...values) },
    ];
    return ends.filter(({ away }) => away <= near).map((end) => ({ ...end, i }));
  });
}

/** Where the curves end, the names a little apart. @param {any[]} curves @param {number[]} members */
function names(curves, members) {
  const last = members.map((i) => curves.filter((point) => point.i === i).at(-1));
  const values = curves.map(({ value }) => value);
  const gap = (Math.max(...values) - Math.min(...values) || 1) * 0.06;
  last.sort((one, other) => one.value - other.value);
  const placed = /** @type {any[]} */ ([]);
  for (const point of last) {
    const below = placed.at(-1);
    placed.push({ ...point, value: below && point.value < below.value + gap ? below.value + gap : point.value });
  }
  return placed;
}

import assert from "node:assert/strict";
import { test } from "node:test";
import { COLUMNS, newTable } from "../../../static/js/editor/model.js";
import { gridOf, isTable } from "../../../static/js/editor/cut.js";
import { fromLatex } from "../../../static/js/editor/latex.js";
import { readPasted, withBlock, withPasted } from "../../../static/js/editor/paste.js";
import { isCode } from "../../../static/js/editor/toolbox-code.js";

const rowsOf = (pasted) => pasted.rows.map(({ cells }) => [cells.alpha, cells.a, cells.d, cells.theta]);

test("a spreadsheet's rows, in the order of the form", () => {
  const text = "0\t0\t0\tθ1\n-90\t0\t0\tθ2\n0\t0,4318\t0,15005\tθ3\n";
  const pasted = readPasted(text, COLUMNS.modified);
  assert.equal(pasted.format, "tabs");
  assert.deepEqual(rowsOf(pasted), [
    ["0", "0", "0", "θ1"],
    ["-90", "0", "0", "θ2"],
    ["0", "0.4318", "0.15005", "θ3"],
  ]);
  assert.deepEqual(
    pasted.rows.map((row) => row.joint),
    ["revolute", "revolute", "revolute"],
  );
});

test("headings decide the columns and the convention", () => {
  const text = "i\tθ_i\td_i\ta_{i}\tα_i\n1\tq1\t0\t0\t90\n2\tq2\t0\tL2\t0\n";
  const pasted = readPasted(text, COLUMNS.modified);
  assert.equal(pasted.convention, "standard");
  assert.deepEqual(rowsOf(pasted), [
    ["90", "0", "0", "q1"],
    ["0", "L2", "0", "q2"],
  ]);
  const modified = readPasted(
    "Link & $\\alpha_{i-1}$ & $a_{i-1}$ & $d_i$ & $\\theta_i$ \\\\ \\hline\n1 & 0 & 0 & 0 & $\\theta_1$ \\\\",
    COLUMNS.standard,
  );
  assert.equal(modified.convention, "modified");
  assert.deepEqual(rowsOf(modified), [["0", "0", "0", "θ_1"]]);
});

test("headings whose index is typed beside the letter, as text processors and mail leave it", () => {
  const word = readPasted("i\tθi\tdi\tai\tαi\n1\tθ1*\t0\t0\t90°\n2\tθ2*\t0\ta2\t0°\n", COLUMNS.modified);
  assert.equal(word.convention, "standard");
  assert.deepEqual(rowsOf(word), [
    ["90°", "0", "0", "θ1"],
    ["0°", "a2", "0", "θ2"],
  ]);
  const craig = readPasted("i\tαi-1\tai−1\tdi\tθi\n1\t0\t0\t0\tθ1\n2\t-90\t0\td2\tθ2\n", COLUMNS.standard);
  assert.equal(craig.convention, "modified");
  assert.deepEqual(rowsOf(craig), [
    ["0", "0", "0", "θ1"],
    ["-90", "0", "d2", "θ2"],
  ]);
  const names = readPasted("Elo;teta;d;a;alfa\n1;q1;0;0;90\n2;q2;0;L2;0\n", COLUMNS.modified);
  assert.deepEqual(rowsOf(names), [
    ["90", "0", "0", "q1"],
    ["0", "L2", "0", "q2"],
  ]);
});

test("LaTeX tabular, with rules, environments and fractions", () => {
  const text = String.raw`
    \begin{table}[h] \centering
    \begin{tabular}{|c|c|c|c|c|} \hline
      $i$ & $\alpha_{i-1}$ & $a_{i-1}$ & $d_i$ & $\theta_i$ \\ \hline
      1 & $0$ & 0 & 0 & $\theta_{1}$ \\[2pt] \hline
      2 & $-\frac{\pi}{2}$ & $0$ & $d_{2}$ & $\theta_2+\dfrac{\pi}{2}$ \\ \hline % wrist
      3 & $-90^{\circ}$ & $L_{1}\cdot 2$ & $\mathrm{q}_3$ & 0 \\
    \end{tabular} \end{table}`;
  const pasted = readPasted(text, COLUMNS.modified);
  assert.equal(pasted.format, "latex");
  assert.deepEqual(rowsOf(pasted), [
    ["0", "0", "0", "θ_1"],
    ["-π/2", "0", "d_2", "θ_2+π/2"],
    ["-90°", "L_1* 2", "q_3", "0"],
  ]);
  assert.deepEqual(
    pasted.rows.map((row) => row.joint),
    ["revolute", "revolute", "prismatic"],
  );
});

test("Markdown", () => {
  const text = "| i | α | a | d | θ |\n|---|:-:|---|---|---|\n| 1 | 0 | 0 | 0 | θ₁ |\n| 2 | `-π/2` | 0 | 0 | θ₂ |";
  const pasted = readPasted(text, COLUMNS.standard);
  assert.equal(pasted.format, "markdown");
  assert.deepEqual(rowsOf(pasted), [
    ["0", "0", "0", "θ₁"],
    ["-π/2", "0", "0", "θ₂"],
  ]);
});

test("the text of a PDF: blanks part cells, signs with blanks around them do not", () => {
  const text = "1  0   0   0   q1\n2 −90° 0 0 q2 + π/2\n3 0 L2 d3 q3 - 90\n4 -90 0.02 0.43 q4";
  const pasted = readPasted(text, COLUMNS.modified);
  assert.equal(pasted.format, "text");
  assert.deepEqual(rowsOf(pasted), [
    ["0", "0", "0", "q1"],
    ["−90°", "0", "0", "q2+π/2"],
    ["0", "L2", "d3", "q3-90"],
    ["-90", "0.02", "0.43", "q4"],
  ]);
});

test("CSV with semicolons and decimal commas, and with commas", () => {
  assert.deepEqual(rowsOf(readPasted("0;0,5;0;q1\n90;0;0,1;q2", COLUMNS.modified)), [
    ["0", "0.5", "0", "q1"],
    ["90", "0", "0.1", "q2"],
  ]);
  assert.deepEqual(rowsOf(readPasted('0,0.5,0,"q1"\natan2(1,2),0,0.1,q2', COLUMNS.modified)), [
    ["0", "0.5", "0", "q1"],
    ["atan2(1,2)", "0", "0.1", "q2"],
  ]);
});

test("joint types in words, in the form's languages", () => {
  for (const [word, joint] of [
    ["R", "revolute"],
    ["prismatique", "prismatic"],
    ["rotație", "revolute"],
    ["обертальний", "revolute"],
    ["prismática", "prismatic"],
    ["fixo", "fixed"],
  ]) {
    const pasted = readPasted(`1\t${word}\t0\t0\t1\t2`, COLUMNS.modified);
    assert.equal(pasted.rows[0].joint, joint, word);
  }
});

test("what is no table is left alone", () => {
  assert.ok(!isTable("q1 + pi/2"));
  assert.ok(!isTable("  0.4318 "));
  assert.equal(readPasted("hello world", COLUMNS.modified), null);
  assert.equal(readPasted("no table at all\nor is it one", COLUMNS.modified), null);
  assert.equal(readPasted("1\t2\t3", COLUMNS.modified), null);
  assert.equal(readPasted("", COLUMNS.modified), null);
});

test("pasted rows replace rows; numbers alone keep the joint types of the form", () => {
  const table = newTable("modified", 3);
  const pasted = readPasted("0\t1\t2\t3\n4\t5\t6\t7", COLUMNS.modified);
  const next = withPasted(table, pasted, 0, false, ["modified"]).table;
  assert.deepEqual(
    next.rows.map((row) => [row.joint, row.theta]),
    [
      ["revolute", "3"],
      ["revolute", "7"],
      ["revolute", "θ3"],
    ],
  );
  assert.equal(withPasted(table, pasted, 0, true, ["modified"]).table.rows.length, 2);
});

test("where some rows hold a variable, the others are fixed", () => {
  const pasted = readPasted("0\t0\t0\tq1\n0\t0\t0.2\t0", COLUMNS.modified);
  assert.deepEqual(
    withPasted(newTable("modified", 2), pasted, 0, true, []).table.rows.map((row) => row.joint),
    ["revolute", "fixed"],
  );
});

test("headings choose the convention only where it may be chosen", () => {
  const pasted = readPasted("θ_i\td_i\ta_i\tα_i\nq1\t0\t0\t90", COLUMNS.modified);
  const convention = (allowed) => withPasted(newTable("modified", 1), pasted, 0, true, allowed).table.convention;
  assert.equal(convention(["modified", "standard"]), "standard");
  assert.equal(convention(["modified"]), "modified");
});

test("a block goes right and down from its cell, adding rows", () => {
  const next = withBlock(newTable("modified", 2), "1\t2\n3\t4\n5\t6", 1, "a");
  assert.deepEqual(
    next.rows.map((row) => [row.a, row.d]),
    [
      ["", ""],
      ["1", "2"],
      ["3", "4"],
      ["5", "6"],
    ],
  );
  assert.equal(withBlock(newTable("modified", 2), "1", 0, "a"), null);
});

test("LaTeX is spelled out, nested", () => {
  assert.equal(fromLatex(String.raw`\sqrt{\frac{a_1}{2}}`), "sqrt(a_1/2)");
  assert.equal(fromLatex(String.raw`\left(l_1+l_2\right)`).replace(/\s/g, ""), "(l_1+l_2)");
  assert.equal(fromLatex(String.raw`x^{2}`), "x^(2)");
  assert.equal(gridOf("a & b \\\\ c & d").grid.length, 2);
});

test("columns without headings are turned round where the joint variables say so", () => {
  const pasted = readPasted("0 0 0 θ1\n-90 a2 d2 θ2", ["theta", "d", "a", "alpha"]);
  assert.deepEqual(pasted.rows[1].cells, { alpha: "-90", a: "a2", d: "d2", theta: "θ2" });
  const algebra = readPasted("0\t0\t0\ttheta[1]\n-90\ta2\td2\ttheta[2]", ["theta", "d", "a", "alpha"]);
  assert.deepEqual(algebra.rows[1].cells, { alpha: "-90", a: "a2", d: "d2", theta: "theta[2]" });
  const usual = readPasted("θ1 0 0 90\nθ2 0 a2 0", ["theta", "d", "a", "alpha"]);
  assert.deepEqual(usual.rows[1].cells, { theta: "θ2", d: "0", a: "a2", alpha: "0" });
  const numbers = readPasted("0 0.1 0.2 90\n0 0 0.3 0", ["theta", "d", "a", "alpha"]);
  assert.deepEqual(numbers.rows[0].cells, { theta: "0", d: "0.1", a: "0.2", alpha: "90" });
});

test("what the text of a PDF does to a table is undone", () => {
  const order = ["theta", "d", "a", "alpha"];
  const stars = readPasted("Link a_i α_i d_i θ_i\n1 0 90◦ d1 θ1∗\n2 a2 0 0 θ2∗", order);
  assert.deepEqual(stars.rows[0].cells, { a: "0", alpha: "90°", d: "d1", theta: "θ1" });
  const wide = readPasted("1  0  0  L1 + L2  θ1\n2  − π/2  0  0  θ2 − 90°", order);
  assert.deepEqual(wide.rows[0].cells, { alpha: "0", a: "0", d: "L1 + L2", theta: "θ1" });
  assert.deepEqual(wide.rows[1].cells, { alpha: "−π/2", a: "0", d: "0", theta: "θ2 − 90°" });
});

test("a column that numbers the joints is not read as their types", () => {
  const text =
    "Joint & $\\theta$ & $d$ & $a$ & $\\alpha$\\\\ 1 & $\\theta_1$ & 0 & $l_1$ & 0\\\\ 2 & $\\theta_2$ & 0 & $l_2$ & 0\\\\";
  const pasted = readPasted(text, ["theta", "d", "a", "alpha"]);
  assert.deepEqual(
    pasted.rows.map((row) => row.joint),
    ["revolute", "revolute"],
  );
  const typed = readPasted("type\tθ\td\ta\tα\n0\tq1\t0\t0\t90\n1\t0\tq2\t0\t0", ["theta", "d", "a", "alpha"]);
  assert.deepEqual(
    typed.rows.map((row) => row.joint),
    ["revolute", "prismatic"],
  );
});

const cellsOf = (pasted) => pasted.rows.map(({ cells }) => [cells.theta, cells.d, cells.a, cells.alpha]);

test("LaTeX as textbooks and siunitx write it: a variable's star, a decimal comma, quantities", () => {
  const stars = "1 & $\\theta_1^{*}$ & 0 & 0 & $90^\\circ$\\\\ 2 & $\\theta_2^* - 90$ & $0{,}15$ & $a_2$ & 0";
  assert.deepEqual(cellsOf(readPasted(stars, COLUMNS.standard)), [
    ["θ_1", "0", "0", "90°"],
    ["θ_2* - 90", "0.15", "a_2", "0"],
  ]);
  const quantities = String.raw`$\theta_1$ & \SI{0.4}{\metre} & \qty{20}{\milli\metre} & \ang{90} \\ $\theta_2$ & \num{0.2} & 0 & \SI{-90}{\degree}`;
  assert.deepEqual(cellsOf(readPasted(quantities, COLUMNS.standard)), [
    ["θ_1", "0.4 m", "20 mm", "90°"],
    ["θ_2", "0.2", "0", "-90°"],
  ]);
});

test("units that headings name become the table's, unless numbers in another one stay", () => {
  const pasted = readPasted("Joint\tθ (deg)\td [mm]\ta [mm]\tα (deg)\n1\tq1\t0\t431.8\t90", COLUMNS.standard);
  assert.deepEqual(pasted.units, { angleUnit: "deg", lengthUnit: "mm" });
  const table = newTable("standard", 2, { angleUnit: "rad" });
  const whole = withPasted(table, pasted, 0, true, ["standard"]);
  assert.deepEqual([whole.table.angleUnit, whole.table.lengthUnit, whole.left], ["deg", "mm", null]);
  table.rows[1] = { ...table.rows[1], a: "0.3" };
  const beside = withPasted(table, pasted, 0, false, ["standard"]);
  assert.deepEqual([beside.table.angleUnit, beside.table.lengthUnit, beside.left], ["deg", "m", 0]);
  assert.deepEqual([beside.table.rows[0].a, beside.table.rows[0].alpha], ["0.4318", "90"]);
  const mixed = readPasted("θ\td (mm)\ta (m)\tα\nq1\t10\t1\t90", COLUMNS.standard);
  assert.deepEqual(mixed.units, {});
});

test("pasted radians beside rows in degrees are written in degrees; what cannot be is counted", () => {
  const table = newTable("standard", 2);
  table.rows[0] = { ...table.rows[0], alpha: "90" };
  const pasted = readPasted("Link('d', 0.3, 'alpha', 1.5707963267948966, 'offset', 2*0.5)", COLUMNS.standard);
  const { table: next, left } = withPasted(table, pasted, 1, false, ["standard"]);
  assert.equal(next.angleUnit, "deg");
  const exact = withPasted(table, readPasted("Link('d', 0, 'alpha', -pi/2)", COLUMNS.standard), 1, false, []);
  assert.deepEqual([exact.table.rows[1].alpha, exact.table.angleUnit, exact.left], ["-pi/2", "deg", null]);
  assert.deepEqual([next.rows[1].alpha, next.rows[1].d, next.rows[1].theta, left], ["90", "0.3", "θ1+2*0.5", 1]);
});

test("the notation of Khalil and Kleinfinger, in which d is the length and r the offset", () => {
  const pasted = readPasted("j\tσj\tαj\tdj\tθj\trj\n1\t0\t0\t0\tθ1\t0\n2\t1\tπ/2\tD2\t0\tr2", COLUMNS.standard);
  assert.equal(pasted.convention, "modified");
  assert.deepEqual(cellsOf(pasted), [
    ["θ1", "0", "0", "0"],
    ["0", "r2", "D2", "π/2"],
  ]);
  assert.deepEqual(
    pasted.rows.map((row) => row.joint),
    ["revolute", "prismatic"],
  );
});

test("tables drawn with lines, lists of programs, letters of formulas, empty columns", () => {
  const expected = [
    ["q1", "0", "0", "90"],
    ["q2", "0", "a2", "-90"],
  ];
  const ways = {
    pandoc:
      "  i    theta   d     a     alpha\n --- ------- ----- ----- -------\n  1    q1      0     0     90\n  2    q2      0     a2    -90",
    grid: "+---+----+---+----+-----+\n| i | θ  | d | a  | α   |\n+===+====+===+====+=====+\n| 1 | q1 | 0 | 0  | 90  |\n+---+----+---+----+-----+\n| 2 | q2 | 0 | a2 | -90 |\n+---+----+---+----+-----+",
    python: "[[q1, 0, 0, 90],\n [q2, 0, a2, -90]]",
    matlab: "[q1 0 0 90; q2 0 a2 -90];",
    formulas: "𝜃\t𝑑\t𝑎\t𝛼\n𝑞1\t0\t0\t90\n𝑞2\t0\t𝑎2\t-90",
    trailing: "q1\t0\t0\t90\t\nq2\t0\ta2\t-90\t",
  };
  for (const [name, text] of Object.entries(ways)) {
    assert.ok(isTable(text), name);
    assert.deepEqual(cellsOf(readPasted(text, COLUMNS.standard)), expected, name);
  }
  const signs = readPasted("1 q1 0 0 - 90°\n2 q2 0 a2 0", COLUMNS.standard);
  assert.deepEqual(cellsOf(signs)[0], ["q1", "0", "0", "-90°"]);
  const numbered = readPasted("1\tq1\t0\t0\t\n2\tq2\t0\ta2\t", COLUMNS.standard);
  assert.deepEqual(cellsOf(numbered)[1], ["q2", "0", "a2", ""]);
});

test("a table whose cells came on lines of their own, as PDF viewers copy it", () => {
  const craig = "i\nαi−1\nai−1\ndi\nθi\n1\n0\n0\n0\nθ1\n2\n−90°\n0\nd2\nθ2\n";
  const pasted = readPasted(craig, COLUMNS.standard);
  assert.equal(pasted.convention, "modified");
  const rows = [
    ["0", "0", "0", "θ1"],
    ["−90°", "0", "d2", "θ2"],
  ];
  assert.deepEqual(rowsOf(pasted), rows);
  const standard = readPasted("θi\ndi\nai\nαi\nθ1\n0\n0\n90\nθ2\n0\na2\n0\n", COLUMNS.modified);
  assert.deepEqual(rowsOf(standard), [
    ["90", "0", "0", "θ1"],
    ["0", "a2", "0", "θ2"],
  ]);
  const numbered = readPasted(craig.slice(craig.indexOf("\n1\n") + 1), COLUMNS.modified);
  assert.deepEqual(rowsOf(numbered), rows);
  assert.equal(readPasted("0\n90\n0\n-90\n90\n0\n1\n2\n3\n4\n", COLUMNS.modified), null);
});

test("links as the Robotics Toolbox writes them, in MATLAB and in Python", () => {
  const types = (pasted) => pasted.rows.map(({ joint }) => joint);
  const vectors = "L(1) = Link([0 0 0 0], 'modified');\nL(2) = Link([0, d3, a2, -pi/2, 0, pi/2], 'modified');\n";
  const modified = readPasted(`${vectors}L(3) = Link([0 0 0 0 1], 'modified');`, COLUMNS.standard);
  assert.equal(modified.convention, "modified");
  assert.equal(modified.units.angleUnit, "rad");
  assert.deepEqual(rowsOf(modified), [
    ["0", "0", "0", "θ1"],
    ["-pi/2", "a2", "d3", "θ2+pi/2"],
    ["0", "0", "d3", "0"],
  ]);
  assert.deepEqual(types(modified), ["revolute", "revolute", "prismatic"]);
  const matlab =
    "R = SerialLink([Revolute('d', 0.5, 'alpha', -pi/2), Link('d', 0, 'a', 0.4), Prismatic('theta', pi/2)]);";
  const python =
    "DHRobot([RevoluteDH(d=0.5, alpha=-np.pi/2), RevoluteDH(a=0.4), PrismaticDH(theta=np.pi/2)], name='R')";
  for (const text of [matlab, python]) {
    assert.ok(isCode(text));
    const pasted = readPasted(text, COLUMNS.modified);
    assert.equal(pasted.convention, "standard");
    assert.deepEqual(rowsOf(pasted), [
      ["-pi/2", "0", "0.5", "θ1"],
      ["0", "0.4", "0", "θ2"],
      ["0", "0", "d3", "pi/2"],
    ]);
    assert.deepEqual(types(pasted), ["revolute", "revolute", "prismatic"]);
  }
  assert.ok(!isCode("0\t0\t0\tθ1\nLink 2"));
});

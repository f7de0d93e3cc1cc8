/** Matrices as text: every notation that people paste, and prose that is left alone. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { blockOf, readMatrix } from "../../../static/js/exercise/matrix-text.js";

const WANTED = [
  ["c1", "-s1", "0", "a1*c1"],
  ["s1", "c1", "0", "a1*s1"],
  ["0", "0", "1", "0"],
  ["0", "0", "0", "1"],
];
const SOURCES = {
  tabs: "c1\t-s1\t0\ta1*c1\ns1\tc1\t0\ta1*s1\n0\t0\t1\t0\n0\t0\t0\t1\n",
  matlab: "T = [c1, -s1, 0, a1*c1; s1, c1, 0, a1*s1; 0, 0, 1, 0; 0, 0, 0, 1];",
  matlabBlanks: "[c1 -s1 0 a1*c1; s1 c1 0 a1*s1; 0 0 1 0; 0 0 0 1]",
  python:
    "np.array([[c1, -s1, 0, a1*c1],\n          [s1, c1, 0, a1*s1],\n          [0, 0, 1, 0],\n          [0, 0, 0, 1]])",
  sympy: "Matrix([[c1, -s1, 0, a1*c1], [s1, c1, 0, a1*s1], [0, 0, 1, 0], [0, 0, 0, 1]])",
  text: "c1  -s1  0  a1*c1\ns1  c1  0  a1*s1\n0 0 1 0\n0 0 0 1",
};

for (const [name, source] of Object.entries(SOURCES)) {
  test(`a matrix as ${name}`, () => assert.deepEqual(readMatrix(source), WANTED));
}

test("LaTeX", () => {
  const source =
    "\\begin{bmatrix} \\cos(\\theta_1) & 0 & \\frac{1}{2} & L_1 \\\\ 0 & 1 & 0 & 0 \\\\ 0 & 0 & 1 & 0 \\end{bmatrix}";
  const matrix = readMatrix(source);
  assert.equal(matrix?.length, 4);
  assert.equal(matrix?.[0][0], "cos(θ_1)");
  assert.equal(matrix?.[0][2], "1/2");
  assert.deepEqual(matrix?.[3], ["0", "0", "0", "1"]);
});

test("cells with decimal commas are parted by blanks", () => {
  const source = "0,5 -0,866 0 1,2\n0,866 0,5 0 0,4\n0,0 0,0 1,0 0,0\n0 0 0 1";
  assert.deepEqual(readMatrix(source)?.[0], ["0,5", "-0,866", "0", "1,2"]);
  assert.deepEqual(blockOf("0,5 0,25"), [["0,5", "0,25"]]);
  assert.deepEqual(blockOf("1,0, 0"), [["1", "0", "0"]]);
  assert.deepEqual(blockOf("1,0,0"), [["1", "0", "0"]]);
});

test("functions of two arguments stay whole", () => {
  const source = "[cos(q1), 0, 0, 0; 0, atan2(a, b), 0, 0; 0, 0, 1, 0; 0, 0, 0, 1]";
  assert.equal(readMatrix(source)?.[1][1], "atan2(a, b)");
});

test("prose, one cell and ragged rows are no matrix", () => {
  const prose = "The matrix is given below.\nPlease check, whether it is right; thank you.\nYours";
  for (const text of [
    prose,
    "c1*c2 - s1*s2",
    "",
    "1 2 3\n4 5",
    "one two three four\nfive six seven eight\nand so on it",
  ]) {
    assert.equal(readMatrix(text), null, text);
    assert.equal(blockOf(text), null, text);
  }
});

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { adviceFor } from "../../../static/js/lecturer/score-advice.js";

const SENTENCES = readFileSync(new URL("../../../service/locales/en/lecturer.ftl", import.meta.url), "utf8");
const GIVEN_UP = {
  line_item_gone: "column",
  http_404: "gone",
  http_403: "forbidden",
  http_400: "refused",
  http_410: "refused",
  http_412: "refused",
  http_429: "silent",
  http_503: "silent",
  no_answer: "silent",
};
const TRIED_AGAIN = {
  token_refused: "forbidden",
  http_408: "busy",
  http_429: "busy",
  http_302: "busy",
  no_answer: "busy",
};

test("nobody is told that a score is sent again when it is not", () => {
  for (const [dead, expected] of [
    [true, GIVEN_UP],
    [false, TRIED_AGAIN],
  ]) {
    for (const [problem, advice] of Object.entries(expected)) {
      assert.equal(adviceFor({ problem, dead }), advice, problem);
      assert.match(SENTENCES, new RegExp(`^lecturer-problem-${advice} = `, "m"));
    }
  }
});

import assert from "node:assert/strict";
import { test } from "node:test";
import { instant, local } from "../../../static/js/lecturer/local-time.js";

process.env.TZ = "Europe/Bucharest";

test("a time that nobody has changed is saved as it was, also in the hour that comes twice", () => {
  for (const time of ["2027-10-31T00:30:00+00:00", "2027-10-31T01:30:00+00:00", "2027-06-01T20:59:59.999000+00:00"]) {
    assert.equal(instant(local(time), time), time);
  }
});

test("a time that was changed is one of the browser's zone, in summer and in winter", () => {
  assert.equal(local("2027-10-31T01:30:00+00:00"), "2027-10-31T03:30");
  assert.equal(instant("2027-07-01T12:00", "2027-10-31T01:30:00+00:00"), "2027-07-01T09:00:00.000Z");
  assert.equal(instant("2027-12-01T12:00", null), "2027-12-01T10:00:00.000Z");
  assert.equal(instant("", "2027-10-31T01:30:00+00:00"), null);
});

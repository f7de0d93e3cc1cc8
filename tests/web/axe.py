"""What axe-core finds on a page, and at what price."""

import os
from typing import Any

from playwright.sync_api import Page

_RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
_OF_COLOURS = ["color-contrast", "link-in-text-block"]
"""The rules that depend on nothing but colours and sizes of text: the others see one page, light or dark."""
_FINDINGS = """async ([rules, switched]) => {
  for (const picture of document.querySelectorAll("svg[role=img]"))
    [...picture.querySelectorAll("circle")].slice(20).forEach((mark) => mark.remove());
  axe.configure({ noHtml: true });
  const { violations } = await axe.run(document, {
    runOnly: rules, rules: switched, resultTypes: ["violations"], elementRef: true, selectors: false,
    preload: false,
  });
  return violations.map(({ id, help, nodes }) => `${id}: ${help}: ` + nodes.slice(0, 4)
    .map(({ element, failureSummary }) => `${element.outerHTML.slice(0, 300)} ${failureSummary}`).join("; "));
}"""
"""Of the four thousand marks of a plot, which are alike, axe-core looks at a few; and elements are written
out only where they are at fault."""
_COLOURS_ARE_READ_ONCE = """(() => {
  const colour = axe.commons.color.Color.prototype, read = colour.parseString, known = new Map();
  colour.parseString = function (text) {
    if (known.has(text)) [this.r, this.g, this.b, this.alpha] = known.get(text);
    else read.call(this, text);
    known.set(text, [this.r, this.g, this.b, this.alpha]);
    return this;
  };
})()"""
"""For each element axe-core reads the colours of all that lie under it: the same dozen texts, thousands of
times, a quarter of what it costs."""
_PRIVATE_FIELDS_LIE_ON_THEIR_OBJECTS = """(() => {
  class OnObjects {
    #key = Symbol();
    constructor(entries = []) { for (const [object, value] of entries) this.set(object, value); }
    has(object) { return this.#key in Object(object); }
    get(object) { return object?.[this.#key]; }
    set(object, value) { object[this.#key] = value; return this; }
    add(object) { return this.set(object, true); }
    delete(object) { return this.has(object) && delete object[this.#key]; }
  }
  return [OnObjects, OnObjects];
})()"""
"""axe-core is translated for browsers without private fields and has them in WeakMaps, a quarter of its time:
each colour is such an object, and each is remembered until the garbage is collected."""
EVERYTHING = bool(os.environ.get("EVERYTHING"))
"""All rules in all colours at every width, and all pages in all languages (`make accessibility`)."""


class Axe:
    """axe-core's findings on a page as it stands now."""

    def __init__(self, source: str) -> None:
        self._source = f"((WeakMap, WeakSet) => {{ {source} }})(...{_PRIVATE_FIELDS_LIE_ON_THEIR_OBJECTS})"

    def assert_accessible(self, page: Page, *, light_colours: bool = True, dark_colours: bool = True) -> None:
        """Fail with what is found in a light page and, by the rules of colours, in a dark one.

        Where the system forces its colours, the rules of colours alone are checked, once: axe-core takes the
        dark ones of the style sheet for the text's.
        """
        if page.evaluate("() => !window.axe"):
            page.evaluate(self._source)
            page.evaluate(_COLOURS_ARE_READ_ONCE)
        off = {} if light_colours or EVERYTHING else {rule: {"enabled": False} for rule in _OF_COLOURS}
        forced = page.evaluate("matchMedia('(forced-colors: active)').matches")
        of_colours = {"type": "rule", "values": _OF_COLOURS}
        self._assert_nothing(page, of_colours if forced and not EVERYTHING else _RULES, off)
        if forced:
            return
        if not dark_colours and not EVERYTHING:
            return
        page.emulate_media(color_scheme="dark")
        self._assert_nothing(page, _RULES if EVERYTHING else of_colours, {})
        page.emulate_media(color_scheme="light")

    def _assert_nothing(self, page: Page, rules: Any, switched: dict[str, Any]) -> None:
        found = page.evaluate(_FINDINGS, [rules, switched])
        assert found == [], found

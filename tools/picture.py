"""The README's picture, from the live page: the PUMA exercise with a table typed and its robot moved.

python -m tools.picture          writes docs/images/form.png and docs/images/form-dark.png
"""

from playwright.sync_api import Browser, Page

from tools.web import ROOT, chromium, service

IMAGES = ROOT / "docs" / "images"
TABLE = {
    "convention": "modified",
    "angle_unit": "deg",
    "length_unit": "m",
    "rows": [
        {"joint": "revolute", "alpha": "0", "a": "0", "d": "0", "theta": "θ1"},
        {"joint": "revolute", "alpha": "-90", "a": "0", "d": "0", "theta": "θ2"},
        {"joint": "revolute", "alpha": "0", "a": "a2", "d": "d3", "theta": "θ3"},
        {"joint": "revolute", "alpha": "-90", "a": "a3", "d": "d4", "theta": "θ4"},
        {"joint": "revolute", "alpha": "90", "a": "0", "d": "0", "theta": "θ5"},
        {"joint": "revolute", "alpha": "-90", "a": "0", "d": "0", "theta": "θ6"},
    ],
}
JOINTS = ("20", "-35", "60", "0", "40", "0")


def answer(page: Page, origin: str) -> None:
    """Type the table, move the robot a little."""
    page.goto(f"{origin}/exercises/puma560?lang=en")
    page.locator("html[data-ready=true]").wait_for(state="attached")
    page.evaluate("table => (document.querySelector('dh-table-editor').table = table)", TABLE)
    page.locator("#own robot-scene[data-renderer=webgl]:not(.stale, [aria-busy])").wait_for()
    for i, value in enumerate(JOINTS, 1):
        page.get_by_label(f"q{i} in °").fill(value)
    page.wait_for_timeout(500)
    page.evaluate(
        "document.activeElement.blur(); document.querySelectorAll('*').forEach(e => e.scrollTo(0, 0))"
    )


def picture(browser: Browser, origin: str, name: str, scheme: str) -> None:
    """One picture, sharp enough for a dense display."""
    page = browser.new_page(
        viewport={"width": 1360, "height": 1240},
        device_scale_factor=1,
        color_scheme="dark" if scheme == "dark" else "light",
        reduced_motion="reduce",
    )
    answer(page, origin)
    page.screenshot(path=IMAGES / name)
    page.close()


def main() -> None:
    """Write the pictures."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    with service() as origin, chromium() as browser:
        picture(browser, origin, "form.png", "light")
        picture(browser, origin, "form-dark.png", "dark")


if __name__ == "__main__":
    main()

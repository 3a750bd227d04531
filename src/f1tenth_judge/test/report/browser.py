"""A headless Chromium for tests of the report."""

import contextlib
import shutil

import pytest

PATIENCE = 20.0  # wall s
_ARGUMENTS = ("headless=new", "no-sandbox", "disable-dev-shm-usage", "disable-gpu", "hide-scrollbars")


@contextlib.contextmanager
def chromium(width=1280, height=900, phone=False):
    """A browser window of this size (px); the test is skipped, saying why, where there is no browser."""
    webdriver = pytest.importorskip("selenium.webdriver", reason="python3-selenium is not installed")
    browser, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not (browser and driver):
        pytest.skip("chromium or chromium-driver is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    for argument in (*_ARGUMENTS, f"window-size={width},{height}"):
        options.add_argument(f"--{argument}")
    if phone:
        metrics = {"width": width, "height": height, "pixelRatio": 2.0}
        options.add_experimental_option("mobileEmulation", {"deviceMetrics": metrics})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    window = webdriver.Chrome(service=webdriver.chrome.service.Service(driver), options=options)
    try:
        yield window
    finally:
        window.quit()

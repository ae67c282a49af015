"""Chromium without a window, as the tests of the page use it: what it says, shows and holds."""

import io
import tempfile
import time

import numpy
from matplotlib import image
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

FLAGS = ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--disable-background-networking", "--no-first-run", "--disable-sync", "--disable-component-update",
         "--disable-dev-shm-usage", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1")


class Browser:
    """A page in a browser of its own; a context manager."""

    def __init__(self, width=1180, height=720, *, dark=False, mobile=False, reduced_motion=False):
        self.profile = tempfile.TemporaryDirectory(prefix="vesica-browser-", ignore_cleanup_errors=True)
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for flag in (*FLAGS, f"--window-size={width},{height}", f"--user-data-dir={self.profile.name}"):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_script_timeout(60)
        features = [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                    {"name": "prefers-reduced-motion", "value": "reduce" if reduced_motion else "no-preference"}]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile})

    def __enter__(self):
        return self

    def __exit__(self, *reason):
        self.driver.quit()
        self.profile.cleanup()

    def open(self, address):
        """Load a page and wait until it can be used."""
        self.driver.get(address)
        self.wait("return performance.getEntriesByName('vesica-usable').length > 0")
        return self

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not self.run(condition):
            if time.monotonic() > end:
                raise AssertionError(f"this did not come true: {condition}; the page said {self.complaints()}")
            time.sleep(0.05)

    def complaints(self):
        """What the page wrote to the console as warnings or errors."""
        return [entry for entry in self.driver.get_log("browser")
                if entry["level"] in ("WARNING", "SEVERE") and "GPU stall" not in entry["message"]]

    def shown_step(self):
        return self.run("return window.vesica.stage.shown?.step ?? null")

    def settle(self):
        """Wait until the frame that the slider names is drawn."""
        self.wait("const v = window.vesica; return v.stage.shown?.step === v.manifest.frames[v.store.get('frame')]?.step")
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def canvas(self):
        """The pixels of the 3D view as it appears, without what lies over it."""
        self.run("for (const e of document.querySelectorAll('.view > :not(canvas)')) e.style.visibility = 'hidden'")
        place = self.run("const r = document.getElementById('canvas').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]")
        shot = image.imread(io.BytesIO(self.driver.get_screenshot_as_png()), format="png")[:, :, :3]
        self.run("for (const e of document.querySelectorAll('.view > :not(canvas)')) e.style.visibility = ''")
        x, y, width, height = (round(value) for value in place)
        return shot[max(y, 0):y + height, x:x + width]


def colourful(pixels):
    """The share of pixels with a colour; backgrounds, boxes and walls have none to speak of."""
    return float(numpy.mean(pixels.max(axis=2) - pixels.min(axis=2) > 0.15))

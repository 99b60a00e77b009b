"""Drives report.html in a real Chromium without a window: report_page.py CLONE FOLDER"""

import base64
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

clone, work = map(pathlib.Path, sys.argv[1:])
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # WebDriver's name for a reference to an element
KEYS = {"tab": "\ue004", "enter": "\ue007", "right": "\ue014", "left": "\ue012", "home": "\ue011"}


def moved(x, y):
    return {"type": "pointerMove", "duration": 20, "x": int(x), "y": int(y)}


class Browser:
    """A session of WebDriver (W3C), by plain HTTP."""

    def __init__(self, width, height):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.base = f"http://127.0.0.1:{port}"
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL)
        for _ in range(100):
            try:
                urllib.request.urlopen(self.base + "/status").close()
                break
            except OSError:
                time.sleep(0.1)
        arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
                     "--disable-component-update", "--disable-sync", f"--user-data-dir={work}/profile-{width}",
                     f"--window-size={width},{height}"]
        capabilities = {"goog:chromeOptions": {"args": arguments}, "goog:loggingPrefs": {"browser": "ALL"}}
        self.session = ""
        session = self.ask("POST", "", {"capabilities": {"alwaysMatch": capabilities}})["sessionId"]
        self.session = "/" + session
        self.narrowed(width, height)

    def ask(self, method, path, body=None):
        data = None if method == "GET" else json.dumps(body or {}).encode()
        request = urllib.request.Request(f"{self.base}/session{self.session}{path}", data, method=method,
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(error.read().decode()[:500]) from error

    def develop(self, command, **parameters):
        return self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def narrowed(self, width, height):
        """As wide as a telephone: a window of Chromium's is not so narrow by itself."""
        self.develop("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def open(self, page):
        self.ask("POST", "/url", {"url": page.resolve().as_uri()})
        for _ in range(200):
            ready = self.run("return document.documentElement.dataset.ready")
            if ready:
                return int(ready)
            time.sleep(0.05)
        raise AssertionError(f"{page} is never ready: {self.log()}")

    def run(self, script, *arguments):
        return self.ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def find(self, selector):
        return self.ask("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector):
        self.ask("POST", f"/element/{self.find(selector)}/click")

    def act(self, kind, *actions):
        source = {"type": kind, "id": kind, "actions": list(actions)}
        if kind == "pointer":
            source["parameters"] = {"pointerType": "mouse"}
        self.ask("POST", "/actions", {"actions": [source]})

    def keys(self, *names):
        keys = [KEYS.get(name, name) for name in names]
        self.act("key", *({"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")))

    def point_at(self, x, y):
        self.act("pointer", moved(x, y))

    def drag(self, x, y, by_x, by_y):
        self.act("pointer", moved(x, y), {"type": "pointerDown", "button": 0}, moved(x + by_x, y + by_y),
                 {"type": "pointerUp", "button": 0})

    def turn_wheel(self, x, y, by):
        self.act("wheel", {"type": "scroll", "duration": 0, "x": int(x), "y": int(y), "deltaX": 0, "deltaY": by})

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def log(self):
        return self.ask("POST", "/se/log", {"type": "browser"})

    def picture(self, file, whole=True):
        got = self.develop("Page.captureScreenshot", captureBeyondViewport=whole)
        (work / file).write_bytes(base64.b64decode(got["data"]))

    def close(self):
        try:
            self.ask("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()


def study(name, stations, basins, rainfall, *options):
    folder = work / name
    subprocess.run([os.environ["THIESSEN"], "run", stations, basins, rainfall, "-o", folder, "-q", *options], check=True)
    return folder / "report.html"


def box_of(browser):
    return browser.run("return document.getElementById('map').getAttribute('viewBox')")


def fills(browser):
    return browser.run("return [...document.querySelectorAll('.cell')].map((cell) => cell.getAttribute('fill'))")


def middle_of(browser, selector):
    return browser.run("""const box = document.querySelector(arguments[0]).getBoundingClientRect();
        return [box.left + box.width / 2, box.top + box.height / 2]""", selector)


def column(browser, part, number):
    return browser.run("""return [...document.querySelectorAll('#' + arguments[0] + ' tbody tr')].map(
        (row) => row.cells[arguments[1]].textContent)""", part, number)


def check_map(browser):
    """Hover, pan and zoom, by mouse and by keys."""
    browser.run("document.getElementById('map').scrollIntoView({behavior: 'instant', block: 'center'})")
    x, y = middle_of(browser, "#map")
    browser.point_at(x, y)
    told = browser.text("#tip")
    assert re.fullmatch(r"Gauge .+\nBasin .+\n(Mean|Reading): .+\nWeight: [\d.]+", told), told
    assert browser.text("#info") == told
    whole = box_of(browser)
    browser.turn_wheel(x, y, -100)
    zoomed = box_of(browser)
    assert zoomed != whole
    browser.drag(x, y, 60, 40)
    dragged = box_of(browser)
    assert float(dragged.split()[0]) < float(zoomed.split()[0]), (zoomed, dragged)
    browser.run("document.getElementById('map').focus()")
    browser.keys("right")
    assert float(box_of(browser).split()[0]) > float(dragged.split()[0])
    browser.keys("+")
    assert float(box_of(browser).split()[2]) < float(dragged.split()[2])
    browser.keys("0")
    assert box_of(browser) == whole, (box_of(browser), whole)
    browser.click("#zoom-in")
    assert box_of(browser) != whole
    browser.click("#zoom-all")
    assert box_of(browser) == whole


def check_legend(browser):
    """The legend is there without the script; each colour of the map is in it, at every step."""
    shown = """return [...document.querySelectorAll('#legend ul:not([hidden]) rect[fill]')].map((rect) => rect.getAttribute('fill'))"""
    assert browser.run("return document.querySelectorAll('#mean-classes li').length") > 3
    assert set(fills(browser)) - {None} <= set(browser.run(shown))
    signs = browser.run("return [...document.querySelectorAll('#legend ul:last-child li')].map((item) => item.textContent)")
    assert signs == ["no reading", "rain gauge", "gauge without any reading"], signs
    browser.run("document.getElementById('step').focus()")
    browser.keys("right")
    assert set(fills(browser)) - {None} <= set(browser.run(shown))
    browser.keys("home")


def check_keyboard(browser):
    """A cell is reached by Tab, the next by N; what is told of it is in its label too."""
    browser.run("document.getElementById('map').focus()")
    browser.keys("tab")
    assert browser.run("return document.activeElement.classList.contains('cell')")
    first = browser.run("return document.activeElement.getAttribute('aria-label')")
    browser.keys("n")
    second = browser.run("return document.activeElement.getAttribute('aria-label')")
    assert first != second and second.startswith("Gauge ") and "Weight: " in second, (first, second)
    browser.keys("enter")
    basin = browser.run("return document.querySelector('#basin').selectedOptions[0].textContent")
    assert f"Basin {basin}," in second, (basin, second)
    for _ in range(12):
        browser.keys("+")
    outside = """const cell = document.activeElement.getBBox();
        const [x, y, width, height] = document.getElementById('map').getAttribute('viewBox').split(' ').map(Number);
        const middle = [cell.x + cell.width / 2 - x, cell.y + cell.height / 2 - y];
        return middle[0] < 0 || middle[1] < 0 || middle[0] > width || middle[1] > height"""
    for key in "n" * 20 + "p" * 20:
        browser.keys(key)
        assert not browser.run(outside), browser.run("return document.activeElement.getAttribute('aria-label')")
    browser.keys("0")


def check_slider(browser):
    """Each step has its text, its colours and its readings."""
    before = fills(browser)
    subtitle = browser.text("#subtitle")
    assert subtitle == "each gauge's mean over the steps it reports, of 120 time steps, mm per month", subtitle
    browser.run("document.getElementById('step').focus()")
    browser.keys("right", "right", "right")
    text = browser.run("return document.getElementById('step').getAttribute('aria-valuetext')")
    assert text == browser.text("#step-text") and "(3 of " in text, text
    assert fills(browser) != before
    assert browser.text("#subtitle") == "1988-03, mm per month", browser.text("#subtitle")
    browser.click("#before")
    assert "(2 of " in browser.text("#step-text")
    browser.run("document.getElementById('step').focus()")
    browser.keys("home")
    assert fills(browser) == before and browser.text("#subtitle") == subtitle
    assert browser.text("#step-text").startswith("mean of ")


def check_tables(browser):
    """Sorted by click and by keyboard, by number and by text."""
    head = "#basins-part thead th:nth-child(2)"
    browser.click(head + " button")
    areas = [float(text) for text in column(browser, "basins-part", 1)]
    assert areas == sorted(areas) and len(areas) > 1
    assert browser.run("return document.querySelector(arguments[0]).getAttribute('aria-sort')", head) == "ascending"
    browser.run("document.querySelector(arguments[0]).focus()", head + " button")
    browser.keys("enter")
    assert [float(text) for text in column(browser, "basins-part", 1)] == areas[::-1]
    assert browser.run("return document.querySelector(arguments[0]).getAttribute('aria-sort')", head) == "descending"
    browser.click("#weights-part thead th:nth-child(2) button")
    assert len(column(browser, "weights-part", 1)) > 1


def check_access(browser):
    """What a screen reader goes by: landmarks, names, captions; and nothing is wider than the page."""
    for landmark in ("header", "nav", "main", "footer"):
        assert browser.run("return document.querySelectorAll(arguments[0]).length", landmark) == 1, landmark
    nameless = browser.run("""return [...document.querySelectorAll('button, input, select')].filter((control) =>
        !control.textContent.trim() && !control.ariaLabel && !control.labels?.length).length""")
    assert nameless == 0
    assert browser.run("return [...document.querySelectorAll('table')].every((table) => table.caption)")
    assert browser.run("""return [...document.querySelectorAll('svg.chart')].every(
        (chart) => chart.querySelector('title').textContent.length > 16)""")
    wide = browser.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert wide <= 0, wide


def check_nothing_read(browser):
    """Where there is no reading no line is drawn at 0."""
    folder = work / "nothing-inputs"
    folder.mkdir()
    (folder / "stations.csv").write_text("id,x,y\nA,1,2\nB,8,2\n", encoding="utf-8")
    (folder / "basins.csv").write_text('id,WKT\nQ,"POLYGON ((0 0,10 0,10 4,0 4,0 0))"\n', encoding="utf-8")
    (folder / "rain.csv").write_text("time,A,B\n2020-01-01,,\n2020-01-02,NA,\n", encoding="utf-8")
    browser.open(study("nothing", folder / "stations.csv", folder / "basins.csv", folder / "rain.csv", "--metric", "planar"))
    for chart in ("hydrograph", "cumulative"):
        told = browser.text(f"#{chart}-caption")
        assert told == "Q has no value at any step: there is no reading." == browser.text(f"#{chart}-title"), told
    browser.run("document.getElementById('step').focus()")
    browser.keys("right")
    assert browser.text("#silence") == "At this step no gauge reports.", browser.text("#silence")
    browser.run("document.querySelector('.cell').focus()")
    assert "Reading: none\n" in browser.text("#info"), browser.text("#info")
    assert browser.run("return document.querySelectorAll('.chart .sum, .chart .error').length") == 0


def check_narrow(browser, page):
    """A label without a break does not widen the page; no button is over the map; headings have one ground."""
    label = "x" * 80
    folder = work / "label-inputs"
    folder.mkdir()
    (folder / "stations.csv").write_text("id,x,y\nA,1,2\nB,8,2\n", encoding="utf-8")
    (folder / "basins.csv").write_text('id,WKT\nQ,"POLYGON ((0 0,10 0,10 4,0 4,0 0))"\n', encoding="utf-8")
    (folder / "rain.csv").write_text(f"time,A,B\n{label},1,2\n", encoding="utf-8")
    browser.open(study("label", folder / "stations.csv", folder / "basins.csv", folder / "rain.csv", "--metric", "planar"))
    browser.run("document.getElementById('step').focus()")
    browser.keys("right")
    assert browser.text("#step-text").startswith(label)
    check_access(browser)
    browser.open(page)
    over = browser.run("""const map = document.getElementById('map').getBoundingClientRect();
        return [...document.querySelectorAll('button')].map((button) => button.getBoundingClientRect()).filter((box) =>
            box.right > map.left && box.left < map.right && box.bottom > map.top && box.top < map.bottom).length""")
    assert over == 0, over
    grounds = browser.run("""return [...document.querySelectorAll('.sortable thead')].map((head) => new Set(
        [...head.rows[0].cells].map((cell) => getComputedStyle(cell).backgroundColor + cell.getBoundingClientRect().height)).size)""")
    assert set(grounds) == {1}, grounds
    lines = browser.run("""return [...document.querySelectorAll('.sortable thead button')].map(
        (button) => Math.round((button.getBoundingClientRect().height - 6) / 20))""")
    assert max(lines) <= 3, lines
    bare = browser.run("""return [...document.querySelectorAll('.sortable thead button')].every(
        (button) => getComputedStyle(button).backgroundColor === 'rgba(0, 0, 0, 0)')""")
    assert bare


def check_print(browser, file):
    pages = base64.b64decode(browser.ask("POST", "/print", {"page": {"width": 21, "height": 29.7}}))
    (work / file).write_bytes(pages)
    assert pages.startswith(b"%PDF") and len(pages) > 20_000
    text = subprocess.run(["pdftotext", "-layout", work / file, "-"], check=True, capture_output=True, text=True).stdout
    assert "Cells and weights are those of the full network." in text and "longest silence" in text, text[:2000]
    of_weights = [page for page in text.split("\f") if re.search(r"^ *(\S+ ){1,2} *\d{6} +[\d.]+ +[01]\.\d+$", page, re.M)]
    assert len(of_weights) > 5, len(of_weights)
    for page in of_weights:
        assert re.search(r"basin +gauge( \S)? +area", page), page[:500]


def evil_study():
    """A gauge and a basin whose names would be markup."""
    evil = "</script><img src=x onerror=document.title='evil'>"
    folder = work / "evil-inputs"
    folder.mkdir()
    (folder / "stations.csv").write_text(f"id,x,y\n{evil},1,2\nB,8,2\n", encoding="utf-8")
    (folder / "basins.csv").write_text(f'id,WKT\n{evil},"POLYGON ((0 0,10 0,10 4,0 4,0 0))"\n', encoding="utf-8")
    (folder / "rain.csv").write_text(f"time,{evil},B\n2020-01-01,1.5,2.5\n2020-01-02,0,4\n", encoding="utf-8")
    return study("evil", folder / "stations.csv", folder / "basins.csv", folder / "rain.csv", "--metric", "planar"), evil


def gaps_study(policy):
    """Three gauges in a row, of which the second is silent at the second step."""
    folder = work / f"{policy}-inputs"
    folder.mkdir()
    (folder / "stations.csv").write_text("id,x,y\nA,1,2\nB,5,2\nC,9,2\n", encoding="utf-8")
    (folder / "basins.csv").write_text('id,WKT\nQ,"POLYGON ((0 0,10 0,10 4,0 4,0 0))"\n', encoding="utf-8")
    (folder / "rain.csv").write_text("time,A,B,C\nMonday,1,2,3\nTuesday,4,,8\n", encoding="utf-8")
    return study(policy, folder / "stations.csv", folder / "basins.csv", folder / "rain.csv", "--metric", "planar",
                 "--gaps", policy)


def check_silence(browser, policy, reading):
    """What is told of a step that was made by other cells than the map shows."""
    browser.open(gaps_study(policy))
    assert f"({policy})" in browser.text("#map-part") and "full network" in browser.text("#map-part")
    browser.run("document.getElementById('step').focus()")
    browser.keys("right")
    assert browser.text("#silence") == "At this step every gauge reports.", browser.text("#silence")
    browser.keys("right")
    assert browser.text("#silence") == "At this step 1 of 3 gauges is silent: B.", browser.text("#silence")
    browser.run("document.querySelectorAll('.cell')[1].focus()")
    told = browser.text("#info")
    assert told == (f"Gauge B\nBasin Q\nReading: none: {reading}\n"
                    "Weight: 0.4 in the full network; 2 of the basin's 3 gauges report"), told
    if policy != "strict":  # 4 and 8 have half of the basin each
        assert browser.text("#basin-text") == "6 mm at Tuesday; 2 of the basin's 3 gauges report", browser.text("#basin-text")


def long_study():
    folder = work / "long-inputs"
    folder.mkdir()
    (folder / "stations.csv").write_text("id,x,y\nA,1,2\nB,8,2\n", encoding="utf-8")
    (folder / "basins.csv").write_text(
        'id,WKT\nP,"POLYGON ((0 0,4 0,4 4,0 4,0 0))"\nQ,"POLYGON ((5 0,10 0,10 4,5 4,5 0))"\n', encoding="utf-8")
    rows = long_rows()
    with open(folder / "rain.csv", "w", encoding="utf-8") as table:
        table.write("time,A,B\n")
        table.writelines(f"{i},{a},{b}\n" for i, (a, b) in enumerate(rows))
    return study("long", folder / "stations.csv", folder / "basins.csv", folder / "rain.csv", "--metric", "planar")


def long_rows():
    """What A and B read: all of P's and of Q's rain, whose largest values fall at different times."""
    return [(99.5 if i == 54_321 else i % 7, i * 5 % 11) for i in range(100_000)]


def check_long_values(browser):
    """The text beside the basin tells, step by step, a value that the basin has in the steps that it names."""
    rows = long_rows()
    for number in range(2):
        texts = browser.run("""const basin = document.getElementById('basin');
            const slider = document.getElementById('step');
            const texts = [];
            basin.value = arguments[0];
            basin.dispatchEvent(new Event('change'));
            for (let step = 1; step <= slider.max; ++step) {
              slider.value = step;
              slider.dispatchEvent(new Event('input'));
              texts.push(document.getElementById('basin-text').textContent);
            }
            return texts""", str(number))
        for text in texts:
            found = re.fullmatch(r"largest of the (\d+) steps from (\d+) on: ([\d.]+) mm", text)
            assert found, text
            first = int(found[2])
            largest = max(row[number] for row in rows[first:first + int(found[1])])
            assert float(found[3]) == largest, (text, largest)
    print(f"= {2 * len(texts)} texts of a thinned series tell the largest value of the steps that they name")


def main():
    colorado = clone / "samples/colorado"
    textbook = clone / "samples/textbook"
    large = study("colorado", colorado / "stations.csv", colorado / "counties.geojson", colorado / "rainfall.csv",
                  "--basin-id", "name")
    small = study("textbook", textbook / "stations.csv", textbook / "basin.csv", textbook / "rainfall.csv",
                  "--metric", "planar")
    size = large.stat().st_size
    assert size < 1_500_000, size

    browser = Browser(1400, 900)
    try:
        ready = min(browser.open(large) for _ in range(3))
        assert ready < 1000, ready
        print(f"= 64 basins and 120 months: {size // 1000} kB, ready after {ready} ms")
        browser.picture("wide.png")
        check_access(browser)
        check_map(browser)
        check_legend(browser)
        check_keyboard(browser)
        check_slider(browser)
        check_tables(browser)
        check_print(browser, "report.pdf")
        browser.develop("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
        browser.run("""const slider = document.getElementById('step');
            slider.value = 40;
            slider.dispatchEvent(new Event('input'))""")
        browser.picture("dark.png")
        browser.develop("Emulation.setEmulatedMedia", features=[])
        browser.narrowed(390, 844)
        check_narrow(browser, large)
        check_access(browser)
        browser.picture("narrow.png")
        browser.open(small)
        check_access(browser)
        browser.picture("textbook-narrow.png")
        browser.narrowed(1400, 900)
        browser.open(small)
        browser.picture("textbook.png")
        check_nothing_read(browser)
        check_silence(browser, "retessellate", "its ground goes to gauges that report")
        check_silence(browser, "renormalise", "the weights of the others are scaled up")
        check_silence(browser, "strict", "so the basin has no value")
        page, evil = evil_study()
        browser.open(page)
        assert browser.run("return document.images.length") == 0
        assert browser.run("return document.title") == "Rainfall by Thiessen cells"
        browser.run("document.querySelector('.cell').focus()")
        assert f"Gauge {evil}\n" in browser.text("#info"), browser.text("#info")
        ready = browser.open(long_study())
        thinned = browser.text("#thinned")
        assert "of 100000 time steps each " in thinned, thinned
        assert "99.5" in browser.text("#hydrograph-title"), browser.text("#hydrograph-title")
        browser.picture("long.png")
        check_long_values(browser)
        print(f"= 100,000 steps are thinned, keep their largest, and are ready after {ready} ms")
        assert not browser.log(), browser.log()
    finally:
        browser.close()


main()

// The page of a study: map, time step, series and tables. Texts of the study are only ever set as
// text, never as markup.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const byId = (id) => document.getElementById(id);
  const unit = data.unit ? " " + data.unit : "";
  const map = byId("map");
  const cells = [...map.querySelectorAll(".cell")];
  const slider = byId("step");
  const svgNamespace = "http://www.w3.org/2000/svg";

  const element = (name, attributes, text) => {
    const made = document.createElementNS(svgNamespace, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    return made;
  };
  /// The numbers of a row; null where it has none.
  const numbers = (row, decimals) => row.split(",").map((text) => text === "" ? null : text / 10 ** decimals);
  const rounded = (value, digits) => String(Number(value.toPrecision(digits)));

  // ---- Readings and colours

  let step = 0;  // 0: the means over the series; n: the n-th time step
  let readings = null;  // of the gauges at the step that is shown

  /// Gauges at one place share a value: the mean of those that report.
  function valuesOfCells() {
    if (!readings) return data.cells.map((cell) => cell[3]);
    const sums = [];
    readings.forEach((reading, gauge) => {
      if (reading === null) return;
      const sum = sums[data.places[gauge]] ??= [0, 0];
      sum[0] += reading;
      sum[1] += 1;
    });
    return data.cells.map((cell) => {
      const sum = sums[data.places[cell[0]]];
      return sum ? sum[0] / sum[1] : null;
    });
  }

  function colourOf(value, classes) {
    if (value === null) return null;
    if (value === 0 && classes.dry) return classes.dry;
    const above = classes.bounds.filter((bound) => value >= bound).length;
    return classes.colours[Math.min(above, classes.colours.length - 1)] ?? null;
  }

  /// The range of a class, between its texts; the last and the first may be open.
  function rangeOf(classes, i) {
    const low = classes.ticks[i];
    const high = classes.ticks[i + 1];
    if (high === undefined) return low + unit;
    if (low === "") return "below " + high + unit;
    return high === "" ? "from " + low + unit : low + " to " + high + unit;
  }

  function drawLegend(classes) {
    const legend = byId("legend");
    legend.replaceChildren();
    const add = (colour, text) => {
      const item = document.createElement("li");
      const patch = element("svg", {"aria-hidden": "true", viewBox: "0 0 400 275"});
      patch.append(element("rect", colour ? {width: 400, height: 275, fill: colour} : {width: 400, height: 275}));
      item.append(patch, text);
      legend.append(item);
    };
    for (let i = classes.colours.length - 1; i >= 0; --i) add(classes.colours[i], rangeOf(classes, i));
    if (classes.dry) add(classes.dry, "0" + unit);
    add(null, "no reading");
  }

  let values = valuesOfCells();
  let legendOf = null;

  function drawCells() {
    const classes = readings ? data.classes : data.meanClasses;
    values.forEach((value, i) => {
      const colour = colourOf(value, classes);
      if (colour) cells[i].setAttribute("fill", colour);
      else cells[i].removeAttribute("fill");
    });
    if (legendOf !== classes) drawLegend(classes);
    legendOf = classes;
  }

  // ---- The time step

  function textOfStep() {
    const count = data.times.length;
    if (step === 0) return `mean of ${data.steps} ${data.steps === 1 ? "step" : "steps"}`;
    const time = data.times[step - 1];
    if (data.length === 1) return `${time} (${step} of ${count})`;
    return `${time}, the wettest of ${Math.min(data.length, data.steps - (step - 1) * data.length)} steps (${step} of ${count})`;
  }

  function show(wanted) {
    step = Math.max(0, Math.min(data.times.length, wanted));
    readings = step > 0 && data.readings ? numbers(data.readings[step - 1], data.readingDecimals) : null;
    values = valuesOfCells();
    slider.value = step;
    const text = textOfStep();
    slider.setAttribute("aria-valuetext", text);
    byId("step-text").textContent = text;
    byId("before").disabled = step === 0;
    byId("after").disabled = step === data.times.length;
    drawCells();
    tellOf(shown);
    drawNow();
  }

  let player = 0;
  function play(on) {
    clearInterval(player);
    player = 0;
    const button = byId("play");
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(on));
    if (!on) return;
    if (step === data.times.length) show(0);
    player = setInterval(() => {
      show(step + 1);
      if (step === data.times.length) play(false);
    }, 400);
  }

  slider.max = data.times.length;
  slider.addEventListener("input", () => { play(false); show(Number(slider.value)); });
  byId("before").addEventListener("click", () => { play(false); show(step - 1); });
  byId("after").addEventListener("click", () => { play(false); show(step + 1); });
  byId("play").addEventListener("click", () => play(!player));

  // ---- What is told of a cell

  let shown = -1;  // the cell that is told of; -1: none

  function textOfCell(i) {
    const [gauge, basin, weight] = data.cells[i];
    const reading = readings ? readings[gauge] : data.cells[i][3];
    const what = step > 0 && !data.readings || step === 0 ? "Mean" : "Reading";
    return `Gauge ${data.gauges[gauge]}\nBasin ${data.basins[basin].name}\n` +
        `${what}: ${reading === null ? "none" : rounded(reading, 6) + unit}\nWeight: ${weight}`;
  }

  function tellOf(i) {
    shown = i;
    if (i < 0) return;
    const text = textOfCell(i);
    if (byId("info").textContent !== text) byId("info").textContent = text;
    cells[i].setAttribute("aria-label", text.replaceAll("\n", ", "));
    byId("chosen").setAttribute("d", cells[i].getAttribute("d"));
  }

  const tip = byId("tip");
  function placeTip(event, i) {
    tip.textContent = textOfCell(i);
    tip.hidden = false;
    const frame = map.getBoundingClientRect();
    const x = event.clientX - frame.left, y = event.clientY - frame.top;
    tip.style.left = Math.max(0, Math.min(x + 14, frame.width - tip.offsetWidth)) + "px";
    tip.style.top = (y + 18 + tip.offsetHeight > frame.height ? Math.max(0, y - tip.offsetHeight - 10) : y + 18) + "px";
  }

  const numberOf = new Map(cells.map((cell, i) => [cell, i]));
  map.addEventListener("pointermove", (event) => {
    const i = numberOf.get(event.target);
    if (i === undefined || dragged) { tip.hidden = true; return; }
    if (i !== shown) tellOf(i);
    placeTip(event, i);
  });
  map.addEventListener("pointerleave", () => { tip.hidden = true; });
  map.addEventListener("focusin", (event) => {
    const i = numberOf.get(event.target);
    if (i !== undefined) tellOf(i);
  });

  // One cell at a time is a stop of the Tab key; N and P go from cell to cell.
  let stop = 0;
  function goTo(i) {
    cells[stop].tabIndex = -1;
    stop = (i + cells.length) % cells.length;
    cells[stop].tabIndex = 0;
    cells[stop].focus({preventScroll: true});
  }
  cells.forEach((cell, i) => {
    cell.tabIndex = i === 0 ? 0 : -1;
    cell.setAttribute("aria-label", `Gauge ${data.gauges[data.cells[i][0]]}, basin ${data.basins[data.cells[i][1]].name}`);
  });

  // ---- Pan and zoom

  const whole = map.getAttribute("viewBox").split(" ").map(Number);
  let box = [...whole];
  let dragged = false;

  function setBox(x, y, width) {
    const size = Math.max(whole[2] / 400, Math.min(whole[2], width));
    const height = size * whole[3] / whole[2];
    box = [Math.max(whole[0] - size / 2, Math.min(whole[0] + whole[2] - size / 2, x)),
           Math.max(whole[1] - height / 2, Math.min(whole[1] + whole[3] - height / 2, y)), size, height];
    if (size === whole[2] && !dragged) box = [...whole];
    map.setAttribute("viewBox", box.map((number) => String(Math.round(number * 10) / 10)).join(" "));
  }
  /// Zooms so that the place at these shares of the map's sides stays where it is.
  function zoom(factor, atX = .5, atY = .5) {
    const size = Math.max(whole[2] / 400, Math.min(whole[2], box[2] * factor));
    const height = size * whole[3] / whole[2];
    setBox(box[0] + (box[2] - size) * atX, box[1] + (box[3] - height) * atY, size);
  }
  const pan = (x, y) => { dragged = true; setBox(box[0] + x * box[2], box[1] + y * box[3], box[2]); dragged = false; };

  const unitsPerPixel = (frame) => Math.max(box[2] / frame.width, box[3] / frame.height);

  map.addEventListener("wheel", (event) => {
    if (event.deltaY > 0 && box[2] === whole[2]) return;  // the page scrolls on
    event.preventDefault();
    // The map stands in the middle of its frame where their shapes differ.
    const frame = map.getBoundingClientRect();
    const units = unitsPerPixel(frame);
    zoom(event.deltaY > 0 ? 1.25 : .8, .5 + (event.clientX - frame.left - frame.width / 2) * units / box[2],
         .5 + (event.clientY - frame.top - frame.height / 2) * units / box[3]);
  }, {passive: false});
  let grip = null;
  map.addEventListener("pointerdown", (event) => {
    if (event.button === 0) grip = {x: event.clientX, y: event.clientY, box: [...box]};
  });
  window.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const frame = map.getBoundingClientRect();
    const x = event.clientX - grip.x, y = event.clientY - grip.y;
    if (!dragged && Math.hypot(x, y) < 4) return;
    dragged = true;
    map.classList.add("dragged");
    const units = unitsPerPixel(frame);
    setBox(grip.box[0] - x * units, grip.box[1] - y * units, box[2]);
  });
  const letGo = () => {
    grip = null;
    map.classList.remove("dragged");
    setTimeout(() => { dragged = false; });  // after the click that ends a drag
  };
  window.addEventListener("pointerup", letGo);
  window.addEventListener("pointercancel", letGo);
  map.addEventListener("click", (event) => {
    const i = numberOf.get(event.target);
    if (i === undefined || dragged) return;
    goTo(i);
    chooseBasin(data.cells[i][1]);
  });
  map.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const isCell = numberOf.has(event.target);
    const actions = {
      ArrowLeft: () => pan(-.1, 0), ArrowRight: () => pan(.1, 0), ArrowUp: () => pan(0, -.1), ArrowDown: () => pan(0, .1),
      "+": () => zoom(.8), "=": () => zoom(.8), "-": () => zoom(1.25), "0": () => setBox(whole[0], whole[1], whole[2]),
      n: () => goTo(isCell ? stop + 1 : stop), p: () => goTo(isCell ? stop - 1 : stop),
      Home: () => goTo(0), End: () => goTo(cells.length - 1),
      Enter: () => { if (isCell) chooseBasin(data.cells[stop][1]); },
    };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || cells.length === 0) return;
    event.preventDefault();
    action();
  });
  byId("zoom-in").addEventListener("click", () => zoom(.7));
  byId("zoom-out").addEventListener("click", () => zoom(1 / .7));
  byId("zoom-all").addEventListener("click", () => setBox(whole[0], whole[1], whole[2]));

  // ---- The series of a basin

  let basin = 0;
  const charts = ["hydrograph", "cumulative"].map(byId);
  const edge = {left: 58, right: 14, top: 22, bottom: 26};
  const height = 230;
  let paperWidth = 0;  // of a chart in print; 0 on a screen

  /// Round values from 0, or a rounder value below, to the largest.
  function ticksTo(low, high) {
    const rough = (high - low) / 4 || 1;
    const power = 10 ** Math.floor(Math.log10(rough));
    const size = [1, 2, 5, 10].find((factor) => factor * power >= rough) * power;
    const ticks = [];
    for (let i = Math.floor(low / size); (i - 1) * size < high; ++i) ticks.push(Number((i * size).toPrecision(12)));
    return ticks;
  }

  /// Empties a chart and gives it axes; returns where values and steps stand.
  function frameOf(chart, low, high) {
    const width = paperWidth || Math.max(260, chart.clientWidth || 700);
    const count = Math.max(1, data.times.length);
    const ticks = ticksTo(low, high);
    const first = ticks[0], last = ticks[ticks.length - 1];
    const y = (value) => height - edge.bottom - (value - first) / (last - first || 1) * (height - edge.top - edge.bottom);
    const x = (i) => edge.left + (i + .5) / count * (width - edge.left - edge.right);
    chart.setAttribute("viewBox", `0 0 ${width} ${height}`);
    chart.replaceChildren(chart.querySelector("title"));
    for (const tick of ticks) {
      chart.append(element("path", {class: "axis", d: `M${edge.left} ${y(tick)}H${width - edge.right}`}));
      chart.append(element("text", {x: edge.left - 6, y: y(tick) + 4, "text-anchor": "end"}, String(tick)));
    }
    if (data.unit) chart.append(element("text", {x: 0, y: 9}, data.unit));
    const labels = Math.max(1, Math.min(count, Math.floor(width / 170)));
    for (let k = 0; k < labels; ++k) {
      const i = labels === 1 ? 0 : Math.round(k * (count - 1) / (labels - 1));
      const anchor = labels === 1 ? "middle" : k === 0 ? "start" : k === labels - 1 ? "end" : "middle";
      const at = labels > 1 && k === 0 ? edge.left : labels > 1 && k === labels - 1 ? width - edge.right : x(i);
      const time = data.times[i] ?? "";
      chart.append(element("text", {x: at, y: height - 8, "text-anchor": anchor}, time.length > 24 ? time.slice(0, 23) + "\u2026" : time));
    }
    const now = element("path", {class: "now"});
    chart.append(now);
    return {x, y, now, width, bar: Math.max(1, Math.min(60, (width - edge.left - edge.right) / count * .8))};
  }

  let frames = [];

  function drawNow() {
    for (const frame of frames) {
      if (step === 0) frame.now.removeAttribute("d");
      else frame.now.setAttribute("d", `M${frame.x(step - 1)} ${edge.top}V${height - edge.bottom}`);
    }
    byId("basin-text").textContent = "";
    if (step === 0 || data.basins.length === 0) return;
    const value = series.largest[step - 1];
    const what = data.length === 1 ? "" : "largest of the stretch: ";
    byId("basin-text").textContent = value === null ? "no value at this step" : `${what}${rounded(value, 5)}${unit} at ${data.times[step - 1]}`;
  }

  let series = {largest: []};

  function barsOf(frame, from, to) {
    let path = "";
    from.forEach((value, i) => {
      if (to[i] !== null && value !== null) path += `M${frame.x(i).toFixed(1)} ${frame.y(value).toFixed(1)}V${frame.y(to[i]).toFixed(1)}`;
    });
    return path;
  }

  function drawHydrograph(name) {
    const known = series.largest.filter((value) => value !== null);
    const low = Math.min(0, ...(series.least ?? series.largest).filter((value) => value !== null));
    const frame = frameOf(charts[0], low, known.reduce((a, b) => Math.max(a, b), 0) || 1);
    const zero = series.largest.map(() => 0);
    const add = (kind, path) => charts[0].insertBefore(element("path", {class: kind, d: path, "stroke-width": frame.bar}), frame.now);
    if (series.least) {
      add("range", barsOf(frame, zero, series.largest));
      add("least", barsOf(frame, zero, series.least));
    } else {
      add("bars", barsOf(frame, zero, series.largest));
    }
    byId("hydrograph-title").textContent = `Hydrograph of ${name}: ${known.length} bars up to ${rounded(Math.max(...known, 0), 5)}${unit}`;
    byId("hydrograph-caption").textContent = `Areal rainfall of ${name}` +
        (series.least ? ": the largest (light) and the least (dark) of each " + data.length + " steps" : ", by time step");
    return frame;
  }

  function drawCumulative(name) {
    const told = data.basins[basin];
    let total = 0;
    const sums = (series.sums ?? series.largest).map((value) => total += value ?? 0);
    const half = told.error === undefined ? 0 : 1.96 * told.error * told.values;
    const frame = frameOf(charts[1], Math.min(0, ...sums, total - half < 0 && total < 0 ? total - half : 0), Math.max(total + half, ...sums) || 1);
    const path = sums.map((sum, i) => `${i === 0 ? "M" : "L"}${frame.x(i).toFixed(1)} ${frame.y(sum).toFixed(1)}`).join("");
    charts[1].insertBefore(element("path", {class: sums.length === 1 ? "sum dot" : "sum", d: sums.length === 1 ? path + "h.01" : path, "stroke-linecap": "round"}), frame.now);
    let bar = "The gauges do not tell a 95 % bar.";
    if (told.error !== undefined) {
      const x = frame.x(sums.length - 1), top = frame.y(total + half), bottom = frame.y(Math.max(total - half, Math.min(0, total)));
      charts[1].insertBefore(element("path", {class: "error", d: `M${x - 5} ${top}h10M${x} ${top}V${bottom}M${x - 5} ${bottom}h10`}), frame.now);
      bar = `95 % bar: ${rounded(Math.max(0, total - half), 4)} to ${rounded(total + half, 4)}${unit}; ` +
          `of the mean ${rounded(Math.max(0, told.mean - 1.96 * told.error), 4)} to ${rounded(told.mean + 1.96 * told.error, 4)}${unit}.`;
    }
    const text = `Cumulative rain of ${name}: ${rounded(total, 5)}${unit} in ${told.values} ${told.values === 1 ? "step" : "steps"} with a value.`;
    byId("cumulative-title").textContent = text;
    byId("cumulative-caption").textContent = text + " " + bar;
    return frame;
  }

  function drawCharts() {
    if (data.basins.length === 0) return;
    const name = data.basins[basin].name;
    frames = [drawHydrograph(name), drawCumulative(name)];
    drawNow();
  }

  function chooseBasin(number) {
    basin = number;
    byId("basin").value = String(number);
    const read = (rows) => rows && numbers(rows[number], data.decimals);
    series = {largest: read(data.largest), least: read(data.least), sums: read(data.sums)};
    series.largest.length = data.times.length;
    drawCharts();
  }

  data.basins.forEach((told, i) => byId("basin").append(new Option(told.name, String(i))));
  byId("basin").addEventListener("change", () => chooseBasin(Number(byId("basin").value)));
  charts.forEach((chart, i) => chart.addEventListener("click", (event) => {
    const frame = chart.getBoundingClientRect();
    const at = (event.clientX - frame.left) / frame.width * frames[i].width;
    const share = (at - edge.left) / (frames[i].width - edge.left - edge.right);
    if (share >= 0 && share <= 1) show(Math.min(data.times.length, Math.floor(share * data.times.length) + 1));
  }));
  let drawnWidth = 0;
  new ResizeObserver(() => {
    if (charts[0].clientWidth === drawnWidth) return;
    drawnWidth = charts[0].clientWidth;
    drawCharts();
  }).observe(charts[0]);

  window.addEventListener("beforeprint", () => { paperWidth = 680; drawCharts(); });
  window.addEventListener("afterprint", () => { paperWidth = 0; drawCharts(); });

  // ---- Tables

  const collator = new Intl.Collator(undefined, {numeric: true});

  function sortBy(table, column, ascending) {
    const body = table.tBodies[0];
    const isNumber = table.tHead.rows[0].cells[column].classList.contains("n");
    const keyed = [...body.rows].map((row) => {
      const text = row.cells[column].textContent;
      return {row, text, number: parseFloat(text)};
    });
    const order = ascending ? 1 : -1;
    keyed.sort((a, b) => {
      if (!isNumber) return order * collator.compare(a.text, b.text);
      if (isNaN(a.number) || isNaN(b.number)) return isNaN(a.number) - isNaN(b.number);  // none stand last
      return order * (a.number - b.number);
    });
    body.append(...keyed.map((item) => item.row));
  }

  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => head.firstElementChild.addEventListener("click", () => {
      const ascending = head.getAttribute("aria-sort") !== "ascending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
      sortBy(table, column, ascending);
    }));
  }

  show(0);
  if (data.basins.length > 0) chooseBasin(0);
  document.documentElement.dataset.ready = String(Math.ceil(performance.now()));
})();

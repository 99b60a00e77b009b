// The page of a study: its cells and their readings at the time step that is chosen.

const data = JSON.parse(byId("data").textContent);
const unit = data.unit ? " " + data.unit : "";
const map = byId("map");
const cells = [...map.querySelectorAll(".cell")];
const slider = byId("step");
const view = viewOf(map);
const charts = chartsOf(data, show, textOfReporting);

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

// ---- Who reports

/// What a silent gauge means for the value of its basin, by the policy for gaps.
const afterSilence = {
  retessellate: "its ground goes to gauges that report",
  renormalise: "the weights of the others are scaled up",
  strict: "so the basin has no value",
}[data.gaps];

const gaugesOf = data.basins.map(() => []);  // that have a cell in each basin
data.cells.forEach(([gauge, basin]) => gaugesOf[basin].push(gauge));

/// How many of a basin's gauges report at the step that is shown; empty where that is not known.
function textOfReporting(basin) {
  if (!readings) return "";
  const gauges = gaugesOf[basin];
  const reporting = gauges.filter((gauge) => readings[gauge] !== null).length;
  if (gauges.length === 1) return reporting === 1 ? "the basin's gauge reports" : "the basin's gauge is silent";
  if (reporting === gauges.length) return `all of the basin's ${reporting} gauges report`;
  return `${reporting} of the basin's ${gauges.length} gauges report`;
}

/// Which gauges are silent at the step that is shown.
function textOfSilence() {
  if (!readings) return "";
  const silent = data.gauges.filter((_, gauge) => readings[gauge] === null);
  if (silent.length === 0) return "At this step every gauge reports.";
  if (silent.length === data.gauges.length) return "At this step no gauge reports.";
  const most = 5;
  const named = silent.slice(0, most).join(", ") + (silent.length > most ? ` and ${silent.length - most} more` : "");
  return `At this step ${silent.length} of ${data.gauges.length} gauges ${silent.length === 1 ? "is" : "are"} silent: ${named}.`;
}

let values = valuesOfCells();
function drawCells() {
  const classes = readings ? data.classes : data.meanClasses;
  values.forEach((value, i) => {
    const colour = colourOf(value, classes);
    if (colour) cells[i].setAttribute("fill", colour);
    else cells[i].removeAttribute("fill");
  });
  byId("mean-classes").hidden = Boolean(readings);
  if (data.classes) byId("step-classes").hidden = !readings;
}

// ---- The time step

const textOfMeans = byId("what").textContent;

function textOfTime() {
  const steps = stepsOf(data, step);
  return data.times[step - 1] + (steps === 1 ? "" : `, the wettest of ${steps} steps`);
}

function textOfStep() {
  if (step === 0) return `mean of ${data.steps} ${data.steps === 1 ? "step" : "steps"}`;
  return `${textOfTime()} (${step} of ${data.times.length})`;
}

function show(wanted) {
  step = Math.max(0, Math.min(data.times.length, wanted));
  readings = step > 0 && data.readings ? numbers(data.readings[step - 1], data.readingDecimals) : null;
  values = valuesOfCells();
  slider.value = step;
  const text = textOfStep();
  slider.setAttribute("aria-valuetext", text);
  byId("step-text").textContent = text;
  byId("what").textContent = readings ? textOfTime() : textOfMeans;
  byId("silence").textContent = textOfSilence();
  byId("before").disabled = step === 0;
  byId("after").disabled = step === data.times.length;
  drawCells();
  tellOf(shown);
  charts.showStep(step);
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

// The outlines of cells that the antimeridian cuts, without the cut.
const edgesOf = new Map([...map.querySelectorAll("#edges path")].map((path) => [path.dataset.cell, path]));
let shown = -1;  // the cell that is told of; -1: none

function textOfCell(i) {
  const [gauge, basin, weight] = data.cells[i];
  const reading = readings ? readings[gauge] : data.cells[i][3];
  const what = step > 0 && !data.readings || step === 0 ? "Mean" : "Reading";
  const none = readings?.some((reading) => reading !== null) ? `none: ${afterSilence}` : "none";
  const reporting = textOfReporting(basin);
  return `Gauge ${data.gauges[gauge]}\nBasin ${data.basins[basin].name}\n` +
      `${what}: ${reading === null ? none : rounded(reading, 6) + unit}\nWeight: ${weight}` +
      (reporting ? ` in the full network; ${reporting}` : "");
}

function tellOf(i) {
  shown = i;
  if (i < 0) return;
  const text = textOfCell(i);
  byId("info").classList.remove("hint");
  if (byId("info").textContent !== text) byId("info").textContent = text;
  cells[i].setAttribute("aria-label", text.replaceAll("\n", ", "));
  byId("chosen").setAttribute("d", (edgesOf.get(String(i)) ?? cells[i]).getAttribute("d"));
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
  if (i === undefined || view.isDragged()) { tip.hidden = true; return; }
  if (i !== shown) tellOf(i);
  placeTip(event, i);
});
map.addEventListener("pointerleave", () => { tip.hidden = true; });
map.addEventListener("focusin", (event) => {
  const i = numberOf.get(event.target);
  if (i === undefined) return;
  tellOf(i);
  // A cell that is clicked is seen; moving it away from under the pointer would startle.
  if (cells[i].matches(":focus-visible")) view.reveal(cells[i].getBBox());
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

map.addEventListener("click", (event) => {
  const i = numberOf.get(event.target);
  if (i === undefined || view.isDragged()) return;
  goTo(i);
  charts.chooseBasin(data.cells[i][1]);
});
map.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const isCell = numberOf.has(event.target);
  const actions = {
    ArrowLeft: () => view.pan(-.1, 0), ArrowRight: () => view.pan(.1, 0),
    ArrowUp: () => view.pan(0, -.1), ArrowDown: () => view.pan(0, .1),
    "+": () => view.zoom(.8), "=": () => view.zoom(.8), "-": () => view.zoom(1.25), "0": view.showAll,
    n: () => goTo(isCell ? stop + 1 : stop), p: () => goTo(isCell ? stop - 1 : stop),
    Home: () => goTo(0), End: () => goTo(cells.length - 1),
    Enter: () => { if (isCell) charts.chooseBasin(data.cells[stop][1]); },
  };
  const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!action || cells.length === 0) return;
  event.preventDefault();
  action();
});
byId("zoom-in").addEventListener("click", () => view.zoom(.7));
byId("zoom-out").addEventListener("click", () => view.zoom(1 / .7));
byId("zoom-all").addEventListener("click", view.showAll);

makeSortable();
show(0);
if (data.basins.length > 0) charts.chooseBasin(0);
document.documentElement.dataset.ready = String(Math.ceil(performance.now()));

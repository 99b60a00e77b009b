// The series of a basin as charts: its hydrograph and its cumulative rain.

/// Draws the charts of the basin that is chosen; `goTo(step)` is called where one is
/// clicked, and `textOfReporting(basin)` says who reports at the step that is shown.
function chartsOf(data, goTo, textOfReporting) {
  const unit = data.unit ? " " + data.unit : "";
  let basin = 0;
  let step = 0;
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
      chart.append(svgElement("path", {class: "axis", d: `M${edge.left} ${y(tick)}H${width - edge.right}`}));
      chart.append(svgElement("text", {x: edge.left - 6, y: y(tick) + 4, "text-anchor": "end"}, String(tick)));
    }
    if (data.unit) chart.append(svgElement("text", {x: 0, y: 9}, data.unit));
    const labels = Math.max(1, Math.min(count, Math.floor(width / 170)));
    for (let k = 0; k < labels; ++k) {
      const i = labels === 1 ? 0 : Math.round(k * (count - 1) / (labels - 1));
      const anchor = labels === 1 ? "middle" : k === 0 ? "start" : k === labels - 1 ? "end" : "middle";
      const at = labels > 1 && k === 0 ? edge.left : labels > 1 && k === labels - 1 ? width - edge.right : x(i);
      const time = (data.begins ?? data.times)[i] ?? "";
      chart.append(svgElement("text", {x: at, y: height - 8, "text-anchor": anchor}, time.length > 24 ? time.slice(0, 23) + "\u2026" : time));
    }
    const now = svgElement("path", {class: "now"});
    chart.append(now);
    return {x, y, now, width, bar: Math.max(1, Math.min(60, (width - edge.left - edge.right) / count * .8))};
  }

  let frames = [];

  /// The value of a step; of several, whose largest may be at another time in each basin, it is told
  /// where they begin.
  function textOfValue() {
    const value = series.largest[step - 1];
    const steps = stepsOf(data, step);
    if (value === null) return steps === 1 ? "no value at this step" : `no value in these ${steps} steps`;
    const text = rounded(value, 5) + unit;
    if (steps > 1) return `largest of the ${steps} steps from ${data.begins[step - 1]} on: ${text}`;
    const reporting = textOfReporting(basin);
    return `${text} at ${data.times[step - 1]}${reporting && "; " + reporting}`;
  }

  function showStep(wanted) {
    step = wanted;
    for (const frame of frames) {
      if (step === 0) frame.now.removeAttribute("d");
      else frame.now.setAttribute("d", `M${frame.x(step - 1)} ${edge.top}V${height - edge.bottom}`);
    }
    byId("basin-text").textContent = step === 0 || data.basins.length === 0 ? "" : textOfValue();
  }

  let series = {largest: []};

  function barsOf(frame, from, to) {
    let path = "";
    from.forEach((value, i) => {
      if (to[i] !== null && value !== null) path += `M${frame.x(i).toFixed(1)} ${frame.y(value).toFixed(1)}V${frame.y(to[i]).toFixed(1)}`;
    });
    return path;
  }

  const isReadAnywhere = data.cells.some(([, , , mean]) => mean !== null);

  /// Says that a basin has no value, and, where it is so, why.
  const textOfNone = (name) => `${name} has no value at any step` + (isReadAnywhere ? "." : ": there is no reading.");

  function drawHydrograph(name) {
    const known = series.largest.filter((value) => value !== null);
    const low = Math.min(0, ...(series.least ?? series.largest).filter((value) => value !== null));
    const frame = frameOf(charts[0], low, known.reduce((a, b) => Math.max(a, b), 0) || 1);
    const zero = series.largest.map(() => 0);
    const add = (kind, path) => charts[0].insertBefore(svgElement("path", {class: kind, d: path, "stroke-width": frame.bar}), frame.now);
    if (series.least) {
      add("range", barsOf(frame, zero, series.largest));
      add("least", barsOf(frame, zero, series.least));
    } else {
      add("bars", barsOf(frame, zero, series.largest));
    }
    byId("hydrograph-title").textContent = known.length === 0 ? textOfNone(name) : `Hydrograph of ${name}: ${known.length} bars up to ${rounded(Math.max(...known, 0), 5)}${unit}`;
    byId("hydrograph-caption").textContent = known.length === 0 ? textOfNone(name) : `Areal rainfall of ${name}` +
        (series.least ? ": the largest (light) and the least (dark) of each " + data.length + " steps" : ", by time step");
    return frame;
  }

  function drawCumulative(name) {
    const told = data.basins[basin];
    if (told.values === 0) {
      byId("cumulative-title").textContent = byId("cumulative-caption").textContent = textOfNone(name);
      return frameOf(charts[1], 0, 1);
    }
    let total = 0;
    const sums = (series.sums ?? series.largest).map((value) => total += value ?? 0);
    const half = told.error === undefined ? 0 : 1.96 * told.error * told.values;
    const frame = frameOf(charts[1], Math.min(0, ...sums, total - half < 0 && total < 0 ? total - half : 0), Math.max(total + half, ...sums) || 1);
    const path = sums.map((sum, i) => `${i === 0 ? "M" : "L"}${frame.x(i).toFixed(1)} ${frame.y(sum).toFixed(1)}`).join("");
    charts[1].insertBefore(svgElement("path", {class: sums.length === 1 ? "sum dot" : "sum", d: sums.length === 1 ? path + "h.01" : path, "stroke-linecap": "round"}), frame.now);
    let bar = "The gauges do not tell a 95 % bar.";
    if (told.error !== undefined) {
      const x = frame.x(sums.length - 1), top = frame.y(total + half), bottom = frame.y(Math.max(total - half, Math.min(0, total)));
      charts[1].insertBefore(svgElement("path", {class: "error", d: `M${x - 5} ${top}h10M${x} ${top}V${bottom}M${x - 5} ${bottom}h10`}), frame.now);
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
    showStep(step);
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
    if (share >= 0 && share <= 1) goTo(Math.min(data.times.length, Math.floor(share * data.times.length) + 1));
  }));
  let drawnWidth = 0;
  new ResizeObserver(() => {
    if (charts[0].clientWidth === drawnWidth) return;
    drawnWidth = charts[0].clientWidth;
    drawCharts();
  }).observe(charts[0]);

  window.addEventListener("beforeprint", () => { paperWidth = 680; drawCharts(); });
  window.addEventListener("afterprint", () => { paperWidth = 0; drawCharts(); });

  return {chooseBasin, showStep};
}

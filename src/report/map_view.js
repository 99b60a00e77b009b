// The part of the map that is seen: it is moved by dragging, and zoomed by the wheel.

/// Returns what moves the view of an SVG, in shares of its sides.
function viewOf(map) {
  const whole = map.getAttribute("viewBox").split(" ").map(Number);
  let box = [...whole];
  let isDragged = false;

  function setBox(x, y, width) {
    const size = Math.max(whole[2] / 400, Math.min(whole[2], width));
    const height = size * whole[3] / whole[2];
    box = [Math.max(whole[0] - size / 2, Math.min(whole[0] + whole[2] - size / 2, x)),
           Math.max(whole[1] - height / 2, Math.min(whole[1] + whole[3] - height / 2, y)), size, height];
    if (size === whole[2] && !isDragged) box = [...whole];
    map.setAttribute("viewBox", box.map((number) => String(Math.round(number * 10) / 10)).join(" "));
  }
  /// Zooms so that the place at these shares of the map's sides stays where it is.
  function zoom(factor, atX = .5, atY = .5) {
    const size = Math.max(whole[2] / 400, Math.min(whole[2], box[2] * factor));
    const height = size * whole[3] / whole[2];
    setBox(box[0] + (box[2] - size) * atX, box[1] + (box[3] - height) * atY, size);
  }
  function pan(x, y) {
    isDragged = true;
    setBox(box[0] + x * box[2], box[1] + y * box[3], box[2]);
    isDragged = false;
  }

  /// Moves the view so far that it holds the whole box, or its middle where that is larger.
  function reveal({x, y, width, height}) {
    const along = (seen, length, from, size) =>
      size > length ? from + (size - length) / 2 : Math.max(from + size - length, Math.min(from, seen));
    const left = along(box[0], box[2], x, width), top = along(box[1], box[3], y, height);
    if (left !== box[0] || top !== box[1]) setBox(left, top, box[2]);
  }

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
    if (!isDragged && Math.hypot(x, y) < 4) return;
    isDragged = true;
    map.classList.add("dragged");
    const units = unitsPerPixel(frame);
    setBox(grip.box[0] - x * units, grip.box[1] - y * units, box[2]);
  });
  const letGo = () => {
    grip = null;
    map.classList.remove("dragged");
    setTimeout(() => { isDragged = false; });  // after the click that ends a drag
  };
  window.addEventListener("pointerup", letGo);
  window.addEventListener("pointercancel", letGo);

  return {zoom, pan, reveal, showAll: () => setBox(whole[0], whole[1], whole[2]), isDragged: () => isDragged};
}

// Buttons, keys and pointer.

const firstLabel = model.images[0].label; // of a verdict: reference

/// Every key, once: what the page does, and what its list of keys says.
const keys = [
  {keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], shown: "1 to 5", does: "what is shown, in the order of the buttons",
   act: (key) => [...layers.keys()][key - 1] && show([...layers.keys()][key - 1])},
  {keys: ["s", "S"], shown: "S", does: `split: ${firstLabel} on the left, this view on the right`, act: () => setMode("split")},
  {keys: ["b", "B"], shown: "B", does: `blink: ${firstLabel} and this view in turn`, act: () => setMode("blink")},
  {keys: [" "], shown: "Space", does: `${firstLabel} in place of this view, and back`, onStage: true, act: () => flip()},
  {keys: ["+", "="], shown: "+", does: "zoom in", act: () => zoomStep(1, zoomCentre())},
  {keys: ["-", "_"], shown: "−", does: "zoom out", act: () => zoomStep(-1, zoomCentre())},
  {keys: ["0"], shown: "0", does: "the whole image", act: () => fit()},
  {keys: ["z", "Z"], shown: "Z", does: "1:1", act: () => zoomTo(1, zoomCentre())},
  {keys: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"], shown: "← → ↑ ↓", onStage: true,
   does: "another pixel; with Shift ten pixels on. The image must have the focus", act: (key, event) => movePixel(key, event)},
  {keys: ["Escape"], shown: "Esc", does: "no pixel is pinned", act: () => pin(null)},
  {keys: [".", ","], shown: ". and ,", does: "the next or previous pixel of the chosen classes, or of the most severe one",
   act: (key) => nextOfClass(key === "." ? 1 : -1)},
  {keys: ["n", "N", "p", "P"], shown: "N and P", does: "the next or previous cluster",
   act: (key) => showCluster(clusterIndex + (key.toLowerCase() === "n" ? 1 : -1))},
  {keys: ["m", "M"], shown: "M", does: "rectangles around clusters", act: () => setMarks(!state.marks)},
  {keys: ["]", "["], shown: "] and [", does: "more or less gain of the difference", act: (key) => slide("gain", key === "]" ? 1 : -1)},
  {keys: ["e", "E"], shown: "E, Shift+E", does: "more or less exposure, of images of floats", act: (key) => slide("exposure", key === "e" ? 1 : -1)},
  {keys: ["a", "A"], shown: "A", does: "all classes", act: () => choose(null)},
  {keys: ["?"], shown: "?", does: "this list", act: () => $("help").showModal()},
];

const pressed = (id, is) => $(id).setAttribute("aria-pressed", is);

function show(name) {
  state.view = name;
  for (const button of $("views").children) button.setAttribute("aria-pressed", button.dataset.view === name);
  $("gain-box").hidden = name !== "difference";
  $("exposure-box").hidden = !hasFloats() || name === "difference" || name === "bound";
  showRamp();
  draw();
}

let blinking = 0;
function setMode(mode) {
  state.mode = state.mode === mode ? "single" : mode;
  state.blinked = false;
  clearInterval(blinking);
  // Slower than three flashes a second, which WCAG 2.3.1 allows.
  if (state.mode === "blink") blinking = setInterval(() => { state.blinked = !state.blinked; draw(); }, 700);
  pressed("split", state.mode === "split");
  pressed("blink", state.mode === "blink");
  $("divider").hidden = state.mode !== "split";
  draw();
}

/// The reference and what was seen before it.
function flip() {
  if (state.mode !== "single") return;
  if (state.view !== "reference") state.before = state.view;
  show(state.view === "reference" ? state.before || "actual" : "reference");
}

function setSplit(fraction) {
  state.split = Math.min(1, Math.max(0, fraction));
  $("divider").style.left = `${100 * state.split}%`;
  $("divider").setAttribute("aria-valuenow", Math.round(100 * state.split));
  draw();
}

function setMarks(on) {
  state.marks = on;
  pressed("marks", on);
  draw();
}

const hasFloats = () => [...model.shown.values()].some((image) => image.type === "f32");

function setGain() {
  state.gain = 2 ** +$("gain").value;
  $("gain-value").textContent = `× ${numberText(state.gain, 3)}`;
  layers.get("difference").changed();
  draw();
}

function setExposure() {
  state.exposure = +$("exposure").value;
  $("exposure-value").textContent = signedText(state.exposure, 3);
  for (const layer of layers.values()) if (layer.name !== "difference" && layer.name !== "bound") layer.changed();
  inspect();
  draw();
}

function slide(id, steps) {
  if ($(id + "-box").hidden) return;
  if (steps > 0) $(id).stepUp();
  else $(id).stepDown();
  $(id).dispatchEvent(new Event("input"));
}

/// Chooses a class or, if it is chosen, no longer; null: all.
function choose(which) {
  if (!model.classMap) return;
  if (which === null) state.chosen.clear();
  else if (!state.chosen.delete(which)) state.chosen.add(which);
  for (const button of $("legend").children) {
    const is = state.chosen.has(+button.dataset.class);
    button.setAttribute("aria-pressed", is);
    button.classList.toggle("dimmed", state.chosen.size > 0 && !is);
  }
  $("all-classes").hidden = state.chosen.size === 0;
  veil.changed(true);
  draw();
}

function nextOfClass(direction) {
  if (!model.classMap) return;
  const map = model.classMap.values, wanted = new Set(state.chosen);
  if (wanted.size === 0) wanted.add(model.classes.findLastIndex((one) => one.pixels > 0));
  const from = state.pinned ? pixelAt(state.pinned) : direction > 0 ? -1 : map.length;
  for (let step = 1; step <= map.length; step++) {
    const i = (from + direction * step + 2 * map.length) % map.length;
    if (wanted.has(map[i])) return pin([i % model.width, Math.floor(i / model.width)]);
  }
}

let clusterIndex = -1;
function showCluster(index) {
  if (model.clusters.length === 0) return;
  clusterIndex = (index + model.clusters.length) % model.clusters.length;
  const [x, y, width, height, worstX, worstY] = model.clusters[clusterIndex];
  showRectangle(x, y, width, height);
  pin([worstX, worstY]);
}

function pin(place) {
  state.pinned = place;
  if (place) keepInView(place);
  inspect();
  // So that a link can point to a pixel. Not where a page may not change its address.
  try {
    history.replaceState(null, "", place ? `#${place[0]},${place[1]}` : location.pathname + location.search);
  } catch {}
  draw();
}

function movePixel(key, event) {
  const step = event.shiftKey ? 10 : 1;
  const [x, y] = state.pinned || state.hovered || state.centre.map(Math.floor);
  const dx = key === "ArrowLeft" ? -step : key === "ArrowRight" ? step : 0;
  const dy = key === "ArrowUp" ? -step : key === "ArrowDown" ? step : 0;
  state.hovered = null;
  pin([Math.min(Math.max(x + dx, 0), model.width - 1), Math.min(Math.max(y + dy, 0), model.height - 1)]);
}

/// After each drawing: what buttons and labels say of it.
function showState({left, right}) {
  const zoom = state.zoom / devicePixelRatio;
  $("zoom").textContent = zoom < 1 ? `${Math.round(100 * zoom)} %` : `${numberText(zoom, 3)}×`;
  $("label-left").textContent = left.label;
  $("label-right").textContent = right ? right.label : "";
  $("label-right").hidden = !right;
  $("stage").dataset.zoom = state.zoom; // for those who drive the page
  $("stage").dataset.view = state.view;
  $("stage").dataset.mode = state.mode;
}

function showRamp() {
  const ramp = $("ramp");
  ramp.hidden = state.view !== "bound" && !(state.view === "difference" && differenceHasNaN);
  if (ramp.hidden) return;
  const parts = [];
  if (state.view === "bound") {
    const ticks = [0, 0.1, 1, 10, 100, 1000].filter((t) => {
      const at = rampPosition(t, state.rampEnd);
      return t === 0 || (at > 0.1 && at < 0.85);
    }).concat(state.rampEnd);
    parts.push(h("div", {class: "bar", style: `background:linear-gradient(to right, ${model.ramp.filter((_, i) => i % 15 === 0).join(",")})`}),
      h("div", {class: "ticks"}, ticks.map((t) => h("span", {style: `left:${100 * rampPosition(t, state.rampEnd)}%`}, numberText(t, 3)))),
      h("figcaption", {}, "width of the bound, levels"));
  }
  parts.push(h("p", {}, swatch(model.not_a_number), state.view === "bound" ? "no bound" : "NaN or infinite"));
  ramp.replaceChildren(...parts);
}

let differenceHasNaN = false;

function prepareSliders() {
  let largest = 0;
  for (const size of model.largestDifferences) {
    if (size === Infinity) differenceHasNaN = true;
    else if (size > largest) largest = size;
  }
  // The largest difference is white, or nearly; of large ones small ones are seen too.
  $("gain").value = largest > 0 ? Math.min(8, Math.max(3, Math.floor(Math.log2(255 / largest)))) : 0;
  $("exposure").value = 0;
  if (model.bound) state.rampEnd = [1, 2, 5].flatMap((d) => [-2, -1, 0, 1, 2, 3, 4, 5, 6].map((e) => d * 10 ** e))
    .sort((p, q) => p - q).find((end) => end >= largestWidth()) || 1e7;
  $("gain").addEventListener("input", setGain);
  $("exposure").addEventListener("input", setExposure);
  setGain();
  setExposure();
}

function addViewButton(layer) {
  layers.set(layer.name, layer);
  const number = layers.size;
  const button = h("button", {type: "button", "data-view": layer.name, "aria-pressed": "false", title: [layer.source, `key ${number}`].filter(Boolean).join(", ")}, layer.label);
  button.addEventListener("click", () => show(layer.name));
  $("views").append(button);
}

/// The image of a hypothesis becomes one more view.
async function showHypothesis(plane) {
  if (!layers.has(plane)) addViewButton(imageLayer(await imageOf(plane)));
  show(plane);
  $("viewer").scrollIntoView({block: "start"});
  canvas.focus({preventScroll: true});
}

function makeLegend() {
  if (!model.classMap) return;
  $("legend-box").hidden = false;
  veil = new Layer("veil", "", {colour: veilColour, severity: () => {
    const map = model.classMap.values;
    return (i) => (state.chosen.has(map[i]) ? 1 : 0);
  }});
  const whole = model.width * model.height;
  model.classes.forEach((one, k) => {
    if (one.pixels === 0) return;
    const button = h("button", {type: "button", "data-class": k, "aria-pressed": "false", title: one.meaning}, swatch(one.colour),
      h("span", {class: "name"}, one.name), h("span", {class: "count"}, withCommas(one.pixels)),
      h("span", {class: "percent"}, percentOf(one.pixels, whole)));
    button.addEventListener("click", () => choose(k));
    $("legend").append(button);
  });
  $("all-classes").addEventListener("click", () => choose(null));
}
/// Cut, not rounded: 100 % means all; "<" is no pixel of none.
function percentOf(count, whole) {
  const percent = (100 * count) / whole;
  return percent < 0.01 ? "< 0.01 %" : `${(Math.floor(percent * 100) / 100).toFixed(2)} %`;
}

function listenToPointer() {
  let from = null, wheel = 0;
  const box = () => canvas.getBoundingClientRect(), ratio = () => canvas.width / box().width;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    from = {x: event.clientX, y: event.clientY, centre: [...state.centre], moved: false};
  });
  canvas.addEventListener("pointermove", (event) => {
    if (from) {
      const dx = event.clientX - from.x, dy = event.clientY - from.y;
      if (Math.hypot(dx, dy) > 3) from.moved = true;
      if (!from.moved) return;
      state.centre = [from.centre[0] - (dx * ratio()) / state.zoom, from.centre[1] - (dy * ratio()) / state.zoom];
      keepInside();
      return draw();
    }
    state.hovered = imagePixel(event);
    inspect();
  });
  canvas.addEventListener("pointerup", (event) => {
    if (from && !from.moved) pin(imagePixel(event));
    from = null;
  });
  canvas.addEventListener("pointercancel", () => (from = null));
  canvas.addEventListener("pointerleave", () => {
    state.hovered = null;
    inspect();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    wheel += event.deltaMode === 0 ? event.deltaY : 40 * event.deltaY; // lines, of some mice
    if (Math.abs(wheel) < 30) return;
    const at = [(event.clientX - box().left) * ratio(), (event.clientY - box().top) * ratio()];
    zoomStep(wheel < 0 ? 1 : -1, at);
    wheel = 0;
  }, {passive: false});

  const divider = $("divider");
  const drag = (event) => setSplit((event.clientX - box().left) / box().width);
  divider.addEventListener("pointerdown", (event) => {
    divider.setPointerCapture(event.pointerId);
    divider.onpointermove = drag;
  });
  divider.addEventListener("pointerup", () => (divider.onpointermove = null));
  divider.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: -0.01, ArrowRight: 0.01, PageDown: -0.1, PageUp: 0.1, Home: -1, End: 1}[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    setSplit(state.split + step);
  });
}

function listenToKeys() {
  $("help-keys").replaceChildren(...keys.map((one) => h("tr", {}, h("th", {scope: "row"}, h("kbd", {}, one.shown)), h("td", {}, one.does))));
  document.addEventListener("keydown", (event) => {
    document.documentElement.classList.add("keyed");
    if (event.ctrlKey || event.metaKey || event.altKey || $("help").open) return;
    const one = keys.find(({keys: all}) => all.includes(event.key));
    if (!one || (one.onStage && document.activeElement !== canvas)) return;
    event.preventDefault();
    one.act(event.key, event);
  });
  const click = {"split": () => setMode("split"), "blink": () => setMode("blink"), "marks": () => setMarks(!state.marks),
    "zoom-in": () => zoomStep(1, zoomCentre()), "zoom-out": () => zoomStep(-1, zoomCentre()), "zoom-fit": fit,
    "zoom-one": () => zoomTo(1, zoomCentre()), "help-button": () => $("help").showModal(), "unpin": () => pin(null)};
  for (const [id, act] of Object.entries(click)) $(id).addEventListener("click", act);
  for (const button of document.querySelectorAll("[data-cluster]"))
    button.addEventListener("click", () => {
      showCluster(+button.dataset.cluster);
      $("viewer").scrollIntoView({block: "start"});
      canvas.focus({preventScroll: true});
    });
  for (const button of document.querySelectorAll("[data-show]"))
    button.addEventListener("click", () => showHypothesis(button.dataset.show));
}

function listSections() {
  for (const section of document.querySelectorAll(".sections > section[id]")) {
    const title = section.querySelector("h2");
    if (title) $("sections").append(h("a", {href: "#" + section.id}, title.textContent));
  }
}

async function main() {
  document.documentElement.classList.add("scripted");
  listSections();
  readColours();
  await readModel();
  readDifferences();
  for (const layer of makeLayers()) addViewButton(layer);
  makeLegend();
  prepareSliders();
  $("split").title = `${firstLabel} on the left, this view on the right (S)`;
  $("blink").title = `${firstLabel} and this view in turn (B)`;
  $("divider").setAttribute("aria-label", `Split: how much of ${firstLabel} is shown`);
  $("marks").hidden = model.clusters.length === 0;
  listenToPointer();
  listenToKeys();
  new ResizeObserver(resize).observe($("stage"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    readColours();
    if (veil) veil.changed();
    inspected = "";
    inspect();
    draw();
  });
  $("busy").hidden = true;
  resize();
  fit();
  show(layers.has("classes") ? "classes" : "actual");
  const link = location.hash.match(/^#(\d+),(\d+)$/);
  if (link && within(+link[1], +link[2])) {
    zoomTo(Math.max(state.zoom, 16));
    pin([+link[1], +link[2]]);
  }
  canvas.focus({preventScroll: true});
}

main().catch((error) => {
  $("busy").hidden = false;
  $("busy").textContent = `The images cannot be shown: ${error.message}`;
  throw error;
});

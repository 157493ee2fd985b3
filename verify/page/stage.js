// The canvas: which part of the image is where, and drawing it. Lengths are pixels of the screen but where they are
// said to be of the image.

const $ = (id) => document.getElementById(id);
const canvas = $("canvas"), context = canvas.getContext("2d", {alpha: false});

const state = {
  view: "actual",     // name of a layer
  mode: "single",     // "split", "blink"
  split: 0.5,         // fraction of the stage's width that shows the reference
  blinked: false,     // whether the reference is seen now
  zoom: 1,            // pixels of the screen for one of the image: whole numbers from 1 on, so that all are alike
  centre: [0, 0],     // of the image, at the middle of the stage
  fitted: true,       // follows the stage's size
  gain: 1, exposure: 0, rampEnd: 1,
  chosen: new Set(),  // classes; none: all
  marks: true,        // rectangles around clusters
  pinned: null,       // [x, y]
  hovered: null,
};

const layers = new Map();
let veil = null;

const zooms = [];
for (let k = 12; k >= 1; k--) zooms.push(2 ** -k, 1.5 * 2 ** -k);
zooms.push(1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128);
const grid_from = 10, text_from = 56; // zooms from which pixels have lines between them, and their numbers in them

const stageColours = {};
function readColours() {
  const style = getComputedStyle($("stage"));
  for (const name of ["stage", "grid", "mark", "cursor", "cursor-edge"])
    stageColours[name] = style.getPropertyValue("--" + name).trim();
  stageColours.veil = rgbaOfCss(stageColours.stage);
}

const pixelAt = ([x, y]) => y * model.width + x;
const within = (x, y) => x >= 0 && y >= 0 && x < model.width && y < model.height;

function fitZoom() {
  const zoom = Math.min(canvas.width / model.width, canvas.height / model.height);
  return zoom < 1 ? zoom : Math.min(128, Math.floor(zoom));
}

function fit() {
  state.fitted = true;
  state.zoom = fitZoom();
  state.centre = [model.width / 2, model.height / 2];
  draw();
}

/// The stage's place of the image's corner. Whole, so that pixels have sharp edges.
function imageCorner() {
  return [0, 1].map((k) => {
    const size = k === 0 ? canvas.width : canvas.height, length = (k === 0 ? model.width : model.height) * state.zoom;
    return Math.round(length <= size ? (size - length) / 2 : size / 2 - state.centre[k] * state.zoom);
  });
}

/// No border of the image comes farther in than that of the stage.
function keepInside() {
  [canvas.width, canvas.height].forEach((size, k) => {
    const whole = k === 0 ? model.width : model.height, half = size / 2 / state.zoom;
    state.centre[k] = 2 * half >= whole ? whole / 2 : Math.min(Math.max(state.centre[k], half), whole - half);
  });
}

/// at: what stays where it is, in pixels of the canvas.
function zoomTo(zoom, at = [canvas.width / 2, canvas.height / 2]) {
  const [ox, oy] = imageCorner();
  const point = [(at[0] - ox) / state.zoom, (at[1] - oy) / state.zoom];
  state.zoom = zoom;
  state.fitted = false;
  state.centre = [point[0] - (at[0] - canvas.width / 2) / zoom, point[1] - (at[1] - canvas.height / 2) / zoom];
  keepInside();
  draw();
}

/// One step nearer (1) or farther (-1); never farther than the whole image needs.
function zoomStep(direction, at) {
  const least = Math.min(fitZoom(), 1), zoom = state.zoom;
  const next = direction > 0 ? zooms.find((z) => z > zoom * 1.001) : zooms.findLast((z) => z < zoom / 1.001);
  if (next === undefined) return;
  if (direction < 0 && next <= least) fit();
  else zoomTo(next, at);
}

/// Where the pinned pixel is seen, or the middle.
function zoomCentre() {
  if (!state.pinned) return undefined;
  const [ox, oy] = imageCorner(), at = [0, 1].map((k) => [ox, oy][k] + (state.pinned[k] + 0.5) * state.zoom);
  return at[0] < 0 || at[1] < 0 || at[0] > canvas.width || at[1] > canvas.height ? undefined : at;
}

function imagePixel(event) {
  const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
  const [ox, oy] = imageCorner();
  const x = Math.floor(((event.clientX - box.left) * ratio - ox) / state.zoom);
  const y = Math.floor(((event.clientY - box.top) * ratio - oy) / state.zoom);
  return within(x, y) ? [x, y] : null;
}

/// So that the pixel is not at the stage's border.
function keepInView([x, y]) {
  const size = [canvas.width, canvas.height];
  [x, y].forEach((place, k) => {
    const margin = Math.max(0, size[k] / 2 / state.zoom - 2);
    if (Math.abs(place + 0.5 - state.centre[k]) > margin) state.centre[k] = place + 0.5;
  });
  keepInside();
}

/// A rectangle of the image fills about half of the stage.
function showRectangle(x, y, width, height) {
  const wanted = Math.min(canvas.width / width, canvas.height / height) / 2;
  const zoom = zooms.findLast((z) => z <= wanted) || zooms[0];
  state.zoom = Math.max(Math.min(zoom, 32), Math.min(fitZoom(), 32));
  state.fitted = false;
  state.centre = [x + width / 2, y + height / 2];
  keepInside();
  draw();
}

/// What is shown on the left and on the right, or in turn: the reference, and the view beside it.
function sides() {
  const view = layers.get(state.view), reference = layers.get("reference");
  if (state.mode === "single") return {left: view};
  const other = state.view === "reference" ? layers.get("actual") : view;
  if (state.mode === "blink") return {left: state.blinked ? reference : other};
  return {left: reference, right: other};
}

function drawLayer(layer) {
  const {zoom} = state, {x0, y0, x1, y1, ox, oy} = visiblePixels();
  if (x0 >= x1 || y0 >= y1) return;
  const fits = Math.max(model.width, model.height) <= max_side;
  if (zoom < 1 && (layer.severity || !fits)) {
    context.imageSmoothingEnabled = false;
    context.drawImage(layer.smallCanvas(zoom), ox, oy);
    return;
  }
  context.imageSmoothingEnabled = zoom < 1;
  context.imageSmoothingQuality = "high";
  const width = x1 - x0, height = y1 - y0, place = [ox + x0 * zoom, oy + y0 * zoom, width * zoom, height * zoom];
  if (fits) context.drawImage(layer.wholeCanvas(), x0, y0, width, height, ...place);
  else context.drawImage(part(layer, x0, y0, width, height), 0, 0, width, height, ...place);
}

function visiblePixels() {
  const {zoom} = state, [ox, oy] = imageCorner();
  return {x0: Math.max(0, Math.floor(-ox / zoom)), y0: Math.max(0, Math.floor(-oy / zoom)),
          x1: Math.min(model.width, Math.ceil((canvas.width - ox) / zoom)),
          y1: Math.min(model.height, Math.ceil((canvas.height - oy) / zoom)), ox, oy};
}

function drawGrid() {
  const {x0, y0, x1, y1, ox, oy} = visiblePixels(), {zoom} = state;
  context.fillStyle = stageColours.grid;
  for (let x = x0; x <= x1; x++) context.fillRect(ox + x * zoom, oy + y0 * zoom, 1, (y1 - y0) * zoom);
  for (let y = y0; y <= y1; y++) context.fillRect(ox + x0 * zoom, oy + y * zoom, (x1 - x0) * zoom, 1);
}

function drawNumbers({left, right}) {
  const {x0, y0, x1, y1, ox, oy} = visiblePixels(), {zoom} = state;
  const border = right ? state.split * canvas.width : Infinity;
  const size = Math.min(15, Math.floor(zoom / 4.6));
  context.font = `${size}px ui-monospace, monospace`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const colours = new Map();
  for (const layer of [left, right]) if (layer) colours.set(layer, layer.colour());
  for (let y = y0; y < y1; y++)
    for (let x = x0; x < x1; x++) {
      const middle = ox + (x + 0.5) * zoom, layer = middle > border ? right : left, i = y * model.width + x;
      const c = colours.get(layer)(i);
      const light = (c & 255) * 0.3 + ((c >>> 8) & 255) * 0.59 + ((c >>> 16) & 255) * 0.11 > 120;
      context.fillStyle = light ? "#000000" : "#ffffff";
      const lines = layer.text(i);
      lines.forEach((line, k) =>
        context.fillText(line, middle, oy + (y + 0.5) * zoom + (k - (lines.length - 1) / 2) * size * 1.2, zoom - 4));
    }
}

function outline(x, y, width, height, colour, edge, thickness) {
  context.lineWidth = thickness + 2;
  context.strokeStyle = edge;
  context.strokeRect(x, y, width, height);
  context.lineWidth = thickness;
  context.strokeStyle = colour;
  context.strokeRect(x, y, width, height);
}

/// Rectangles stand outside of what they mark, and are never too small to be seen.
function drawMarks() {
  const [ox, oy] = imageCorner(), {zoom} = state, ratio = devicePixelRatio;
  for (const [x, y, width, height] of model.clusters) {
    const gap = 4 * ratio, least = 14 * ratio;
    const w = Math.max(least, width * zoom + 2 * gap), h = Math.max(least, height * zoom + 2 * gap);
    outline(Math.round(ox + (x + width / 2) * zoom - w / 2) + 0.5, Math.round(oy + (y + height / 2) * zoom - h / 2) + 0.5,
            Math.round(w), Math.round(h), stageColours.mark, stageColours["cursor-edge"], ratio);
  }
}

function drawCursor() {
  if (!state.pinned) return;
  const [ox, oy] = imageCorner(), {zoom, pinned} = state, size = Math.max(zoom, 9 * devicePixelRatio);
  outline(Math.round(ox + (pinned[0] + 0.5) * zoom - size / 2), Math.round(oy + (pinned[1] + 0.5) * zoom - size / 2), size, size,
          stageColours.cursor, stageColours["cursor-edge"], 2 * devicePixelRatio);
}

function drawNow() {
  const shown = sides(), {width, height} = canvas, border = Math.round(state.split * width);
  context.fillStyle = stageColours.stage;
  context.fillRect(0, 0, width, height);
  const half = (from, to, layer) => {
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, height);
    context.clip();
    drawLayer(layer);
    context.restore();
  };
  if (shown.right) {
    half(0, border, shown.left);
    half(border, width, shown.right);
  } else drawLayer(shown.left);
  if (state.chosen.size > 0) drawLayer(veil);
  if (state.zoom >= grid_from) drawGrid();
  if (state.zoom >= text_from * Math.max(1, devicePixelRatio * 0.8)) drawNumbers(shown);
  if (state.marks) drawMarks();
  drawCursor();
  showState(shown);
}

let drawing = false;
function draw() {
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    drawNow();
  });
}

function resize() {
  const box = canvas.getBoundingClientRect();
  const width = Math.max(1, Math.round(box.width * devicePixelRatio));
  const height = Math.max(1, Math.round(box.height * devicePixelRatio));
  if (width === canvas.width && height === canvas.height) return;
  canvas.width = width;
  canvas.height = height;
  if (state.fitted) fit();
  else keepInside();
  draw();
}

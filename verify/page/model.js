// What the page knows, pixel by pixel. Pixels are numbered row by row from the top left.

const model = JSON.parse(document.getElementById("data").textContent);

async function readModel() {
  const [reference, actual, classes, bound, objects, triangles, pixels, ends] = await Promise.all(
    ["reference", "actual", "classes", "bound", "objects", "triangles", "allowed-pixels", "allowed-ends"].map(planeOf));
  Object.assign(model, {classMap: classes, bound, objectIds: objects, triangleIds: triangles});
  model.allowed = pixels ? {pixels: pixels.values, ends: ends.values} : null;
  model.notes = await documentOf("notes", []);
  model.noteAt = new Map(model.notes.map((note) => [note.y * model.width + note.x, note]));
  model.shown = new Map(); // by id of the plane
  for (const facts of model.images) model.shown.set(facts.plane, {...facts, names: facts.channels});
  Object.assign(model.shown.get("reference"), reference);
  Object.assign(model.shown.get("actual"), actual);
}

/// The image of a hypothesis, unpacked when it is first asked for.
async function imageOf(plane) {
  const image = model.shown.get(plane);
  if (!image.values) Object.assign(image, await planeOf(plane));
  return image;
}

/// Levels: 255 of what is white, whatever the image holds.
const levelScale = (image) => (image.type === "u8" ? 1 : 255);
const levelAt = (image, pixel, channel) => image.values[pixel * image.channels + channel] * levelScale(image);

/// b - a in levels; 0 for the same infinity, NaN where there is no difference.
function levelDifference(a, b) {
  if (a === b) return 0;
  return Number.isFinite(b - a) ? b - a : NaN;
}

/// What a pixel may be: [{low: [R, G, B], high: [R, G, B]}, …], any of them; empty if that is not known.
function allowedAt(pixel) {
  if (!model.allowed) return [];
  const {pixels, ends} = model.allowed;
  let low = 0, high = pixels.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (pixels[middle] < pixel) low = middle + 1;
    else high = middle;
  }
  const found = [];
  for (; low < pixels.length && pixels[low] === pixel; low++) {
    const at = 6 * low;
    found.push({low: [...ends.slice(at, at + 3)], high: [...ends.slice(at + 3, at + 6)]});
  }
  return found;
}

function objectNameAt(pixel) {
  if (!model.objectIds) return null;
  const id = model.objectIds.values[pixel];
  return id === 0 ? "background" : model.objects[id - 1] || `object ${id}`;
}

// Numbers as text.

const withCommas = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ",");

function numberText(x, digits) {
  if (Number.isNaN(x)) return "NaN";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  const size = Math.abs(x), short = size > 0 && (size < 1e-3 || size >= 1e9);
  const text = short ? x.toExponential(Math.min(digits, 3) - 1) : String(Number.isInteger(x) ? x : +x.toPrecision(digits));
  return text.replaceAll("-", "−").replace("+", "");
}
const signedText = (x, digits) => (x > 0 ? "+" : "") + numberText(x, digits);

/// Levels of bytes are whole. A value of a float is shown with nine digits, which tell any two apart.
const levelText = (image, level) => numberText(level, 6);
const valueText = (image, level) => {
  const value = level / 255;
  return image.type === "u8" || !Number.isFinite(value) ? numberText(value, 4) : String(+value.toPrecision(9)).replaceAll("-", "−");
};

// What can be shown, as canvases. Each layer has a colour for every pixel; it is painted once, and again only when what
// it depends on (gain, exposure, the chosen classes) has changed. Panning and zooming draw canvases.

const rgba = (r, g, b) => (0xff000000 | (b << 16) | (g << 8) | r) >>> 0; // as in the memory of an ImageData
const rgbaOfCss = (css) => rgba(...[1, 3, 5].map((at) => parseInt(css.slice(at, at + 2), 16)));
const toByte = (level) => (level >= 255 ? 255 : level > 0 ? (level + 0.5) | 0 : 0);

const max_side = 16384; // of a canvas, in the browser that allows least (Safari)
const full_bytes = 600e6; // of whole canvases that are kept; a browser tab has some 2 to 4 GB
const wholeCanvases = []; // of layers, the one used last at the end

class Layer {
  /// colour(): gives a function from a pixel to its colour, with what it depends on bound. severity(): likewise, a
  /// number; where several pixels fall on one of the screen, the most severe one is seen. Without it they are averaged.
  constructor(name, label, {colour, severity, text, source}) {
    Object.assign(this, {name, label, colour, severity, text, source});
    this.changed();
  }

  /// Its colours are others; chosen: so is which pixel is the most severe one.
  changed(chosen = false) {
    this.whole = null;
    if (this.small) this.small.canvas = null;
    if (chosen) this.small = null;
  }

  /// A pixel of the image is one of the canvas.
  wholeCanvas() {
    const {width, height} = model;
    const at = wholeCanvases.indexOf(this);
    if (at >= 0) wholeCanvases.splice(at, 1);
    wholeCanvases.push(this);
    if (this.whole) return this.whole;
    while (wholeCanvases.length > 2 && wholeCanvases.length * 4 * width * height > full_bytes)
      wholeCanvases.shift().whole = null;
    const colour = this.colour();
    this.whole = painted(width, height, (out) => {
      for (let i = 0; i < out.length; i++) out[i] = colour(i);
    });
    return this.whole;
  }

  /// The image at a zoom below 1: each pixel of the canvas shows the most severe one of those that fall on it, so that
  /// a single wrong pixel is seen in an image of any size.
  smallCanvas(zoom) {
    const severity = this.severity ? this.severity() : () => 0; // then the first one
    if (!this.small || this.small.zoom !== zoom) this.small = {zoom, ...mostSevere(severity, zoom)};
    const {columns, rows, chosen, canvas} = this.small;
    if (canvas) return canvas;
    const colour = this.colour();
    this.small.canvas = painted(columns, rows, (out) => {
      for (let k = 0; k < out.length; k++) out[k] = colour(chosen[k]);
    });
    return this.small.canvas;
  }
}

/// A rectangle of a layer, as far as it lies within the image.
function part(layer, x, y, width, height) {
  const colour = layer.colour();
  return painted(width, height, (out) => {
    for (let row = Math.max(0, -y); row < Math.min(height, model.height - y); row++)
      for (let column = Math.max(0, -x); column < Math.min(width, model.width - x); column++)
        out[row * width + column] = colour((y + row) * model.width + x + column);
  });
}

/// Of all pixels of the image that fall on one of a smaller image, the most severe one.
function mostSevere(severity, zoom) {
  const {width, height} = model;
  const columns = Math.max(1, Math.ceil(width * zoom)), rows = Math.max(1, Math.ceil(height * zoom));
  const column = Uint32Array.from({length: width}, (_, x) => Math.min(columns - 1, Math.floor(x * zoom)));
  const chosen = new Uint32Array(columns * rows), best = new Float64Array(columns);
  for (let y = 0, row = -1; y < height; y++) {
    const next = Math.min(rows - 1, Math.floor(y * zoom));
    if (next !== row) best.fill(-1);
    row = next;
    for (let x = 0, i = y * width; x < width; x++, i++) {
      const s = severity(i), c = column[x];
      if (s > best[c]) best[c] = s, chosen[row * columns + c] = i;
    }
  }
  return {columns, rows, chosen, canvas: null};
}

function painted(width, height, fill) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  fill(new Uint32Array(image.data.buffer));
  context.putImageData(image, 0, 0);
  return canvas;
}

const notANumber = rgbaOfCss(model.not_a_number);

function imageColour(image, exposure) {
  const {values, channels: step} = image;
  const [g, b] = step >= 3 ? [1, 2] : [0, 0];
  if (image.type === "u8") return (i) => rgba(values[i * step], values[i * step + g], values[i * step + b]);
  const scale = 255 * 2 ** exposure;
  return (i) => {
    const red = values[i * step], green = values[i * step + g], blue = values[i * step + b];
    if (red !== red || green !== green || blue !== blue) return notANumber;
    return rgba(toByte(red * scale), toByte(green * scale), toByte(blue * scale));
  };
}

/// Calls use(i, c, d) for each channel c of three that is shown of each pixel i; d: the difference in levels, or NaN.
function eachDifference(use) {
  const a = model.shown.get("reference"), b = model.shown.get("actual");
  const va = a.values, vb = b.values, sa = a.channels, sb = b.channels, ka = levelScale(a), kb = levelScale(b);
  const ga = sa >= 3 ? 1 : 0, gb = sb >= 3 ? 1 : 0, pixels = model.width * model.height;
  for (let i = 0; i < pixels; i++)
    for (let c = 0; c < 3; c++) use(i, c, levelDifference(va[i * sa + c * ga] * ka, vb[i * sb + c * gb] * kb));
}

/// Once for all: of each pixel the size of the three differences, in levels, and the largest one; infinity is none.
function readDifferences() {
  const bytes = model.images.every(({plane}) => plane.startsWith("hypothesis") || model.shown.get(plane).type === "u8");
  const pixels = model.width * model.height;
  const sizes = bytes ? new Uint8Array(3 * pixels) : new Float32Array(3 * pixels);
  const largest = bytes ? new Uint8Array(pixels) : new Float32Array(pixels);
  eachDifference((i, c, d) => {
    const size = d === d ? Math.abs(d) : Infinity;
    sizes[3 * i + c] = size;
    if (size > largest[i]) largest[i] = size;
  });
  Object.assign(model, {differences: sizes, largestDifferences: largest});
}

function differenceColour() {
  const sizes = model.differences, gain = state.gain;
  if (sizes instanceof Uint8Array) {
    const shown = Uint8Array.from({length: 256}, (_, size) => toByte(size * gain));
    return (i) => rgba(shown[sizes[3 * i]], shown[sizes[3 * i + 1]], shown[sizes[3 * i + 2]]);
  }
  return (i) => {
    const [r, g, b] = [sizes[3 * i], sizes[3 * i + 1], sizes[3 * i + 2]];
    return r + g + b < Infinity ? rgba(toByte(r * gain), toByte(g * gain), toByte(b * gain)) : notANumber;
  };
}

function classColour() {
  const colours = model.classes.map((one) => rgbaOfCss(one.colour));
  const map = model.classMap.values;
  // The first class is no finding: its pixels show a little of the image, so that one sees where one is.
  const [r, g, b] = [0, 8, 16].map((shift) => (colours[0] >>> shift) & 255);
  const lightness = imageColour(model.shown.get("reference"), state.exposure);
  const shades = Uint32Array.from({length: 256}, (_, l) => {
    const t = 0.45 * (l / 255);
    return rgba(...[r, g, b].map((c) => Math.round(c + (255 - c) * t)));
  });
  return (i) => {
    if (map[i] !== 0) return colours[map[i]];
    const c = lightness(i);
    return shades[((c & 255) * 54 + ((c >>> 8) & 255) * 183 + ((c >>> 16) & 255) * 19) >>> 8];
  };
}

/// Where on the ramp of widths a width stands, in [0, 1]; it is logarithmic from 0 on, as that of heat images.
const rampPosition = (width, end) => Math.log1p(width) / Math.log1p(end);
function largestWidth() {
  let largest = 0;
  for (const width of model.bound.values) if (width < Infinity && width > largest) largest = width;
  return largest;
}

function boundColour() {
  const ramp = model.ramp.map(rgbaOfCss), widths = model.bound.values, end = state.rampEnd;
  return (i) => {
    if (!(widths[i] < Infinity)) return notANumber;
    return ramp[Math.min(255, Math.max(0, Math.round(255 * rampPosition(widths[i], end))))];
  };
}

/// Lies over every view where classes are chosen: a veil on all others.
function veilColour() {
  const map = model.classMap.values, veil = ((stageColours.veil & 0xffffff) | 0xd0000000) >>> 0;
  const colours = model.classes.map((_, k) => (state.chosen.has(k) ? 0 : veil));
  return (i) => colours[map[i]];
}

function imageLayer(image) {
  return new Layer(image.plane, image.label, {
    source: image.source,
    colour: () => imageColour(image, state.exposure),
    text: (i) => Array.from({length: Math.min(image.channels, 4)}, (_, c) => levelText(image, levelAt(image, i, c))),
  });
}

const differenceText = (i) => {
  const a = model.shown.get("reference"), b = model.shown.get("actual");
  return Array.from({length: Math.min(a.channels, b.channels, 4)},
                    (_, c) => signedText(levelDifference(levelAt(a, i, c), levelAt(b, i, c)), 4));
};

function makeLayers() {
  const layers = [imageLayer(model.shown.get("reference")), imageLayer(model.shown.get("actual"))];
  if (model.classMap)
    layers.push(new Layer("classes", "classes", {
      colour: classColour,
      severity: () => (i) => model.classMap.values[i],
      text: (i) => [model.classes[model.classMap.values[i]].name],
    }));
  layers.push(new Layer("difference", "difference", {
    colour: differenceColour,
    severity: () => (i) => model.largestDifferences[i],
    text: differenceText,
  }));
  if (model.bound)
    layers.push(new Layer("bound", "bound width", {
      colour: boundColour,
      severity: () => (i) => (model.bound.values[i] < Infinity ? model.bound.values[i] : Infinity),
      text: (i) => [numberText(model.bound.values[i], 3)],
    }));
  return layers;
}

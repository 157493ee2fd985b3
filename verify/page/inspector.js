// What is known of one pixel, beside the image.

/// An element with attributes and children, which are elements or texts; texts are never read as HTML.
function h(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

const swatch = (css) => h("span", {class: "swatch", style: `background:${css}`, "aria-hidden": "true"});
const percentText = (fraction) => `${+(100 * fraction).toFixed(fraction < 0.1 ? 1 : 0)} %`;

/// A line of levels: bars where they are allowed, a stroke for the reference, a lozenge for the actual level.
function scale(reference, actual, bars) {
  const ends = [reference, actual, ...bars.flat()].filter(Number.isFinite);
  const low = Math.min(...ends), high = Math.max(...ends), pad = Math.max((high - low) * 0.08, 0.02);
  const at = (level) => Math.min(100, Math.max(0, (100 * (level - low + pad)) / (high - low + 2 * pad)));
  const inside = bars.some(([from, to]) => from <= actual && actual <= to);
  const parts = bars.map(([from, to]) => h("i", {class: "allowed", style: `left:${at(from)}%;width:${at(to) - at(from)}%`}));
  if (Number.isFinite(reference)) parts.push(h("i", {class: "reference", style: `left:${at(reference)}%`}));
  if (Number.isFinite(actual)) parts.push(h("i", {class: `actual ${inside ? "inside" : "outside"}`, style: `left:${at(actual)}%`}));
  return h("span", {class: "scale", "aria-hidden": "true"}, parts);
}

function channelRows(pixel) {
  const a = model.shown.get("reference"), b = model.shown.get("actual"), allowed = allowedAt(pixel), rows = [];
  const number = (image, level) => h("td", {}, levelText(image, level), h("small", {}, valueText(image, level)));
  for (let c = 0; c < Math.max(a.channels, b.channels); c++) {
    const x = c < a.channels ? levelAt(a, pixel, c) : NaN, y = c < b.channels ? levelAt(b, pixel, c) : NaN;
    const bars = c < 3 ? allowed.map(({low, high}) => [low[c], high[c]]) : [];
    rows.push(h("tr", {}, h("th", {scope: "row"}, (a.names[c] || b.names[c])), number(a, x), number(b, y),
                h("td", {class: x === y ? "same" : "differs"}, signedText(levelDifference(x, y), 4))));
    if (bars.length === 0) continue;
    const text = "allowed " + bars.slice(0, 3).map(([low, high]) => `${numberText(low, 5)} to ${numberText(high, 5)}`).join(" or ");
    rows.push(h("tr", {class: "allowed"}, h("td"), h("td", {colspan: 3}, h("div", {}, scale(x, y, bars),
      h("small", {}, text + (bars.length > 3 ? ` or ${bars.length - 3} more` : ""))))));
  }
  return rows;
}

const fact = (name, ...content) => [h("dt", {}, name), h("dd", {}, ...content)];

function pixelFacts(pixel) {
  const facts = [];
  if (model.classMap) {
    const one = model.classes[model.classMap.values[pixel]];
    facts.push(...fact("class", swatch(one.colour), h("b", {}, one.name), one.meaning ? h("small", {}, one.meaning) : null));
  }
  const name = objectNameAt(pixel), triangle = model.triangleIds ? model.triangleIds.values[pixel] : 0;
  if (name !== null) facts.push(...fact("object", name));
  if (triangle > 0) facts.push(...fact("triangle", withCommas(triangle)));
  if (model.bound) {
    const width = model.bound.values[pixel];
    facts.push(...fact("bound", width < Infinity ? `${numberText(width, 4)} levels wide` : "none"));
  }
  return facts;
}

function noteParts(pixel) {
  const note = model.noteAt.get(pixel), parts = [];
  if (!note) return parts;
  if (note.attribution.length > 0)
    parts.push(h("h3", {}, "What makes the bound wide"), h("div", {class: "attribution"}, note.attribution.map(({cause, fraction}) =>
      h("div", {class: "bar"}, h("span", {class: "label"}, cause),
        h("span", {class: "track"}, h("span", {class: "fill", style: `width:${100 * Math.min(1, Math.max(0, fraction))}%`})),
        h("span", {class: "count"}, percentText(fraction))))));
  if (note.text) parts.push(h("pre", {tabindex: "0"}, note.text));
  return parts;
}

/// The pixel and its neighbours, in both images.
function loupes([x, y]) {
  const columns = 15, rows = 9, step = 10;
  return h("div", {class: "loupes"}, ["reference", "actual"].map((name) => {
    const canvas = h("canvas", {width: columns * step, height: rows * step, "aria-hidden": "true"});
    const context = canvas.getContext("2d"), left = (columns - 1) / 2, above = (rows - 1) / 2;
    context.imageSmoothingEnabled = false;
    context.fillStyle = stageColours.stage;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(part(layers.get(name), x - left, y - above, columns, rows), 0, 0, canvas.width, canvas.height);
    for (const [colour, thickness] of [[stageColours["cursor-edge"], 3], [stageColours.cursor, 1.5]]) {
      context.lineWidth = thickness, context.strokeStyle = colour;
      context.strokeRect(left * step, above * step, step, step);
    }
    return h("figure", {}, canvas, h("figcaption", {}, layers.get(name).label));
  }));
}

function pixelSentence([x, y]) {
  const pixel = pixelAt([x, y]);
  const parts = ["reference", "actual"].map((name) => {
    const image = model.shown.get(name);
    return `${image.label} ${Array.from({length: image.channels}, (_, c) => levelText(image, levelAt(image, pixel, c))).join(" ")}`;
  });
  if (model.classMap) parts.push(model.classes[model.classMap.values[pixel]].name);
  if (model.objectIds) parts.push(objectNameAt(pixel));
  return `(${x}, ${y})  ${parts.join("  ·  ")}`;
}

let inspected = "";
function inspect() {
  const place = state.pinned || state.hovered;
  $("pixel-line").textContent = state.hovered || state.pinned ? pixelSentence(state.hovered || state.pinned) : "";
  $("unpin").hidden = !state.pinned;
  const key = `${place} ${state.exposure}`;
  if (!place || key === inspected) return;
  inspected = key;
  const pixel = pixelAt(place), a = model.shown.get("reference"), b = model.shown.get("actual");
  $("place").textContent = `${place[0]}, ${place[1]}`;
  $("pixel").replaceChildren(
    loupes(place),
    h("table", {class: "values"}, h("thead", {}, h("tr", {}, h("th"), h("th", {scope: "col"}, a.label),
      h("th", {scope: "col"}, b.label), h("th", {scope: "col"}, "difference"))), h("tbody", {}, channelRows(pixel))),
    h("dl", {class: "facts"}, pixelFacts(pixel)), ...noteParts(pixel));
}

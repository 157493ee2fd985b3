// Unpacks what verify/page/packed.cpp packs. What it gives are the numbers of the images, to the last bit: no image
// decoder of the browser, which may manage colours or add noise against tracking, comes between.

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// Undoes PNG's filters 0 to 4; step: bytes to the neighbour on the left.
function unfiltered(raw, rowBytes, step) {
  const rows = raw.length / (rowBytes + 1);
  const out = new Uint8Array(rows * rowBytes);
  for (let y = 0; y < rows; y++) {
    const filter = raw[y * (rowBytes + 1)];
    const from = y * (rowBytes + 1) + 1, to = y * rowBytes, above = to - rowBytes;
    if (filter === 0) {
      out.set(raw.subarray(from, from + rowBytes), to);
      continue;
    }
    for (let i = 0; i < rowBytes; i++) {
      const a = i < step ? 0 : out[to + i - step];
      const b = y === 0 ? 0 : out[above + i];
      let foreseen = a;
      if (filter === 2) foreseen = b;
      else if (filter === 3) foreseen = (a + b) >> 1;
      else if (filter === 4) {
        const c = y === 0 || i < step ? 0 : out[above + i - step];
        const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
        foreseen = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      }
      out[to + i] = raw[from + i] + foreseen;
    }
  }
  return out;
}

/// Four images of bytes, the highest first, as numbers of 32 bits.
function joined(bytes) {
  const count = bytes.length / 4, numbers = new Uint32Array(count);
  for (let i = 0; i < count; i++)
    numbers[i] = (bytes[i] << 24) | (bytes[count + i] << 16) | (bytes[2 * count + i] << 8) | bytes[3 * count + i];
  return numbers;
}

/// The bytes of the element of this id, unpacked; null if the page has none.
async function contentOf(id) {
  const element = document.getElementById("plane-" + id);
  if (!element) return null;
  const bytes = await inflated(bytesOfBase64(element.textContent));
  element.textContent = ""; // its memory
  return {bytes, facts: element.dataset};
}

/// What a packed JSON document says.
async function documentOf(id, otherwise) {
  const content = await contentOf(id);
  return content ? JSON.parse(new TextDecoder().decode(content.bytes)) : otherwise;
}

const planes = new Map(); // id > promise

/// The plane of this id: {width, height, channels, type, values}; null if the page has none.
function planeOf(id) {
  if (!planes.has(id)) planes.set(id, unpackPlane(id));
  return planes.get(id);
}

async function unpackPlane(id) {
  const content = await contentOf(id);
  if (!content) return null;
  const {type, base} = content.facts;
  const width = +content.facts.width, height = +content.facts.height, channels = +content.facts.channels;
  const bytes = unfiltered(content.bytes, width * channels, channels);
  const other = base ? await planeOf(base) : null;
  if (type === "u8") {
    if (other) for (let i = 0; i < bytes.length; i++) bytes[i] += other.values[i];
    return {width, height, channels, type, values: bytes};
  }
  const bits = joined(bytes);
  if (other) {
    const otherBits = new Uint32Array(other.values.buffer);
    for (let i = 0; i < bits.length; i++) bits[i] = otherBits[i] + ((bits[i] >>> 1) ^ -(bits[i] & 1));
  }
  return {width, height, channels, type, values: type === "f32" ? new Float32Array(bits.buffer) : bits};
}

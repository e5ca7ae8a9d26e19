// Pictures as PNG files (W3C Recommendation, third edition). Written here and not by a canvas' `toBlob`, which some
// browsers blur against fingerprinting; the browser's own deflate does the work.

const SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const BYTES_PER_PIXEL = 4;
/** Bits a channel, RGBA, and the only methods of compression, filtering and interlacing that are used. */
const FORMAT = [8, 6, 0, 0, 0];
/** Each byte as its difference from the pixel to the left: smooth shades become long runs. */
const FILTER_SUB = 1;
const SRGB_PERCEPTUAL = 0;

/** Pictures are painted and packed in at least so many strips, of at most so many pixels. */
const STRIPS = 16;
const STRIP_PIXELS = 1 << 20;

/**
 * A picture of any size, painted while it is written: no more than a strip of it is there at a time.
 * @param {import("./engine.js").Export} picture
 * @param {boolean} transparent
 * @param {(part: number) => Promise<void>} done after each strip, with the part of the picture that is written; what it throws ends the work
 */
export async function pngOf(picture, transparent, done) {
  const { width, height } = picture;
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set(FORMAT, 8);
  const deflate = new CompressionStream("deflate");
  const packed = new Response(deflate.readable).arrayBuffer();
  const writer = deflate.writable.getWriter();
  try {
    const count = Math.max(1, Math.floor(Math.min(height / STRIPS, STRIP_PIXELS / width)));
    for (let y = 0; y < height; y += count) {
      const strip = Math.min(count, height - y);
      await writer.write(filtered(width, strip, picture.rows(y, strip, transparent)));
      await done((y + strip) / height);
    }
    await writer.close();
  } catch (fault) {
    // What is there ends the stream: Firefox reports one that is broken off as a fault of the page.
    writer.close().catch(() => {});
    packed.catch(() => {});
    throw fault;
  }
  const chunks = [
    chunk("IHDR", header),
    chunk("sRGB", Uint8Array.of(SRGB_PERCEPTUAL)),
    chunk("IDAT", new Uint8Array(await packed)),
    chunk("IEND", new Uint8Array()),
  ];
  return new Blob([SIGNATURE, ...chunks], { type: "image/png" });
}

/**
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array} rgba
 */
function filtered(width, height, rgba) {
  const stride = width * BYTES_PER_PIXEL;
  const rows = new Uint8Array((stride + 1) * height);
  for (let y = 0; y < height; y++) {
    const row = rgba.subarray(y * stride, (y + 1) * stride);
    const start = y * (stride + 1);
    rows[start] = FILTER_SUB;
    for (let i = 0; i < stride; i++) rows[start + 1 + i] = row[i] - (row[i - BYTES_PER_PIXEL] ?? 0);
  }
  return rows;
}

/**
 * @param {string} type
 * @param {Uint8Array} data
 */
function chunk(type, data) {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(type), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/** @type {Uint32Array | undefined} */
let remainders;

/** @param {Uint8Array} bytes */
function crc(bytes) {
  remainders ??= Uint32Array.from({ length: 256 }, (_, n) => remainder(n));
  let sum = 0xffffffff;
  for (const byte of bytes) sum = remainders[(sum ^ byte) & 0xff] ^ (sum >>> 8);
  return ~sum;
}

/** @param {number} n */
function remainder(n) {
  for (let bit = 0; bit < 8; bit++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
}

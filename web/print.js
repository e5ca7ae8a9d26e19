// Printing: the picture of the drawing as it is, not the page around it. A canvas that a graphics card draws on comes out blank.

import { areLinesShown } from "./toolbar.js";

/** Pixels of a print on its longer side. */
const PRINT_PX = 2400;

/** @param {import("./engine.js").Engine} engine */
export function connectPrinter(engine) {
  const sheet = document.createElement("canvas");
  sheet.id = "print";
  addEventListener("beforeprint", () => {
    const picture = engine.export(PRINT_PX, areLinesShown());
    if (!picture) return;
    const { width, height } = picture;
    Object.assign(sheet, { width, height });
    const pixels = new Uint8ClampedArray(picture.rows(0, height, false));
    picture.free();
    sheet.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
    document.body.append(sheet);
  });
  addEventListener("afterprint", () => sheet.remove());
}

// What other programs write: diffusion curves open as a picture, a palette becomes that of the drawing that is shown.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { makeFolder, useSession } from "./harness.mjs";
import { hex } from "./picture.mjs";

const points = Array.from({ length: 4 }, (_, i) => `<control_point x="50" y="${-1 + 34 * i}" />`).join("");

/** A line to the right across the middle of a page of 100 by 100, red above and blue below. */
const CURVES = `<!DOCTYPE CurveSetXML>
<curve_set image_width="100" image_height="100" nb_curves="1" >
 <curve><control_points_set>${points}</control_points_set>
  <left_colors_set><left_color G="20" R="10" globalID="0" B="200" /></left_colors_set>
  <right_colors_set><right_color G="30" R="220" globalID="5" B="10" /></right_colors_set>
  <blur_points_set><best_scale value="1" globalID="0" /></blur_points_set>
 </curve>
</curve_set>`;

const PALETTE = "GIMP Palette\nName: Sea\n  1   2   3\tDeep\n 59 130 246\tShallow\n";

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`imports in ${browser}`, () => {
    const session = useSession(browser);
    const folder = makeFolder();

    test("diffusion curves open as the picture that they are", async () => {
      const editor = await session.open("cpu");
      const path = await folder.write("sea.xml", CURVES);
      await editor.until("Opened sea.xml; left out: 1 curve’s blur", () => editor.tab.chooseFiles([path]));
      const picture = await editor.picture();
      const [above, below] = await editor.place([[30, 20], [70, 80]], 100);
      assert.equal(hex(picture.at(...above)), "#c8140a");
      assert.equal(hex(picture.at(...below)), "#0a1edc");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("diffusion curves that are none say so and leave the work as it is", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      const before = await editor.picture();
      await editor.tab.chooseFiles([await folder.write("bad.xml", CURVES.replace("image_width", "width"))]);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /image_width/);
      await editor.click("Dismiss");
      assert.ok((await editor.picture()).equals(before));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a damaged palette is called one, by its name where its beginning does not tell", async () => {
      const editor = await session.open("cpu");
      for (const [name, content, message] of /** @type {[string, string, RegExp][]} */ ([
        ["sea.gpl", "\nGIMP\n1 2 3\n", /palette cannot be used: line 2 should have “GIMP Palette”/],
        ["sea.ase", "ASE", /palette is damaged: .*ASEF.*save it again/],
        ["sea.hex", "; sea\nblue\n", /palette cannot be used: line 2 should have a colour #rrggbb/],
      ])) {
        await editor.tab.chooseFiles([await folder.write(name, content)]);
        await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
        assert.match(await editor.message(), message);
        await editor.click("Dismiss");
      }
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a palette becomes that of the drawing, and undo takes it back", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      const swatches = () =>
        editor.tab.evaluate(`[...document.querySelectorAll("#palette .swatch")].map((swatch) => swatch.ariaLabel)`);
      const usual = await swatches();
      const path = await folder.write("sea.gpl", PALETTE);
      await editor.until("The palette has the colours of sea.gpl", () => editor.tab.chooseFiles([path]));
      assert.deepEqual(await swatches(), ["Deep", "Shallow", "No colour"]);
      assert.equal(await editor.name(), "rooms.svg");
      await editor.tab.press("1");
      assert.equal(await editor.tab.evaluate(`document.getElementById("color").dataset.color`), "#010203");
      await editor.until("Undone", () => editor.click("Undo"));
      assert.deepEqual(await swatches(), usual);
      await editor.until("Redone", () => editor.click("Redo"));
      await editor.tab.chooseFiles([await folder.write("bad.gpl", PALETTE.replace("59", "blue"))]);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /line 4/);
      assert.deepEqual(await swatches(), ["Deep", "Shallow", "No colour"]);
      const most = Array.from({ length: 1000 }, (_, i) => `#${(0x100000 + 7 * i).toString(16)}`).join("\n");
      const long = await folder.write("long.hex", most);
      await editor.until("The palette has the colours of long.hex", () => editor.tab.chooseFiles([long]));
      assert.equal((await swatches()).length, 1001, "all of them can be scribbled with");
      await editor.tab.evaluate(`document.getElementById("color").click()`);
      await editor.tab.waitFor(`document.querySelector("#color-panel:popover-open")`);
      await editor.tab.evaluate(`{
        const field = document.querySelector("#color-panel [type=text]");
        field.value = "#abcdef";
        field.dispatchEvent(new Event("change"));
      }`);
      await editor.until("#abcdef has been added", () => editor.tab.click("button", "Add to palette"));
      assert.equal((await swatches()).length, 1001, "no more are shown");
      assert.equal(await editor.tab.evaluate(`document.querySelectorAll("#palette-panel [role=option]").length`), 1000);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}

// What becomes of the page where a call into its module fails: what the module does not take changes nothing, what breaks it
// off stops the page.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession, version } from "./harness.mjs";

describe("a call that fails", () => {
  const session = useSession("chromium");

  /** The next command does this, and no more. @param {import("./harness.mjs").Editor} editor @param {string} act */
  const next = async (editor, act) => {
    const module = `${session.url}${await version()}/pkg/webgpu/scumble_web.js`;
    await editor.tab.evaluate(`import("${module}").then(({ App }) => {
      const { command } = App.prototype;
      App.prototype.command = function (...args) {
        App.prototype.command = command;
        ${act}
      };
    })`);
  };

  const open = async () => {
    const editor = await session.open("cpu");
    await editor.openDrawing("rooms");
    return editor;
  };

  test("what the module does not take leaves the page as it is", async () => {
    const editor = await open();
    await next(editor, `return command.call(this, "color", undefined);`);
    await editor.tab.press("1");
    assert.equal(editor.tab.faults.length, 1, "it is told of on the console");
    await editor.scribble([[30, 30], [50, 60]], 200);
    assert.equal(await editor.message(), "");
  });

  for (const fault of ["WebAssembly.RuntimeError", "RangeError", "TypeError"]) {
    test(`a ${fault} stops it`, async () => {
      const editor = await open();
      await next(editor, `throw new ${fault}("unreachable");`);
      await editor.tab.press("1");
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /has run into a fault and stopped/);
    });
  }
});

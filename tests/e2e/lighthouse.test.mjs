// Lighthouse, by Google, finds nothing to mend in accessibility and best practices; and Chromium would install the page.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import lighthouse from "lighthouse";
import puppeteer from "puppeteer-core";
import { CHROMIUM } from "./browsers.mjs";
import { DIST } from "./harness.mjs";
import { serve } from "./static_server.mjs";

const CATEGORIES = ["accessibility", "best-practices"];

describe("a whole visit", () => {
  /** @type {import("puppeteer-core").Browser} */
  let browser;
  /** @type {Awaited<ReturnType<typeof serve>>} */
  let host;
  before(async () => {
    browser = await puppeteer.launch(CHROMIUM);
    host = await serve(DIST, { base: "/some/where/", isKept: true });
  });
  after(async () => {
    await browser?.close();
    host?.server.close();
    host?.server.closeAllConnections();
  });

  for (const formFactor of /** @type {const} */ (["mobile", "desktop"])) {
    test(`has full marks as on a ${formFactor}`, async (t) => {
      const port = Number(new URL(browser.wsEndpoint()).port);
      const screenEmulation = formFactor === "desktop" ? { mobile: false, width: 1350, height: 940, deviceScaleFactor: 1 } : undefined;
      // Only times would need a connection that is slower than it is.
      const flags = { port, onlyCategories: CATEGORIES, formFactor, screenEmulation, throttlingMethod: /** @type {const} */ ("provided") };
      const result = await lighthouse(host.url, flags);
      assert.ok(result, "Lighthouse has no result");
      assert.equal(result.lhr.runtimeError, undefined);
      const { audits, categories } = result.lhr;
      for (const { id, score, auditRefs } of Object.values(categories)) {
        t.diagnostic(`${id}: ${score}`);
        const counted = auditRefs.filter(({ weight }) => weight > 0).map((ref) => audits[ref.id]);
        const failed = counted.filter((audit) => audit.score !== null && audit.score < 1);
        assert.deepEqual(failed.map((audit) => [audit.title, JSON.stringify(audit.details)]), []);
        assert.equal(score, 1, id);
      }
      assert.equal(Object.keys(categories).length, CATEGORIES.length);
    });
  }

  test("can be installed", async () => {
    const page = await browser.newPage();
    await page.goto(host.url);
    await page.evaluate("navigator.serviceWorker.ready.then(() => undefined)");
    const devtools = await page.createCDPSession();
    const { installabilityErrors } = await devtools.send("Page.getInstallabilityErrors");
    assert.deepEqual(installabilityErrors, []);
    const { data, errors } = await devtools.send("Page.getAppManifest");
    assert.deepEqual(errors, []);
    const { name, display, icons } = JSON.parse(String(data));
    assert.deepEqual([name, display], ["Scumble", "standalone"]);
    assert.ok(icons.some((/** @type {{purpose?: string}} */ { purpose }) => purpose === "maskable"));
  });
});

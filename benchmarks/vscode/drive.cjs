// Uses the extension as a person would, in a real host in a headless browser; prints what was seen as JSON.
//   node drive.cjs '{"url": …, "chromium": …, "packages": …, "pictures": …}'
"use strict";
const { createRequire } = require("node:module");
const { join } = require("node:path");

const order = JSON.parse(process.argv[2]);
const puppeteer = createRequire(join(order.packages, "package.json"))("puppeteer-core");
const MOST = 40_000; // milliseconds for anything to happen

async function main() {
  const browser = await puppeteer.launch({
    executablePath: order.chromium,
    userDataDir: order.profile,
    args: "no-sandbox disable-gpu disable-quic no-first-run disable-background-networking disable-component-update disable-sync"
      .split(" ")
      .map((flag) => `--${flag}`),
  });
  const seen = {};
  const page = await browser.newPage();
  page.setDefaultTimeout(MOST);
  try {
    await page.setViewport({ width: 1500, height: 900 });
    await page.goto(order.url, { waitUntil: "domcontentloaded" });
    await page.waitForSelector(".monaco-workbench");
    await open(page, "team.aseme");

    seen.language = await text(page, ".statusbar-item[id='status.editor.mode']", (found) => /ASEME/.test(found));
    seen.coloured = await page.waitForFunction(() => {
      const spans = [...document.querySelectorAll(".view-line span span")];
      const colour = (word) => {
        const span = spans.find((each) => each.textContent.trim() === word);
        return span && getComputedStyle(span).color;
      };
      const [keyword, name] = [colour("participant"), colour("manager")];
      return keyword && name && keyword !== name && { keyword, name };
    });
    seen.coloured = await seen.coloured.jsonValue();

    // A mistake, as it is typed, and its fix.
    await line(page, order.lines.blank);
    await page.keyboard.type("let nobody = 2 +", { delay: 5 });
    await page.waitForSelector(".squiggly-error");
    await page.screenshot({ path: join(order.pictures, "mistake.png") });
    seen.mistake = true;
    await press(page, "Control", "z");
    await page.keyboard.down("Control");
    for (let count = 0; count < 20; count++) await page.keyboard.press("z");
    await page.keyboard.up("Control");
    await page.waitForFunction(() => !document.querySelector(".squiggly-error"));

    // Completion that knows its place.
    await line(page, order.lines.blank);
    await page.keyboard.type("enter ", { delay: 5 });
    await press(page, "Control", " ");
    await page.waitForFunction(() => document.querySelectorAll(".suggest-widget.visible .monaco-list-row").length > 0);
    seen.completion = await page.$$eval(".suggest-widget.visible .monaco-list-row .label-name", (rows) =>
      rows.map((row) => row.textContent),
    );
    await page.screenshot({ path: join(order.pictures, "completion.png") });
    await page.keyboard.press("Escape");
    await page.keyboard.down("Control");
    for (let count = 0; count < 10; count++) await page.keyboard.press("z");
    await page.keyboard.up("Control");

    // The diagram follows the cursor, and a click on it leads to the text.
    await line(page, order.lines.first);
    await command(page, "ASEME: Show the Diagram Beside the Text");
    const view = await frame(page);
    await view.waitForSelector("#picture svg");
    seen.title = await view.$eval("#title", (title) => title.textContent);
    await view.waitForSelector("#picture .here");
    seen.here = await view.$eval("#picture .here", (here) => here.id);
    await page.screenshot({ path: join(order.pictures, "diagram.png") });
    await focusText(page);
    await line(page, order.lines.second);
    await view.waitForFunction((before) => document.querySelector("#title").textContent !== before, {}, seen.title);
    seen.followed = await view.$eval("#title", (title) => title.textContent);
    await view.waitForSelector("#picture .here");
    const before = await cursor(page);
    const clicked = await view.evaluate((word) => {
      const place = [...document.querySelectorAll("#picture .place")].find((each) => each.textContent.includes(word));
      place.querySelector("text").dispatchEvent(new MouseEvent("click", { bubbles: true }));
      return place.id;
    }, order.click);
    await page.waitForFunction(
      (old) => document.querySelector("[id='status.editor.selection']")?.textContent !== old,
      {},
      before,
    );
    seen.clicked = clicked;
    seen.jumped = await cursor(page);
    await page.screenshot({ path: join(order.pictures, "clicked.png") });

    // The page of a diagnostic.
    await command(page, "ASEME: Explain a Diagnostic");
    await page.waitForSelector(".quick-input-widget input[placeholder=E101]");
    await pause(500);
    await page.keyboard.type("E101");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => [...document.querySelectorAll(".tab")].some((tab) => /E101/.test(tab.textContent)));
    seen.explained = true;

    // A task, and what its problem matcher makes of it.
    await command(page, "Tasks: Run Task");
    await choose(page, "Show All Tasks...", "");
    await choose(page, "asemec: check", "check");
    await page.waitForFunction(() =>
      /^[1-9]/.test(document.querySelector("[id='status.problems']")?.textContent.trim() ?? ""),
    );
    await command(page, "Problems: Focus on Problems View");
    await page.waitForFunction(() => /there is no role/.test(document.querySelector(".markers-panel")?.textContent ?? ""));
    seen.problems = await page.$$eval(".markers-panel .monaco-list-row", (rows) => rows.map((row) => row.textContent));
    await page.screenshot({ path: join(order.pictures, "problems.png") });
  } catch (error) {
    seen.failed = String(error);
    await page.screenshot({ path: join(order.pictures, "failed.png") });
  } finally {
    await browser.close();
  }
  process.stdout.write(JSON.stringify(seen));
}

const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.down(key);
  for (const key of keys.reverse()) await page.keyboard.up(key);
}

async function text(page, selector, wanted) {
  await page.waitForSelector(selector);
  await page.waitForFunction(
    (where, pattern) => new RegExp(pattern).test(document.querySelector(where)?.textContent ?? ""),
    {},
    selector,
    wanted.toString().match(/\/(.*)\//)[1],
  );
  return page.$eval(selector, (found) => found.textContent);
}

async function open(page, name) {
  await pause(1500);
  await press(page, "Control", "p");
  await page.waitForSelector(".quick-input-widget input");
  await page.keyboard.type(name);
  await page.waitForFunction(
    (wanted) => document.querySelector(".quick-input-list .monaco-list-row")?.textContent.includes(wanted),
    {},
    name,
  );
  await page.keyboard.press("Enter");
  await page.waitForSelector(".editor-instance .view-line");
}

async function command(page, name) {
  await focusText(page);
  await page.keyboard.press("F1");
  await choose(page, name);
}

/** Types into the list that is open, and takes the row of this name. */
async function choose(page, name, typed = name) {
  await page.waitForFunction(() => document.activeElement?.closest(".quick-input-widget"));
  await pause(500);
  await page.keyboard.type(typed);
  const found = await page.waitForFunction(
    (wanted) =>
      [...document.querySelectorAll(".quick-input-list .monaco-list-row")].find(
        (row) => row.querySelector(".label-name")?.textContent.replace(/\s/g, " ") === wanted,
      ),
    {},
    name,
  );
  await found.asElement().click();
}

async function focusText(page) {
  await press(page, "Control", "1");
  await pause(300);
}

async function line(page, number) {
  await focusText(page);
  await press(page, "Control", "g");
  await page.waitForSelector(".quick-input-widget input");
  await page.keyboard.type(String(number));
  await page.keyboard.press("Enter");
  await pause(200);
  await page.keyboard.press("End");
}

async function cursor(page) {
  return page.$eval("[id='status.editor.selection']", (found) => found.textContent);
}

async function frame(page) {
  const end = Date.now() + MOST;
  while (Date.now() < end) {
    for (const each of page.frames()) {
      if (await each.$("#picture").catch(() => null)) return each;
    }
    await pause(200);
  }
  throw new Error("there is no view of a diagram");
}

main();

// Whether Mermaid reads drawings: they come as JSON on standard input, what is wrong goes out.
import fs from "fs";
import { JSDOM } from "jsdom";

const page = new JSDOM("<!doctype html><html><body></body></html>");
globalThis.window = page.window;
globalThis.document = page.window.document;
const mermaid = (await import("mermaid")).default;
const found = [];
for (const file of JSON.parse(fs.readFileSync(0, "utf8"))) {
  try {
    await mermaid.parse(file.mermaid);
    found.push([]);
  } catch (error) {
    found.push([String(error).slice(0, 1000)]);
  }
}
process.stdout.write(JSON.stringify(found), () => process.exit(0));

// Inside the view: shows the picture that the extension sends, marks where the cursor is, and reports clicks.
"use strict";
const editor = acquireVsCodeApi();
const [title, note, picture] = ["title", "note", "picture"].map((id) => document.getElementById(id));
let places = new Set();
let scale = 1;
let fitted = true;

window.addEventListener("message", ({ data }) => {
  if (data.title !== undefined) title.textContent = data.title;
  if (data.note !== undefined) note.textContent = data.note;
  if (data.places !== undefined) places = new Set(data.places);
  if (data.svg !== undefined) show(data.svg, data.name);
  if (data.here !== undefined) mark(data.here);
});

function show(text, name) {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
  const svg = parsed.documentElement;
  if (svg.nodeName !== "svg") return;
  for (const link of svg.querySelectorAll("a")) link.removeAttributeNS("http://www.w3.org/1999/xlink", "href");
  const another = picture.dataset.name !== name;
  const { scrollLeft, scrollTop } = picture;
  picture.dataset.name = name;
  picture.replaceChildren(document.importNode(svg, true));
  for (const id of places) element(id)?.classList.add("place");
  if (another) fitted = true;
  size();
  if (!another) picture.scrollTo(scrollLeft, scrollTop);
}

function element(id) {
  return picture.querySelector(`[id="${CSS.escape(id)}"]`);
}

function mark(id) {
  for (const before of picture.querySelectorAll(".here")) before.classList.remove("here");
  const here = id === null ? null : element(id);
  if (!here) return;
  here.classList.add("here");
  // A transition is drawn in several parts: t3, t3.turn, t3.rest.
  const parts = id.startsWith("t") ? [...places].filter((place) => place.startsWith(`${id}.`)) : [];
  for (const part of parts) element(part)?.classList.add("here");
  const box = here.getBoundingClientRect();
  const view = picture.getBoundingClientRect();
  const seen = box.top >= view.top && box.bottom <= view.bottom && box.left >= view.left && box.right <= view.right;
  if (!seen) here.scrollIntoView({ block: "center", inline: "center" });
}

function size() {
  const svg = picture.querySelector("svg");
  if (!svg) return;
  const [, , width, height] = (svg.getAttribute("viewBox") ?? "0 0 100 100").split(/[\s,]+/).map(Number);
  if (fitted) {
    const space = [picture.clientWidth - 26, picture.clientHeight - 26];
    scale = Math.min(space[0] / width, space[1] / height, 1.4);
    scale = Math.max(scale, Math.min(0.6, space[0] / width)); // what is tall is scrolled rather than unreadable
  }
  svg.setAttribute("width", `${width * scale}`);
  svg.setAttribute("height", `${height * scale}`);
}

function zoom(factor) {
  fitted = false;
  scale = Math.min(Math.max(scale * factor, 0.05), 8);
  size();
}

picture.addEventListener("click", ({ target }) => {
  for (let node = target; node && node !== picture; node = node.parentNode) {
    if (places.has(node.id)) return editor.postMessage({ id: node.id });
  }
});
picture.addEventListener(
  "wheel",
  (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoom(event.deltaY < 0 ? 1.1 : 1 / 1.1);
  },
  { passive: false },
);
document.getElementById("in").addEventListener("click", () => zoom(1.25));
document.getElementById("out").addEventListener("click", () => zoom(0.8));
document.getElementById("fit").addEventListener("click", () => {
  fitted = true;
  size();
});
window.addEventListener("resize", size);

"use strict";
/* What is wider than its place can be reached and scrolled by keyboard; what fits is no stop on the way. */
let planned = false;
function markScrollable() {
  planned = false;
  const all = [...document.querySelectorAll(".wide, .long, .display")];
  const wider = all.map((element) => element.scrollWidth > element.clientWidth + 1);
  all.forEach((element, index) => {
    if (wider[index]) element.tabIndex = 0;
    else element.removeAttribute("tabindex");
  });
}
function planMarking() {
  if (!planned) { planned = true; setTimeout(markScrollable); } // a frame may be long in coming, where nobody looks
}
addEventListener("resize", planMarking);
addEventListener("load", planMarking);
document.addEventListener("toggle", planMarking, true);
document.fonts.ready.then(planMarking);

/* A row's page in a frame gives its contents to the first page, which shows them in place: files may not be fetched. */
const row = document.querySelector("main > article.row");
if (parent !== self && row) {
  for (const one of row.querySelectorAll("a")) one.href = one.href;
  for (const one of row.querySelectorAll("img")) one.src = one.src;
  parent.postMessage(row.outerHTML, "*");
}

const form = document.getElementById("filters");
if (form) {
  const rows = [...document.querySelectorAll("[data-row]")];
  const make = (tag, of, ...inside) => { const one = Object.assign(document.createElement(tag), of); one.append(...inside); return one; };
  const search = make("input", { type: "search", id: "search", placeholder: "words of a row" });
  const strongest = ["holds", "holds-corrected", "refuted", "not-judged", "undecided", "kernel", "smt", "exact", "enclosure", "argument"];
  const TITLES = { section: "Section", verdict: "Verdict", step: "Weakest step", open: "Open part" };
  const filters = Object.keys(TITLES).map((name) => {
    const rank = (one) => strongest.indexOf(one) >>> 0, found = [...new Set(rows.map((row) => row.dataset[name]))];
    const values = name === "section" ? found : found.sort((one, other) => rank(one) - rank(other) || (one < other ? 1 : -1));
    return [name, make("select", { id: `filter-${name}` }, make("option", { value: "" }, "all"), ...values.map((one) => make("option", { value: one }, one)))];
  });
  form.append(make("label", {}, "Search ", search), ...filters.map(([name, chosen]) => make("label", {}, `${TITLES[name]} `, chosen)), make("output", { id: "shown" }));
  const named = new Map(rows.map((row) => [row.dataset.row, row])), behind = new Map();

  function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of rows) {
      row.hidden = filters.some(([name, chosen]) => chosen.value && row.dataset[name] !== chosen.value)
        || !words.every((word) => row.dataset.words.includes(word));
      const below = behind.get(row);
      if (below) below.hidden = row.hidden || !below.dataset.open;
      if (!row.hidden) shown += 1;
    }
    document.getElementById("shown").textContent = `${shown} of ${rows.length} claims`;
  }

  function load(row, place) {
    const frame = Object.assign(document.createElement("iframe"), { hidden: true, title: row.dataset.row });
    addEventListener("message", function take(event) {
      if (event.source !== frame.contentWindow) return;
      removeEventListener("message", take);
      place.innerHTML = event.data;
      frame.remove();
      planMarking();
    });
    frame.src = row.querySelector("a").href;
    place.append("\u2026", frame);
  }

  function show(row, open) {
    let below = behind.get(row);
    if (!below) {
      below = document.createElement("tr");
      below.append(Object.assign(document.createElement("td"), { colSpan: 4, className: "behind" }));
      behind.set(row, below);
      row.after(below);
      load(row, below.firstChild);
    }
    below.dataset.open = open ? "yes" : "";
    below.hidden = !open;
    row.querySelector("a").setAttribute("aria-expanded", String(open));
  }

  function openTarget() {
    const row = named.get(decodeURIComponent(location.hash.slice(1)));
    if (!row) return;
    if (row.hidden) { search.value = ""; for (const [, chosen] of filters) chosen.value = ""; filter(); }
    show(row, true);
    row.scrollIntoView();
  }

  document.querySelector(".claims").addEventListener("click", (event) => {
    const row = event.target.closest("[data-row]"), link = event.target.closest("a");
    if (!row || event.ctrlKey || event.metaKey || event.shiftKey || (link && link !== row.querySelector("a"))) return;
    event.preventDefault();
    show(row, !(behind.has(row) && behind.get(row).dataset.open));
  });
  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", filter);
  for (const row of rows) row.querySelector("a").setAttribute("aria-expanded", "false");
  addEventListener("hashchange", openTarget);
  filter();
  openTarget();
}

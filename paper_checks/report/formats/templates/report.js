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

/* A link opens all that its target is folded in. */
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.hidden) showAll();
  for (let one = target.closest("details"); one; one = one.parentElement.closest("details")) one.open = true;
  target.scrollIntoView();
}

const form = document.getElementById("filters"), claims = [...document.querySelectorAll(".claim")];
const make = (tag, of, ...inside) => { const one = Object.assign(document.createElement(tag), of); one.append(...inside); return one; };
const search = make("input", { type: "search", id: "search", placeholder: "words of a claim" });
const strongest = ["holds", "holds-corrected", "refuted", "not-judged", "undecided", "kernel", "smt", "exact", "enclosure", "argument"];
const TITLES = { section: "Section", verdict: "Verdict", step: "Weakest step", open: "Open part" };
const filters = Object.keys(TITLES).map((name) => {
  const rank = (one) => strongest.indexOf(one) >>> 0, found = [...new Set(claims.map((claim) => claim.dataset[name]))];
  const values = name === "section" ? found : found.sort((one, other) => rank(one) - rank(other) || (one < other ? 1 : -1));
  return [name, make("select", { id: `filter-${name}` }, make("option", { value: "" }, "all"), ...values.map((one) => make("option", { value: one }, one)))];
});
form.append(make("label", {}, "Search ", search), ...filters.map(([name, chosen]) => make("label", {}, `${TITLES[name]} `, chosen)), make("output", { id: "shown" }));

function filter() {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const claim of claims) {
    claim.hidden = filters.some(([name, chosen]) => chosen.value && claim.dataset[name] !== chosen.value)
      || !words.every((word) => claim.dataset.words.includes(word));
  }
  document.getElementById("shown").textContent = `${claims.filter((claim) => !claim.hidden).length} of ${claims.length} claims`;
}

function showAll() {
  search.value = "";
  for (const [, chosen] of filters) chosen.value = "";
  filter();
}

form.hidden = false;
form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener("input", filter);
addEventListener("hashchange", reveal);
document.addEventListener("click", (event) => { if (event.target.closest('a[href^="#"]')) setTimeout(reveal); }); // also where the address stays the same
filter();
reveal();

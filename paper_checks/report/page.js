"use strict";
const claims = [...document.querySelectorAll(".claims > tbody")];
const section = document.getElementById("filter-section");
const verdict = document.getElementById("filter-verdict");

function filter() {
  for (const claim of claims) {
    claim.hidden = (section.value && claim.dataset.section !== section.value)
      || (verdict.value && claim.dataset.verdict !== verdict.value);
  }
  const shown = claims.filter((claim) => !claim.hidden).length;
  document.getElementById("shown").textContent = `${shown} of ${claims.length} claims`;
}

function openTarget() {
  const target = claims.find((claim) => claim.id === decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.hidden) { section.value = verdict.value = ""; filter(); }
  target.querySelector("details").open = true;
  target.scrollIntoView();
}

document.getElementById("filters").hidden = false;
section.addEventListener("change", filter);
verdict.addEventListener("change", filter);
document.getElementById("open-all").addEventListener("click", () => {
  const all = claims.filter((claim) => !claim.hidden).map((claim) => claim.querySelector("details"));
  const open = all.some((details) => !details.open);
  for (const details of all) details.open = open;
});
addEventListener("hashchange", openTarget);
addEventListener("beforeprint", () => { for (const claim of claims) claim.querySelector("details").open = true; });
filter();
openTarget();

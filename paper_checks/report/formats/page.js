const claims = [...document.querySelectorAll(".claims > tbody")];
const filters = ["section", "verdict", "step", "open"].map((name) => [name, document.getElementById(`filter-${name}`)]);
const behind = (claim) => claim.querySelector("details");

function filter() {
  for (const claim of claims) {
    claim.hidden = filters.some(([name, chosen]) => chosen.value && claim.dataset[name] !== chosen.value);
  }
  for (const table of document.querySelectorAll(".claims")) {
    table.hidden = [...table.tBodies].every((claim) => claim.hidden);
  }
  const shown = claims.filter((claim) => !claim.hidden).length;
  document.getElementById("shown").textContent = `${shown} of ${claims.length} rows`;
}

function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.hidden) { for (const [, chosen] of filters) chosen.value = ""; filter(); }
  if (claims.includes(target)) behind(target).open = true;
  for (let around = target; around; around = around.parentElement) {
    if (around.tagName === "DETAILS") around.open = true;
  }
  target.scrollIntoView();
}

document.getElementById("filters").hidden = false;
for (const [, chosen] of filters) chosen.addEventListener("change", filter);
document.getElementById("open-all").addEventListener("click", () => {
  const all = claims.filter((claim) => !claim.hidden).map(behind);
  const open = all.some((details) => !details.open);
  for (const details of all) details.open = open;
});
addEventListener("hashchange", openTarget);
addEventListener("beforeprint", () => { for (const claim of claims) behind(claim).open = true; });
filter();
openTarget();

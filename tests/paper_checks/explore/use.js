// What test_use.py does with the page, and what it saw.
const by = (id) => document.getElementById(`explore-${id}`), all = (what) => [...document.querySelectorAll(what)];
const regime = () => by("regime").textContent, change = (one) => one.dispatchEvent(new Event("change"));
const field = (name) => document.querySelector(`[data-name="${name}"] input[type=number]`);
const type = (name, text) => {
  field(name).value = text;
  change(field(name));
  return field(name).getAttribute("aria-invalid");
};
const found = {};

found.regimes = all("[data-scene]").map((button) => { button.click(); return [button.textContent, regime()]; });
found.files = all("[data-scene]").map((button) => { button.click(); return [by("file").textContent, inertialPair.scenes[button.dataset.scene].scene]; });
found.pressed = all("[aria-pressed=true]").length;

all("[data-scene]")[1].click();
found.proof = [by("regime").textContent.endsWith("See claim critical-mass-ratio."), by("regime").querySelector("a")];
inertialPair.beside.push("critical-mass-ratio");
all("[data-scene]")[1].click();
found.proof.push(by("regime").querySelector("a").getAttribute("href"));
all("[data-scene]")[0].click();
found.merging = [...by("rows").children].map((row) => row.firstChild.textContent);
by("ratio").value = 900;
by("ratio").dispatchEvent(new Event("input"));
found.slid = [field("ratio").value, by("ratio").getAttribute("aria-valuetext"), all("[aria-pressed=true]").length, by("units").hidden];
found.hidden = ["none", "sine", "none"].map((kind) => {
  by("force").value = kind;
  change(by("force"));
  return document.querySelector("[data-name=size]").hidden;
});
found.invalid = [type("V1", ""), type("V1", "1e99"), type("V1", "-3"), by("V1").value < 500];

by("literal").checked = true;
change(by("literal"));
found.literal = regime();
by("literal").checked = false;
change(by("literal"));
return found;

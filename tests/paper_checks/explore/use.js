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

const tab = (name) => by(`tab-${name}`), hidden = (name) => by(name).hidden;
tab("line").focus();
tab("line").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
found.tabs = [["line", "above"].map((name) => tab(name).getAttribute("aria-selected")), hidden("line"), hidden("above"), document.activeElement.id];
const typed = (name) => document.querySelector(`#explore-above [data-name="${name}"] input[type=number]`).value;
found.above = all("[data-above]").map((button) => { button.click(); return [button.textContent, by("above-regime").textContent]; });
all("[data-above]")[0].click();
const canvas = by("above-picture"), place = inertialPair.placeAbove;
const at = (kind, [offsetX, offsetY], pointerType = "mouse") => {
  const event = new PointerEvent(kind, { pointerId: 1, bubbles: true, pointerType });
  Object.defineProperties(event, { offsetX: { value: offsetX }, offsetY: { value: offsetY } });
  canvas.dispatchEvent(event);
};
canvas.setPointerCapture = () => {};
canvas.hasPointerCapture = () => true;
at("pointerdown", place([1.01, 0]));
at("pointermove", place([0.5, 0.25]));
at("pointerup", place([0.5, 0.25]));
const finger = (point) => {
  at("pointerdown", place(point), "touch");
  const touch = new Event("touchstart", { bubbles: true, cancelable: true });
  canvas.dispatchEvent(touch);
  at("pointermove", place([point[0], point[1] + 0.1]), "touch");
  at("pointerup", place(point), "touch");
  return [touch.defaultPrevented, typed("x"), typed("y")];
};
found.scrolled = finger([-0.5, -0.5]);
found.taken = finger([0.5, 0.25]);
at("pointerdown", place([0.5, 0.35]));
at("pointermove", place([0.5, 0.25]));
at("pointerup", place([0.5, 0.25]));
found.dragged = [typed("x"), typed("y"), all("#explore-above [aria-pressed=true]").length === 0];
canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true }));
found.pushed = [Number(typed("x")), Number(typed("y"))];
canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true, cancelable: true }));
at("pointerdown", place([0.5, 0.25 + 0.4 * Number(typed("v1y"))]));
at("pointermove", place([0.9, -0.15]));
at("pointerup", place([0.9, -0.15]));
found.thrown = ["x", "y", "v1x", "v1y"].map(typed);
by("above-force").value = "constant";
change(by("above-force"));
const before2 = Number(typed("angle"));
canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "+", bubbles: true, cancelable: true }));
found["turned-force"] = Number(typed("angle")) - before2;
found.file = by("above-file").textContent;
found.mode = by("above-now").textContent.split(": ")[1].split(";")[0];
tab("line").click();
found.back = [hidden("line"), hidden("above")];
return found;

// What test_in_place.py does with the first page, and what it saw.
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const rows = [...document.querySelectorAll("[data-row]")], found = {};
const row = rows.find((one) => one.dataset.row === OPENED), link = row.querySelector("a");
const below = () => row.nextElementSibling.querySelector(".behind");
const shown = () => rows.filter((one) => !one.hidden).map((one) => one.dataset.row);
found.before = [document.querySelectorAll(".behind, iframe").length, link.getAttribute("aria-expanded")];
link.click();
for (let n = 0; n < 40 && !(below() && below().querySelector("article")); n += 1) await wait(100);
found.text = below().textContent;
found.links = [...below().querySelectorAll("a")].map((one) => one.getAttribute("href"));
found.images = await Promise.all([...below().querySelectorAll("img")].map(async (one) => {
  one.loading = "eager";
  await one.decode().catch(() => {});
  return one.naturalWidth;
}));
found.after = [document.querySelectorAll("iframe").length, link.getAttribute("aria-expanded"), location.hash];
link.click();
found.closed = [below().parentElement.hidden, link.getAttribute("aria-expanded")];
const search = document.getElementById("search");
const type = (text) => { search.value = text; search.dispatchEvent(new Event("input", { bubbles: true })); return shown(); };
found.searched = [type("BOUND printed"), type("no such word"), type("")];
type("no such word");
location.hash = OPENED;
await wait(200);
found.targeted = [row.hidden, below().parentElement.hidden];
const choose = (name, value) => {
  const one = document.getElementById(`filter-${name}`);
  one.value = value;
  one.dispatchEvent(new Event("input", { bubbles: true }));
  return shown();
};
found.chosen = [choose("verdict", "refuted"), choose("verdict", "")];
found.shown = document.getElementById("shown").textContent;
return found;

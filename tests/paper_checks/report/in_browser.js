// What test_html.py does with the report, and what it saw.
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const claims = [...document.querySelectorAll(".claim")], found = {};
const claim = claims.find((one) => one.id === OPENED);
const shown = () => claims.filter((one) => !one.hidden).map((one) => one.id);
found.closed = document.querySelectorAll("details[open]").length;
claim.querySelector("summary").click();
found.opened = [claim.open, claim.querySelector("article").getBoundingClientRect().height > 100];
found.images = await Promise.all([...claim.querySelectorAll("img")].map(async (one) => {
  one.loading = "eager";
  await one.decode().catch(() => {});
  return one.naturalWidth;
}));
claim.open = false;
const search = document.getElementById("search");
const type = (text) => { search.value = text; search.dispatchEvent(new Event("input", { bubbles: true })); return shown(); };
found.searched = [type("BOUND printed"), type("no such word"), type("")];
type("no such word");
location.hash = OPENED;
await wait(200);
found.targeted = [claim.hidden, claim.open];
claim.open = false;
document.querySelector(`a[href="#${OPENED}"]`).click();
await wait(200);
found.again = claim.open;
location.hash = "symbol-E";
await wait(200);
found.folded = document.getElementById("notation").open;
const choose = (name, value) => {
  const one = document.getElementById(`filter-${name}`);
  one.value = value;
  one.dispatchEvent(new Event("input", { bubbles: true }));
  return shown();
};
found.chosen = [choose("verdict", "refuted"), choose("verdict", "")];
found.shown = document.getElementById("shown").textContent;
found.wide = document.documentElement.scrollWidth - innerWidth;
return found;

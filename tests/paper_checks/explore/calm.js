// A reader who wants less motion plays a scene: what is told after each second, and when its motions begin.
const by = (id) => document.getElementById(`explore-${id}`), seen = [];
document.querySelectorAll("[data-scene]")[1].click();
by("start").click();
seen.push(by("now").textContent);
by("play").click();
for (let n = 0; n < 2; n += 1) {
  await new Promise((done) => setTimeout(done, 1050));
  seen.push(by("now").textContent);
}
return [seen, [...by("rows").children].map((row) => row.children[1].textContent)];

// The page WHOLE in a frame as wide as a phone: how wide it gets, what sticks out, and the picture's width.
const frame = Object.assign(document.createElement("iframe"), { width: 390, height: 844, srcdoc: WHOLE });
document.body.append(frame);
await new Promise((done) => { frame.onload = done; });
const inside = frame.contentDocument;
await new Promise((done) => setTimeout(done, 50));
const out = [...inside.querySelectorAll("#explore *")].filter((one) => one.getBoundingClientRect().right > 391);
return [
  inside.documentElement.scrollWidth,
  out.filter((one) => !one.closest(".explore-wide")).map((one) => `${one.tagName}#${one.id}`),
  inside.querySelector("canvas").clientWidth,
];

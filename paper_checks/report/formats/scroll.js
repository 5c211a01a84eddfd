"use strict";
// What is wider than its place can be reached and scrolled by keyboard; what fits is no stop on the way.
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
document.addEventListener("toggle", planMarking, true);
document.fonts.ready.then(planMarking);

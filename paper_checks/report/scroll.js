"use strict";
// What is wider than its place can be reached and scrolled by keyboard; what fits is no stop on the way.
function markScrollable() {
  for (const element of document.querySelectorAll(".wide, .long, .display")) {
    if (element.scrollWidth > element.clientWidth + 1) element.tabIndex = 0;
    else element.removeAttribute("tabindex");
  }
}
addEventListener("resize", markScrollable);
document.addEventListener("toggle", markScrollable, true);
document.fonts.ready.then(markScrollable);

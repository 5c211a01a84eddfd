/* Tabs: one panel is shown; the arrow keys, Home and End go from tab to tab. The address may name one, #explore-tab-above. */

function tabsOf(list, changed) {
  const tabs = [...list.querySelectorAll("[role=tab]")], panelOf = (tab) => document.getElementById(tab.getAttribute("aria-controls"));
  const choose = (chosen) => {
    for (const tab of tabs) {
      const on = tab === chosen;
      tab.setAttribute("aria-selected", String(on));
      tab.tabIndex = on ? 0 : -1;
      panelOf(tab).hidden = !on;
    }
    changed();
  };
  tabs.forEach((tab, n) => {
    tab.addEventListener("click", () => choose(tab));
    tab.addEventListener("keydown", ({ key }) => {
      const to = { ArrowRight: n + 1, ArrowLeft: n - 1, Home: 0, End: -1 }[key];
      if (to === undefined) return;
      const next = tabs.at(to % tabs.length);
      choose(next);
      next.focus();
    });
  });
  choose(tabs.find((tab) => `#${tab.id}` === location.hash) || tabs[0]);
}

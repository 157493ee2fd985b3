"use strict";
// Filters: an entry is shown if it has one of the chosen states, one of the chosen tags, the chosen object, and the
// words. The address has them behind its #, so that a link leads to what one sees.
document.documentElement.classList.add("scripted");

const wall = document.getElementById("wall");
const cards = [...wall.children];
const states = [...document.querySelectorAll("[data-choose-state]")];
const tags = [...document.querySelectorAll("[data-choose-tag]")];
const object = document.getElementById("object");
const words = document.getElementById("words");
const order = document.getElementById("order");

function pressed(buttons, key) {
  return new Set(buttons.filter((b) => b.getAttribute("aria-pressed") === "true").map((b) => b.dataset[key]));
}

function list(card, key) {
  return card.dataset[key] ? card.dataset[key].split(" ") : [];
}

function is_shown(card, chosen) {
  const {state, tag, seen, text} = chosen;
  if (state.size > 0 && !state.has(card.dataset.state) && !(state.has("bless") && card.dataset.bless)) return false;
  if (tag.size > 0 && !list(card, "tags").some((t) => tag.has(t))) return false;
  if (seen !== "" && !list(card, "objects").includes(seen)) return false;
  return text === "" || card.querySelector(".words").textContent.toLowerCase().includes(text);
}

function show() {
  const chosen = {
    state: pressed(states, "chooseState"), tag: pressed(tags, "chooseTag"),
    seen: object ? object.value : "", text: words.value.trim().toLowerCase(),
  };
  let count = 0;
  for (const card of cards) {
    card.hidden = !is_shown(card, chosen);
    if (!card.hidden) ++count;
  }
  document.getElementById("shown").textContent =
    count === cards.length ? "" : `${count} of ${cards.length} are shown`;
  const parts = new URLSearchParams();
  for (const value of chosen.state) parts.append("state", value);
  for (const value of chosen.tag) parts.append("tag", value);
  if (chosen.seen !== "") parts.set("object", chosen.seen);
  if (chosen.text !== "") parts.set("words", chosen.text);
  history.replaceState(null, "", parts.toString() === "" ? location.pathname + location.search : "#" + parts);
}

function sort() {
  const by = {
    worst: (a, b) => a.dataset.rank - b.dataset.rank,
    name: (a, b) => a.dataset.name < b.dataset.name ? -1 : 1,
    time: (a, b) => b.dataset.seconds - a.dataset.seconds,
  }[order.value];
  wall.append(...[...cards].sort(by));
}

function from_address() {
  const parts = new URLSearchParams(location.hash.slice(1));
  for (const button of states)
    button.setAttribute("aria-pressed", parts.getAll("state").includes(button.dataset.chooseState));
  for (const button of tags) button.setAttribute("aria-pressed", parts.getAll("tag").includes(button.dataset.chooseTag));
  if (object) object.value = parts.get("object") ?? "";
  words.value = parts.get("words") ?? "";
  show();
}

for (const button of [...states, ...tags])
  button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", button.getAttribute("aria-pressed") !== "true");
    show();
  });
object?.addEventListener("change", show);
words.addEventListener("input", show);
order.addEventListener("change", sort);
window.addEventListener("hashchange", from_address);
from_address();

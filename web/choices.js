"use strict";

/** What could happen in the state that is shown, what was taken marked; each can be taken. */
const Choices = (() => {
  /** @type {Player} */
  let player;
  /** @type {List} */
  let list;
  /** @type {HTMLElement} */
  let said;
  /** @type {HTMLElement} */
  let further;
  /** @type {DataChoice[]} */
  let possible = [];
  let state = -1;
  let at = -1;
  /** @type {DataStep[] | null} */
  let steps = null;

  /** @param {Player} of */
  function start(of) {
    player = of;
    said = Dom.make("p", { class: "quiet", test: "choices-said" });
    further = Dom.button("Go on by first choices", goOn, {
      class: "small",
      test: "go-on",
      title: "Take what is possible first, again and again: until nothing is, or a state comes again",
    });
    Dom.get("choices").append(said);
    list = new List(Dom.get("choices"), {
      label: "What can happen here: Enter takes it",
      height: 44,
      row,
      choose: take,
      step: (index) => list.mark(index),
      test: "choices-list",
    });
    list.box.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || list.current < 0) return;
      event.preventDefault();
      take(list.current);
    });
    Dom.get("choices").append(Dom.make("p", {}, [further]));
    player.on("move", show);
    show();
  }

  /** Steps after which going on stops. */
  const most = 200;

  function goOn() {
    if (!player.goOn(most)) Dom.tell(said, "There is no state to go on to in the file.");
  }

  /** @param {number} index */
  function take(index) {
    if (player.choose(index)) list.box.focus({ preventScroll: true });
    else
      Dom.tell(
        said,
        "The state that this leads to is not in the file: it lies beyond the bound of its state graph.",
      );
  }

  /** @returns {number} which of them the run takes, or -1 */
  function taken() {
    const leg = player.course.legs[player.legs];
    return leg && typeof leg.choice === "number" ? leg.choice : -1;
  }

  function show() {
    if (player.state === state && player.legs === at && player.run.steps === steps) return;
    if (player.playing && player.legs === at) return;
    state = player.state;
    at = player.legs;
    steps = player.run.steps;
    const next = player.data.states[state].next;
    possible = next || [];
    list.show(possible.length, taken());
    list.box.style.height = `${Math.min(5, possible.length) * 44 + 2}px`;
    list.nothing.hidden = true;
    const step = at < player.run.steps.length ? player.run.steps[at] : null;
    const before = at > 0 ? player.run.steps[at - 1] : null;
    further.hidden = at < player.run.steps.length || !(next || []).some((one) => one.to !== null);
    const turning = (step && step.tail) || (before && before.tail);
    const asked = step && next && step.choice !== null ? next[step.choice] : null;
    const part = step && (step.choice === null ? next !== null : asked && asked.label !== step.label);
    Dom.tell(
      said,
      turning
        ? "Nothing but the passing of time is possible."
        : next === null
          ? "What else is possible here is not in the file: it lies beyond the bound of its state graph."
          : possible.length === 0
            ? player.data.states[state].stuck
              ? "Nothing is possible here."
              : "Nothing is possible any more."
            : part
              ? "The run lets less time pass here than could. Choose something to go there."
              : possible.length === 1
                ? "One thing is possible."
                : `${possible.length} things are possible. Choose one to go there.`,
    );
  }

  /** @param {number} index @param {HTMLElement} element */
  function row(index, element) {
    const choice = possible[index];
    const label = player.data.labels[choice.label];
    const here = index === taken();
    element.classList.add(`kind-${label.kind}`);
    element.classList.toggle("away", choice.to === null);
    element.setAttribute("data-label", Dom.clip(label.text, 1000));
    element.append(
      Dom.make("span", { class: "dot", "aria-hidden": "true" }),
      Dom.make("span", { class: "row-text" }, [
        Dom.name(Dom.clip(label.words || label.text, 600), "words clipped"),
      ]),
      Dom.make("span", { class: "row-side" }, [
        Dom.make("span", {
          class: here ? "taken" : "quiet",
          text: here ? "taken" : choice.to === null ? "not in the file" : "",
        }),
        choice.rules.length === 0
          ? null
          : Dom.make("span", {
              class: "link",
              text: choice.rules[0],
              click: (/** @type {Event} */ event) => {
                event.stopPropagation();
                Rules.show(choice.rules[0]);
              },
            }),
      ]),
    );
  }

  function focus() {
    list.box.focus();
  }

  return { start, focus };
})();

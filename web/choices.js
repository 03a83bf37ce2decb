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
    player.on("grow", () => {
      state = -1;
      show();
    });
    show();
  }

  /** Steps after which going on stops. */
  const most = 200;

  function goOn() {
    const none = Live.on ? "There is no state to go on to." : "There is no state to go on to in the file.";
    when(player.goOn(most), (done) => done || Dom.tell(said, none));
  }

  /** @param {number} index */
  function take(index) {
    const none = Live.on
      ? "The state that this leads to could not be asked for."
      : "The state that this leads to is not in the file: it lies beyond the bound of its state graph.";
    when(player.choose(index), (done) => {
      if (done) list.box.focus({ preventScroll: true });
      else Dom.tell(said, none);
    });
  }

  /**
   * Does something at once, or when an answer has come, if one has not gone elsewhere meanwhile.
   * @param {boolean | Promise<boolean | null>} answer @param {(done: boolean) => void} then
   */
  function when(answer, then) {
    if (typeof answer === "boolean") then(answer);
    else answer.then((done) => done !== null && then(done));
  }

  /** The state that was asked for. */
  let asked = -1;

  /** A served page asks what is possible in the state that is shown. */
  function look() {
    const here = player.state;
    if (player.playing || asked === here || player.data.states[here].next || Grow.why(here) || turning()) return;
    asked = here;
    Grow.expand(here, { still: () => player.state === here && !player.playing }).then(() => {
      asked = -1;
    });
  }

  /** Whether time alone passes here for ever. */
  function turning() {
    const { steps } = player.run;
    const step = steps[player.legs], before = steps[player.legs - 1];
    return Boolean((step && step.tail) || (before && before.tail));
  }

  /** @returns {number} which of them the run takes, or -1 */
  function taken() {
    const leg = player.course.legs[player.legs];
    return leg && typeof leg.choice === "number" ? leg.choice : -1;
  }

  function show() {
    if (Live.on) look();
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
    const onwards = Live.on ? next === null || next.length > 0 : (next || []).some((one) => one.to !== null);
    further.hidden = at < player.run.steps.length || !onwards || turning();
    const asked = step && next && step.choice !== null ? next[step.choice] : null;
    const part = step && (step.choice === null ? next !== null : asked && asked.label !== step.label);
    Dom.tell(
      said,
      turning()
        ? "Nothing but the passing of time is possible."
        : next === null
          ? unknown()
          : possible.length === 0
            ? player.data.states[state].stuck
              ? "Nothing is possible here."
              : "Nothing is possible any more."
            : part
              ? "The run lets less time pass here than could. Choose something to go there."
              : possible.length === 1
                ? "One thing is possible."
                : `${possible.length} things are possible.${Live.on || possible.some((one) => one.to !== null) ? " Choose one to go there." : ""}`,
    );
  }

  /** What is said where it is not known what is possible. */
  function unknown() {
    if (!Live.on) return "What else is possible here is not in the file: it lies beyond the bound of its state graph.";
    const why = Grow.why(state);
    return why ? `What is possible here could not be looked at: ${why}.` : "…";
  }

  /** @param {number} index @param {HTMLElement} element */
  function row(index, element) {
    const choice = possible[index];
    const label = player.data.labels[choice.label];
    const here = index === taken();
    element.classList.add(`kind-${label.kind}`);
    const away = choice.to === null && !Live.on;
    element.classList.toggle("away", away);
    element.setAttribute("data-label", Dom.clip(label.text, 1000));
    element.append(
      Dom.make("span", { class: "dot", "aria-hidden": "true" }),
      Dom.make("span", { class: "row-text" }, [
        Dom.name(Dom.clip(label.words || label.text, 600), "words clipped"),
      ]),
      Dom.make("span", { class: "row-side" }, [
        Dom.make("span", {
          class: here ? "taken" : "quiet",
          text: here ? "taken" : away ? "not in the file" : "",
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

"use strict";

/** The events of the run in words, the present one marked; and what is said of where one is. */
const Events = (() => {
  /** @type {Player} */
  let player;
  /** @type {List} */
  let list;
  let told = 0;
  let timer = 0;

  /** @param {Player} of */
  function start(of) {
    player = of;
    list = new List(Dom.get("events"), {
      label: "Events of the run",
      height: 44,
      row,
      choose: (index) => {
        player.pause();
        player.go(index);
      },
      test: "events-list",
    });
    player.on("run", show);
    player.on("move", move);
    player.on("grow", now);
    show();
    move();
  }

  function show() {
    list.show(player.course.legs.length + 1, player.legs);
  }

  /**
   * The words of what led to a position of the run.
   * @param {number} legs
   */
  function words(legs) {
    if (legs === 0) return "the beginning";
    return label(legs).words || label(legs).text;
  }

  /** @param {number} legs @returns {DataLabel} */
  function label(legs) {
    return player.data.labels[player.run.steps[legs - 1].label];
  }

  /** @param {number} index @param {HTMLElement} element */
  function row(index, element) {
    const kind = index === 0 ? "start" : label(index).kind;
    const rules = index === 0 ? [] : player.run.steps[index - 1].rules;
    element.classList.add(`kind-${kind}`);
    element.append(
      Dom.make("span", { class: "dot", "aria-hidden": "true" }),
      Dom.make("span", { class: "row-text" }, [Dom.name(Dom.clip(words(index), 600), "words clipped")]),
      Dom.make("span", { class: "row-side" }, [
        Dom.make("span", { class: "time", text: Dom.clip(short(player.instant(index)), 40) }),
        rules.length === 0
          ? null
          : Dom.make("span", {
              class: "link",
              text: rules[0],
              click: (/** @type {Event} */ event) => {
                event.stopPropagation();
                player.go(index);
                Rules.show(rules[0]);
              },
            }),
      ]),
    );
  }

  /** @param {Rational} time */
  function short(time) {
    const exact = Exactly.text(time);
    return exact.length <= 10 ? exact : Exactly.told(time);
  }

  function move() {
    list.mark(player.legs);
    if (player.playing) {
      // While the run is played, an event is told at most every two seconds, and time as decimals.
      if (player.legs === told) return;
    }
    told = player.legs;
    now();
  }

  function now() {
    const legs = player.legs;
    const count = player.course.legs.length;
    const box = Dom.get("now");
    const kind = legs === 0 ? "start" : label(legs).kind;
    const after = player.between && !player.playing;
    const rules = legs === 0 ? [] : player.run.steps[legs - 1].rules;
    Dom.fill(
      box,
      Dom.make("p", { class: `now-words kind-${kind}` }, [
        Dom.make("span", { class: "dot", "aria-hidden": "true" }),
        Dom.make("bdi", { class: "words", text: words(legs), test: "now-words" }),
      ]),
      Dom.make("dl", { class: "facts" }, [
        Dom.make("dt", { text: "at time" }),
        Dom.make("dd", {}, [Exactly.show(player.instant(legs))]),
        after ? Dom.make("dt", { text: "now at" }) : null,
        after ? Dom.make("dd", {}, [Exactly.show(player.time)]) : null,
        Dom.make("dt", { text: "step" }),
        Dom.make("dd", { text: `${legs} of ${count}`, test: "now-step" }),
        rules.length === 0 ? null : Dom.make("dt", { text: rules.length === 1 ? "rule" : "rules" }),
        rules.length === 0
          ? null
          : Dom.make(
              "dd",
              {},
              rules.map((rule) => Rules.link(rule)),
            ),
      ]),
      player.playing ? null : Changes.show(player),
      ending(legs === count),
    );
    announce(`${words(legs)}. Step ${legs} of ${count}, time ${Exactly.both(player.time)}.`);
  }

  /**
   * What is said where the run ends.
   * @param {boolean} last
   */
  function ending(last) {
    const state = player.data.states[player.state];
    const said = state.stuck
      ? `Nothing can happen, and no time can pass: ${state.stuck}`
      : state.rests
        ? "Nothing will ever happen again."
        : last && player.run.way === null && typeof player.run.cycle === "number"
          ? `From here on the run repeats all from step ${player.run.cycle} on, for ever.`
          : null;
    return said === null ? null : Dom.make("p", { class: "quiet", text: said });
  }

  /** @param {string} text */
  function announce(text) {
    clearTimeout(timer);
    timer = window.setTimeout(
      () => Dom.tell(Dom.get("live"), Dom.clip(text, 500)),
      player.playing ? 1500 : 150,
    );
  }

  return { start, words };
})();

"use strict";

/** The runs to choose from, each with its check and verdict; and why the verdict of the one shown is so. */
const Runs = (() => {
  /** @type {Player} */
  let player;
  /** @type {HTMLElement} */
  let box;
  /**
   * Entries of the list: runs, and checks that no run shows.
   * @type {Entry[]}
   */
  let entries = [];
  let chosen = 0;

  /**
   * What is said where no run is the reason of a verdict.
   * @param {DataRun["check"]} check
   */
  const bare = (check) =>
    check && check.verdict === "undecided" ? "It is undecided: no run shows more of it." : "A verdict about all runs: no single run shows it.";

  /**
   * What is said over the scene where the run that is shown does not decide its check.
   * @param {PlayedRun} run
   */
  function note(run) {
    if (run.bare) return `${bare(run.check)} This is the beginning.`;
    const [why] = run.ending || [];
    if (!run.check || !why || Player.decisive.includes(run.finish || "")) return "";
    return `${why[0].toUpperCase()}${why.slice(1)}. This is a run from there, by first choices.`;
  }

  /** @typedef {{name: string, check: DataRun["check"], run: PlayedRun}} Entry */

  /** @param {Player} of */
  function start(of) {
    player = of;
    box = Dom.make("div", {
      class: "cards",
      role: "listbox",
      tabindex: "0",
      "aria-labelledby": "runs-head",
      keydown: key,
    });
    Dom.get("runs").append(box);
    player.on("run", show);
    show();
  }

  function show() {
    entries = player.data.runs.flatMap((run, index) =>
      isAside(run, index) ? [] : [{
        name: run.name,
        check: run.check,
        run: /** @type {PlayedRun} */ (player.base(index)),
      }]);
    for (const run of player.runs) if (run.way !== null) entries.push({ name: run.name, check: null, run });
    if (entries.length === 0) entries.push({ name: player.run.name, check: null, run: player.run });
    chosen = entries.findIndex((entry) => entry.run === player.run);
    Dom.fill(box, ...entries.map(card));
    const text = note(player.run);
    Dom.get("scene-note").hidden = text === "";
    Dom.get("scene-note").textContent = text;
    reasons(entries[chosen]);
    mark();
  }

  /**
   * What is listed only while it is shown, or what it belongs to.
   * @param {DataRun} run @param {number} index
   */
  function isAside(run, index) {
    if (index === player.run.index) return false;
    return run.sample || (run.contrast !== undefined && player.run.index !== index - 1);
  }

  /** @param {Entry} entry @param {number} index */
  function card(entry, index) {
    const verdict = entry.check ? entry.check.verdict : entry.run.way ? "own" : "run";
    return Dom.make(
      "div",
      {
        class: `card verdict-${verdict.split("-")[0]}${entry.run.bare ? " bare" : ""}`,
        role: "option",
        id: `run-${index}`,
        test: "run",
        "title": entry.run.bare ? bare(entry.check) : null,
        "data-run": entry.name.slice(0, 200),
        click: () => choose(index),
      },
      [
        Dom.make("span", { class: "card-top" }, [
          Dom.name(Dom.clip(entry.name, 300), "name clipped"),
          Dom.make("span", { class: "verdict", text: said(entry) }),
        ]),
        entry.check
          ? Dom.make("bdi", { class: "formula clipped", text: Dom.clip(entry.check.formula, 400) })
          : null,
      ],
    );
  }

  /** @param {Entry} entry */
  function said(entry) {
    if (entry.run.contrast !== undefined && !entry.run.way) return "does otherwise";
    if (!entry.check) return entry.run.way ? "by choices" : "run";
    return entry.check.verdict.replace(/-/g, " ");
  }

  /** @param {number} index */
  function choose(index) {
    const entry = entries[index];
    chosen = index;
    if (entry.run !== player.run && Spread.there()) Spread.open(entry.run);
    else if (entry.run !== player.run) player.open(entry.run);
    else {
      reasons(entry);
      mark();
    }
    if (!Spread.there() || Tabs.shown() !== "spread") Tabs.show("why");
  }

  function mark() {
    [...box.children].forEach((child, i) => {
      child.setAttribute("aria-selected", String(i === chosen));
      child.classList.toggle("here", i === chosen);
    });
    if (chosen >= 0) {
      box.setAttribute("aria-activedescendant", `run-${chosen}`);
      const card = /** @type {HTMLElement} */ (box.children[chosen]);
      if (
        card.offsetTop < box.scrollTop ||
        card.offsetTop + card.offsetHeight > box.scrollTop + box.clientHeight
      ) {
        box.scrollTop = card.offsetTop - 20;
      }
    }
  }

  /**
   * Goes to the next run, or the one before.
   * @param {number} by
   */
  function step(by) {
    const to = Math.max(0, Math.min(entries.length - 1, chosen + by));
    if (to !== chosen) choose(to);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    /** @type {{[key: string]: number}} */
    const moves = { ArrowDown: 1, ArrowUp: -1, Home: -entries.length, End: entries.length };
    if (moves[event.key] === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    step(moves[event.key]);
  }

  /**
   * Why a verdict is so.
   * @param {Entry | undefined} entry
   */
  function reasons(entry) {
    const panel = Dom.get("why");
    if (!entry) return;
    const { run, check } = entry, facts = run.facts || [];
    const values = Exactly.values(run.values);
    Dom.fill(
      panel,
      Dom.make("h3", {}, [Dom.name(Dom.clip(entry.name, 2000))]),
      check ? Dom.make("p", { class: "formula" }, [Dom.make("bdi", { text: check.formula })]) : null,
      check
        ? Dom.make("p", { class: `verdict-line verdict-${check.verdict.split("-")[0]}`, test: "verdict" }, [
            Dom.make("bdi", { text: check.text }),
          ])
        : null,
      run.bare ? Dom.make("p", { class: "quiet", text: bare(check) }) : null,
      run.way
        ? Dom.make("p", {
            class: "quiet",
            text: `Steps of a run of the ${Live.on ? "document" : "file"}: ${run.way.legs}. Steps by your choices after them: ${run.way.choices.length}.`,
          })
        : null,
      otherwise(run),
      values === "" ? null : Dom.make("p", {}, ["where ", Dom.make("bdi", { text: values })]),
      facts.length > 0 ? lines("What is so there", facts, there(run)) : null,
      marked(run),
      run.argument ? Dom.make("h3", { text: "Because" }) : null,
      run.argument ? tree(run.argument) : null,
      lines("How it ends", (run.ending || []).filter((line) => !facts.includes(line)), facts.length > 0 ? null : there(run)),
    );
  }

  /**
   * What leads to the instant that decides.
   * @param {PlayedRun} run
   */
  function there(run) {
    const at = run === player.run ? player.deciding() : null;
    if (!at) return null;
    const go = () => {
      player.pause();
      player.go(at.legs, at.time);
    };
    return Dom.button(`t = ${Dom.clip(Exactly.brief(Exactly.text(at.time)), 24)}`, go,
      { class: "link", title: "Go to the instant that decides", test: "deciding" });
  }

  /**
   * From the run of a check to one that does otherwise, and back: where they part.
   * @param {PlayedRun} run
   */
  function otherwise(run) {
    if (run.way) return null;
    const [first, second] = run.contrast === undefined
      ? [run, player.base(run.index + 1)] : [player.base(run.index - 1), run];
    if (!first || !second || second.contrast === undefined) return null;
    const shared = second.contrast, other = run === first ? second : first;
    const steps = shared === 0 ? "No step is the same" : shared === 1 ? "The first step is the same" : `The first ${shared} steps are the same`;
    return Dom.make("p", { class: "contrast" }, [
      Dom.make("span", { text: run === first ? "" : `This run does otherwise than ${Dom.clip(first.name, 200)}. ${steps}. ` }),
      Dom.button(run === first ? "Show the nearest run that does otherwise" : "Back to the run of the check",
        () => player.open(other, shared), { test: "contrast" }),
      " ",
      Dom.button("Compare both", () => Compare.choose(other), { test: "contrast-compare" }),
    ]);
  }

  /**
   * The bodies that the reasons name, as in the scene.
   * @param {PlayedRun} run
   */
  function marked(run) {
    const { leaves } = player.course, lit = run === player.run ? Marked.named(run, leaves) : [];
    if (lit.length === 0) return null;
    const some = lit.slice(0, 40).map((leaf) =>
      Dom.button(Dom.clip(leaves[leaf].name, 80), () => Details.select({ leaf }), { class: "link" }));
    return Dom.make("p", { class: "marked", test: "marked" }, [
      "Marked in the scene: ",
      ...some.flatMap((one, i) => (i === 0 ? [one] : [", ", one])),
      lit.length > some.length ? ` and ${lit.length - some.length} more` : null,
    ]);
  }

  /** @param {string} head @param {string[]} texts @param {HTMLElement | null} [beside] */
  function lines(head, texts, beside = null) {
    if (texts.length === 0) return null;
    return Dom.make("div", {}, [
      Dom.make("h3", {}, [head, " ", beside]),
      Dom.make(
        "ul",
        {},
        texts.map((text) => Dom.make("li", {}, [fact(text)])),
      ),
    ]);
  }

  /**
   * A fact, with very long numbers by their decimals.
   * @param {string} text
   */
  function fact(text) {
    const brief = Exactly.brief(text);
    return Dom.make("bdi", { text: brief, title: brief === text ? null : Dom.clip(text, 2000) });
  }

  /**
   * The tree of reasons. Parts of a claim are made when they are opened.
   * @param {DataArgument} argument
   */
  function tree(argument) {
    const root = Dom.make("ul", {
      role: "tree",
      class: "tree",
      "aria-label": "Reasons",
      keydown: walk,
      test: "reasons",
    });
    root.append(branch(argument, 0));
    const first = root.querySelector("[role=treeitem]");
    if (first) first.setAttribute("tabindex", "0");
    return root;
  }

  /** @param {DataArgument} argument @param {number} depth @returns {HTMLElement} */
  function branch(argument, depth) {
    const time = argument.time ? Exactly.read(argument.time) : null;
    const more = argument.parts.length > 0;
    const line = Dom.make("div", { class: "reason" }, [
      Dom.make("span", {
        class: argument.holds ? "sign yes" : "sign no",
        text: argument.holds ? "✓" : "✗",
        "aria-hidden": "true",
      }),
      Dom.make("span", { class: "reason-text" }, [
        Dom.make("bdi", { text: argument.claim }),
        argument.holds ? " holds" : " fails",
        argument.where ? Dom.make("span", { class: "quiet", text: ` · ${argument.where}` }) : null,
        ...argument.because.map((text) => Dom.make("span", { class: "because" }, [fact(text)])),
      ]),
      time
        ? Dom.make("span", {
            class: "link jump",
            text: `t = ${Dom.clip(Exactly.text(time), 16)}`,
            "aria-hidden": "true",
          })
        : null,
    ]);
    const item = Dom.make(
      "li",
      {
        role: "treeitem",
        tabindex: "-1",
        "aria-expanded": more ? String(depth < 3) : null,
        "aria-level": depth + 1,
      },
      [line],
    );
    const open = () => {
      if (!more || item.querySelector("ul")) return;
      item.append(
        Dom.make(
          "ul",
          { role: "group" },
          argument.parts.map((part) => branch(part, depth + 1)),
        ),
      );
    };
    if (depth < 3) open();
    line.addEventListener("click", () => {
      if (time) jump(time, depth);
      else if (more) item.setAttribute("aria-expanded", String(item.getAttribute("aria-expanded") !== "true"));
      open();
    });
    item.addEventListener("jump", (event) => {
      event.stopPropagation();
      if (time) jump(time, depth);
    });
    item.addEventListener("unfold", (event) => {
      event.stopPropagation();
      open();
    });
    return item;
  }

  /**
   * Goes to the last state of an instant; the whole claim is about the state that the run begins in, whatever else
   * happens at its instant.
   * @param {Rational} time @param {number} depth
   */
  function jump(time, depth) {
    player.pause();
    if (depth === 0 && Rational.sign(time) === 0) player.first();
    else player.seek(time);
  }

  /** @param {KeyboardEvent} event */
  function walk(event) {
    const item = /** @type {HTMLElement} */ (event.target);
    const root = /** @type {HTMLElement} */ (event.currentTarget);
    if (item.getAttribute("role") !== "treeitem") return;
    const seen = /** @type {HTMLElement[]} */ ([...root.querySelectorAll("[role=treeitem]")]).filter(
      (one) => !one.parentElement || !one.parentElement.closest("[aria-expanded=false]"),
    );
    const at = seen.indexOf(item);
    const open = item.getAttribute("aria-expanded");
    let to = null;
    if (event.key === "ArrowDown") to = seen[at + 1];
    else if (event.key === "ArrowUp") to = seen[at - 1];
    else if (event.key === "Home") to = seen[0];
    else if (event.key === "End") to = seen[seen.length - 1];
    else if (event.key === "ArrowRight" && open === "false") {
      item.setAttribute("aria-expanded", "true");
      item.dispatchEvent(new CustomEvent("unfold"));
    } else if (event.key === "ArrowRight") to = open === "true" ? seen[at + 1] : null;
    else if (event.key === "ArrowLeft" && open === "true") item.setAttribute("aria-expanded", "false");
    else if (event.key === "ArrowLeft")
      to = item.parentElement && item.parentElement.closest("[role=treeitem]");
    else if (event.key === "Enter" || event.key === " ") item.dispatchEvent(new CustomEvent("jump"));
    else return;
    event.preventDefault();
    event.stopPropagation();
    if (!(to instanceof HTMLElement)) return;
    for (const one of seen) one.tabIndex = one === to ? 0 : -1;
    to.focus();
  }

  return { start, step };
})();

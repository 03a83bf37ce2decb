"use strict";

/**
 * Addresses of what is shown: the part of the page's address after # holds the run, the exact time and how many legs are
 * taken, one's own choices, the camera and what is selected, which marks are shown, numbers, and the state graph. The size
 * of the scene is there for `scc view --camera`.
 */
const Links = (() => {
  /** @type {Player} */
  let player;
  /** @type {Scene | null} */
  let scene;
  let timer = 0;
  let written = "";
  /** Whether an answer has to come before what the address says can be shown. */
  let following = false;
  /** An address is at most so long, a formula in it so: what has no room in it is left out. */
  const longest = 16000, formula = 4000;
  /** What an address can say, besides the plots. */
  const known = new Set(["run", "step", "time", "way", "select", "with", "camera", "size", "switched", "numbers", "against", "graph", "find"]);
  /**
   * What an address that is read says wrongly.
   * @type {string[]}
   */
  let wrong = [];

  /** @param {Player} of @param {Scene | null} shown */
  function start(of, shown) {
    player = of;
    scene = shown;
    read();
    player.on("move", later);
    for (const event of ["plots", "compare", "graph", "view"]) document.addEventListener(event, later);
    Details.onSelect(later);
    for (const event of ["pointerup", "wheel", "keyup"]) {
      Dom.get("scene-panel").addEventListener(event, later, { passive: true });
    }
    window.addEventListener("hashchange", () => {
      if (window.location.hash.slice(1) !== written) read();
    });
    const cite = Dom.get("cite");
    if (Live.on) cite.title += ": it works on this machine alone, while scc serve runs and has this document";
    cite.addEventListener("click", () => {
      write();
      copy(window.location.href).then((done) => {
        cite.textContent = (done ? "Copied" : "In the address bar") + (Live.on ? ", for here only" : "");
        setTimeout(() => {
          cite.textContent = "Copy link";
        }, 1500);
      });
    });
  }

  /** @param {string} text */
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch (_) {
      return false;
    }
  }

  /** Browsers bound how often an address may be changed: it is done when all has been still for a moment. */
  function later() {
    clearTimeout(timer);
    if (!player.playing && !following) timer = window.setTimeout(write, 400);
  }

  /** The address of what is shown, after #. */
  function text() {
    const parts = [`run=${player.run.index}`, `step=${player.legs}`, `time=${Exactly.text(player.time)}`];
    const way = player.run.way;
    if (way) parts.push(`way=${way.legs}.${way.choices.join(".")}`);
    const selected = Details.selection();
    if (selected) {
      parts.push(
        "select=" +
          [selected.leaf, selected.part, selected.kind, selected.index]
            .filter((one) => one !== null && one !== undefined)
            .join("."),
      );
    }
    const other = Compare.other();
    if (other && !other.run.way) parts.push(`with=${other.run.index}`);
    if (scene) {
      parts.push(`camera=${encodeURIComponent(JSON.stringify(scene.camera()))}`);
      // A page that is hidden has no size.
      const { clientWidth: width, clientHeight: height } = scene.box;
      if (width > 0 && height > 0) parts.push(`size=${width}x${height}`);
    }
    const { numbers, against } = Plots.save(), switched = Tools.switched(), graph = Graph.save(), sought = Graph.sought();
    const more = [
      ...(switched.length > 0 ? [`switched=${switched.join(".")}`] : []),
      ...(numbers ? [`numbers=${numbers.join(".")}`] : []),
      ...(against ? ["against=1"] : []),
      ...(graph !== "" ? [`graph=${graph}`] : []),
      ...(sought !== "" ? [`find=${encodeURIComponent(sought)}`] : []),
      ...Plots.own().map((text) => `plot=${encodeURIComponent(text)}`),
    ];
    let size = parts.join("&").length;
    for (const part of more) {
      if (size + part.length + 1 > longest) continue;
      parts.push(part);
      size += part.length + 1;
    }
    return parts.join("&");
  }

  function write() {
    written = text();
    try {
      window.history.replaceState(null, "", "#" + written);
    } catch (_) {
      // A page that may not change its address is shown all the same.
    }
  }

  /** Shows what the address says. What it does not say, or says wrongly, stays as it is. */
  function read() {
    const hash = window.location.hash.slice(1);
    if (hash === "" || !hash.includes("=")) return;
    written = hash;
    wrong = [];
    /** @type {Map<string, string>} */
    const said = new Map();
    /** @type {string[]} */
    const plots = [];
    for (const part of hash.split("&")) {
      const at = part.indexOf("=");
      try {
        if (at > 0 && part.slice(0, at) === "plot") plots.push(decodeURIComponent(part.slice(at + 1)));
        else if (at > 0) said.set(part.slice(0, at), decodeURIComponent(part.slice(at + 1)));
      } catch (_) {
        notice("a part of the address is not readable");
      }
    }
    place(said);
    if (plots.some((text) => text.length > formula)) notice("a formula in it is too long");
    Plots.add(plots.filter((text) => text.length <= formula));
    panels(said);
    const beside = said.get("with");
    if (beside !== undefined) {
      const run = /^[0-9]{1,9}$/.test(beside) ? player.base(Number(beside)) : undefined;
      if (run && !run.bare) Compare.choose(run);
      else notice("the second run of the address is not in this file");
    }
    const chosen = said.get("select");
    if (chosen !== undefined) pick(chosen);
    const size = said.get("size");
    if (size !== undefined && !/^0*[1-9][0-9]{0,4}x0*[1-9][0-9]{0,4}$/.test(size)) notice("the size in the address is none of a picture");
    if ([...said.keys()].some((name) => !known.has(name))) notice("a part of the address is not known here");
    const camera = said.get("camera");
    if (camera !== undefined && scene) {
      try {
        const plain = JSON.parse(camera);
        if (plain === null || typeof plain !== "object") throw new Error("no camera");
        scene.setCamera(plain);
        Tools.learn();
      } catch (_) {
        notice("the camera in the address is not one of this page");
      }
    }
  }

  /**
   * What is shown in the scene and in the panels; an address without it leaves them as they are.
   * @param {Map<string, string>} said
   */
  function panels(said) {
    const switched = said.get("switched"), numbers = said.get("numbers"), against = said.get("against");
    const graph = said.get("graph"), sought = said.get("find");
    if (switched !== undefined && !Tools.load(switched.split("."))) notice("what is shown in the scene is not all known here");
    if (numbers !== undefined || against !== undefined) {
      const all = (numbers || "").split(".").filter(Boolean).map((text) => (/^[0-9]{1,6}$/.test(text) ? Number(text) : -1));
      const there = [...new Set(all)].filter((plot) => plot >= 0 && plot < player.data.plots.length);
      if (there.length < all.length || (against !== undefined && against !== "1")) notice("the plots are not all known here");
      Plots.load(numbers === undefined ? null : there, against === "1");
    }
    if (graph === undefined && sought === undefined) return;
    const short = (sought || "").length <= formula;
    if (!Graph.load(graph || "", short ? sought || "" : "") || !short) notice("what is said of the state graph is not all known");
  }

  /** @param {Map<string, string>} said */
  function place(said) {
    const index = said.get("run");
    if (index !== undefined) {
      const way = said.get("way");
      const run = /^-?[0-9]+$/.test(index) ? player.base(Number(index)) : undefined;
      if (!run) notice(`the run of the address is not ${Live.on ? "here" : "in this file"}`);
      else if (way !== undefined) {
        const numbers = /^[0-9]+(\.[0-9]+)+$/.test(way) ? way.split(".").map(Number) : [];
        const there = numbers.length > 0 && player.walk(run.index, numbers[0], numbers.slice(1));
        if (typeof there !== "boolean") {
          following = true;
          there.then((done) => {
            following = false;
            if (done !== null) arrive(said, done);
          });
          return;
        }
        arrive(said, there);
        return;
      } else if (run !== player.run) player.open(run);
    } else if (said.has("way")) notice("the address has choices, and not the run that they belong to");
    arrive(said, true);
  }

  /**
   * Goes to the step and the time of an address, in its run.
   * @param {Map<string, string>} said @param {boolean} there whether there is that run
   */
  function arrive(said, there) {
    if (!there) notice(`the choices of the address are not possible ${Live.on ? "here" : "in this file"}`);
    const step = said.get("step");
    const time = said.get("time");
    const exact = time === undefined ? null : Exactly.read(time);
    if (time !== undefined && exact === null) notice("the time of the address is not a number such as 5/2");
    player.pause();
    const number = step !== undefined && /^[0-9]{1,9}$/.test(step) ? Number(step) : null;
    if (step !== undefined && (number === null || number > player.course.legs.length)) notice("the run has no such step");
    if (number !== null) player.go(number, exact || undefined);
    else if (exact !== null) player.seek(exact);
    // A run that ends in a state at which it is looked at no longer has that instant alone.
    if (exact !== null && Rational.cmp(player.time, exact) !== 0) notice("the time of the address is not in that run, or not at that step");
  }

  /** @param {string} chosen */
  function pick(chosen) {
    const [leaf, part, kind, index] = chosen.split(".");
    const number = Number(leaf);
    const of = /^[0-9]+$/.test(leaf) ? player.data.leaves[number] : undefined;
    if (!of) {
      notice("the body of the address is not in this file");
      return;
    }
    const solid = part !== undefined && /^[0-9]{1,9}$/.test(part) && of.parts[Number(part)] && player.data.solids[of.parts[Number(part)].solid];
    const features = solid && { face: solid.faces, edge: solid.edges, vertex: solid.corners }[kind];
    const whole = !features || !/^[0-9]{1,9}$/.test(index) || Number(index) >= features.length;
    if (whole && part !== undefined) notice("what is selected of a body in the address is not in this file");
    Tabs.show("details");
    Details.select(
      whole
        ? { leaf: number }
        : { leaf: number, part: Number(part), kind: /** @type {SiteKind} */ (kind), index: Number(index) },
    );
  }

  /** @param {string} text */
  function notice(text) {
    const box = Dom.get("notice");
    box.hidden = false;
    if (!wrong.includes(text)) wrong.push(text);
    Dom.fill(
      box,
      `The address was not followed in all: ${wrong.join("; ")}.`,
      " ",
      Dom.button(
        "Close",
        () => {
          box.hidden = true;
        },
        { class: "small" },
      ),
    );
  }

  return { start, text };
})();

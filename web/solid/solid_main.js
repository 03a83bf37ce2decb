"use strict";

/** The page of a solid. */
const SolidPage = (() => {
  /** @type {SolidData} */
  let data;
  /** @type {SolidScene | null} */
  let scene = null;
  /** @type {SolidSpot | null} */
  let chosen = null;

  /** @param {number} v */
  const vertexName = (v) => data.vertices[v].name;

  /** @param {SolidSpot | null} a @param {SolidSpot} b */
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

  /** @param {SolidSpot | null} spot */
  function choose(spot) {
    chosen = spot;
    if (scene) scene.choose(spot);
    for (const row of document.querySelectorAll("button.row"))
      row.setAttribute("aria-pressed", String(chosen !== null && row.getAttribute("data-spot") === JSON.stringify(chosen)));
    tell();
  }

  /**
   * A row that chooses.
   * @param {SolidSpot} spot @param {(Node | string)[]} words
   */
  function row(spot, ...words) {
    const press = () => choose(same(chosen, spot) ? null : spot);
    return Dom.make("button",
      { type: "button", class: "row", "aria-pressed": "false", "data-spot": JSON.stringify(spot), click: press }, words);
  }

  /** @param {string[]} at */
  const place = (at) => `(${at.map((x) => Exactly.text(Rational.of(x))).join(", ")})`;

  /**
   * Where a vertex is.
   * @param {number} v
   */
  const where = (v) => Dom.make("p", {}, [
    Dom.name(Dom.clip(vertexName(v), 400)),
    " ",
    Dom.make("span", { class: "exact", text: Dom.clip(place(data.vertices[v].at), 2000) }),
  ]);

  /**
   * The names of these faces.
   * @param {(corners: number[]) => boolean} which
   */
  function facesWith(which) {
    const names = data.faces.filter((f) => which(f.corners)).map((f) => f.name);
    return Dom.make("p", { class: "quiet" }, ["of ", Dom.name(Dom.clip(names.join(", ") || "no face", 2000))]);
  }

  /** What is chosen, in words. */
  function tell() {
    const box = Dom.get("here"), spot = chosen;
    if (spot === null) {
      Dom.fill(box, Dom.make("p", { class: "quiet", text: "Point at a face, an edge or a vertex." }));
    } else if (spot.vertex !== undefined) {
      const v = spot.vertex;
      Dom.fill(box, Dom.make("p", { text: "Vertex" }), where(v), facesWith((corners) => corners.includes(v)));
    } else if (spot.edge !== undefined) {
      const [a, b] = spot.edge;
      const name = `[${Dom.clip(vertexName(a), 200)},${Dom.clip(vertexName(b), 200)}]`;
      const along = (/** @type {number[]} */ corners) =>
        corners.some((v, i) => {
          const w = corners[(i + 1) % corners.length];
          return (v === a && w === b) || (v === b && w === a);
        });
      Dom.fill(box, Dom.make("p", {}, ["Edge ", Dom.name(name)]), where(a), where(b), facesWith(along));
    } else if (spot.face !== undefined) {
      const { name, corners } = data.faces[spot.face];
      Dom.fill(box, Dom.make("p", {}, ["Face ", Dom.name(Dom.clip(name, 400))]), ...corners.slice(0, 200).map(where));
    } else if (spot.wrong !== undefined) {
      const { text, vertices } = data.wrong[spot.wrong];
      Dom.fill(box, Dom.make("p", {}, [Dom.name(text)]), ...vertices.map(where));
    }
  }

  function lists() {
    const { wrong, more } = data;
    Dom.get("faults-panel").hidden = wrong.length === 0;
    Dom.fill(Dom.get("faults"), ...wrong.map(({ badge, text }, i) =>
      row({ wrong: i }, Dom.make("span", { class: "badge", text: badge }), Dom.name(Dom.clip(text, 1000)))),
      more > 0 ? Dom.make("p", { class: "quiet", text: `and ${more} more` }) : null);
    const most = 2000;
    Dom.fill(Dom.get("all"),
      ...data.faces.slice(0, most).map(({ name, corners }, i) =>
        row({ face: i }, Dom.name(Dom.clip(name, 200)),
          Dom.make("span", { class: "quiet", text: ` face of ${corners.length} corners` }))),
      ...data.vertices.slice(0, most).map(({ name, at }, v) =>
        row({ vertex: v }, Dom.name(Dom.clip(name, 200)), " ",
          Dom.make("span", { class: "quiet exact", text: Dom.clip(place(at), 200) }))));
  }

  /**
   * A button that shows names.
   * @param {string} id @param {"faces" | "vertices"} what
   */
  function names(id, what) {
    const button = Dom.get(id);
    button.addEventListener("click", () => {
      if (!scene) return;
      scene.shows[what] = !scene.shows[what];
      button.setAttribute("aria-pressed", String(scene.shows[what]));
      scene.refresh();
    });
  }

  function stage() {
    let why = /** @type {string | null} */ (null);
    try {
      const made = new SolidScene(Dom.get("scene"), data, choose);
      why = SolidScene.why;
      if (!why) return made;
    } catch (error) {
      why = String(error instanceof Error ? error.message : error);
    }
    Dom.get("scene").hidden = true;
    const told = Dom.get("scene-why");
    told.hidden = false;
    told.textContent = `The solid cannot be drawn here: ${why}. All else is beside it.`;
    return null;
  }

  function start() {
    data = JSON.parse(Dom.get("data").textContent || "");
    if (data.format !== "scc-solid" || data.version !== 1) throw new Error("the data is of another version than the page");
    Dom.get("title").textContent = Dom.clip(data.name, 2000);
    const verdict = Dom.get("verdict");
    verdict.textContent = data.accepted ? "accepted" : "refused";
    verdict.className = data.accepted ? "good" : "bad";
    Dom.get("report").textContent = data.report;
    lists();
    tell();
    scene = stage();
    names("face-names", "faces");
    names("vertex-names", "vertices");
    Dom.get("fit").addEventListener("click", () => scene && scene.fit());
    document.addEventListener("keydown", (event) => {
      if (event.key === "f" && !event.ctrlKey && !event.metaKey && scene) scene.fit();
      if (event.key === "Escape") choose(null);
    });
    Theme.start(Dom.get("theme"), false, (is) => scene && scene.setTheme(is));
    if (scene) scene.fit();
    Object.defineProperty(window, "scc", { value: probe() });
    document.body.setAttribute("data-ready", "true");
  }

  /** What tests ask for. */
  function probe() {
    return {
      data,
      chosen: () => chosen,
      choose,
      spots: () => {
        // Nothing has a place before it is drawn once.
        if (!scene || scene.places.length === 0) return null;
        const made = scene, project = made.projector(made.box.clientWidth, made.box.clientHeight);
        const middles = data.faces.map((f) => project(made.middle(f.corners)));
        return { faces: middles, vertices: made.places.map(project) };
      },
      pick: (/** @type {number} */ x, /** @type {number} */ y) => (scene ? scene.pick(x, y) : null),
    };
  }

  /** A page that cannot be shown says so. */
  function open() {
    try {
      start();
    } catch (error) {
      const box = Dom.get("notice");
      box.hidden = false;
      box.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : error}.`;
      throw error;
    }
  }

  return { open };
})();

SolidPage.open();

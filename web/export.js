"use strict";

/**
 * Pictures and films of the scene as it is composed, to take along: PNG, WebM, and the command that draws the same as SVG
 * with exact hidden surfaces.
 *
 * @typedef {{ kind: string, size: string, pixels: number, background: string, legend: boolean, bar: boolean, clock: boolean,
 *   axes: boolean, rate: number }} Wishes
 */
const Export = (() => {
  const dpi = 300, longest = 8000;
  /** Pixels of the page in a millimetre of a figure: letters of 11 pixels are then 6.6 points high. */
  const dense = 4.7;
  /** @type {Player} */
  let player;
  /** @type {Scene} */
  let scene;
  /** @type {HTMLDialogElement} */
  let dialog;
  /** @type {Wishes} */
  const wishes = {
    kind: "png", size: "page", pixels: 1600, background: "white", legend: true, bar: true, clock: true, axes: true, rate: 30,
  };
  /** Whether a film is being made, and is still wanted. */
  let making = false;

  /** @param {Player} of @param {Scene | null} shown */
  function start(of, shown) {
    const button = Dom.get("export");
    button.hidden = shown === null;
    if (!shown) return;
    player = of;
    scene = shown;
    dialog = /** @type {HTMLDialogElement} */ (Dom.get("export-dialog"));
    button.addEventListener("click", open);
    dialog.addEventListener("close", () => { making = false; });
  }

  function open() {
    if (!scene) return;
    player.pause();
    show();
    dialog.showModal();
  }

  /**
   * The frame of the file: in pixels of the page, and how many of the file there are in one.
   * @param {Wishes} wanted @returns {{ width: number, height: number, ratio: number }}
   */
  function frame({ kind, size, pixels }) {
    const { clientWidth: wide, clientHeight: high } = scene.box, film = kind === "film", mm = Number(size);
    const even = (/** @type {number} */ x) => (film ? 2 * Math.round(x / 2) : Math.round(x));
    const asked = size === "page" ? wide * (film ? 1 : 2) : size === "own" ? pixels : (mm / 25.4) * dpi;
    const across = Math.max(16, Math.min(even(asked), longest)), down = Math.max(16, even((across * high) / wide));
    const ratio = size === "page" || size === "own" ? across / wide : across / (mm * dense);
    return { width: across / ratio, height: down / ratio, ratio };
  }

  /**
   * How the scene is drawn for a file.
   * @param {Wishes} wanted @returns {Composition}
   */
  function composition(wanted) {
    const { background, legend, bar, clock, axes } = wanted;
    // Films have no transparent parts.
    return { ...frame(wanted), background: wanted.kind === "film" && background === "transparent" ? "white" : background, legend, bar, clock, axes };
  }

  /**
   * A picture of what is shown, as the bytes of a file.
   * @param {Wishes} wanted
   */
  async function png(wanted) {
    const canvas = scene.compose(composition(wanted));
    scene.restore();
    const blob = await new Promise((/** @type {(blob: Blob | null) => void} */ done) => canvas.toBlob(done, "image/png"));
    if (!blob) throw new Error("the picture is too large for this browser");
    const bytes = new Uint8Array(await blob.arrayBuffer());
    return wanted.size === "page" || wanted.size === "own" ? bytes : Png.sized(bytes, dpi);
  }

  /** For how many seconds the end of a film is seen. */
  const rest = 1;

  /**
   * The moments of a film: the run from its beginning, at the speed of the page.
   * @param {number} rate frames in a second @returns {Generator<Player>}
   */
  function* moments(rate) {
    const at = Player.beside(player, player.run);
    at.speed = player.speed;
    yield at;
    while (!at.ended) {
      at.advance(at.speed / rate);
      yield at;
    }
    for (let k = 1; k < rest * rate; k++) yield at;
  }

  /** @param {number} rate */
  function count(rate) {
    let frames = 0;
    for (const _ of moments(rate)) if (++frames > 100000) break;
    return frames;
  }

  /**
   * A film of the run, as the bytes of a file: each frame is drawn by itself, however long that takes.
   * @param {Wishes} wanted @param {(part: number) => boolean} going is told how much is done, and whether it is still wanted
   * @returns {Promise<Uint8Array | null>}
   */
  async function film(wanted, going) {
    if (typeof VideoEncoder === "undefined") throw new Error("this browser cannot make films (WebCodecs)");
    const form = composition(wanted), { rate } = wanted, total = count(rate);
    const width = Math.round(form.width * form.ratio), height = Math.round(form.height * form.ratio);
    const config = await supported(width, height, rate);
    /** @type {Picture[]} */
    const pictures = [];
    /** @type {Error | null} */
    let fault = null;
    const encoder = new VideoEncoder({
      output: (chunk) => {
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        pictures.push({ data, time: Math.round(chunk.timestamp / 1000), key: chunk.type === "key" });
      },
      error: (error) => { fault = error; },
    });
    encoder.configure(config);
    let k = 0;
    try {
      for (const at of moments(rate)) {
        if (fault) throw fault;
        if (!going(k / total)) return null;
        stage(at);
        const picture = new VideoFrame(scene.compose(form), { timestamp: Math.round((k * 1e6) / rate), duration: Math.round(1e6 / rate) });
        encoder.encode(picture, { keyFrame: k % (2 * rate) === 0 });
        picture.close();
        k++;
        // The page stays alive, and no more than some frames wait.
        do await new Promise((done) => setTimeout(done, 0)); while (encoder.encodeQueueSize > 4);
      }
      await encoder.flush();
      if (fault) throw fault;
    } finally {
      if (encoder.state !== "closed") encoder.close();
      stage(player);
      scene.restore();
    }
    const codec = config.codec === "vp8" ? "V_VP8" : "V_VP9";
    return Webm.file(pictures, { width, height, codec, duration: (1000 * k) / rate });
  }

  /**
   * Shows a moment.
   * @param {Player} at
   */
  function stage(at) {
    Compare.stage(at);
    scene.mark(at === player ? Marked.now(player, scene.bodies.colors) : { ...Marked.none, lit: Marked.named(at.run, at.course.leaves) });
    scene.show(at.course, at.legs, at.time);
  }

  /**
   * The settings of the best film that this browser can make.
   * @param {number} width @param {number} height @param {number} framerate
   */
  async function supported(width, height, framerate) {
    const bitrate = Math.max(1e6, Math.round(0.15 * width * height * framerate));
    for (const codec of ["vp09.00.51.08", "vp09.00.31.08", "vp8"]) {
      /** @type {VideoEncoderConfig} */
      const config = { codec, width, height, framerate, bitrate };
      if ((await VideoEncoder.isConfigSupported(config)).supported) return config;
    }
    throw new Error("this browser cannot make films of this size");
  }

  /** The name of the model, as the name of a file. */
  const stem = () => player.data.name.replace(/\.[^.]*$/, "").replace(/[^\p{L}\p{N}_-]+/gu, "_").slice(0, 60) || "scene";

  /** @param {string} text */
  const quoted = (text) => (/^[\w./=-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);

  /**
   * The run up to what is shown, as a schedule; null where first choices lead to it. A check does not: alone it may be
   * explored with other reductions, and show another run.
   */
  function schedule() {
    const { run, course, legs, data, between } = player, plain = run.name === "first choices" || run.sample;
    const last = legs === course.legs.length || between || Rational.sign(course.legs[legs].duration) > 0;
    if (plain && last && !run.way && run.contrast === undefined) return null;
    const steps = run.steps.filter((step) => !step.tail).slice(0, between ? legs + 1 : legs);
    const choices = steps.map(({ label, choice }) =>
      ({ label: data.labels[label].text, ...(choice === null ? {} : { choice }) }));
    return { format: "scc-schedule", version: 2, parameters: { ...data.parameters, ...run.values }, choices };
  }

  /**
   * The command that draws what is shown.
   * @param {Wishes} wanted
   */
  function command(wanted) {
    const { data, run, time } = player, { width, height } = frame({ ...wanted, kind: "svg" }), own = schedule();
    const given = own ? [] : Object.entries({ ...data.parameters, ...run.values }).map(([name, value]) => `-D ${quoted(`${name}=${value}`)}`);
    const which = own ? [`--schedule ${quoted(stem() + ".json")}`] : [];
    const size = `${Math.round(width)}x${Math.round(height)}`;
    const link = `camera=${encodeURIComponent(JSON.stringify(scene.camera()))}&size=${size}`;
    return ["scc view", quoted(data.name), ...given, ...which, `--svg ${Exactly.text(time)}`,
      ...(scene.options.names ? ["--names"] : []), `--camera ${quoted(link)}`, `-o ${quoted(stem() + ".svg")}`].join(" ");
  }

  /** @param {string} name @param {string} text @param {[string, string][]} options */
  function select(name, text, options) {
    const key = /** @type {"kind" | "size" | "background"} */ (name);
    const box = Dom.make("select", { test: `export-${name}`, change: () => { wishes[key] = box.value; show(); } },
      options.map(([value, said]) => Dom.make("option", { value, text: said, selected: wishes[key] === value })));
    return Dom.make("label", {}, [Dom.make("span", { text }), box]);
  }

  /** @param {"legend" | "bar" | "clock" | "axes"} key @param {string} text */
  function tick(key, text) {
    const box = Dom.make("input", { type: "checkbox", test: `export-${key}`, checked: wishes[key], change: () => { wishes[key] = box.checked; } });
    return Dom.make("label", { class: "tick" }, [box, text]);
  }

  function number() {
    const box = Dom.make("input", {
      type: "number", min: 16, max: longest, value: wishes.pixels, test: "export-pixels",
      change: () => { wishes.pixels = Math.max(16, Math.min(longest, Math.round(Number(box.value)) || 1600)); show(); },
    });
    return Dom.make("label", {}, [Dom.make("span", { text: "Pixels across" }), box]);
  }

  function show() {
    const { kind, size } = wishes, { width, height, ratio } = frame(wishes), film = kind === "film", svg = kind === "svg";
    const across = `${Math.round(width * ratio)} × ${Math.round(height * ratio)} pixels`;
    const focus = document.activeElement?.getAttribute("data-testid");
    Dom.fill(
      dialog,
      Dom.make("h2", { id: "export-head", text: "Save what is shown" }),
      Dom.make("div", { class: "export" }, [
        select("kind", "As", [["png", "a picture (PNG)"], ["film", "a film of the run (WebM)"], ["svg", "a drawing with exact edges (SVG)"]]),
        select("size", "Width", [["page", "as on the page"], ["85", "85 mm at 300 dpi"], ["120", "120 mm at 300 dpi"], ["180", "180 mm at 300 dpi"], ["own", "in pixels"]]),
        size === "own" ? number() : null,
        svg ? null : select("background", "Background", [["white", "white"], ["page", "as on the page"], ...(film ? [] : [/** @type {[string, string]} */ (["transparent", "transparent"])])]),
        svg ? null : Dom.make("fieldset", {}, [Dom.make("legend", { text: "With" }), tick("legend", "legend"), tick("bar", "scale"), tick("clock", "clock"), tick("axes", "axes")]),
      ]),
      svg ? drawing() : Dom.make("p", { class: "quiet", test: "export-told", text: film ? `${across}, ${(count(wishes.rate) / wishes.rate).toFixed(1)} s at the speed of the page` : across }),
      Dom.make("p", { role: "status", test: "export-said" }),
      Dom.make("p", { class: "export-buttons" }, [
        svg ? null : Dom.button("Save", save, { class: "primary", test: "export-save" }),
        Dom.button("Close", () => dialog.close(), { test: "export-close" }),
      ]),
    );
    const again = focus && dialog.querySelector(`[data-testid="${focus}"]`);
    if (again instanceof HTMLElement) again.focus();
  }

  /** What is said of a drawing: scc makes it, as its edges are exact. */
  function drawing() {
    const text = command(wishes), own = schedule();
    const copy = Dom.button("Copy", () => navigator.clipboard.writeText(text).then(() => say("Copied."), () => say("Select the command to copy it.")), { test: "export-copy" });
    return Dom.make("div", {}, [
      Dom.make("p", { text: "This command draws the same state from the same camera, with exact hidden surfaces:" }),
      Dom.make("pre", { class: "source command", dir: "ltr", tabindex: "0", text, test: "export-command" }),
      Dom.make("p", { class: "export-buttons" }, [
        copy,
        own ? Dom.button("Save the run for it", () => Dom.save(stem() + ".json", "application/json", JSON.stringify(own, null, 1) + "\n"), { test: "export-schedule" }) : null,
      ]),
    ]);
  }

  /** @param {string} text */
  function say(text) {
    const box = dialog.querySelector('[data-testid="export-said"]');
    if (box) Dom.tell(box, text);
  }

  async function save() {
    if (making) return;
    making = true;
    try {
      if (wishes.kind === "png") Dom.save(stem() + ".png", "image/png", await png(wishes));
      else {
        const made = await film(wishes, (part) => {
          say(`${Math.floor(100 * part)} % are drawn. Close ends it.`);
          return making;
        });
        if (made) Dom.save(stem() + ".webm", "video/webm", made);
      }
      say(making ? "Saved." : "");
    } catch (error) {
      say(`It cannot be saved: ${error instanceof Error ? error.message : error}.`);
    } finally {
      making = false;
    }
  }

  /**
   * The bytes of a file, for tests.
   * @param {Partial<Wishes>} some
   */
  const bytes = (some) => {
    const wanted = { ...wishes, ...some };
    return wanted.kind === "film" ? film(wanted, () => true) : png(wanted);
  };

  return { start, open, bytes, command: (/** @type {Partial<Wishes>} */ some) => command({ ...wishes, ...some }), schedule, quoted };
})();

"use strict";

/**
 * @typedef {{name: string, formula: string, verdict: string, text: string}} Verdict
 * @typedef {{kind: "show" | "check", only: string | null, sum: string, id: string | null, dropped: boolean, entered: boolean,
 *            closed: boolean, verdicts: Verdict[], interrupted: boolean}} Made  `sum` tells the text
 */

/**
 * Documents: one is made of a text to be shown, and one is made with its checks. The newest of a kind takes the place
 * of the one before, also while that one is still made.
 */
const Documents = (() => {
  /** @type {{show: Made | null, check: Made | null}} */
  const making = { show: null, check: null };
  /** @type {Made | null} in the frame */
  let shown = null;
  /** @type {Made | null} whose verdicts are listed */
  let checked = null;
  /** @type {() => string} */
  let present = () => "";
  /** @type {() => void} */
  let changed = () => {};
  let progress = "";

  /** @param {() => string} text @param {() => void} hear */
  function start(text, hear) {
    present = text;
    changed = hear;
  }

  /** @param {Made} of */
  const path = (of) => `view/${of.id}`;

  /** @param {Made | null} of */
  function inUse(of) {
    return of === null || [making.show, making.check, shown, checked].some((one) => one !== null && one.id === of.id);
  }

  /** @param {Made | null} of */
  function discard(of) {
    if (of === null || of.id === null || of.closed || inUse(of)) return;
    of.closed = true;
    Server.attempt(`${path(of)}/close`, {}).catch(() => {});
  }

  /**
   * @param {"show" | "check"} kind @param {string | null} only the check that is made alone
   */
  async function open(kind, only) {
    const text = present();
    const before = making[kind];
    /** @type {Made} */
    const made = { kind, only, sum: Source.sum(text), id: null, dropped: false, entered: false, closed: false, verdicts: [], interrupted: false };
    making[kind] = made;
    if (before) drop(before);
    progress = kind === "check" ? "Checking …" : "Opening …";
    changed();
    const check = kind === "show" ? "none" : only === null ? "all" : { only };
    const { status, body } = await Server.post("open", { text: Source.outer(text), check, seconds: null });
    if (status !== 200) {
      failed(made, `The model cannot be ${kind === "check" ? "checked" : "shown"}: ${body.error}.`);
      return;
    }
    made.id = String(body.document);
    if (made.dropped) discard(made);
    else {
      changed();
      await follow(made);
    }
  }

  /**
   * One that is just shown is shown first.
   * @param {Made} made
   */
  function drop(made) {
    if (made.entered) return;
    made.dropped = true;
    discard(made);
  }

  /**
   * Waits until a document is made.
   * @param {Made} made
   */
  async function follow(made) {
    for (;;) {
      const { status, body } = await Server.post(`${path(made)}/status`, {});
      if (made.dropped) return;
      if (status !== 200) return failed(made, `The document is over: ${body.error}.`);
      if (body.state === "working") {
        if (body.progress) {
          progress = body.progress;
          changed();
        }
        continue;
      }
      made.entered = true;
      await enter(made, body);
      if (making[made.kind] === made) making[made.kind] = null;
      // Where a newer one took its place in the frame, nobody needs it.
      discard(made);
      changed();
      return;
    }
  }

  /** @param {Made} made @param {any} body */
  async function enter(made, body) {
    const same = made.sum === Source.sum(present());
    if (body.state === "ready") {
      made.verdicts = body.verdicts;
      made.interrupted = body.interrupted;
      if (same) Problems.set("made", body.diagnostics);
      Notices.close("document");
      await adopt(made, same);
    } else if (body.state === "refused") {
      if (same) Problems.set("made", body.diagnostics);
      const first = body.diagnostics[0];
      failed(made, `The model is refused: ${first ? first.message : "it has errors"}.`);
    } else failed(made, `The model cannot be shown: ${body.why}.`);
  }

  /** @param {Made} made @param {string} why */
  function failed(made, why) {
    if (making[made.kind] === made) making[made.kind] = null;
    if (!made.dropped) Notices.show("document", Dom.clip(why, 1000));
    discard(made);
    changed();
  }

  /** @param {Made} made @param {boolean} same whether its text is the present one */
  async function adopt(made, same) {
    const before = [shown, checked];
    if (made.kind === "check") {
      checked = made;
      Verdicts.show(made.verdicts, made.interrupted);
    }
    // A run that breaks a check is what one wants to see first.
    const broken = made.verdicts.find((one) => one.verdict === "violated");
    if (made.kind === "show" || same || !Desk.automatic()) await put(made, broken ? broken.name : null);
    for (const one of before) discard(one);
  }

  /**
   * Shows a document in the frame.
   * @param {Made} made @param {string | null} run
   */
  async function put(made, run) {
    const before = shown;
    const same = before !== null && before.sum === made.sum;
    const alike = same && before !== null && before.kind === made.kind && before.only === made.only;
    // Runs have other numbers where other checks were made.
    const wanted = run === null && same && !alike ? Frames.current() : run;
    const address = Frames.carried(Frames.link(), alike && run === null);
    const done = await Frames.show(String(made.id), address || Desk.kept(), wanted);
    if (!done) return false;
    shown = made;
    changed();
    discard(before);
    return true;
  }

  /**
   * Shows the run that decides a check, of the document that was checked.
   * @param {string} name
   */
  async function run(name) {
    if (checked === null) return;
    if (!(shown !== null && shown.id === checked.id) && !(await put(checked, name))) {
      Notices.show("document", "The checked document is over. Check again to see its runs.");
      return;
    }
    if (!Frames.run(name)) Notices.say(`${Dom.clip(name, 80)}: no single run shows it.`);
  }

  /** Asks what is made to end with what it has. */
  function stop() {
    const made = making.check || making.show;
    if (made && made.id !== null) {
      progress = "Stopping …";
      changed();
      Server.attempt(`${path(made)}/stop`, {}).catch(() => {});
    }
  }

  /** What a reload needs to show the same. */
  function memory() {
    const plain = (/** @type {Made | null} */ one) =>
      one && one.id !== null ? { kind: one.kind, only: one.only, sum: one.sum, id: one.id } : null;
    return { shown: plain(shown), checked: plain(checked), making: plain(making.check) };
  }

  /**
   * Goes on with documents of before, if they still live; whether the one that was shown does.
   * @param {ReturnType<typeof memory>} kept
   */
  async function recall(kept) {
    const again = (/** @type {any} */ one) =>
      one && /** @type {Made} */ ({ ...one, dropped: false, entered: false, closed: false, verdicts: [], interrupted: false });
    const wanted = [again(kept.checked), again(kept.shown)];
    /** @type {Set<string>} */
    const over = new Set();
    for (const one of wanted) {
      if (!one || over.has(one.id)) continue;
      const { status, body } = await Server.post(`${path(one)}/status`, {});
      if (status !== 200 || body.state !== "ready") {
        over.add(one.id);
        continue;
      }
      one.verdicts = body.verdicts;
      one.interrupted = body.interrupted;
      if (one === wanted[0]) {
        checked = one;
        Verdicts.show(one.verdicts, one.interrupted);
      } else await put(one, null);
    }
    const work = again(kept.making);
    if (work && making.check === null) {
      making.check = work;
      progress = "Checking …";
      follow(work);
    }
    changed();
    return shown !== null;
  }

  const working = () => (making.check ? "check" : making.show ? "show" : null);

  return {
    start,
    open,
    run,
    stop,
    memory,
    recall,
    working,
    progress: () => (working() ? progress : ""),
    shown: () => shown,
    checked: () => checked,
    opening: () => making.show,
  };
})();

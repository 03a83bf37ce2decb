"use strict";

/**
 * The view of the newest document, in a frame. A new one is loaded behind the one that is seen, and takes over from it
 * from where one looks, if one has moved the camera, which panels are open, and, where the text is the same, run and time.
 */
const Frames = (() => {
  // Parts of a view's address that are of any model.
  const ofAny = ["camera"];
  const patience = 30000;
  /** @type {HTMLElement} */
  let box;
  /** @type {HTMLIFrameElement | null} */
  let seen = null;
  /** @type {HTMLIFrameElement | null} */
  let coming = null;
  /** Gives up the one that is coming: a frame that is taken away tells nothing more. */
  let giveUp = () => {};
  /** @type {((event: KeyboardEvent) => void)} */
  let pressed = () => {};
  /** @type {() => void} */
  let over = () => {};

  /**
   * @param {HTMLElement} place @param {(event: KeyboardEvent) => void} keys heard in the frame, too
   * @param {() => void} end of the document that is seen
   */
  function start(place, keys, end) {
    box = place;
    pressed = keys;
    over = end;
  }

  /**
   * The page in a frame: what it tells to tests, if it is there.
   * @param {HTMLIFrameElement | null} frame @returns {any}
   */
  function page(frame) {
    try {
      return frame && frame.contentWindow ? /** @type {any} */ (frame.contentWindow).scc || null : null;
    } catch (_) {
      return null;
    }
  }

  /** The address of what is seen, after #; with the camera if it was moved by hand, or else the view chooses its own. */
  function link() {
    const view = page(seen);
    if (!view) return "";
    const parts = String(view.link()).split("&");
    return (view.moved() ? parts : parts.filter((part) => !part.startsWith("camera="))).join("&");
  }

  /** @param {string} address @param {boolean} whole */
  function carried(address, whole) {
    const parts = address.split("&").filter((part) => whole || ofAny.includes(part.split("=")[0]));
    return parts.join("&");
  }

  /**
   * Shows a document, once it is loaded.
   * @param {string} id @param {string} address where to begin @param {string | null} run the name of the run to show
   * @returns {Promise<boolean>} false if it could not be
   */
  function show(id, address, run) {
    giveUp();
    const frame = Dom.make("iframe", {
      title: "View of the model",
      class: "frame coming",
      src: `view/${id}/${address ? "#" + address : ""}`,
      test: "frame",
      tabindex: "-1",
    });
    coming = frame;
    box.append(frame);
    return new Promise((done) => {
      const end = (/** @type {boolean} */ shown) => {
        window.clearTimeout(late);
        if (!shown) frame.remove();
        if (coming === frame) coming = null;
        done(shown);
      };
      giveUp = () => {
        if (coming === frame) end(false);
      };
      const late = window.setTimeout(() => end(false), patience);
      frame.addEventListener("load", () => {
        if (coming !== frame) return end(false);
        if (!page(frame)) return end(false);
        take(frame, run);
        end(true);
      });
    });
  }

  /** @param {HTMLIFrameElement} frame @param {string | null} run */
  function take(frame, run) {
    const had = seen !== null && document.activeElement === seen;
    if (seen) settle(seen, frame);
    const before = page(seen);
    const view = page(frame);
    if (run !== null) open(view, run);
    if (before && (!related(before, view) || (before.inView() && !view.inView()))) click(frame, '[data-testid="fit"]');
    // One button for both pages is enough.
    const theme = frame.contentDocument && frame.contentDocument.getElementById("theme");
    if (theme) theme.hidden = true;
    frame.classList.remove("coming");
    frame.removeAttribute("tabindex");
    if (seen) seen.remove();
    seen = frame;
    if (had) frame.focus();
    /** @type {Window} */ (frame.contentWindow).addEventListener("keydown", pressed, true);
    watch(frame);
  }

  /**
   * The view says at its body when its document has ended.
   * @param {HTMLIFrameElement} frame
   */
  function watch(frame) {
    const body = frame.contentDocument && frame.contentDocument.body;
    if (!body) return;
    const tell = () => {
      if (body.hasAttribute("data-over") && frame === seen) over();
    };
    new MutationObserver(tell).observe(body, { attributes: true, attributeFilter: ["data-over"] });
    tell();
  }

  /** @param {any} view @param {string} run */
  function open(view, run) {
    const index = view.runs().findIndex((/** @type {{name: string}} */ one) => one.name === run);
    if (index >= 0) view.open(index);
    return index >= 0;
  }

  /** Whether a body of the one is in the other, so that where one looked at the one shows the other. */
  function related(/** @type {any} */ before, /** @type {any} */ after) {
    const names = new Set(before.data.leaves.map((/** @type {{name: string}} */ leaf) => leaf.name));
    return after.data.leaves.some((/** @type {{name: string}} */ leaf) => names.has(leaf.name));
  }

  /** @param {HTMLIFrameElement} frame @param {string} selector */
  function click(frame, selector) {
    const found = frame.contentDocument && frame.contentDocument.querySelector(selector);
    if (found) /** @type {HTMLElement} */ (found).click();
  }

  /**
   * Opens the panels, and sets the switches of the scene, as they were.
   * @param {HTMLIFrameElement} from @param {HTMLIFrameElement} to
   */
  function settle(from, to) {
    const old = from.contentDocument;
    const now = to.contentDocument;
    if (!old || !now) return;
    for (const one of old.querySelectorAll("button[data-testid][aria-pressed]")) {
      const name = one.getAttribute("data-testid");
      const other = now.querySelector(`button[data-testid="${name}"][aria-pressed]`);
      if (name === "follow" || !other) continue;
      if (other.getAttribute("aria-pressed") !== one.getAttribute("aria-pressed"))
        /** @type {HTMLElement} */ (other).click();
    }
    const tab = old.querySelector('#tabs [role="tab"][aria-selected="true"]');
    if (tab && tab.id) click(to, `#${tab.id}:not([hidden])`);
  }

  /**
   * Shows another run of the document that is seen.
   * @param {string} run
   */
  function run(run) {
    const view = page(seen);
    return view !== null && open(view, run);
  }

  /** The run that is seen, if it is one of the document's own. */
  function current() {
    const view = page(seen);
    const state = view && view.state();
    return state && state.way === null ? String(state.run) : null;
  }

  return { start, show, link, carried, run, current };
})();

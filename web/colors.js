"use strict";

/** Colours of bodies, channels and marks: told apart by those who see few colours, in the light and in the dark. */
const Colors = (() => {
  /** @param {number} hex @returns {[number, number, number]} */
  const rgb = (hex) => [((hex >> 16) & 255) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];

  /** Of bodies. */
  const families = [
    0xe8a317, 0x56aee0, 0x12a07a, 0xd9622b, 0xc77fab, 0x2f6fb5, 0xe0d24a, 0x8d78cf, 0x9a9a9a, 0xa8485a,
  ].map(rgb);

  /** Of channels: bright, on bodies of any colour within a dark line. */
  const channels = [
    0xfff3a0, 0x9ff0ff, 0xffb3d9, 0xc9f7a8, 0xffffff, 0xd3c2ff, 0xffc79a, 0xb6c8ff,
  ].map(rgb);

  const fixed = rgb(0x94a0ae), absorbing = rgb(0x9a7bb8);

  /**
   * Between two colours.
   * @param {number[]} a @param {number[]} b @param {number} t
   * @returns {[number, number, number]}
   */
  const mix = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];

  /**
   * How each leaf looks: those of one family alike.
   * @param {PageData} data @param {DataLeaf[]} leaves
   * @returns {{ name: string, color: [number, number, number], fixed: boolean, absorbs: boolean }[]}
   */
  function ofLeaves(data, leaves) {
    return leaves.map(({ family, fixed: still, absorbs }) => {
      const own = families[family % families.length];
      const color = absorbs ? mix(absorbing, own, 0.25) : still ? mix(fixed, own, 0.18) : own;
      return { name: data.families[family], color, fixed: still, absorbs };
    });
  }

  /**
   * A colour for each channel, in the order in which they come up.
   * @param {DataBehaviour[]} behaviours
   * @returns {Map<string, [number, number, number]>}
   */
  function ofChannels(behaviours) {
    const names = [...new Set(behaviours.flatMap((b) => b.open.map((o) => o.channel)))];
    return new Map(names.map((name, i) => [name, channels[i % channels.length]]));
  }

  /**
   * Of lines and words.
   * @param {boolean} dark
   */
  function theme(dark) {
    return dark
      ? {
          line: rgb(0x070a0e), plate: rgb(0x10151c), bond: rgb(0xffffff), chosen: rgb(0xffd23f), hover: rgb(0xcfe3ff),
          lit: rgb(0xb58cff), before: rgb(0xa7b4c4), made: rgb(0x4ade80), split: rgb(0xff6b6b), other: rgb(0x4fd8e8),
          velocity: rgb(0x6cb6ff), spin: rgb(0xff8ec2), grid: rgb(0x8fa0b4), x: rgb(0xff7b6b), y: rgb(0x6fd08c),
          z: rgb(0x76a9ff), wall: rgb(0x2a3340), shadow: 0.5, text: "#e3e8ef", quiet: "#93a1b3", halo: "#12161d",
        }
      : {
          line: rgb(0x1b2430), plate: rgb(0x1b2430), bond: rgb(0x05070c), chosen: rgb(0xd0104c), hover: rgb(0x0b4fb3),
          lit: rgb(0x7c3aed), before: rgb(0x6a7686), made: rgb(0x0f9d58), split: rgb(0xd0104c), other: rgb(0x00809c),
          velocity: rgb(0x0a5fd0), spin: rgb(0xc0247f), grid: rgb(0x8492a4), x: rgb(0xc9382b), y: rgb(0x1f8a43),
          z: rgb(0x2a63d6), wall: rgb(0xf4f6f9), shadow: 0.16, text: "#1d2430", quiet: "#5f6b7b", halo: "#ffffff",
        };
  }

  /** @param {number[]} c @returns {string} as styles write it */
  const css = (c) => `rgb(${c.slice(0, 3).map((x) => Math.round(255 * x)).join(", ")})`;

  return { ofLeaves, ofChannels, theme, mix, css };
})();

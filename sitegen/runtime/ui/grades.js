// @ts-check
// The shapes of good and bad, different for those who do not see colours.

/** A disc, a triangle, an octagon, and a ring for what is not known. */
export const SHAPES = {
  good: "M 12 3 a 9 9 0 1 0 0.01 0 z",
  caution: "M 12 2.5 L 22.5 21 L 1.5 21 z",
  danger: "M 8 2.5 L 16 2.5 L 21.5 8 L 21.5 16 L 16 21.5 L 8 21.5 L 2.5 16 L 2.5 8 z",
  stale: "M 12 3 a 9 9 0 1 0 0.01 0 z M 12 7 a 5 5 0 1 1 -0.01 0 z",
  plain: "",
};

// The data of a page, as lib/program/view writes it: format "scc-view", version 1. Rationals are texts "p/q".

type Vec = [string, string, string];

interface DataSolid {
  name: string;
  vertices: Vec[];
  faces: { name: string; corners: number[] }[];
  edges: { name: string; corners: number[] }[];
  corners: string[];
}

interface DataPart {
  name: string;
  template: string;
  solid: number;
  offset: Vec;
}

interface DataLeaf {
  name: string;
  /** What looks alike: an index into the families of the page. */
  family: number;
  template: string;
  fixed: boolean;
  absorbs: boolean;
  mass: string | null;
  parts: DataPart[];
  /** From the point of reference, as declared. */
  centroid: Vec;
  /** About the centroid, as declared, where bodies turn: rows. */
  inertia?: [Vec, Vec, Vec];
}

type SiteKind = "vertex" | "edge" | "face";

/** A feature of a part: the part's number in its leaf, what it is, its number in the solid. */
type DataSite = [number, SiteKind, number];

interface DataBehaviour {
  text: string;
  origin: string | null;
  open: { channel: string; co: boolean; sites: DataSite[] }[];
  /** Channels of its weak and strong splits. */
  releases: string[];
}

interface DataPlace {
  leaf: number;
  at: Vec;
  turned?: [string, string, string, string];
  behaviour: number;
  arm?: Vec;
}

interface DataBond {
  name: string;
  ends: { leaf: number; site: DataSite; text: string }[];
}

interface DataProcess {
  leaves: DataPlace[];
  bonds: DataBond[];
  velocity: Vec;
  mass: string | null;
  /** kept: of a free body, its angular momentum about the centre. */
  turn?: { centre: Vec; spin: Vec; since: string; kept?: Vec };
}

interface DataChoice {
  label: number;
  to: number | null;
  rules: string[];
  /** Its probability, where chance decides. */
  chance?: string;
}

type DataPiece =
  | { n: string[]; d: string[]; none?: undefined; pieces?: undefined }
  | { none: string; n?: undefined; d?: undefined; pieces?: undefined }
  | { pieces: (DataPiece & { from: string })[]; n?: undefined; d?: undefined; none?: undefined };

interface DataState {
  of: number | null;
  after: string;
  gone: number[];
  come: number[];
  next: DataChoice[] | null;
  rests: boolean;
  stuck: string | null;
  values?: DataPiece[];
}

interface DataLabel {
  kind: string;
  text: string;
  words: string;
  duration?: string;
  leaves?: number[];
}

interface DataStep {
  tail?: boolean;
  choice: number | null;
  label: number;
  to: number;
  rules: string[];
}

interface DataArgument {
  where: string | null;
  claim: string;
  holds: boolean;
  because: string[];
  parts: DataArgument[];
  time?: string | null;
}

/** A run. Where a check has none to show, its start is null, and it has a name and a check alone. */
interface DataRun {
  name: string;
  check: { formula: string; verdict: string; text: string } | null;
  start: number | null;
  steps?: DataStep[];
  rest?: string;
  finish?: string;
  cycle?: number | null;
  facts?: string[];
  argument?: DataArgument | null;
  values?: { [parameter: string]: string };
  ending?: string[];
  /** Of a run whose bodies are put together in another way than those of the others. */
  leaves?: DataLeaf[];
  /** A run from a start in the drawing of regions. */
  sample?: boolean;
  /** A run that does otherwise than the one before it, which a check has: so many steps are the same at first. */
  contrast?: number;
}

/** Where checks hold, in the plane of two parameters, or on the line of one (then the second coordinate is from 0 to 1). */
interface DataWhere {
  axes: { name: string; low: DataBound; high: DataBound }[];
  /** Parameters that are not shown. */
  hidden: string[];
  checks: string[];
  /** Probabilities, each with its values by size. */
  numbers: { name: string; values: { least: string | null; most: string | null; form?: string }[] }[];
  regions: DataRegion[];
  samples: DataSample[];
}

interface DataBound {
  value: string;
  included: boolean;
}

interface DataRegion {
  /** Of the checks. */
  outcomes: string[];
  /** Of the numbers: which of its values it has; null where that depends on what is not shown. */
  values: (number | null)[];
  /** All of it: what satisfies all constraints of a piece. */
  pieces: { normal: [string, string]; relation: "<" | "<=" | "="; right: string }[][];
  polygons: [string, string][][];
  borders: { ends: [[string, string], [string, string]]; belongs: boolean }[];
  lines: [[string, string], [string, string]][];
  points: [string, string][];
  share: string;
}

/** A start, and the number of its run. */
interface DataSample {
  at: { [parameter: string]: string };
  run: number;
}

/** The values of all runs of a simulation; by time, and then by observable. */
interface DataSpread {
  seed: string | number;
  first: number;
  asked: number;
  made: number;
  observables: string[];
  times: string[];
  /** How many runs had ended, or been cut short, before each time. */
  over: number[];
  cut: number[];
  cells: DataCell[][];
  /** Each is the run of the data in its place. */
  shown: { run: number; values: (string | null)[][]; ended: string | null }[];
  /** An interruption left no time to show more. */
  hurried: boolean;
}

/** Bar i begins at from + i width; a single one has no other value. */
interface DataCell {
  none: number;
  least?: string;
  mean?: string | { near: string };
  greatest?: string;
  from?: string;
  width?: string;
  single?: true;
  counts?: number[];
}

interface PageData {
  format: string;
  version: number;
  semantics: string;
  model: string | null;
  digest: string;
  parameters: { [name: string]: string };
  name: string;
  text: string;
  lets?: { [name: string]: string };
  timestep: string;
  resolution: string | null;
  solids: DataSolid[];
  families: string[];
  leaves: DataLeaf[];
  behaviours: DataBehaviour[];
  processes: DataProcess[];
  states: DataState[];
  labels: DataLabel[];
  plots: { text: string }[];
  runs: DataRun[];
  graph: { complete: boolean; bound: number; states: number; expanded: number } | null;
  where: DataWhere | null;
  /** Of runs of a simulation. */
  spread?: DataSpread;
  rules: { [name: string]: string };
}

/** A run as it is played: one of the file, or one's own way: so many legs of one of the file, then choices. */
interface PlayedRun extends DataRun {
  start: number;
  index: number;
  steps: DataStep[];
  rest: string;
  way: { base: number; legs: number; choices: number[] } | null;
  /** No single run shows the verdict: this is the beginning of any. */
  bare?: boolean;
}

/** How many rows of each table of a document are known. */
interface Had {
  solids: number;
  behaviours: number;
  processes: number;
  labels: number;
  states: number;
}

/** Rows that come after these, and states that are told anew: what a served document answers. */
interface DataMore {
  solids: DataSolid[];
  behaviours: DataBehaviour[];
  processes: DataProcess[];
  labels: DataLabel[];
  states: DataState[];
  looked: [number, DataState][];
}

/** What is selected: a body, or a feature of one of its parts. */
interface Chosen {
  leaf: number;
  part?: number | null;
  kind?: SiteKind | null;
  index?: number | null;
}

/** The data of the page of a solid, as lib/program/view/solid_page.ml writes it: format "scc-solid", version 1. */
interface SolidData {
  format: string;
  version: number;
  name: string;
  accepted: boolean;
  report: string;
  vertices: { name: string; at: Vec }[];
  faces: { name: string; corners: number[] }[];
  /** What is wrong, each with where it is: a badge that the picture has, too. */
  wrong: { badge: string; text: string; faces: number[]; edges: [number, number][]; vertices: number[] }[];
  /** How much more is wrong. */
  more: number;
}

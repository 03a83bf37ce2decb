open Scc_exact
open Scc_json
open Scc_runs
open Json_format

type shown = { number : int; values : Rat.t option array array; ended : string option }
type cell = { sorted : Rat.t array; mean : Rat.t option }

type t = {
  seed : int64;
  first : int;
  asked : int;
  made : int;
  observables : string list;
  times : Rat.t array;
  over : int array;
  cut : int array;
  cells : cell array array;
  shown : shown list;
  hurried : bool;
}

let most_cells = 10_000

(* {1 Bars} *)

(* Of equal widths without gaps: bar [i] has the values from [from + i width] on, up to [width] more, which belong
   to the next one; or the value [from + i width] alone. *)
type bars = { from : Rat.t; width : Rat.t; single : bool; counts : int array }

(* From multiples of a width on there may be one bar more, and another one for the greatest value. *)
let most_widths = 24

let rec common a b = if Rat.sign b = 0 then a else common b (Rat.modulo a b)

(* The greatest number of which all differences are multiples, unless there are too many of them in the range. *)
let step sorted range =
  let few step = Rat.compare range (Rat.mul (Rat.of_int most_widths) step) <= 0 in
  let rec go i step =
    if not (few step) then None
    else if i >= Array.length sorted then Some step
    else go (i + 1) (common step (Rat.sub sorted.(i) sorted.(i - 1)))
  in
  go 1 range

(* The least of 1, 2 and 5 times powers of ten of which the range has few. *)
let round_width range =
  let share = Rat.div range (Rat.of_int most_widths) in
  let power =
    let n = Decimal.order_of_magnitude share in
    let ten = Z.pow (Z.of_int 10) (abs n) in
    if n >= 0 then Rat.make ten Z.one else Rat.make Z.one ten
  in
  let widths = List.map (fun k -> Rat.mul (Rat.of_int k) power) [ 1; 2; 5; 10 ] in
  List.find (fun w -> Rat.compare share w <= 0) widths

(* Of sorted values. Bars are of single values where these are multiples of one number apart, and few enough.
   Otherwise they begin at multiples of 1, 2 or 5 times a power of ten. *)
let bars sorted =
  match Array.length sorted with
  | 0 -> None
  | n ->
    let least = sorted.(0) and greatest = sorted.(n - 1) in
    let range = Rat.sub greatest least in
    let from, width, single =
      if Rat.sign range = 0 then (least, Rat.one, true)
      else
        match step sorted range with
        | Some step -> (least, step, true)
        | None ->
          let width = round_width range in
          (Rat.mul width (Rat.make (Rat.floor (Rat.div least width)) Z.one), width, false)
    in
    let bar x = Z.to_int (Rat.floor (Rat.div (Rat.sub x from) width)) in
    let counts = Array.make (bar greatest + 1) 0 in
    Array.iter (fun x -> counts.(bar x) <- counts.(bar x) + 1) sorted;
    Some { from; width; single; counts }

(* {1 JSON} *)

(* The mean of many values may have thousands of digits. *)
let longest_mean = 400
let digits = 20

let mean_format =
  let short x = String.length (Rat.to_string x) <= longest_mean in
  union
    [
      case Shared.rational (fun x -> if short x then Some x else None) ignore;
      case
        (fields
           [
             field "near" some_text (Decimal.significant ~digits)
               ~about:"Rounded: all its digits would be too many.";
           ])
        (fun x -> if short x then None else Some x)
        ignore;
    ]

let cell_format =
  let bars f (_, _, bars) = Option.map f bars in
  let value at (_, c, _) = if Array.length c.sorted = 0 then None else Some c.sorted.(at c) in
  fields
    [
      field "none" natural (fun (went_on, c, _) -> went_on - Array.length c.sorted)
        ~about:"How many of the runs that went on have no value.";
      maybe "least" Shared.rational (value (fun _ -> 0));
      maybe "mean" mean_format (fun (_, c, _) -> c.mean);
      maybe "greatest" Shared.rational (value (fun c -> Array.length c.sorted - 1));
      maybe "from" Shared.rational (bars (fun b -> b.from)) ~about:"Where the first bar begins.";
      maybe "width" Shared.rational (bars (fun b -> b.width)) ~about:"From each bar to the next one.";
      maybe "single" (constant (`Bool true))
        (fun (_, _, bars) -> match bars with Some { single = true; _ } -> Some () | Some _ | None -> None)
        ~about:
          "Each bar is of one value alone. Otherwise it has all values up to the next bar, without its first.";
      maybe "counts" (array natural) (bars (fun b -> b.counts)) ~about:"How many runs have a value of each bar.";
    ]

let shown_format =
  fields
    [
      field "run" natural (fun s -> s.number) ~about:"Its number in the simulation.";
      field "values" (array (array (nullable Shared.rational))) (fun s -> s.values)
        ~about:"By time, and then by observable.";
      field "ended" (nullable some_text) (fun s -> s.ended) ~about:"Why it did not come to the last time.";
    ]

let format =
  let rows t =
    let row i cells = Array.map (fun c -> (t.made - t.over.(i) - t.cut.(i), c, bars c.sorted)) cells in
    Array.mapi row t.cells
  in
  fields
    [
      field "seed" Shared.seed (fun t -> t.seed);
      field "first" natural (fun t -> t.first) ~about:"The number of the first run.";
      field "asked" natural (fun t -> t.asked) ~about:"So many runs were to be made.";
      field "made" natural (fun t -> t.made) ~about:"So many runs are counted.";
      field "observables" (list some_text) (fun t -> t.observables);
      field "times" (array Shared.rational) (fun t -> t.times);
      field "over" (array natural) (fun t -> t.over) ~about:"By time: how many runs had ended before it.";
      field "cut" (array natural) (fun t -> t.cut)
        ~about:"By time: how many runs an interruption had ended before it.";
      field "cells" (array (array cell_format)) rows ~about:"By time, and then by observable.";
      field "shown" (list shown_format) (fun t -> t.shown) ~about:"Each is the run of the document in its place.";
      field "hurried" bool (fun t -> t.hurried)
        ~about:
          "True if an interruption left no time to show more runs; otherwise there are as many as fit, at most \
           20.";
    ]
  |> Rows.named "spread"

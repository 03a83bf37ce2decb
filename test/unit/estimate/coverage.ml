(* Coverage by counting: how often an interval misses, of so many experiments of each kind.

   usage: coverage [EXPERIMENTS], by default a share of them.

   An experiment on means looks at its bounds after 1, 2, 4, ... 1024 runs, and misses if any of them does. One on
   probabilities looks when [scc estimate] does by default, until 2000 runs, or once (--runs). It ends with 1 if
   some kind misses more often than it may: what is expected, and four deviations. *)

open Scc_exact
open Scc_runs
open Scc_estimate
open Counting

(* Values with weights. *)
let kinds =
  [
    ("two points at the ends", 10, [ (0, 1); (10, 1) ], 1);
    ("two points", 10, [ (3, 1); (5, 2) ], 1);
    ("rare and great", 1000, [ (0, 999); (1000, 1) ], 1);
    ("rare and less great", 1000, [ (1, 999); (200, 1) ], 1);
    ("skewed", 1000, [ (0, 90); (5, 9); (100, 1) ], 1);
    ("skewed to the other side", 1000, [ (1000, 90); (995, 9); (900, 1) ], 1);
    ("constant", 10, [ (3, 1) ], 1);
    ("at the low end", 10, [ (0, 1) ], 1);
    ("at the high end", 10, [ (10, 1) ], 1);
    ("even", 10, List.init 11 (fun i -> (i, 1)), 1);
    ("even, and a quarter is open", 10, List.init 11 (fun i -> (i, 1)), 4);
  ]

let looks = List.init 11 (fun i -> 1 lsl i)
let miss = fraction 1 20

let experiment (range : Range.t) values weights ~mean ~open_of g =
  let rec go tally made looks missed g =
    match looks with
    | [] -> (missed, g)
    | n :: rest ->
      let rec runs tally made g =
        if made = n then (tally, g)
        else
          let i, g = Splitmix64.by_chance (Array.of_list weights) g in
          let o, g = Splitmix64.below open_of g in
          let open_ = open_of > 1 && o = 0 in
          let outcome = if open_ then Sample.Too_long Steps else Number values.(i) in
          runs (Tally.add tally outcome) (made + 1) g
      in
      let tally, g = runs tally made g in
      let low, high = Tally.mean tally range ~look:miss ~miss in
      let beyond = Rat.compare (Option.get low) mean > 0 || Rat.compare mean (Option.get high) > 0 in
      go tally n rest (missed || beyond) g
  in
  go Tally.empty 0 looks false g

(* {1 Probabilities} *)

(* Rare and likely events. *)
let chances = [ (1, 10_000); (1, 1000); (1, 100); (1, 10); (1, 3); (1, 2); (99, 100); (999, 1000) ]

type way = Once of int | Again_until of int

(* The sizes at which is looked, with the shares of the miss. *)
let sizes = function
  | Once n -> [ (n, miss) ]
  | Again_until most ->
    let rec from j n =
      let share = Rat.div miss (Rat.of_int (j * (j + 1))) in
      (n, share) :: if n = most then [] else from (j + 1) (Int.min most (n + (n / 2)))
    in
    from 1 128

(* The intervals of so many runs and so many that do are few: each is computed once. *)
let interval =
  let known = Hashtbl.create 1000 in
  fun ~runs ~yes share ->
    let key = (runs, yes) in
    match Hashtbl.find_opt known (key, Rat.to_string share) with
    | Some found -> found
    | None ->
      let found = Tally.likelihood { Tally.empty with runs; yes; no = runs - yes } ~miss:share in
      Hashtbl.add known (key, Rat.to_string share) found;
      found

let misses (n, d) sizes g =
  let p = fraction n d in
  let of_coin yes g =
    let i, g = Splitmix64.below d g in
    ((if i < n then yes + 1 else yes), g)
  in
  let rec go made yes sizes g =
    match sizes with
    | [] -> (false, g)
    | (n, share) :: rest ->
      let rec flip made yes g =
        if made = n then (yes, g)
        else
          let yes, g = of_coin yes g in
          flip (made + 1) yes g
      in
      let yes, g = flip made yes g in
      let low, high = interval ~runs:n ~yes share in
      if Rat.compare low p > 0 || Rat.compare p high > 0 then (true, g) else go n yes rest g
  in
  go 0 0 sizes g

(* {1 All of them} *)

let worst = ref 0

let counted name ~count experiment seed =
  let rec go i missed g =
    if i = count then missed
    else
      let missed_now, g = experiment g in
      go (i + 1) (if missed_now then missed + 1 else missed) g
  in
  let missed = go 0 0 (Splitmix64.of_seed (Int64.of_int seed)) in
  Printf.printf "%-40s %5d of %d miss, at most %s of them may\n%!" name missed count
    (Rat.to_string (Rat.mul miss (Rat.of_int count)));
  match few_missed name ~count ~miss missed with () -> () | exception _ -> worst := 1

let of_mean ~count k (name, high, law, open_of) =
  let total = List.fold_left (fun sum (_, w) -> sum + w) 0 law in
  let mean = fraction (List.fold_left (fun sum (x, w) -> sum + (x * w)) 0 law) total in
  let values = Array.of_list (List.map (fun (x, _) -> Rat.of_int x) law) in
  let weights = List.map (fun (_, w) -> fraction w total) law in
  let range = { Range.low = Some Rat.zero; high = Some (Rat.of_int high); ends_only = false } in
  counted name ~count (experiment range values weights ~mean ~open_of) (k + 1)

let of_chance ~count k (n, d) =
  let one what way seed =
    counted (Printf.sprintf "probability %d/%d, %s" n d what) ~count (misses (n, d) (sizes way)) seed
  in
  one "again and again" (Again_until 2000) (100 + k);
  one "once, 300 runs" (Once 300) (200 + k)

let () =
  let count = if Array.length Sys.argv > 1 then int_of_string Sys.argv.(1) else 40 in
  List.iteri (of_chance ~count) chances;
  List.iteri (of_mean ~count) kinds;
  exit !worst

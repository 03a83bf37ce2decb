(* Coverage by counting: how often an interval misses, of so many experiments of each kind.

   usage: coverage [EXPERIMENTS], by default a share of them.

   Each experiment looks at its bounds after 1, 2, 4, ... 1024 runs, and misses if any of them does. It ends with 1
   if some kind misses more often than it may: what is expected, and four deviations. *)

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
          let i, g = Splitmix64.by_chance weights g in
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

let () =
  let count = if Array.length Sys.argv > 1 then int_of_string Sys.argv.(1) else 40 in
  let worst = ref 0 in
  List.iteri
    (fun k (name, high, law, open_of) ->
       let total = List.fold_left (fun sum (_, w) -> sum + w) 0 law in
       let mean = fraction (List.fold_left (fun sum (x, w) -> sum + (x * w)) 0 law) total in
       let values = Array.of_list (List.map (fun (x, _) -> Rat.of_int x) law) in
       let weights = List.map (fun (_, w) -> fraction w total) law in
       let range = { Range.low = Some Rat.zero; high = Some (Rat.of_int high); ends_only = false } in
       let rec go i missed g =
         if i = count then missed
         else
           let missed_now, g = experiment range values weights ~mean ~open_of g in
           go (i + 1) (if missed_now then missed + 1 else missed) g
       in
       let missed = go 0 0 (Splitmix64.of_seed (Int64.of_int (k + 1))) in
       Printf.printf "%-30s %5d of %d miss, at most %s of them may\n%!" name missed count
         (Rat.to_string (Rat.mul miss (Rat.of_int count)));
       match few_missed name ~count ~miss missed with
       | () -> ()
       | exception _ -> worst := 1)
    kinds;
  exit !worst

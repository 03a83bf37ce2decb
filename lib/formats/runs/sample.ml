open Scc_exact
open Scc_calculus

type how = Simple | Random of int64

let parts = 1024

(* A run may be chosen by the same seed, from its first output on: a start that was made of the same outputs
   would go with certain choices only. *)
let generator seed = Splitmix64.of_seed (fst (Splitmix64.next (Splitmix64.of_seed seed)))

let random_value g (r : Ranges.range) =
  let k, g = Splitmix64.below (parts - 1) g in
  let width = Rat.sub r.high.value r.low.value in
  let share = Rat.div (Rat.of_int (k + 1)) (Rat.of_int parts) in
  (g, Rat.add r.low.value (Rat.mul share width))

let values how ranges =
  let names = List.map (fun (r : Ranges.range) -> r.name) (Array.to_list ranges) in
  let values =
    match how with
    | Simple -> Array.to_list (Ranges.point ranges)
    | Random seed -> snd (List.fold_left_map random_value (generator seed) (Array.to_list ranges))
  in
  List.combine names values

let to_string values =
  String.concat ", " (List.map (fun (name, x) -> Printf.sprintf "%s = %s" name (Rat.to_string x)) values)

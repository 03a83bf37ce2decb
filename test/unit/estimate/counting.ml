(* What tests of estimates share: trials with known chances, and how many intervals may miss. *)

open Scc_exact
open Scc_runs
open Scc_estimate
open Scc_test_models

let fraction n d = Rat.make (Z.of_int n) (Z.of_int d)
let rec power r n = if n = 0 then Rat.one else Rat.mul r (power r (n - 1))


let small = QCheck2.Gen.(bind (int_range 1 40) (fun n -> triple (return n) (int_bound n) (int_range 1 499)))
let print (n, k, m) = Printf.sprintf "%d of %d, miss %d/1000" k n m


(* Of [count] estimates of a coin at most so many may miss: what is expected and four deviations. *)
let few_missed what ~count ~miss missed =
  let expected = Rat.mul miss (Rat.of_int count) in
  let above = Rat.sub (Rat.of_int missed) expected in
  let variance = Rat.mul expected (Rat.sub Rat.one miss) in
  if Rat.sign above > 0 && Rat.compare (Rat.mul above above) (Rat.mul (Rat.of_int 16) variance) > 0 then
    Alcotest.failf "%s: %d of %d intervals miss" what missed count

let coin (p : Rat.t) g =
  let i, g = Splitmix64.by_chance [| p; Rat.sub Rat.one p |] g in
  (i = 0, g)

let path text =
  let model = "model m\nimport <solids>\nprocess a = solids.Cube(1) mass 1 [nil]\ncheck c : " ^ text ^ "\n" in
  let e = Load.exactly (Load.text model) in
  Result.get_ok (Path.of_check e.model (List.hd e.checks))


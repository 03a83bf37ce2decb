open Scc_exact
open Scc_ctl
open Scc_evaluate
open Scc_json

(* {1 Pieces} *)

let coefficients p = `List (List.map Json.rat (Polynomial.coefficients p))

let value : Value.t -> (string * Json.t) list = function
  | Ratio (n, d) -> [ ("n", coefficients n); ("d", coefficients d) ]
  | Undefined why -> [ ("none", Json.text why) ]

let constant n = [ ("n", `List [ Json.rat n ]); ("d", `List [ Json.rat Rat.one ]) ]

let holds : Truth.t -> (string * Json.t) list = function
  | True -> constant Rat.one
  | False -> constant Rat.zero
  | Undecided why -> [ ("none", Json.text why) ]

(* {1 Where they begin} *)

let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12)

let instant a =
  match Algebraic.to_rat a with
  | Some r -> r
  | None -> fst (Algebraic.enclose a ~width)

let told equal piece line =
  let line = Timeline.simplify equal line in
  let stretch from at after =
    if equal at after then [ (from, after) ] else [ (from, at); (from, after) ]
  in
  let later (c : _ Timeline.piece) = stretch (instant c.cut) c.at c.after in
  let from (a, v) = `Assoc (("from", Json.rat a) :: piece v) in
  match line.extent with
  | Instant -> `Assoc (piece line.start)
  | Lasts _ | Forever -> (
      match stretch Rat.zero line.start line.first @ List.concat_map later line.rest with
      | [ (_, v) ] -> `Assoc (piece v)
      | pieces -> `Assoc [ ("pieces", `List (List.map from pieces)) ])

let number line = told Value.equal value line
let truth line = told Truth.equal holds line

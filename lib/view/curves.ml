open Scc_exact
open Scc_property
open Scc_evaluate
open Scc_exchange

let most = 8

(* {1 What checks name} *)

let rec of_num found (n : Property.num) =
  match n with
  | Const _ | Quantity (Time | Parameter _) -> found
  | Quantity _ -> n :: found
  | Count props -> List.fold_left of_prop found props
  | Neg a -> of_num found a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> of_num (of_num found a) b
  | If (p, a, b) -> of_num (of_num (of_prop found p) a) b

and of_prop found (p : Property.prop) =
  match p with
  | Bool _ | Fact _ -> found
  | Compare (_, a, b) -> of_num (of_num found a) b
  | Not p -> of_prop found p
  | And all | Or all -> List.fold_left of_prop found all

let of_checks (checks : Property.check list) =
  let of_check (c : Property.check) =
    List.rev (List.fold_left of_prop [] (Formula.predicates c.formula))
  in
  let add kept n = if List.exists (Formula.equal_num n) kept then kept else n :: kept in
  List.rev (List.fold_left add [] (List.concat_map of_check checks))
  |> List.filteri (fun i _ -> i < most)

(* {1 Pieces} *)

let coefficients p = `List (List.map Json.rat (Polynomial.coefficients p))

let piece : Value.t -> (string * Json.t) list = function
  | Ratio (n, d) -> [ ("n", coefficients n); ("d", coefficients d) ]
  | Undefined why -> [ ("none", Json.text why) ]

(* Instants that are not rational are told by a rational close by. *)
let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12)

let instant a =
  match Algebraic.to_rat a with
  | Some r -> r
  | None -> fst (Algebraic.enclose a ~width)

let value semantics state extent num =
  let line = Trajectory.num (Trajectory.make semantics state extent) num in
  match (extent, line.rest) with
  | Scc_ctl.Timeline.Instant, _ -> `Assoc (piece line.start)
  | (Lasts _ | Forever), [] -> `Assoc (piece line.first)
  | (Lasts _ | Forever), cuts ->
    let from a v = `Assoc (("from", Json.rat a) :: piece v) in
    let later (c : _ Scc_ctl.Timeline.piece) = from (instant c.cut) c.after in
    `Assoc [ ("pieces", `List (from Rat.zero line.first :: List.map later cuts)) ]

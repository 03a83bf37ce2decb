open Scc_property
open Scc_evaluate
open Scc_runs

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

let value semantics state extent num =
  Curve_json.number (Trajectory.num (Trajectory.make semantics state extent) num)

open Scc_property
open Scc_evaluate
open Scc_runs

let most = 8

(* {1 What checks name} *)

let rec of_num found (n : Property.num) =
  match n with
  | Quantity (Time | Parameter _) -> found
  | Quantity _ -> n :: found
  | _ -> of_parts found (Parts.of_num n)

and of_prop found p = of_parts found (Parts.of_prop p)

and of_parts found { numbers; predicates } =
  List.fold_left of_num (List.fold_left of_prop found predicates) numbers

let of_checks (checks : Property.check list) =
  let of_check (c : Property.check) =
    List.rev (List.fold_left of_prop [] (Formula.predicates c.formula))
  in
  let add kept n = if List.exists (Formula.equal_num n) kept then kept else n :: kept in
  List.rev (List.fold_left add [] (List.concat_map of_check checks))
  |> List.filteri (fun i _ -> i < most)

let value semantics state extent num =
  Curve_json.number (Trajectory.num (Trajectory.make semantics state extent) num)

open Scc_polyhedra
open Scc_calculus

(* Functions of the theories of numbers, and of those that solvers know without being asked: no constant can have
   these names, not even in quotes. *)
let functions =
  [
    "abs"; "and"; "distinct"; "div"; "divisible"; "false"; "implies"; "is_int"; "ite"; "mod"; "not"; "or";
    "select"; "store"; "to_int"; "to_real"; "true"; "xor";
  ]

let parameter ranges i =
  let name = Ranges.name ranges i in
  if List.mem name functions then "param-" ^ name else name

let definition ~name check suffix u =
  Printf.sprintf "(define-fun %s () Bool %s)" (Text.smt_symbol (check ^ suffix)) (Text.smt_union ~name u)

let check ~name (title, (w : Where.t)) =
  [
    definition ~name title "-holds" w.holds;
    definition ~name title "-fails" w.fails;
    definition ~name title "-unknown" w.unknown;
  ]

let script ranges checks =
  let name = parameter ranges in
  let declaration i _ = Printf.sprintf "(declare-const %s Real)" (Text.smt_symbol (name i)) in
  let box = Printf.sprintf "(assert %s)" (Text.smt_polyhedron ~name (Ranges.box ranges)) in
  let head = [ "(set-info :smt-lib-version 2.6)"; "(set-logic QF_LRA)" ] in
  let declarations = Array.to_list (Array.mapi declaration ranges) in
  String.concat "\n" (head @ declarations @ [ box ] @ List.concat_map (check ~name) checks) ^ "\n"

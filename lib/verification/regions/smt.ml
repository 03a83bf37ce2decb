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

(* An end that is infinite has no term: a bound says nothing there. *)
let number ~name (title, (c : Chances.t)) =
  let function_of suffix end_ =
    let term (part : Chances.part) =
      Option.map (fun form -> (Text.smt_union ~name part.set, Text.smt_form ~name form)) (end_ part.value)
    in
    let finite = List.filter_map term c.parts in
    let without (part : Chances.part) = Option.is_none (end_ part.value) in
    let infinite = List.concat_map (fun (p : Chances.part) -> Union.pieces p.set) (List.filter without c.parts) in
    let case (set, form) rest = Printf.sprintf "(ite %s %s %s)" set form rest in
    let cases = List.fold_right case finite "0.0" in
    [
      Printf.sprintf "(define-fun %s () Real %s)" (Text.smt_symbol (title ^ suffix)) cases;
      definition ~name title (suffix ^ "-infinite")
        (Union.of_polyhedra (Array.length c.ranges) infinite);
    ]
  in
  function_of "-low" (fun (v : Chances.value) -> v.least)
  @ function_of "-high" (fun (v : Chances.value) -> v.most)
  @ [ definition ~name title "-unknown" c.unknown ]

let script ranges ~numbers checks =
  let name = parameter ranges in
  let declaration i _ = Printf.sprintf "(declare-const %s Real)" (Text.smt_symbol (name i)) in
  let box = Printf.sprintf "(assert %s)" (Text.smt_polyhedron ~name (Ranges.box ranges)) in
  let head = [ "(set-info :smt-lib-version 2.6)"; "(set-logic QF_LRA)" ] in
  let declarations = Array.to_list (Array.mapi declaration ranges) in
  String.concat "\n" 
    (head @ declarations @ [ box ] @ List.concat_map (check ~name) checks @ List.concat_map (number ~name) numbers)
  ^ "\n"

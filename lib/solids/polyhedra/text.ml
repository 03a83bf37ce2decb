open Scc_exact

(* [2x], [x], [1/2 x] for a positive coefficient: letters stand next to an integer, not next to a fraction. *)
let term name (i, a) =
  if Rat.equal a Rat.one then name i
  else if Rat.is_integer a then Rat.to_string a ^ name i
  else Rat.to_string a ^ " " ^ name i

let terms coefficients =
  List.filter (fun (_, a) -> Rat.sign a <> 0) (List.mapi (fun i a -> (i, a)) (Array.to_list coefficients))

let form ~name (f : Linear.t) =
  let variables = List.map (fun (i, a) -> (Rat.sign a, term name (i, Rat.abs a))) (terms f.coefficients) in
  let constant = (Rat.sign f.constant, Rat.to_string (Rat.abs f.constant)) in
  match List.filter (fun (sign, _) -> sign <> 0) (variables @ [ constant ]) with
  | [] -> "0"
  | (sign, first) :: rest ->
    let next (sign, text) = (if sign < 0 then " - " else " + ") ^ text in
    (if sign < 0 then "-" else "") ^ first ^ String.concat "" (List.map next rest)

(* {1 Constraints} *)

let relation ~backwards = function
  | Constraint.Equal -> "="
  | Constraint.Less -> if backwards then ">" else "<"
  | Constraint.At_most -> if backwards then ">=" else "<="

(* The constant goes to the side on which it is positive; alone on its side it stays there. *)
let side name terms constant =
  let constant = if Rat.sign constant = 0 && terms <> [] then [] else [ Rat.to_string constant ] in
  String.concat " + " (List.map (term name) terms @ constant)

let several name left right (c : Constraint.t) =
  let constant = Q.of_bigint c.right in
  let opposite = List.map (fun (i, a) -> (i, Rat.neg a)) in
  let between ~backwards left right constant =
    let on_left, on_right =
      if Rat.sign constant < 0 && right <> [] then (Rat.neg constant, Rat.zero) else (Rat.zero, constant)
    in
    String.concat " " [ side name left on_left; relation ~backwards c.relation; side name right on_right ]
  in
  if left = [] then between ~backwards:true (opposite right) [] (Rat.neg constant)
  else between ~backwards:false left (opposite right) constant

let constraint_ ~name (c : Constraint.t) =
  match terms (Array.map Q.of_bigint c.normal) with
  | [] -> if Constraint.truth c = Some true then "true" else "false"
  | [ (i, a) ] ->
    let bound = Rat.div (Q.of_bigint c.right) a in
    String.concat " " [ name i; relation ~backwards:(Rat.sign a < 0) c.relation; Rat.to_string bound ]
  | all ->
    let left, right = List.partition (fun (_, a) -> Rat.sign a > 0) all in
    several name left right c

let polyhedron ~name p =
  if Polyhedron.is_empty p then "false"
  else
    match Polyhedron.constraints p with
    | [] -> "true"
    | constraints -> String.concat ", " (List.map (constraint_ ~name) constraints)

(* {1 SMT-LIB} *)

let reserved =
  [ "!"; "_"; "as"; "BINARY"; "DECIMAL"; "exists"; "HEXADECIMAL"; "forall"; "let"; "match"; "NUMERAL"; "par";
    "STRING" ]

let smt_symbol name =
  let allowed = function
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' -> true
    | c -> String.contains "~!@$%^&*_-+=<>.?/" c
  in
  let starts = name <> "" && match name.[0] with '0' .. '9' | '@' | '.' -> false | _ -> true in
  let simple = starts && String.for_all allowed name && not (List.mem name reserved) in
  if simple then name else "|" ^ name ^ "|"

let smt_integer z =
  let size = Z.to_string (Z.abs z) ^ ".0" in
  if Z.sign z < 0 then "(- " ^ size ^ ")" else size

let smt_rational q =
  let whole = smt_integer (Z.abs (Q.num q)) in
  let size = if Rat.is_integer q then whole else Printf.sprintf "(/ %s %s)" whole (smt_integer (Q.den q)) in
  if Rat.sign q < 0 then "(- " ^ size ^ ")" else size

let application op = function
  | [ only ] -> only
  | arguments -> "(" ^ String.concat " " (op :: arguments) ^ ")"

let smt_constraint ~name (c : Constraint.t) =
  let term (i, a) =
    let symbol = smt_symbol (name i) in
    if Z.equal a Z.one then symbol else "(* " ^ smt_integer a ^ " " ^ symbol ^ ")"
  in
  let all = List.mapi (fun i a -> (i, a)) (Array.to_list c.normal) in
  match List.filter (fun (_, a) -> Z.sign a <> 0) all with
  | [] -> if Constraint.truth c = Some true then "true" else "false"
  | mentioned ->
    let sum = application "+" (List.map term mentioned) in
    "(" ^ relation ~backwards:false c.relation ^ " " ^ sum ^ " " ^ smt_integer c.right ^ ")"

let smt_form ~name (f : Linear.t) =
  let term i a =
    let symbol = smt_symbol (name i) in
    if Rat.sign a = 0 then []
    else if Rat.equal a Rat.one then [ symbol ]
    else [ Printf.sprintf "(* %s %s)" (smt_rational a) symbol ]
  in
  let terms = List.concat (Array.to_list (Array.mapi term f.coefficients)) in
  match terms with
  | [] -> smt_rational f.constant
  | _ :: _ -> application "+" (if Rat.sign f.constant = 0 then terms else terms @ [ smt_rational f.constant ])

let smt_polyhedron ~name p =
  match Polyhedron.constraints p with
  | [] -> "true"
  | constraints -> application "and" (List.map (smt_constraint ~name) constraints)

let smt_union ~name u =
  match Union.pieces u with
  | [] -> "false"
  | pieces -> application "or" (List.map (smt_polyhedron ~name) pieces)

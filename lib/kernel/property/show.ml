open Scc_exact
open Scc_calculus
open Property

let leaf (m : Model.t) i = m.leaves.(i).name

let comparison : Law.comparison -> string = function
  | Lt -> "<"
  | Le -> "<="
  | Gt -> ">"
  | Ge -> ">="
  | Eq -> "="
  | Ne -> "!="

let call name arguments = Printf.sprintf "%s(%s)" name (String.concat ", " arguments)

let written word = function
  | [] -> word
  | arguments -> call word arguments

let argument m : Atom.argument -> string = function
  | Leaf i -> leaf m i
  | Part (i, k) -> m.leaves.(i).parts.(k).name
  | Channel (Some Co_name, a) -> "~" ^ a
  | Channel ((Some Name | None), a) -> a
  | Definition k -> m.definitions.(k).name
  | Parameter i -> Ranges.name m.ranges i

let event m e = written (Atom.event_word e) (List.map (argument m) (Atom.event_arguments e))

(* A definition is compared with: [behaviour(p) = K]. *)
let atom m (a : Atom.t) =
  let is_definition = function
    | Atom.Definition _ -> true
    | Leaf _ | Part _ | Channel _ | Parameter _ -> false
  in
  let definitions, others = List.partition is_definition a.arguments in
  String.concat " = " (written a.word (List.map (argument m) others) :: List.map (argument m) definitions)

let rec num m = function
  | Const q -> Rat.to_string q
  | Quantity (Parameter i) -> Ranges.name m.Model.ranges i
  | Quantity q -> atom m (Atom.quantity q)
  | Count ps -> call "count" (List.map (prop m) ps)
  | Neg a -> "-" ^ num m a
  | Add (a, b) -> infix m "+" a b
  | Sub (a, b) -> infix m "-" a b
  | Mul (a, b) -> infix m "*" a b
  | Div (a, b) -> infix m "/" a b
  | If (c, a, b) -> Printf.sprintf "(if %s then %s else %s)" (prop m c) (num m a) (num m b)

and infix m operator a b = Printf.sprintf "(%s %s %s)" (num m a) operator (num m b)

and prop m = function
  | Bool b -> string_of_bool b
  | Compare (c, a, b) -> Printf.sprintf "%s %s %s" (num m a) (comparison c) (num m b)
  | Fact f -> atom m (Atom.fact f)
  | Not p -> "not " ^ bracket m p
  | And ps -> connective m "and" "true" ps
  | Or ps -> connective m "or" "false" ps

and connective m word neutral = function
  | [] -> neutral
  | ps -> String.concat (" " ^ word ^ " ") (List.map (bracket m) ps)

and bracket m p =
  match p with
  | And (_ :: _ :: _) | Or (_ :: _ :: _) -> "(" ^ prop m p ^ ")"
  | _ -> prop m p

let quantifier = function
  | All -> "A"
  | Exists -> "E"
  | Chance c -> Scc_ctl.Timed_formula.chance c ^ " "

let bound b =
  match (Rat.sign b.low, b.high) with
  | 0, None -> ""
  | 0, Some t -> Printf.sprintf "[<= %s]" (Rat.to_string t)
  | _, Some t -> Printf.sprintf "[%s, %s]" (Rat.to_string b.low) (Rat.to_string t)
  | _, None -> Printf.sprintf "[>= %s]" (Rat.to_string b.low)

let states ps = List.map (fun p -> State p) ps

(* Of what a formula is the negation. *)
let negated = function
  | Temporal_not f -> Some f
  | State (Not p) -> Some (State p)
  | _ -> None

(* The levels of the syntax: 0 [=>], 1 [or], 2 [and], 3 prefixes, 4 what never needs brackets. *)
let rec levelled m f =
  let prefix word f = (3, Printf.sprintf "%s %s" word (at 3 m f)) in
  let joined level word f fs =
    (level, String.concat (" " ^ word ^ " ") (List.map (at (level + 1) m) (f :: fs)))
  in
  match f with
  | State (And ps) -> levelled m (Temporal_and (states ps))
  | State (Or ps) -> levelled m (Temporal_or (states ps))
  | State (Not p) -> levelled m (Temporal_not (State p))
  | State p -> (4, prop m p)
  | Temporal_and [] -> (4, "true")
  | Temporal_or [] -> (4, "false")
  | Temporal_and [ f ] | Temporal_or [ f ] -> levelled m f
  | Temporal_not f -> (
      match negated f with
      | Some f -> levelled m f
      | None -> prefix "not" f)
  | Temporal_and (f :: fs) -> joined 2 "and" f fs
  | Temporal_or (f :: fs) -> (
      match (negated f, fs) with
      | Some premise, [ g ] -> (0, Printf.sprintf "%s => %s" (at 1 m premise) (at 0 m g))
      | _ -> joined 1 "or" f fs)
  | Finally (Chance c, b, f) -> likely m c ("eventually" ^ bound b) f
  | Globally (Chance c, b, f) -> likely m c ("always" ^ bound b) f
  | Next (q, f) -> prefix (quantifier q ^ "X") f
  | Finally (q, b, f) -> prefix (quantifier q ^ "F" ^ bound b) f
  | Globally (q, b, f) -> prefix (quantifier q ^ "G" ^ bound b) f
  | Until (q, b, f, g) ->
    (4, Printf.sprintf "%s[ %s U%s %s ]" (quantifier q) (temporal m f) (bound b) (temporal m g))

and likely m c operator f =
  (4, Printf.sprintf "%s [ %s %s ]" (Scc_ctl.Timed_formula.chance c) operator (temporal m f))

and at level m f =
  let own, text = levelled m f in
  if own < level then "(" ^ text ^ ")" else text

and temporal m f = snd (levelled m f)

let atoms p =
  let rec collect found = function
    | Not p -> collect found p
    | And ps | Or ps -> List.fold_left collect found ps
    | atom -> if List.exists (Formula.equal_prop atom) found then found else atom :: found
  in
  List.rev (collect [] p)

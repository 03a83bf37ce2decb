open Scc_base
open Scc_calculus
open Property

let equal_event a b = Order.event a b = 0
let equal_num a b = Order.num a b = 0
let equal_prop a b = Order.prop a b = 0
let equal a b = Order.temporal a b = 0
let equal_modulo_order a b = equal (Rename.ordered a) (Rename.ordered b)
let permuted = Rename.temporal

let complement : Law.comparison -> Law.comparison = function
  | Lt -> Ge
  | Le -> Gt
  | Gt -> Le
  | Ge -> Lt
  | Eq -> Ne
  | Ne -> Eq

let rec negate = function
  | Bool b -> Bool (not b)
  | Compare (c, a, b) -> Compare (complement c, a, b)
  | Not p -> p
  | And ps -> Or (Long_list.map negate ps)
  | Or ps -> And (Long_list.map negate ps)
  | (Bound _ | Same _ | Behaviour _ | Offers _ | Touching _ | Quiescent | Event _) as atom -> Not atom

let dual = function
  | All -> Exists
  | Exists -> All

let rec negation_normal_form = function
  | State p -> State p
  | Temporal_not f -> refuse f
  | Temporal_and fs -> Temporal_and (Long_list.map negation_normal_form fs)
  | Temporal_or fs -> Temporal_or (Long_list.map negation_normal_form fs)
  | Next (q, f) -> Next (q, negation_normal_form f)
  | Finally (q, b, f) -> Finally (q, b, negation_normal_form f)
  | Globally (q, b, f) -> Globally (q, b, negation_normal_form f)
  | Until (q, b, f, g) -> Until (q, b, negation_normal_form f, negation_normal_form g)

(* The normal form of the negation. *)
and refuse = function
  | State p -> State (negate p)
  | Temporal_not f -> negation_normal_form f
  | Temporal_and fs -> Temporal_or (Long_list.map refuse fs)
  | Temporal_or fs -> Temporal_and (Long_list.map refuse fs)
  | Next (q, f) -> Next (dual q, refuse f)
  | Finally (q, b, f) -> Globally (dual q, b, refuse f)
  | Globally (q, b, f) -> Finally (dual q, b, refuse f)
  | Until _ as f -> Temporal_not (negation_normal_form f)

(* Whether some number or predicate of a formula satisfies its test; every term is visited. *)
type tests = { of_num : num -> bool; of_prop : prop -> bool }

let rec exists_num t n =
  t.of_num n
  ||
  match n with
  | Const _ | Bonds _ | Size _ | Processes | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _
  | Momentum _ | Angular _ | Energy | Time -> false
  | Count ps -> List.exists (exists_prop t) ps
  | Neg a -> exists_num t a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> exists_num t a || exists_num t b
  | If (p, a, b) -> exists_prop t p || exists_num t a || exists_num t b

and exists_prop t p =
  t.of_prop p
  ||
  match p with
  | Bool _ | Bound _ | Same _ | Behaviour _ | Offers _ | Touching _ | Quiescent | Event _ -> false
  | Compare (_, a, b) -> exists_num t a || exists_num t b
  | Not p -> exists_prop t p
  | And ps | Or ps -> List.exists (exists_prop t) ps

let rec exists t = function
  | State p -> exists_prop t p
  | Temporal_not f | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> exists t f
  | Temporal_and fs | Temporal_or fs -> List.exists (exists t) fs
  | Until (_, _, f, g) -> exists t f || exists t g

let no _ = false

let mentions_time f =
  exists
    { of_num = (function Time -> true | _ -> false); of_prop = no }
    f

let mentions_position f =
  exists
    { of_num = (function Position _ | Angular _ -> true | _ -> false); of_prop = no }
    f

let has_events f =
  exists
    { of_num = no; of_prop = (function Event _ -> true | _ -> false) }
    f

let rec mentions_next = function
  | State _ -> false
  | Next _ -> true
  | Temporal_not f | Finally (_, _, f) | Globally (_, _, f) -> mentions_next f
  | Temporal_and fs | Temporal_or fs -> List.exists mentions_next fs
  | Until (_, _, f, g) -> mentions_next f || mentions_next g

let depends_on_all_num = function
  | Bonds (_, None) | Processes | Momentum _ | Angular _ | Energy -> true
  | Const _ | Bonds (_, Some _) | Size _ | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _
  | Time | Count _ | Neg _ | Add _ | Sub _ | Mul _ | Div _ | If _ -> false

let depends_on_all_prop = function
  | Quiescent | Event (Bond (_, _, Any) | Bounce Any) -> true
  | Event (Bond (_, _, (One _ | Two _)) | Bounce (One _ | Two _))
  | Bool _ | Compare _ | Bound _ | Same _ | Behaviour _ | Offers _ | Touching _ | Not _ | And _ | Or _ -> false

let global f = exists { of_num = depends_on_all_num; of_prop = depends_on_all_prop } f

let leaves_of_num = function
  | Size i | Position (_, i) | Velocity (_, i) | Speed2 i | Spin (_, i) | Spin2 i -> [ i ]
  | Bonds (_, Some (i, j)) | Distance2 (i, j) -> [ i; j ]
  | Const _ | Bonds (_, None) | Processes | Momentum _ | Angular _ | Energy | Time | Count _ | Neg _ | Add _
  | Sub _ | Mul _ | Div _ | If _ -> []

let leaves_of_prop = function
  | Behaviour (i, _) | Offers (i, _, _) -> [ i ]
  | Bound (i, j) | Same (i, j) | Touching (i, j) -> [ i; j ]
  | Event (Bond (_, _, One i) | Bounce (One i)) -> [ i ]
  | Event (Bond (_, _, Two (i, j)) | Bounce (Two (i, j))) -> [ i; j ]
  | Event (Bond (_, _, Any) | Bounce Any) | Bool _ | Compare _ | Quiescent | Not _ | And _ | Or _ -> []

let iter ~num ~prop f =
  let visit g x = g x; false in
  ignore (exists { of_num = visit num; of_prop = visit prop } f)

module Leaves = Set.Make (Int)

let leaves f =
  let found = ref Leaves.empty in
  let note list = found := List.fold_left (fun found i -> Leaves.add i found) !found list in
  iter ~num:(fun n -> note (leaves_of_num n)) ~prop:(fun p -> note (leaves_of_prop p)) f;
  Leaves.elements !found

let rec predicates = function
  | State p -> [ p ]
  | Temporal_not f | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> predicates f
  | Temporal_and fs | Temporal_or fs -> List.concat_map predicates fs
  | Until (_, _, f, g) -> predicates f @ predicates g

let rec state_formula = function
  | State p -> Some p
  | Temporal_not f -> Option.map negate (state_formula f)
  | Temporal_and fs -> Option.map (fun ps -> And ps) (all fs)
  | Temporal_or fs -> Option.map (fun ps -> Or ps) (all fs)
  | Next _ | Finally _ | Globally _ | Until _ -> None

and all fs =
  let add found f =
    match (found, state_formula f) with
    | Some ps, Some p -> Some (p :: ps)
    | _, _ -> None
  in
  Option.map List.rev (List.fold_left add (Some []) fs)

let events f =
  let found = ref [] in
  let note = function
    | Event e -> if not (List.exists (equal_event e) !found) then found := e :: !found
    | _ -> ()
  in
  iter ~num:ignore ~prop:note f;
  List.rev !found

let leaves_of_events f = List.concat_map (fun e -> leaves_of_prop (Event e)) (events f)

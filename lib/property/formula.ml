open Scc_base
open Scc_exact
open Scc_calculus
open Property

let equal_axis a b =
  match (a, b) with
  | X, X | Y, Y | Z, Z -> true
  | (X | Y | Z), _ -> false

let equal_pair (a, b) (c, d) = Int.equal a c && Int.equal b d

let equal_comparison (a : Law.comparison) (b : Law.comparison) =
  match (a, b) with
  | Lt, Lt | Le, Le | Gt, Gt | Ge, Ge | Eq, Eq | Ne, Ne -> true
  | (Lt | Le | Gt | Ge | Eq | Ne), _ -> false

let equal_polarity (a : Behaviour.polarity) (b : Behaviour.polarity) =
  match (a, b) with
  | Name, Name | Co_name, Co_name -> true
  | (Name | Co_name), _ -> false

let equal_change a b =
  match (a, b) with
  | Made, Made
  | Released_weakly, Released_weakly
  | Released_strongly, Released_strongly
  | Released, Released -> true
  | (Made | Released_weakly | Released_strongly | Released), _ -> false

let equal_ends a b =
  match (a, b) with
  | Any, Any -> true
  | One i, One j -> Int.equal i j
  | Two (i, j), Two (k, l) -> equal_pair (i, j) (k, l)
  | (Any | One _ | Two _), _ -> false

let equal_event a b =
  match (a, b) with
  | Bond (c, n, e), Bond (d, o, f) -> equal_change c d && Option.equal String.equal n o && equal_ends e f
  | Bounce e, Bounce f -> equal_ends e f
  | (Bond _ | Bounce _), _ -> false

let rec equal_num a b =
  match (a, b) with
  | Const x, Const y -> Rat.equal x y
  | Bonds (a, p), Bonds (b, q) -> Option.equal String.equal a b && Option.equal equal_pair p q
  | Size i, Size j | Speed2 i, Speed2 j -> Int.equal i j
  | Processes, Processes | Energy, Energy | Time, Time -> true
  | Position (x, i), Position (y, j) | Velocity (x, i), Velocity (y, j) ->
    equal_axis x y && Int.equal i j
  | Distance2 (i, j), Distance2 (k, l) -> equal_pair (i, j) (k, l)
  | Momentum x, Momentum y -> equal_axis x y
  | Count ps, Count qs -> List.equal equal_prop ps qs
  | Neg a, Neg b -> equal_num a b
  | Add (a, b), Add (c, d) | Sub (a, b), Sub (c, d) | Mul (a, b), Mul (c, d) | Div (a, b), Div (c, d) ->
    equal_num a c && equal_num b d
  | If (p, a, b), If (q, c, d) -> equal_prop p q && equal_num a c && equal_num b d
  | ( ( Const _ | Bonds _ | Size _ | Speed2 _ | Processes | Energy | Time | Position _ | Velocity _
      | Distance2 _ | Momentum _ | Count _ | Neg _ | Add _ | Sub _ | Mul _ | Div _ | If _ ),
      _ ) -> false

and equal_prop a b =
  match (a, b) with
  | Bool x, Bool y -> Bool.equal x y
  | Compare (c, a, b), Compare (d, e, f) -> equal_comparison c d && equal_num a e && equal_num b f
  | Bound (i, j), Bound (k, l) | Same (i, j), Same (k, l) | Touching (i, j), Touching (k, l)
  | Behaviour (i, j), Behaviour (k, l) -> equal_pair (i, j) (k, l)
  | Offers (i, p, a), Offers (j, q, b) ->
    Int.equal i j && Option.equal equal_polarity p q && String.equal a b
  | Quiescent, Quiescent -> true
  | Event e, Event f -> equal_event e f
  | Not p, Not q -> equal_prop p q
  | And ps, And qs | Or ps, Or qs -> List.equal equal_prop ps qs
  | ( ( Bool _ | Compare _ | Bound _ | Same _ | Touching _ | Behaviour _ | Offers _ | Quiescent | Event _
      | Not _ | And _ | Or _ ),
      _ ) -> false

let equal_quantifier a b =
  match (a, b) with
  | All, All | Exists, Exists -> true
  | (All | Exists), _ -> false

let equal_bound a b = Rat.equal a.low b.low && Option.equal Rat.equal a.high b.high

let rec equal a b =
  match (a, b) with
  | State p, State q -> equal_prop p q
  | Temporal_not f, Temporal_not g -> equal f g
  | Temporal_and fs, Temporal_and gs | Temporal_or fs, Temporal_or gs -> List.equal equal fs gs
  | Next (q, f), Next (r, g) -> equal_quantifier q r && equal f g
  | Finally (q, b, f), Finally (r, c, g) | Globally (q, b, f), Globally (r, c, g) ->
    equal_quantifier q r && equal_bound b c && equal f g
  | Until (q, b, f, g), Until (r, c, h, i) ->
    equal_quantifier q r && equal_bound b c && equal f h && equal g i
  | ( ( State _ | Temporal_not _ | Temporal_and _ | Temporal_or _ | Next _ | Finally _ | Globally _
      | Until _ ),
      _ ) -> false

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
  | Const _ | Bonds _ | Size _ | Processes | Position _ | Velocity _ | Speed2 _ | Distance2 _ | Momentum _
  | Energy | Time -> false
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
    { of_num = (function Position _ -> true | _ -> false); of_prop = no }
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
  let rec look = function
    | Event e -> if not (List.exists (equal_event e) !found) then found := e :: !found
    | Not p -> look p
    | And ps | Or ps -> List.iter look ps
    | Compare (_, a, b) ->
      look_num a;
      look_num b
    | Bool _ | Bound _ | Same _ | Behaviour _ | Offers _ | Touching _ | Quiescent -> ()
  and look_num = function
    | Count ps -> List.iter look ps
    | If (p, a, b) ->
      look p;
      look_num a;
      look_num b
    | Neg a -> look_num a
    | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) ->
      look_num a;
      look_num b
    | Const _ | Bonds _ | Size _ | Processes | Position _ | Velocity _ | Speed2 _ | Distance2 _ | Momentum _
    | Energy | Time -> ()
  in
  let rec walk = function
    | State p -> look p
    | Temporal_not f | Next (_, f) | Finally (_, _, f) | Globally (_, _, f) -> walk f
    | Temporal_and fs | Temporal_or fs -> List.iter walk fs
    | Until (_, _, f, g) ->
      walk f;
      walk g
  in
  walk f;
  List.rev !found

open Scc_exact
open Scc_syntax
open Ast

let number e q = { e with it = Number q }

(* What the name of a loop variable is worth here, unless a quantifier or a [let] of the loop hides it. *)
let value env names (e : expr) =
  match e.it with
  | Path { it = [ { name; indices = [] } ]; _ } when List.exists (String.equal name.it) names -> (
      match Constant.value (Report.create ()) env e with
      | Some (Number q) -> Some q
      | _ -> None)
  | _ -> None

let mentions names e =
  Limits.exists_in
    (fun (e : expr) ->
       match e.it with
       | Path { it = { name; _ } :: _; _ } -> List.exists (String.equal name.it) names
       | _ -> false)
    e

let rec expr env names (e : expr) =
  match names with
  | [] -> e
  | _ :: _ -> written env names e

and written env names (e : expr) =
  let below = expr env names in
  let kind =
    match e.it with
    | Number _ | True | False | Co _ -> e.it
    | Path p -> (
        match value env names e with
        | Some q -> Number q
        | None -> Path { p with it = List.map (segment env names) p.it })
    | Apply (f, es) -> Apply (f, List.map below es)
    | Apply_in (m, f, es) -> Apply_in (m, f, List.map below es)
    | Component (e, axis) -> Component (below e, axis)
    | Vector (x, y, z) -> Vector (below x, below y, below z)
    | Neg a -> Neg (below a)
    | Not a -> Not (below a)
    | Binary (o, a, b) -> Binary (o, below a, below b)
    | If (c, a, b) -> If (below c, below a, below b)
    | Quantified (q, v, over, body) ->
      let inner = List.filter (fun n -> not (String.equal n v.it)) names in
      let over =
        match over with
        | Bodies e -> Bodies (below e)
        | Numbers r ->
          Numbers
            { low = below r.low; high = below r.high; filter = Option.map (expr env inner) r.filter }
      in
      Quantified (q, v, over, expr env inner body)
    | Temporal (t, b, a) -> Temporal (t, Option.map (bound env names) b, below a)
    | Until (q, f, b, g) -> Until (q, below f, Option.map (bound env names) b, below g)
    | Measured (m, test, o) -> Measured (m, Option.map (fun (o, e) -> (o, below e)) test, outcome env names o)
    | Leads_to (f, b, g) -> Leads_to (below f, Option.map (bound env names) b, below g)
    | Event (w, es) -> Event (w, List.map below es)
  in
  { e with it = kind }

and outcome env names = function
  | Does e -> Does (expr env names e)
  | Goes_until (f, b, g) -> Goes_until (expr env names f, Option.map (bound env names) b, expr env names g)
  | Has_at (e, t) -> Has_at (expr env names e, expr env names t)

and bound env names = function
  | Within t -> Within (expr env names t)
  | At_most t -> At_most (expr env names t)
  | Between (a, b) -> Between (expr env names a, expr env names b)

(* An index with a loop variable is worked out. *)
and segment env names s = { s with indices = List.map (index env names) s.indices }

and index env names e =
  let constant () =
    match Constant.value (Report.create ()) env e with
    | Some (Env.Number q) -> Some q
    | _ -> None
  in
  if mentions names e && Constant.is_constant env e then
    match constant () with
    | Some q when Rat.is_integer q -> number e q
    | _ -> expr env names e
  else expr env names e

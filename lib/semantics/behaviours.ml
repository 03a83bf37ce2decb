open Scc_exact
open Scc_calculus.Behaviour

type offer =
  | Offer_open of polarity * channel * t
  | Offer_weak of channel * t
  | Offer_strong of channel list * t

type derivation = { by_sum : bool; by_def : bool }

(* Rules Pre, Weak, Strong give the prefixes; Sum and Def look below; an exposed eps offers nothing (rule
   Eps0 is the canonical form: there is no eps(0)). Each offer comes with the summand that it is of. *)
let rec derive (defs : definitions) how found (b : t) =
  match b with
  | Nil | Delay _ -> found
  | Open (p, c, rest) -> (b, Offer_open (p, c, rest), how) :: found
  | Weak (c, rest) -> (b, Offer_weak (c, rest), how) :: found
  | Strong (l, rest) -> (b, Offer_strong (l, rest), how) :: found
  | Sum (x, y) ->
    let how = { how with by_sum = true } in
    derive defs how (derive defs how found x) y
  | Call k -> derive defs { how with by_def = true } found defs.(k).body

let derivations defs (b : aged) =
  let add kept ((summand, _, _) as derived) =
    if List.exists (fun (s, _, _) -> equal s summand) kept then kept else derived :: kept
  in
  derive defs { by_sum = false; by_def = false } [] b.term
  |> List.rev |> List.fold_left add []
  |> List.rev_map (fun (_, offer, how) -> (offer, how))

let offers defs b = List.map fst (derivations defs b)

(* {1 Rule TimeBehaviour} *)

let least a b =
  match (a, b) with
  | None, x | x, None -> x
  | Some s, Some t -> Some (Rat.min s t)

let rec term_horizon (defs : definitions) : t -> Rat.t option = function
  | Nil | Open _ | Weak _ | Strong _ -> None
  | Delay (t, _) -> Some t
  | Sum (a, b) -> least (term_horizon defs a) (term_horizon defs b)
  | Call k -> term_horizon defs defs.(k).body

let horizon defs (b : aged) = term_horizon defs b.term

(* Ageing can bring up nil and equal summands again and again, which offer nothing new: without them a
   recursion through sums comes back to where it was (reading I-17). *)
let without_repetition b =
  let rec summands found (b : t) =
    match b with
    | Sum (x, y) -> summands (summands found x) y
    | Nil -> found
    | Open _ | Weak _ | Strong _ | Delay _ | Call _ -> if List.exists (equal b) found then found else b :: found
  in
  match List.rev (summands [] b) with
  | [] -> nil
  | first :: rest -> List.fold_left sum first rest

(* A time up to the horizon: no exposed eps is passed, some may expire at its end. *)
let rec pass_term (defs : definitions) d (b : t) =
  match b with
  | Nil | Open _ | Weak _ | Strong _ -> b
  | Delay (t, rest) -> delay (Rat.sub t d) rest
  | Sum (x, y) ->
    let x' = pass_term defs d x and y' = pass_term defs d y in
    if x' == x && y' == y then b else sum x' y'
  | Call k -> (
      match term_horizon defs defs.(k).body with
      | None -> b
      | Some _ -> pass_term defs d defs.(k).body)

let pass_to_horizon defs d (b : aged) =
  let term = pass_term defs d b.term in
  if term == b.term then b else aged b.origin (without_repetition term)

(* By additivity, from horizon to horizon: so a name that an expiring eps brings up becomes the origin. *)
let rec pass defs d b =
  if Rat.sign d = 0 then b
  else
    match horizon defs b with
    | Some h when Rat.compare h d < 0 -> pass defs (Rat.sub d h) (pass_to_horizon defs h b)
    | Some _ -> pass_to_horizon defs d b
    | None -> b

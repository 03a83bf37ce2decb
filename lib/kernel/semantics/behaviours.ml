open Scc_exact
open Scc_calculus.Behaviour

type offer =
  | Offer_open of polarity * channel * t
  | Offer_weak of channel * loosening * t
  | Offer_strong of channel list * Rat.t * t

type derivation = { summand : t; within : int option list; by_sum : bool; by_def : bool }

(* Rules Pre, Weak, Strong give the prefixes; Sum and Def look below; an exposed eps offers nothing (rule
   Eps0 is the canonical form: there is no eps(0)). *)
let rec derive (defs : definitions) how found (b : t) =
  let offered offer = (offer, { how with summand = b }) :: found in
  match b with
  | Nil | Delay _ | Wait _ -> found
  | Open (p, c, rest) -> offered (Offer_open (p, c, rest))
  | Weak (c, push, rest) -> offered (Offer_weak (c, push, rest))
  | Strong (l, push, rest) -> offered (Offer_strong (l, push, rest))
  | Sum (x, y) ->
    let how = { how with by_sum = true } in
    derive defs how (derive defs how found x) y
  | Call k -> derive defs { how with within = [ Some k ]; by_def = true } found defs.(k).body

let by_chance = function
  | Offer_weak (_, { odds = Some _; _ }, _) -> true
  | Offer_weak _ | Offer_open _ | Offer_strong _ -> false

(* Equal summands are one, that may stand in several definitions; but what is left to chance counts as often as
   it is written (rule Lot). *)
let add ((offer, derived) as offered) found =
  let joined (other, kept) =
    if equal kept.summand derived.summand then Some (other, { kept with within = kept.within @ derived.within })
    else None
  in
  if by_chance offer then found @ [ offered ] else Scc_data.Lists.put joined offered found

let derivations defs (b : aged) =
  let whole = { summand = b.term; within = [ b.origin ]; by_sum = false; by_def = false } in
  List.fold_right add (derive defs whole [] b.term) []

let offers defs b = List.map fst (derivations defs b)

let rules how =
  let prefix =
    match how.summand with
    | Open _ -> [ Rule.Pre ]
    | Weak _ -> [ Rule.Weak ]
    | Strong _ -> [ Rule.Strong ]
    | Nil | Delay _ | Wait _ | Sum _ | Call _ -> []
  in
  prefix @ (if how.by_sum then [ Rule.Sum ] else []) @ if how.by_def then [ Rule.Def ] else []

(* {1 Rule TimeBehaviour} *)

let not_known () = Scc_base.Bug.fail __POS__ "the horizon of a delay that is not known"

(* Over the exposed eps of a term. *)
let rec fold_delays (defs : definitions) f found (b : t) =
  match b with
  | Nil | Open _ | Weak _ | Strong _ -> found
  | Delay _ | Wait _ -> f found b
  | Sum (x, y) -> fold_delays defs f (fold_delays defs f found x) y
  | Call k -> fold_delays defs f found defs.(k).body

let sooner horizon : t -> Rat.t option = function
  | Delay (t, _) -> Option.merge Rat.min horizon (Some t)
  | Nil | Open _ | Weak _ | Strong _ | Wait _ | Sum _ | Call _ -> not_known ()

let horizon defs (b : aged) = fold_delays defs sooner None b.term
let delays defs (b : aged) = List.rev (fold_delays defs (fun found delay -> delay :: found) [] b.term)
let ages defs b = fold_delays defs (fun _ _ -> true) false b

(* Whether it offers something by chance, or will when delays have expired. *)
let left_to_chance defs =
  some_prefix defs ~behind:is_delay (function
      | Weak (_, { odds = Some _; _ }, _) -> true
      | Weak _ | Nil | Open _ | Strong _ | Delay _ | Wait _ | Sum _ | Call _ -> false)

module Terms = Set.Make (struct
    type nonrec t = t

    let compare = compare
  end)

(* Ageing can bring up nil and equal summands again and again, which offer nothing new: without them a
   recursion through sums comes back to where it was (reading I-17). What still ages stays a summand, if need be
   of nil: so it makes no difference to origins when the others go (reading I-14). *)
let without_repetition defs b =
  let rec summands ((found, known) as all) (b : t) =
    match b with
    | Sum (x, y) -> summands (summands all x) y
    | Nil -> all
    | Open _ | Weak _ | Strong _ | Delay _ | Wait _ | Call _ ->
      if Terms.mem b known && not (left_to_chance defs b) then all else (b :: found, Terms.add b known)
  in
  match List.rev (fst (summands ([], Terms.empty) b)) with
  | [] -> nil
  | [ only ] -> if ages defs only then sum only nil else only
  | first :: rest -> List.fold_left sum first rest

(* A time up to the horizon: no exposed eps is passed, some may expire at its end. *)
let rec pass_term (defs : definitions) shortened (b : t) =
  match b with
  | Nil | Open _ | Weak _ | Strong _ -> b
  | Delay _ | Wait _ -> shortened b
  | Sum (x, y) ->
    let x' = pass_term defs shortened x and y' = pass_term defs shortened y in
    if x' == x && y' == y then b else sum x' y'
  | Call k -> if ages defs defs.(k).body then pass_term defs shortened defs.(k).body else b

(* A name that an expiring eps brings up is the new origin, unless it is a summand (reading I-14). *)
let shorten defs shortened (b : aged) =
  match pass_term defs shortened b.term with
  | term when term == b.term -> b
  | Sum _ as sum -> aged b.origin (without_repetition defs sum)
  | whole -> reached ~before:b.origin whole

let pass_to_horizon defs d =
  shorten defs (function
      | Delay (t, rest) -> delay (Rat.sub t d) rest
      | Nil | Open _ | Weak _ | Strong _ | Wait _ | Sum _ | Call _ -> not_known ())

(* By additivity, from horizon to horizon. *)
let rec pass defs d b =
  if Rat.sign d = 0 then b
  else
    match horizon defs b with
    | Some h when Rat.compare h d < 0 -> pass defs (Rat.sub d h) (pass_to_horizon defs h b)
    | Some _ -> pass_to_horizon defs d b
    | None -> b

open Scc_exact
open Scc_property
open Scc_symbolic

type t =
  | Now of Property.prop
  | Not of t
  | All of t list
  | Some_of of t list
  | Operator of operator

and operator = {
  quantifier : Property.path_quantifier;
  until : Chance_claims.question;
  negated : bool;
}

exception Not_asked of string

let state f =
  match Formula.state_formula f with
  | Some p -> p
  | None -> raise (Not_asked "over starts, operators of time do not stand within others")

let until bound claim goal : Chance_claims.question = { wanted = Chance; claim; goal; bound }

let rec question (f : Property.temporal) =
  match f with
  | State p -> Now p
  | Temporal_not f -> Not (question f)
  | Temporal_and all -> All (List.map question all)
  | Temporal_or all -> Some_of (List.map question all)
  | Finally (quantifier, bound, g) ->
    Operator { quantifier; until = until bound (Bool true) (state g); negated = false }
  | Until (quantifier, bound, f, g) ->
    Operator { quantifier; until = until bound (state f) (state g); negated = false }
  | Globally (quantifier, bound, f) ->
    Operator { quantifier; until = until bound (Bool true) (Formula.negate (state f)); negated = true }
  | Next _ -> raise (Not_asked "over starts, X has no probability")

let rec predicates = function
  | Now p -> [ p ]
  | Not q -> predicates q
  | All all | Some_of all -> List.concat_map predicates all
  | Operator { until; _ } -> [ until.claim; until.goal ]

let without_rest predicates =
  if List.exists Search_sets.asks_for_rest predicates then
    raise (Not_asked "over starts, `quiescent` is not known in an operator with a probability, or in a mean")

let of_formula f =
  let q = question f in
  without_rest (predicates q);
  q

let of_mean (mean : Property.mean) =
  let until ?(high = None) wanted goal : Chance_claims.question =
    { wanted; claim = Bool true; goal; bound = { low = Rat.zero; high } }
  in
  let q =
    match mean with
    | Time_until g -> until Time (state g)
    | Events_until (p, g) -> until (Happenings p) (state g)
    | Value_at (number, time) -> until ~high:(Some time) (Value_at (number, time)) (Bool false)
  in
  without_rest (Chance_claims.predicates q);
  q

let rec untils = function
  | Now _ -> []
  | Not q -> untils q
  | All all | Some_of all -> List.concat_map untils all
  | Operator { until; _ } -> [ until ]

let of_check (c : Property.check) =
  match c.asked with
  | Expected (_, mean, _) -> [ of_mean mean ]
  | Whether | How_likely _ -> untils (of_formula c.formula)

let untils_of c = match of_check c with all -> all | exception Not_asked _ -> []

open Scc_base
open Scc_exact
open Scc_calculus

type offer = { channel : Behaviour.channel; push : Rat.t; odds : Odds.t; next : Behaviour.t }

(* What a behaviour offers by chance. *)
let offers (definitions : Behaviour.definitions) b =
  let rec from seen found = function
    | [] -> List.rev found
    | b :: rest -> (
        match (b : Behaviour.t) with
        | Sum (x, y) -> from seen found (x :: y :: rest)
        | Call k when List.mem k seen -> from seen found rest
        | Call k -> from (k :: seen) found (definitions.(k).body :: rest)
        | Weak (channel, { push; odds = Some ((Chance _ | Open_chance _) as odds) }, next) ->
          from seen ({ channel; push; odds; next } :: found) rest
        | Weak (_, { odds = Some (Rate _) | None; _ }, _) | Nil | Open _ | Strong _ | Delay _ | Wait _ ->
          from seen found rest)
  in
  from [] [] [ b ]

let all_parts bodies =
  let rec from found = function
    | [] -> found
    | b :: rest -> from (b :: found) (List.rev_append (Behaviour.parts b) rest)
  in
  from [] bodies

let form (odds : Odds.t) =
  match odds with
  | Chance q -> Rational_function.constant q
  | Open_chance n -> n.form
  | Rate _ -> Bug.fail __POS__ "a rate that depends on a parameter"

let same_term a b =
  let term o = Behaviour.weak ~push:o.push o.channel o.next in
  Behaviour.compare (term a) (term b) = 0

let meeting range a b =
  let difference = Rational_function.sub (form a.odds) (form b.odds) in
  match Rational_function.to_constant difference with
  | Some _ -> None
  | None when not (same_term a b) -> None
  | None ->
    Option.map (fun x -> (Open_number.at range x, a.odds, b.odds)) (Open_number.vanishing range difference)

let find (m : Model.t) (declared : State.t) (range : Ranges.range) =
  let offers = offers m.definitions in
  let bodies = Array.to_list (Array.map (fun (d : Behaviour.definition) -> d.body) m.definitions) in
  let of_leaf (l : State.leaf) = l.behaviour.term in
  let of_process (p : State.process) = List.map of_leaf (Array.to_list p.leaves) in
  let states = List.concat_map of_process (Array.to_list declared.processes) in
  (* One of several is released first; what was drawn by another one may stay for what is offered then. *)
  let of_state b =
    let all = offers b in
    let after a first = if first == a then None else List.find_map (meeting range a) (offers first.next) in
    List.find_map (fun a -> List.find_map (after a) all) all
  in
  List.find_map of_state (all_parts (List.rev_append bodies states))

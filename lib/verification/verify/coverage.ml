open Scc_calculus
open Scc_semantics

type summand = { definition : int option; leaf : int; term : Behaviour.t; fired : int }
type behaviour = { definition : int; species : string; leaf : int; reached : bool }
type channel = { name : string; made : int; weak : int; strong : int }

(* What is counted; the order of the list is that of the text. *)
type counter = { owner : int option; first : int; node : Behaviour.t; mutable times : int }
type uses = { mutable mades : int; mutable weaks : int; mutable strongs : int }

module Seen = Hashtbl.Make (struct
    type t = string * Behaviour.aged

    let equal (s, a) (t, b) = String.equal s t && Behaviour.equal_aged a b
    let hash ((s : string), a) = (Hashtbl.hash s * 31) + Behaviour.hash_aged a
  end)

type t = {
  model : Model.t;
  counters : counter list;
  of_definition : counter list array;
  possible : (string * int * int) list;  (** species, definition, first leaf *)
  reached : (string * int, unit) Hashtbl.t;
  seen : unit Seen.t;  (** behaviours of species whose definitions are in [reached] *)
  uses : (string, uses) Hashtbl.t;
  rule_uses : (string, int) Hashtbl.t;
  mutable looked_at : int;
}

(** {2 What the text has} *)

(* The prefixes of a term, those behind prefixes included, and the definitions that it names. *)
let rec prefixes (nodes, calls) (b : Behaviour.t) =
  match b with
  | Nil -> (nodes, calls)
  | Open (_, _, rest) | Weak (_, _, rest) | Strong (_, _, rest) -> prefixes (b :: nodes, calls) rest
  | Delay (_, rest) | Wait (_, rest) -> prefixes (nodes, calls) rest
  | Sum (one, two) -> prefixes (prefixes (nodes, calls) one) two
  | Call k -> (nodes, k :: calls)

(* The nodes come last first. *)
let without_repetition nodes =
  List.fold_left
    (fun kept b -> if List.exists (Behaviour.equal b) kept then kept else b :: kept)
    [] (List.rev nodes)
  |> List.rev

let counters_of owner first nodes =
  List.map (fun node -> { owner; first; node; times = 0 }) (without_repetition nodes)

(* The definitions that a list of them may become. *)
let closure calls_of start =
  let seen = Hashtbl.create 8 in
  let rec visit = function
    | [] -> ()
    | k :: rest when Hashtbl.mem seen k -> visit rest
    | k :: rest ->
      Hashtbl.add seen k ();
      visit (List.rev_append calls_of.(k) rest)
  in
  visit start;
  Hashtbl.fold (fun k () all -> k :: all) seen [] |> List.sort Int.compare

(* The behaviours that leaves begin with, each once for each species, with the first leaf that has it. *)
let beginnings (m : Model.t) (initial : State.t) =
  let seen = Seen.create 8 in
  let add found (l : State.leaf) =
    let key = (m.leaves.(l.leaf).template, l.behaviour) in
    if Seen.mem seen key then found
    else begin
      Seen.add seen key ();
      (l.leaf, fst key, l.behaviour) :: found
    end
  in
  let leaves = State.leaves initial in
  List.sort (fun (a : State.leaf) (b : State.leaf) -> Int.compare a.leaf b.leaf) leaves
  |> List.fold_left add [] |> List.rev

let create (m : Model.t) ~initial =
  let parts = Array.map (fun (d : Behaviour.definition) -> prefixes ([], []) d.body) m.definitions in
  let calls_of = Array.map snd parts in
  let beginnings = beginnings m initial in
  let possible = Hashtbl.create 16 in
  let add_species (leaf, species, (b : Behaviour.aged)) =
    let _, calls = prefixes ([], []) b.term in
    let add k = if not (Hashtbl.mem possible (species, k)) then Hashtbl.add possible (species, k) leaf in
    List.iter add (closure calls_of calls)
  in
  List.iter add_species beginnings;
  let possible = Hashtbl.fold (fun (s, k) leaf all -> (s, k, leaf) :: all) possible [] in
  let in_order (s, k, _) (s', k', _) =
    Int.compare k k' <?> fun () -> String.compare s s'
  in
  let possible = List.sort in_order possible in
  let first_leaf k = List.find_map (fun (_, k', leaf) -> if k = k' then Some leaf else None) possible in
  let of_definition =
    Array.mapi
      (fun k (nodes, _) ->
         match first_leaf k with
         | None -> []
         | Some leaf -> counters_of (Some k) leaf nodes)
      parts
  in
  let written (leaf, _, (b : Behaviour.aged)) = counters_of None leaf (fst (prefixes ([], []) b.term)) in
  let counters = List.concat (Array.to_list of_definition) @ List.concat_map written beginnings in
  let uses = Hashtbl.create 8 in
  let add_name (c : Behaviour.channel) =
    if not (Hashtbl.mem uses c.name) then Hashtbl.add uses c.name { mades = 0; weaks = 0; strongs = 0 }
  in
  List.iter (fun c -> List.iter add_name (Behaviour.channels c.node)) counters;
  {
    model = m;
    counters;
    of_definition;
    possible;
    reached = Hashtbl.create 16;
    seen = Seen.create 64;
    uses;
    rule_uses = Hashtbl.create 16;
    looked_at = 0;
  }

(** {2 What comes to be} *)

(* The definitions that a behaviour is, or has among its summands. *)
let rec shown (defs : Behaviour.definitions) found (b : Behaviour.t) =
  match b with
  | Nil | Open _ | Weak _ | Strong _ | Delay _ | Wait _ -> found
  | Sum (one, two) -> shown defs (shown defs found one) two
  | Call k -> shown defs (k :: found) defs.(k).body

let leaf t (l : State.leaf) =
  let key = (t.model.leaves.(l.leaf).template, l.behaviour) in
  if not (Seen.mem t.seen key) then begin
    Seen.add t.seen key ();
    let names = shown t.model.definitions (Option.to_list l.behaviour.origin) l.behaviour.term in
    List.iter (fun k -> Hashtbl.replace t.reached (fst key, k) ()) names
  end

let state t (s : State.t) =
  Array.iter (fun (p : State.process) -> Array.iter (leaf t) p.leaves) s.processes

let count_rules t rules =
  let add r =
    let id = Rule.id r in
    Hashtbl.replace t.rule_uses id (1 + Option.value ~default:0 (Hashtbl.find_opt t.rule_uses id))
  in
  List.iter add rules

(* What follows a prefix does not tell which definition it stands in. *)
let counters_of_summand t (d : Behaviours.derivation) =
  let same c = Behaviour.equal c.node d.summand in
  let within = function
    | Some k -> List.filter same t.of_definition.(k)
    | None -> []
  in
  List.concat_map
    (fun k -> match within k with [] -> List.filter same t.counters | _ :: _ as own -> own)
    d.within

let note t name change = Option.iter change (Hashtbl.find_opt t.uses name)

(* A summand at both ends of a bond counts twice, one in two ways to do the same does not. *)
let fire t ways =
  let ways = List.map (List.concat_map (counters_of_summand t)) ways in
  let once = List.fold_left (fun kept c -> if List.memq c kept then kept else c :: kept) [] (List.concat ways) in
  let most c = List.fold_left (fun n way -> Int.max n (List.length (List.filter (( == ) c) way))) 0 ways in
  List.iter (fun c -> c.times <- c.times + most c) once

let note_all t releases one_more =
  List.iter (fun (r : Transition.release) -> note t r.bond.name one_more) releases

let transition t (tr : Transition.t) =
  fire t tr.fired;
  count_rules t tr.rules;
  match tr.label with
  | Time _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> ()
  | Bind b | Close b -> note t b.name (fun u -> u.mades <- u.mades + 1)
  | Weak_split releases -> note_all t releases (fun u -> u.weaks <- u.weaks + 1)
  | Strong_split releases -> note_all t releases (fun u -> u.strongs <- u.strongs + 1)

(* All at once, or not at all, if the time is over while it looks. *)
let expanded t semantics here =
  match Network.successors semantics here with
  | Ok transitions ->
    Scc_base.Critical.run (fun () ->
        List.iter (transition t) transitions;
        t.looked_at <- t.looked_at + 1)
  | Error (Persistent_contact _) -> t.looked_at <- t.looked_at + 1
  | Error (Bad_law _ | Bad_chance _) ->
    Scc_base.Bug.fail __POS__ "an expanded state has transitions, or is a dead end"

let explore ?time_seen (options : Setup.t) semantics ~initial =
  let t = create (Semantics.model semantics) ~initial in
  let visitor = { Explored.found = state t; expanded = expanded t semantics } in
  (Explored.explore ?time_seen ~visitor options semantics ~initial, t)

(** {2 The report} *)

let looked_at t = t.looked_at

let summands t =
  List.map (fun c -> { definition = c.owner; leaf = c.first; term = c.node; fired = c.times }) t.counters

let behaviours t =
  List.map
    (fun (species, definition, leaf) ->
       { definition; species; leaf; reached = Hashtbl.mem t.reached (species, definition) })
    t.possible

let channels t =
  Hashtbl.fold
    (fun name u all -> { name; made = u.mades; weak = u.weaks; strong = u.strongs } :: all)
    t.uses []
  |> List.sort (fun a b -> String.compare a.name b.name)

let rules t =
  (* a graph does not show where canonical form used Eps0, nor what was rounded *)
  Rule.of_model t.model
  |> List.filter (function Rule.Eps0 | Round -> false | _ -> true)
  |> List.map (fun r -> (r, Option.value ~default:0 (Hashtbl.find_opt t.rule_uses (Rule.id r))))

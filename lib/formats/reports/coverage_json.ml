open Scc_calculus
open Scc_verify
open Scc_json
open Scc_runs
open Json_format

let on (m : Model.t) definition species = Printf.sprintf "%s on %s" m.definitions.(definition).name species

let owner (m : Model.t) (s : Coverage.summand) =
  let leaf = m.leaves.(s.leaf) in
  match s.definition with
  | Some k -> on m k leaf.template
  | None -> leaf.name

let term m (s : Coverage.summand) = Behaviour_text.to_string m ~leaf:s.leaf s.term
let behaviour m (b : Coverage.behaviour) = on m b.definition b.species

let summand =
  let definition ((m : Model.t), (s : Coverage.summand)) =
    Option.map (fun k -> m.definitions.(k).name) s.definition
  in
  fields
    [
      field "behaviour" (nullable text) definition ~about:"null: written at the body.";
      field "body" text (fun ((m : Model.t), (s : Coverage.summand)) -> m.leaves.(s.leaf).name)
        ~about:"The first body that may come to it.";
      field "term" some_text (fun (m, s) -> term m s);
      field "fired" natural (fun (_, (s : Coverage.summand)) -> s.fired);
    ]

let reached =
  fields
    [
      field "behaviour" text (fun ((m : Model.t), (b : Coverage.behaviour)) -> m.definitions.(b.definition).name);
      field "species" text (fun (_, (b : Coverage.behaviour)) -> b.species) ~about:"The template.";
      field "body" text (fun ((m : Model.t), (b : Coverage.behaviour)) -> m.leaves.(b.leaf).name);
      field "reached" bool (fun (_, (b : Coverage.behaviour)) -> b.reached);
    ]

let channel =
  fields
    [
      field "name" text (fun (c : Coverage.channel) -> c.name);
      field "made" natural (fun (c : Coverage.channel) -> c.made);
      field "weak" natural (fun (c : Coverage.channel) -> c.weak);
      field "strong" natural (fun (c : Coverage.channel) -> c.strong);
    ]

let format =
  let in_model list (s, c) = List.map (fun x -> (Explored.model s, x)) (list c) in
  let rules (_, c) = List.map (fun (r, n) -> (Scc_semantics.Rule.id r, n)) (Coverage.rules c) in
  fields
    [
      field "states" Shared.from_one (fun ((s : Explored.t), _) -> s.size) ~about:"How many were found.";
      field "looked_at" natural (fun (_, c) -> Coverage.looked_at c)
        ~about:"Of how many of them the transitions were counted: of the others a bound left them unknown.";
      field "complete" bool (fun ((s : Explored.t), c) -> Coverage.looked_at c = s.size)
        ~about:"Of all: there are no others.";
      field "summands" (list summand) (in_model Coverage.summands)
        ~about:"The prefixes of behaviours, with the number of transitions that used each.";
      field "behaviours" (list reached) (in_model Coverage.behaviours)
        ~about:"Those that bodies of a template may come to, by their text.";
      field "channels" (list channel) (fun (_, c) -> Coverage.channels c)
        ~about:"How often bonds of the name were made, and released by weak and by strong splits.";
      field "rules" (entries natural) rules
        ~about:"How many transitions each rule of the rule book took part in.";
    ]

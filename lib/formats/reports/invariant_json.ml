open Scc_calculus
module Invariant = Scc_certificate.Invariant
open Scc_json
open Scc_runs
open Json_format

let leaf =
  let behaviour ((m : Model.t), (l : State.leaf)) = Behaviour_text.to_string m ~leaf:l.leaf l.behaviour.term in
  fields
    [
      field "leaf" some_text (fun ((m : Model.t), (l : State.leaf)) -> m.leaves.(l.leaf).name);
      field "behaviour" some_text behaviour;
    ]

let bond =
  fields [ field "name" some_text (fun (_, (b : State.bond)) -> b.name); field "sites" State_json.ends Fun.id ]

let process =
  let each m items = List.map (fun x -> (m, x)) (Array.to_list items) in
  fields
    [
      field "leaves" (list ~least:1 leaf) (fun (m, (p : State.process)) -> each m p.leaves)
        ~about:"Its bodies, with their behaviours as they were when they were set.";
      field "velocity" Shared.vector (fun (_, (p : State.process)) -> p.velocity);
      field "bonds" (list bond) (fun (m, (p : State.process)) -> each m p.bonds);
    ]

let kind =
  let event m events i = Scc_property.Show.event m events.(i) in
  fields
    [
      field "processes" (list process) (fun (m, _, (l : Invariant.location)) ->
          List.map (fun p -> (m, p)) (Array.to_list l.skeleton.processes));
      field "just_now" (list some_text) (fun (m, events, (l : Invariant.location)) ->
          List.map (event m events) l.arrived)
        ~about:"Events that properties ask for, and that have just happened.";
      field "constraints" Where_json.polyhedron_format (fun (m, _, (l : Invariant.location)) ->
          (Invariant.name m, l.set));
    ]

let format =
  let kinds (m, (end_ : Scc_verify.By_invariant.end_)) =
    match end_ with
    | Proved { invariant = i; _ } -> Some (List.map (fun l -> (m, i.Invariant.events, l)) i.locations)
    | None_found _ | Given_up _ -> None
  in
  let reason (_, (end_ : Scc_verify.By_invariant.end_)) =
    match end_ with None_found reason | Given_up reason -> Some reason | Proved _ -> None
  in
  union
    [
      case (fields [ field "kinds" (list kind) Fun.id ]) kinds Fun.id;
      case (fields [ field "reason" some_text Fun.id ]) reason Fun.id;
    ]
  |> about
    "A set of states that has the initial ones and that no run leaves: kinds of states, each with constraints \
     on its numbers. These are the parameters, and for a body p the place of its reference point, x(p), y(p) \
     and z(p), the time since its behaviour was set, age(p), and the split clock of the process whose first \
     body it is, clock(p). Or why none was found that proves anything."
  |> named ~file:Shared.file "invariant"

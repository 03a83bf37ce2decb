open Scc_polyhedra
open Scc_calculus
module Invariant = Scc_certificate.Invariant

let process (m : Model.t) (p : State.process) =
  let leaf (l : State.leaf) =
    `Assoc
      [
        ("leaf", Json.text m.leaves.(l.leaf).name);
        ("behaviour", Json.text (Behaviour_text.to_string m ~leaf:l.leaf l.behaviour.term));
      ]
  in
  let finish (f : State.finish) = Json.text (Model.site_name m ~leaf:f.at f.site) in
  let bond (b : State.bond) =
    `Assoc [ ("name", Json.text b.name); ("sites", `List [ finish b.one; finish b.two ]) ]
  in
  `Assoc
    [
      ("leaves", `List (List.map leaf (Array.to_list p.leaves)));
      ("velocity", Json.vec p.velocity);
      ("bonds", `List (List.map bond (Array.to_list p.bonds)));
    ]

let location (m : Model.t) events (l : Invariant.location) =
  let event i = Json.text (Scc_property.Show.event m events.(i)) in
  let constraint_ = Where_json.constraint_ ~name:(Invariant.name m) in
  `Assoc
    [
      ("processes", `List (List.map (process m) (Array.to_list l.skeleton.processes)));
      ("just_now", `List (List.map event l.arrived));
      ("constraints", `List (List.map constraint_ (Polyhedron.constraints l.set)));
    ]

let found m : Scc_verify.Zone_proof.end_ -> Json.t = function
  | None_found reason | Given_up reason -> `Assoc [ ("reason", Json.text reason) ]
  | Proved { invariant; _ } ->
    `Assoc [ ("kinds", `List (List.map (location m invariant.events) invariant.locations)) ]

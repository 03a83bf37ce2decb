open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_json
open Scc_runs

type t = { solids : Rows.t; behaviours : Rows.t; processes : Rows.t; labels : Rows.t }

let create () =
  { solids = Rows.create (); behaviours = Rows.create (); processes = Rows.create (); labels = Rows.create () }

let site (s : Site.t) =
  let kind, index =
    match s.feature with
    | Feature.Vertex i -> ("vertex", i)
    | Edge i -> ("edge", i)
    | Face i -> ("face", i)
  in
  `List [ `Int s.part; `String kind; `Int index ]

let open_channel : Behaviours.offer -> Json.t option = function
  | Offer_open (polarity, channel, _) ->
    Some
      (`Assoc
         [
           ("channel", Json.text channel.name);
           ("co", `Bool (polarity = Co_name));
           ("sites", `List (List.map site (channel.sites @ channel.only)));
         ])
  | Offer_weak _ | Offer_strong _ -> None

let behaviour t (m : Model.t) ~leaf (b : Behaviour.aged) =
  Rows.add t.behaviours
    (`Assoc
       [
         ("text", Json.text (State_json.behaviour m ~leaf b));
         ("origin", State_json.origin m b);
         ("open", `List (List.filter_map open_channel (Behaviours.offers m.definitions b)));
       ])

(* A spinning process goes on in the turn that has begun: what it is told by is how it was at the start of that
   turn (rule Turn). *)
let leaf t m (turn : Vec.t option) (p : State.process) (l : State.leaf) =
  let turned, arm =
    match turn with
    | None -> (l.turned, [])
    | Some centre ->
      let motion : Scc_rigid.Motion.t = Turn.motion m p ~centre l 0 in
      let offset = m.leaves.(l.leaf).parts.(0).offset in
      (* That of the leaf's reference point: a part's is moved by its offset, which turns too. *)
      (motion.turned, [ ("arm", Json.vec (Vec.sub motion.arm (Quaternion.apply motion.turned offset))) ])
  in
  `Assoc
    ([ ("leaf", `Int l.leaf); ("at", Json.vec l.position) ]
     @ (if Quaternion.is_identity turned then [] else [ ("turned", State_json.quaternion turned) ])
     @ [ ("behaviour", `Int (behaviour t m ~leaf:l.leaf l.behaviour)) ]
     @ arm)

let finish m (f : State.finish) =
  `Assoc
    [ ("leaf", `Int f.at); ("site", site f.site); ("text", Json.text (Model.site_name m ~leaf:f.at f.site)) ]

let bond m (b : State.bond) =
  `Assoc [ ("name", Json.text b.name); ("ends", `List [ finish m b.one; finish m b.two ]) ]

let list f array = `List (List.map f (Array.to_list array))

let process t semantics (p : State.process) =
  let m = Semantics.model semantics in
  let turn = if Turn.spinning p then Some (State.centre_of_mass m p) else None in
  let turning centre =
    ("turn", `Assoc [ ("centre", Json.vec centre); ("spin", Json.vec p.spin); ("since", Json.rat p.since) ])
  in
  Rows.add t.processes
    (`Assoc
       ([
         ("leaves", list (leaf t m turn p) p.leaves);
         ("bonds", list (bond m) p.bonds);
         ("velocity", Json.vec p.velocity);
         ("mass", Json.option Json.rat (State.mass m p));
       ]
         @ List.map turning (Option.to_list turn)))

let leaves_of (l : Transition.label) =
  match l with
  | Time _ -> []
  | Bounce { hits; firsts } ->
    List.sort_uniq Int.compare
      (firsts @ List.concat_map (fun (h : Transition.hit) -> [ fst h.one; fst h.two ]) hits)
  | Absorb { first; absorber } -> [ first; absorber ]
  | Draw { first; _ } -> [ first ]
  | Lot { bond = b; _ } -> List.sort_uniq Int.compare [ b.one.at; b.two.at ]
  | Bind _ | Close _ | Weak_split _ | Strong_split _ ->
    List.sort_uniq Int.compare
      (List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds l))

let label t ~words semantics (l : Transition.label) =
  let m = Semantics.model semantics in
  let duration = match l with Time d -> [ ("duration", Json.rat d) ] | _ -> [] in
  Rows.add t.labels
    (`Assoc
       ([
         ("kind", `String (State_json.kind l));
         ("text", Json.text (Transition.label_to_string m l));
         ("words", Json.text (words m l));
       ]
         @ duration
         @ [ ("leaves", `List (List.map (fun i -> `Int i) (leaves_of l))) ]))

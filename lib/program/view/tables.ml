open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_json
open Scc_runs
open Json_format

type t = { solids : Rows.t; behaviours : Rows.t; processes : Rows.t; labels : Rows.t }

let create () =
  { solids = Rows.create (); behaviours = Rows.create (); processes = Rows.create (); labels = Rows.create () }

let feature =
  let split (s : Site.t) =
    match s.feature with
    | Feature.Vertex i -> (s.part, "vertex", i)
    | Edge i -> (s.part, "edge", i)
    | Face i -> (s.part, "face", i)
  in
  from split (triple natural (word Fun.id [ "vertex"; "edge"; "face" ]) natural)
  |> checked
  |> Rows.named "feature"
    ~text:"A feature of a part of a leaf: the number of the part, what it is, and its number in the solid."

(* {1 Behaviours} *)

let behaviour_format =
  let channels ((m : Model.t), _, (b : Behaviour.aged)) =
    let opened : Behaviours.offer -> _ = function
      | Offer_open (polarity, channel, _) -> Some (polarity, channel)
      | Offer_weak _ | Offer_strong _ -> None
    in
    List.filter_map opened (Behaviours.offers m.definitions b)
  in
  let releases ((m : Model.t), _, (b : Behaviour.aged)) =
    let released : Behaviours.offer -> _ = function
      | Offer_open _ -> []
      | Offer_weak (channel, _, _) -> [ channel.name ]
      | Offer_strong (channels, _, _) -> List.map (fun (c : Behaviour.channel) -> c.name) channels
    in
    List.sort_uniq String.compare (List.concat_map released (Behaviours.offers m.definitions b))
  in
  let channel =
    fields
      [
        field "channel" some_text (fun (_, (c : Behaviour.channel)) -> c.name);
        field "co" bool (fun (polarity, _) -> polarity = Behaviour.Co_name) ~about:"It is a co-name.";
        field "sites" (list feature) (fun (_, (c : Behaviour.channel)) -> c.sites @ c.only);
      ]
  in
  fields
    [
      field "text" some_text (fun (m, leaf, b) -> State_json.behaviour m ~leaf b);
      field "origin" (nullable text) (fun (m, _, b) -> State_json.origin m b)
        ~about:"The name of the definition that it comes from.";
      field "open" (list channel) channels
        ~about:"The channels that are open now, with the features they are listed with.";
      field "releases" (list some_text) releases
        ~about:"The channels of its weak and strong splits, as they are now.";
    ]
  |> Rows.named "behaviour"

(* {1 Processes} *)

(* A leaf with the row of its behaviour, how it has turned, and the arm of a turn. *)
type placed = { leaf : State.leaf; row : int; turned : Quaternion.t; arm : Vec.t option }

let placed =
  fields
    [
      field "leaf" Rows.number (fun l -> l.leaf.leaf);
      field "at" Shared.vector (fun l -> l.leaf.position)
        ~about:"Its point of reference, in the world, when the process came.";
      maybe "turned" Shared.quaternion (fun l -> if Quaternion.is_identity l.turned then None else Some l.turned)
        ~about:
          "How it has turned since it was declared: then, or with a turn of the process at the start of that \
           turn. Left out: not at all.";
      field "behaviour" Rows.number (fun l -> l.row);
      maybe "arm" Shared.vector (fun l -> l.arm)
        ~about:"With a turn: from the centre to the point of reference, at the start of the turn.";
    ]
  |> Rows.named "placed"

let bond =
  let finish =
    fields
      [
        field "leaf" Rows.number (fun (_, (f : State.finish)) -> f.at);
        field "site" feature (fun (_, (f : State.finish)) -> f.site);
        field "text" some_text (fun (m, (f : State.finish)) -> Model.site_name m ~leaf:f.at f.site);
      ]
  in
  fields
    [
      field "name" some_text (fun (_, (b : State.bond)) -> b.name);
      field "ends" (list ~least:2 ~most:2 finish) (fun (m, (b : State.bond)) -> [ (m, b.one); (m, b.two) ]);
    ]

type row = { model : Model.t; process : State.process; leaves : placed list; centre : Vec.t option }

let process_format =
  let turn =
    fields
      [
        field "centre" Shared.vector (fun (_, _, centre) -> centre)
          ~about:"What it turns about, when the process came.";
        field "spin" Shared.vector (fun (_, (p : State.process), _) -> p.spin);
        field "since" Shared.rational (fun (_, (p : State.process), _) -> p.since)
          ~about:"How long ago the turn had begun then.";
        maybe "kept" Shared.vector
          (fun (m, (p : State.process), _) -> if Turn.is_free m then Some p.kept else None)
          ~about:"Of a free body: its angular momentum about the centre.";
      ]
  in
  fields
    [
      field "leaves" (list placed) (fun r -> r.leaves);
      field "bonds" (list bond) (fun r -> List.map (fun b -> (r.model, b)) (Array.to_list r.process.bonds));
      field "velocity" Shared.vector (fun r -> r.process.velocity) ~about:"Of the centre of mass.";
      field "mass" (nullable Shared.rational) (fun r -> State.mass r.model r.process);
      maybe "turn" turn (fun r -> Option.map (fun centre -> (r.model, r.process, centre)) r.centre)
        ~about:
          "Left out: it does not spin. With one, t after it came it has turned by the Cayley map C(u), u = spin \
           (since + t) / 2, from how it was at the start of the turn: a leaf is at centre + t velocity + C(u) arm \
           (rule Turn). Without one, at + t velocity.";
    ]
  |> Rows.named "process" ~text:"A process from the instant on at which it came to be as it is."

(* A spinning process goes on in the turn that has begun: what it is told by is how it was at the start of that
   turn (rule Turn). *)
let leaf t (m : Model.t) centre (p : State.process) (l : State.leaf) =
  let row = Rows.add t.behaviours behaviour_format (m, l.leaf, l.behaviour) in
  match centre with
  | None -> { leaf = l; row; turned = l.turned; arm = None }
  | Some centre ->
    let motion : Scc_rigid.Motion.t = Turn.motion m p ~centre l 0 in
    let offset = m.leaves.(l.leaf).parts.(0).offset in
    (* That of the leaf's reference point: a part's is moved by its offset, which turns too. *)
    let arm = Vec.sub motion.arm (Quaternion.apply motion.turned offset) in
    { leaf = l; row; turned = motion.turned; arm = Some arm }

let process t semantics (p : State.process) =
  let m = Semantics.model semantics in
  let centre = if Turn.spinning p then Some (State.centre_of_mass m p) else None in
  let leaves = List.map (leaf t m centre p) (Array.to_list p.leaves) in
  Rows.add t.processes process_format { model = m; process = p; leaves; centre }

(* {1 Labels} *)

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

let label_format =
  let duration (_, (l : Transition.label), _) = match l with Time d -> Some d | _ -> None in
  let kinds = [ "time"; "bind"; "close"; "bounce"; "absorb"; "weak"; "strong"; "draw"; "lot" ] in
  fields
    [
      field "kind" (word Fun.id kinds) (fun (_, l, _) -> State_json.kind l);
      field "text" some_text (fun (m, l, _) -> Transition.label_to_string m l);
      field "words" some_text (fun (_, _, words) -> words) ~about:"For a person.";
      maybe "duration" Shared.rational duration ~about:"Of a passing of time.";
      field "leaves" (list Rows.number) (fun (_, l, _) -> leaves_of l) ~about:"Who takes part.";
    ]
  |> Rows.named "label"

let label t ~words semantics l =
  let m = Semantics.model semantics in
  Rows.add t.labels label_format (m, l, words m l)

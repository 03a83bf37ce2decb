open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_json
open Json_format

let named name t = named ~file:Shared.file name t
let with_model m all = List.map (fun x -> (m, x)) all
let items m array = with_model m (Array.to_list array)

(* {1 Bonds} *)

let site =
  from (fun ((m : Model.t), (f : State.finish)) -> Model.site_name m ~leaf:f.at f.site) some_text
  |> about "A feature of a part of a leaf: q.left.top, p.[a,b]." |> named "site"

let ends =
  from (fun (m, (b : State.bond)) -> [ (m, b.one); (m, b.two) ]) (list ~least:2 ~most:2 site)
  |> checked |> named "ends"

let bond_fields = all [ field "name" some_text (fun (_, (b : State.bond)) -> b.name); field "ends" ends Fun.id ]
let bond_format = named "bond" (obj bond_fields)

let release_fields =
  let push (_, (r : Transition.release)) = if Rat.sign r.push = 0 then None else Some r.push in
  all
    [
      within (fun (m, (r : Transition.release)) -> (m, r.bond)) bond_fields;
      maybe "push" Shared.rational push ~about:"The impulse that drives the two apart, if it is not 0.";
    ]

let releases ~least = from (fun (m, all) -> with_model m all) (list ~least (named "release" (obj release_fields)))

(* {1 Labels} *)

let leaf_name = from (fun ((m : Model.t), leaf) -> m.leaves.(leaf).name) some_text
let part_name = from (fun ((m : Model.t), (leaf, index)) -> m.leaves.(leaf).parts.(index).name) some_text

let kind : Transition.label -> string = function
  | Time _ -> "time"
  | Bind _ -> "bind"
  | Close _ -> "close"
  | Bounce _ -> "bounce"
  | Absorb _ -> "absorb"
  | Weak_split _ -> "weak"
  | Strong_split _ -> "strong"
  | Draw _ -> "draw"
  | Lot _ -> "lot"

(* The members of one kind of labels: those of what [part] finds in the label. *)
let label_kind tag part members =
  let whole ((m, (l : Transition.label)) as x) = Option.map (fun found -> (x, (m, found))) (part l) in
  let label_text = field "text" some_text (fun ((m, l), _) -> Transition.label_to_string m l) in
  variant tag whole (all [ label_text; within snd members ]) Fun.id

let between part = field "between" (list ~least:2 leaf_name) part

let chance part = field "chance" Shared.rational part ~about:"Its probability, more than 0."

let bounce =
  let pair = list ~least:2 ~most:2 part_name in
  let touching (m, (_, hits)) = Some (List.map (fun (h : Transition.hit) -> [ (m, h.one); (m, h.two) ]) hits) in
  all
    [
      within (fun (m, (firsts, _)) -> with_model m firsts) (between Fun.id);
      maybe "touching" (list pair) touching ~about:"The pairs of bodies that touch, or of parts of them.";
    ]

let tie_chance part =
  let chance x =
    let label, chance = part x in
    if Transition.is_drawn label then None else chance
  in
  maybe "chance" Shared.rational chance
    ~about:"Its probability, where chance decides which of several urgent transitions comes first (rule Ties)."

let draw_members =
  all
    [
      field "process" leaf_name (fun (m, (first, _, _)) -> (m, first))
        ~about:"The first body of the process that draws.";
      field "velocity" Shared.vector (fun (_, (_, given, _)) -> given.Given.velocity) ~about:"What is drawn.";
      maybe "spin" Shared.vector (fun (_, (_, given, _)) -> given.Given.spin)
        ~about:"The spin that is drawn with it, if a law of the process gives spins.";
      chance (fun (_, (_, _, chance)) -> chance);
    ]

let lot ~drawn =
  let told = if drawn then [ Transition.Let_go; Kept; First ] else [ Chosen ] in
  let decision =
    field "decision" (word Transition.decision_to_string told) (fun (_, (_, decision, _)) -> decision)
      ~about:"Whether the bond is to be released, is not, is before others, or chooses its way (rule Lot)."
  in
  all
    ([ within (fun (m, (b, _, _)) -> (m, b)) bond_fields; decision ]
     @ if drawn then [ chance (fun (_, (_, _, chance)) -> chance) ] else [])

let label_format =
  let duration = field "duration" Shared.rational snd in
  let bonds ~least = field "bonds" (releases ~least) Fun.id in
  let drawn_lot drawn (l : Transition.label) =
    match l with
    | Lot { bond; decision; chance } when Bool.equal drawn (Transition.is_drawn l) -> Some (bond, decision, chance)
    | _ -> None
  in
  let choices =
    [
      label_kind "time" (function Transition.Time d -> Some d | _ -> None) duration;
      label_kind "bind" (function Transition.Bind b -> Some b | _ -> None) bond_fields;
      label_kind "close" (function Transition.Close b -> Some b | _ -> None) bond_fields;
      label_kind "bounce" (function Transition.Bounce b -> Some (b.firsts, b.hits) | _ -> None) bounce;
      label_kind "absorb"
        (function Transition.Absorb a -> Some [ a.first; a.absorber ] | _ -> None)
        (between (fun (m, leaves) -> with_model m leaves));
      label_kind "weak" (function Transition.Weak_split [ r ] -> Some r | _ -> None) release_fields;
      label_kind "weak" (function Transition.Weak_split all -> Some all | _ -> None) (bonds ~least:2);
      label_kind "strong" (function Transition.Strong_split all -> Some all | _ -> None) (bonds ~least:1);
      label_kind "draw"
        (function Transition.Draw d -> Some (d.first, d.given, d.chance) | _ -> None)
        draw_members;
      label_kind "lot" (drawn_lot true) (lot ~drawn:true);
      label_kind "lot" (drawn_lot false) (lot ~drawn:false);
    ]
  in
  tagged "kind" choices |> about "What a transition does." |> named "label"

(* {1 Leaves} *)

let behaviour m ~leaf (b : Behaviour.aged) = Behaviour_text.to_string m ~leaf b.term
let origin (m : Model.t) (b : Behaviour.aged) = Option.map (fun k -> m.definitions.(k).name) b.origin
let only_if holds value = if holds then Some (value ()) else None

let leaf =
  let part f (_, (l : State.leaf)) = f l in
  let in_rigid ((m : Model.t), (l : State.leaf)) = only_if (Option.is_some m.rigid) (fun () -> l.turned) in
  let of_each (m, (l : State.leaf)) = only_if (Model.of_each m) (fun () -> l.waited) in
  let term (m, (l : State.leaf)) = behaviour m ~leaf:l.leaf l.behaviour in
  fields
    [
      field "name" leaf_name (fun (m, (l : State.leaf)) -> (m, l.leaf));
      field "position" Shared.vector (part (fun l -> l.position))
        ~about:"Where the leaf's shape has its reference point, in the world.";
      maybe "turned" Shared.quaternion in_rigid
        ~about:"How the leaf has turned since it was declared; of rigid models alone.";
      maybe "waited" Shared.rational of_each
        ~about:"How long ago its law of motion was asked; of models with `timestep ... local` alone.";
      field "behaviour" some_text term ~about:"In the syntax of the language.";
      field "origin" (nullable text) (fun (m, (l : State.leaf)) -> origin m l.behaviour)
        ~about:"The definition whose ageing gave the behaviour, if any.";
    ]
  |> named "leaf"

(* {1 Processes} *)

let phase : State.phase -> string = function
  | Moving -> "moving"
  | Due -> "due"
  | Steered -> "steered"

let step =
  fields
    [
      field "remaining" Shared.rational fst; field "phase" (word phase [ Moving; Due; Steered ]) snd;
    ]
  |> named "step"

(* The step of a whole that has just been bound is over; what remains of it is told of the leaf that waited
   longest. *)
let own_step ((m : Model.t), (p : State.process)) =
  let waited = Array.fold_left (fun w (l : State.leaf) -> Rat.max w l.waited) Rat.zero p.leaves in
  only_if (Model.of_each m) (fun () -> Option.map (fun phase -> (Rat.sub m.timestep waited, phase)) p.phase)

let draw =
  let waits = word Fun.id [ "waits" ] in
  let motion = fields [ field "velocity" Shared.vector fst; field "spin" Shared.vector snd ] in
  let velocity : State.draw -> Vec.t option = function
    | Drawn { velocity; spin = None } -> Some velocity
    | Drawn { spin = Some _; _ } | Waits -> None
  in
  let with_spin : State.draw -> (Vec.t * Vec.t) option = function
    | Drawn { velocity; spin = Some spin } -> Some (velocity, spin)
    | Drawn { spin = None; _ } | Waits -> None
  in
  union
    [
      case waits (function State.Waits -> Some "waits" | Drawn _ -> None) ignore;
      case Shared.vector velocity ignore;
      case motion with_spin ignore;
    ]

let lots =
  let parts : State.lot -> string * (int * Behaviour.t) list = function
    | Undecided -> ("undecided", [])
    | Let_go drawn -> ("release", drawn)
    | Next drawn -> ("first", drawn)
  in
  let by =
    fields
      [
        field "leaf" leaf_name (fun (m, (leaf, _)) -> (m, leaf));
        field "summand" some_text (fun (m, (leaf, summand)) -> Behaviour_text.to_string m ~leaf summand)
          ~about:"In the syntax of the language.";
      ]
  in
  let pending =
    fields
      [
        within (fun (m, (b, _)) -> (m, b)) bond_fields;
        field "decided" (word Fun.id [ "undecided"; "release"; "first" ]) (fun (_, (_, lot)) -> fst (parts lot))
          ~about:"Whether the bond is still to draw, is to be released, or is to be so before all others.";
        field "by" (list ~most:2 by) (fun (m, (_, lot)) -> with_model m (snd (parts lot)))
          ~about:"By which summand an end lets go, of each end that has drawn or chosen; the others are free.";
      ]
  in
  fields
    [
      field "since" Shared.rational (fun (_, (lots : State.lots)) -> lots.since)
        ~about:
          "The time since the last split instant of the network, or since the start; the same for all processes.";
      field "pending" (list pending) (fun (m, (lots : State.lots)) -> with_model m lots.pending)
        ~about:"The bonds of which something is still to be drawn, or to be released, at this instant.";
    ]
  |> named "lots"

(* Members of rigid models, and of those that round velocities: there a turn, of length 0, may be due. *)
let turns =
  let rigid f ((m : Model.t), (p : State.process)) = only_if (Option.is_some m.rigid) (fun () -> f p) in
  let free ((m : Model.t), (p : State.process)) =
    only_if (Option.is_some m.rigid && Turn.is_free m) (fun () -> p.kept)
  in
  let lasts ((m : Model.t), (p : State.process)) =
    only_if (Option.is_some m.rigid || Model.has_turns m) (fun () -> p.lasts)
  in
  all
    [
      maybe "spin" Shared.vector (rigid (fun p -> p.spin)) ~about:"Of rigid models alone.";
      maybe "since" Shared.rational (rigid (fun p -> p.since))
        ~about:"How long ago the present turn began (rule Turn); of rigid models alone.";
      maybe "lasts" (nullable Shared.rational) lasts
        ~about:
          "How long the present turn lasts in all, 0 for what does not spin; null while a turn is due to \
           begin. Of rigid models, and of others with `round velocity`.";
      maybe "angular_momentum" Shared.vector free
        ~about:"About the centre of mass, as turns keep it; of models of free bodies alone.";
    ]

let process =
  let part f (_, (p : State.process)) = f p in
  let drawn ((m : Model.t), (p : State.process)) = only_if (Model.draws m) (fun () -> p.draw) in
  let of_chance ((m : Model.t), (p : State.process)) =
    if m.lots then Option.map (fun l -> (m, l)) p.lots else None
  in
  fields
    [
      field "velocity" Shared.vector (part (fun p -> p.velocity)) ~about:"Of the centre of mass.";
      turns;
      maybe "step" (nullable step) own_step
        ~about:
          "Where the process is in its own movement step, null if no law moves it; of models with `timestep ... \
           local` alone.";
      maybe "draw" (nullable draw) drawn
        ~about:
          "While somebody draws, of each process whose laws are asked: \"waits\" before it has drawn, and then \
           the velocity that it will have when all have, with its spin if a law gives one; else null. Of models \
           in which a law chooses alone.";
      maybe "lots" lots of_chance ~about:"Of models in which a split is left to chance alone (rule Lot).";
      field "clock" (nullable Shared.rational) (part (fun p -> p.clock))
        ~about:"Time since the split clock was set, modulo the split step; null when no weak split is enabled.";
      field "leaves" (list ~least:1 leaf) (fun (m, (p : State.process)) -> items m p.leaves);
      field "bonds" (list bond_format) (fun (m, (p : State.process)) -> items m p.bonds);
    ]
  |> named "process"

(* {1 States} *)

let state_format =
  let step_of (s : State.step) = (s.remaining, s.phase) in
  let gone (m, s) = only_if (Model.absorbs m) (fun () -> with_model m (State.gone m s)) in
  fields
    [
      field "processes" (list process) (fun (m, (s : State.t)) -> items m s.processes);
      field "step" (nullable step) (fun (_, (s : State.t)) -> Option.map step_of s.step)
        ~about:
          "Where the network is in its movement step; null when nothing is steered, or each process by itself.";
      maybe "gone" (list leaf_name) gone
        ~about:"Who has been absorbed; of models in which some body absorbs alone.";
    ]
  |> named "state"

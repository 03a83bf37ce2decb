open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_json

let site (m : Model.t) (f : State.finish) = Json.text (Model.site_name m ~leaf:f.at f.site)
let ends m (b : State.bond) = `List [ site m b.one; site m b.two ]
let bond m (b : State.bond) = [ ("name", Json.text b.name); ("ends", ends m b) ]

let release m ({ bond = b; push } : Transition.release) =
  bond m b @ if Rat.sign push = 0 then [] else [ ("push", Json.rat push) ]
let leaf_name (m : Model.t) leaf = Json.text m.leaves.(leaf).name

let part (m : Model.t) (leaf, index) = Json.text m.leaves.(leaf).parts.(index).name

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

let label m (l : Transition.label) =
  let parts =
    match l with
    | Time d -> [ ("duration", Json.rat d) ]
    | Bind b | Close b -> bond m b
    | Weak_split [ r ] -> release m r
    | Bounce { firsts; hits } ->
      [
        ("between", `List (List.map (leaf_name m) firsts));
        ("touching", `List (List.map (fun (h : Transition.hit) -> `List [ part m h.one; part m h.two ]) hits));
      ]
    | Absorb { first; absorber } -> [ ("between", `List [ leaf_name m first; leaf_name m absorber ]) ]
    | Weak_split releases | Strong_split releases ->
      [ ("bonds", `List (List.map (fun r -> `Assoc (release m r)) releases)) ]
    | Draw { first; velocity; chance } ->
      [ ("process", leaf_name m first); ("velocity", Json.vec velocity); ("chance", Json.rat chance) ]
    | Lot { bond = b; decision; chance } ->
      let chance = if Transition.is_drawn l then [ ("chance", Json.rat chance) ] else [] in
      bond m b @ (("decision", `String (Transition.decision_to_string decision)) :: chance)
  in
  `Assoc
    (("kind", `String (kind l)) :: ("text", Json.text (Transition.label_to_string m l)) :: parts)

let behaviour m ~leaf (b : Behaviour.aged) = Behaviour_text.to_string m ~leaf b.term

let origin (m : Model.t) (b : Behaviour.aged) =
  Json.option (fun k -> Json.text m.definitions.(k).name) b.origin

(* What is told of rigid models alone. *)
let rigid (m : Model.t) members = if Option.is_some m.rigid then members () else []

(* Of translational models that round velocities: whether a turn, of length 0, is due. *)
let straight_turns (m : Model.t) members =
  if Model.has_turns m && Option.is_none m.rigid then members () else []

(* And of those whose processes have movement steps of their own. *)
let of_each m members = if Model.of_each m then members () else []

let phase : State.phase -> string = function
  | Moving -> "moving"
  | Due -> "due"
  | Steered -> "steered"

let quaternion (q : Quaternion.t) =
  `List (List.map (fun z -> `String (Z.to_string z)) [ q.w; q.x; q.y; q.z ])

let leaf m (l : State.leaf) =
  `Assoc
    ([ ("name", leaf_name m l.leaf); ("position", Json.vec l.position) ]
     @ rigid m (fun () -> [ ("turned", quaternion l.turned) ])
     @ of_each m (fun () -> [ ("waited", Json.rat l.waited) ])
     @ [
       ("behaviour", Json.text (behaviour m ~leaf:l.leaf l.behaviour));
       ("origin", origin m l.behaviour);
     ])

let list encode array = `List (List.map encode (Array.to_list array))

(* The step of a whole that has just been bound is over; what remains of it is told of the leaf that waited
   longest. *)
let own_step (m : Model.t) (p : State.process) =
  let waited = Array.fold_left (fun w (l : State.leaf) -> Rat.max w l.waited) Rat.zero p.leaves in
  let step p =
    `Assoc [ ("remaining", Json.rat (Rat.sub m.timestep waited)); ("phase", `String (phase p)) ]
  in
  Json.option step p.phase

(* Of models in which velocities are drawn. *)
let draw (m : Model.t) (p : State.process) =
  if not (Model.draws m) then []
  else
    let told : State.draw -> Json.t = function
      | Waits -> `String "waits"
      | Drawn velocity -> Json.vec velocity
    in
    [ ("draw", Json.option told p.draw) ]

(* Of models in which splits are left to chance. *)
let lots (m : Model.t) (p : State.process) =
  let told (b, (lot : State.lot)) =
    let decided, drawn =
      match lot with
      | Undecided -> ("undecided", [])
      | Let_go drawn -> ("release", drawn)
      | Next drawn -> ("first", drawn)
    in
    let by (leaf, summand) =
      `Assoc
        [
          ("leaf", leaf_name m leaf);
          ("summand", Json.text (Behaviour_text.to_string m ~leaf summand));
        ]
    in
    `Assoc (bond m b @ [ ("decided", `String decided); ("by", `List (List.map by drawn)) ])
  in
  let of_process (lots : State.lots) =
    `Assoc [ ("since", Json.rat lots.since); ("pending", `List (List.map told lots.pending)) ]
  in
  match p.lots with
  | Some lots when m.lots -> [ ("lots", of_process lots) ]
  | Some _ | None -> []

let process m (p : State.process) =
  `Assoc
    ((("velocity", Json.vec p.velocity)
      :: rigid m (fun () ->
          [
            ("spin", Json.vec p.spin);
            ("since", Json.rat p.since);
            ("lasts", Json.option Json.rat p.lasts);
          ]
          @ if Turn.is_free m then [ ("angular_momentum", Json.vec p.kept) ] else []))
     @ straight_turns m (fun () -> [ ("lasts", Json.option Json.rat p.lasts) ])
     @ of_each m (fun () -> [ ("step", own_step m p) ])
     @ draw m p
     @ lots m p
     @ [
       ("clock", Json.option Json.rat p.clock);
       ("leaves", list (leaf m) p.leaves);
       ("bonds", list (fun b -> `Assoc (bond m b)) p.bonds);
     ])

let step (s : State.step) =
  `Assoc [ ("remaining", Json.rat s.remaining); ("phase", `String (phase s.phase)) ]

(* Of models in which bodies may be absorbed. *)
let gone (m : Model.t) s =
  if Model.absorbs m then [ ("gone", `List (List.map (leaf_name m) (State.gone m s))) ] else []

let state m (s : State.t) =
  `Assoc
    ([ ("processes", list (process m) s.processes); ("step", Json.option step s.step) ] @ gone m s)

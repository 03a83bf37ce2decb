open Scc_exact
open Scc_calculus
open Scc_semantics

let standard = Scc_engine.Standard.of_model

type sums = { momentum : Vec.t; angular : Vec.t; energy : Rat.t }

let nothing = { momentum = Vec.zero; angular = Vec.zero; energy = Rat.zero }

let add a b =
  {
    momentum = Vec.add a.momentum b.momentum;
    angular = Vec.add a.angular b.angular;
    energy = Rat.add a.energy b.energy;
  }

(* Of a part that moves with its process, which turns about [centre]. *)
let of_part (m : Model.t) (p : State.process) centre (l : State.leaf) i =
  let part = m.leaves.(l.leaf).parts.(i) in
  let solid = part.solid in
  let turned = Quaternion.to_mat l.turned in
  let at = Vec.add (State.part_position m l i) (Mat.apply turned solid.centroid) in
  let v = Vec.add p.velocity (Vec.cross p.spin (Vec.sub at centre)) in
  let inertia = Mat.mul turned (Mat.mul solid.inertia (Mat.transpose turned)) in
  let own = Vec.scale (Rat.div part.mass solid.volume) (Mat.apply inertia p.spin) in
  let momentum = Vec.scale part.mass v in
  {
    momentum;
    angular = Vec.add own (Vec.cross at momentum);
    energy = Rat.add (Vec.dot v momentum) (Vec.dot p.spin own);
  }

let of_process (m : Model.t) (p : State.process) =
  if Option.is_none (State.mass m p) then nothing
  else
    let centre = State.centre_of_mass m p in
    let of_leaf sums (l : State.leaf) =
      let parts = List.init (Array.length m.leaves.(l.leaf).parts) Fun.id in
      List.fold_left (fun sums i -> add sums (of_part m p centre l i)) sums parts
    in
    Array.fold_left of_leaf nothing p.leaves

let sums m (s : State.t) = Array.fold_left (fun sums p -> add sums (of_process m p)) nothing s.processes

(* Leaves of all the processes that take part. *)
let involved (label : Transition.label) =
  match label with
  | Bounce { firsts; _ } -> firsts
  | Absorb { first; _ } | Draw { first; _ } -> [ first ]
  | Lot { bond; _ } -> [ bond.one.at; bond.two.at ]
  | Time _ | Bind _ | Close _ | Weak_split _ | Strong_split _ ->
    List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds label)

(* By a split (reading I-36). *)
let pushes (label : Transition.label) =
  let by (r : Transition.release) = Rat.sign r.push > 0 in
  match label with
  | Weak_split releases | Strong_split releases -> List.exists by releases
  | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> false

(* Whether a push surely moves pieces apart: not where all that it drives apart goes on as one, nor where the
   pushes on a piece may cancel each other, which takes a ring. *)
let drives_apart (m : Model.t) (t : Transition.t) =
  let home at = (Option.get (State.home t.target at)).leaves.(0).leaf in
  let apart (b : State.bond) = home b.one.at <> home b.two.at in
  let pushing (r : Transition.release) = Rat.sign r.push > 0 && apart r.bond in
  match t.label with
  | Weak_split releases | Strong_split releases -> (
      match List.filter pushing releases with
      | [] -> false
      | [ _ ] -> true
      | _ -> not (Model.closes_rings m))
  | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> false

let is_fixed m s leaf =
  Option.is_none (State.mass m (Option.get (State.home s leaf)))

(* Free bodies keep their momentum from turn to turn: what they have now is what they begin a new turn with. *)
let renewed m s =
  let semantics = standard m in
  let (module K) = semantics.kinematics in
  let processes = List.map (K.renewed semantics.setting) (Array.to_list s.State.processes) in
  State.make ~processes ~step:s.step ~time:s.time

let fault m s (t : Transition.t) =
  let before = sums m (renewed m s) and after = sums m (renewed m t.target) in
  let free = not (List.exists (is_fixed m s) (involved t.label)) in
  let broken what = Some (Printf.sprintf "%s changes %s" (Transition.label_to_string m t.label) what) in
  let rigid = Option.is_some m.Model.rigid in
  let energy = Rat.compare after.energy before.energy in
  match t.label with
  | Time _ | Draw _ -> None
  | Lot _ when List.memq Rule.Steer t.rules || List.memq Rule.Round t.rules -> None
  | Lot _ -> if Vec.equal before.momentum after.momentum && energy = 0 then None else broken "momentum or energy"
  | (Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _)
    when List.memq Rule.Steer t.rules || List.memq Rule.Round t.rules -> None
  | Absorb { first; _ } ->
    let taken = of_process m (Option.get (State.home (renewed m s) first)) in
    let whole = add after taken in
    if
      Vec.equal before.momentum whole.momentum
      && Vec.equal before.angular whole.angular
      && Rat.equal before.energy whole.energy
    then None
    else broken "what others have"
  | (Bind _ | Close _ | Bounce _ | Weak_split _ | Strong_split _)
    when free && not (Vec.equal before.momentum after.momentum) -> broken "momentum"
  | (Bind _ | Close _ | Bounce _ | Weak_split _ | Strong_split _)
    when free && rigid && not (Vec.equal before.angular after.angular) -> broken "angular momentum"
  | Bind _ -> if energy > 0 then broken "energy (it grows)" else None
  | Weak_split _ | Strong_split _ when pushes t.label ->
    if energy < 0 || (free && energy = 0 && drives_apart m t) then broken "energy (it does not grow)" else None
  | Close _ | Bounce _ | Weak_split _ | Strong_split _ -> if energy = 0 then None else broken "energy"

open Scc_calculus

let may_close (m : Model.t) (p : State.process) = Array.length p.leaves >= 3 && Model.closes_rings m
let joins i j (b : State.bond) = (b.one.at = i && b.two.at = j) || (b.one.at = j && b.two.at = i)
let free (p : State.process) i j = i <> j && not (Array.exists (joins i j) p.bonds)

(* All two parts of two leaves that no bond joins yet, and that are near enough to touch. *)
let pairs (c : Semantics.t) (p : State.process) =
  let (module K) = c.kinematics in
  let of_leaf (part : Part.t) = { part with process = part.leaf.leaf } in
  Array.of_list (List.map of_leaf (K.parts c.setting 0 p))
  |> c.setting.neighbours.within (K.margin c.setting)
  |> List.filter (fun ((a : Part.t), (b : Part.t)) -> free p a.leaf.leaf b.leaf.leaf)

let closed (c : Semantics.t) p ({ bond; continuations; fired } : Collisions.candidate) =
  let whole = State.map_leaves (Process.continue continuations) (State.with_bond bond p) in
  {
    Transition.rule = Rule.Close;
    label = Close bond;
    fired;
    gone = [ p ];
    come = [ Process.restart_clock c.setting.model whole ];
  }

let all (c : Semantics.t) (p : State.process) =
  if may_close c.setting.model p then List.concat_map (Collisions.bonds c) (pairs c p) |> List.map (closed c p)
  else []

open Scc_exact
open Scc_calculus
open Scc_semantics

let sum zero add f m (s : State.t) =
  let count total (p : State.process) =
    match State.mass m p with None -> total | Some mass -> add total (f mass p.velocity)
  in
  Array.fold_left count zero s.processes

let momentum m s = sum Vec.zero Vec.add Vec.scale m s
let energy m s = sum Rat.zero Rat.add (fun mass v -> Rat.mul mass (Vec.norm2 v)) m s

(* Leaves of all the processes that take part. *)
let involved : Transition.label -> int list = function
  | Time _ -> []
  | Bind b | Weak_split b -> [ b.one.at; b.two.at ]
  | Bounce (p, q) -> [ p; q ]
  | Strong_split bonds -> List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) bonds

let is_fixed m s leaf =
  let i, _ = State.find_leaf s leaf in
  Option.is_none (State.mass m s.State.processes.(i))

let fault m s (t : Transition.t) =
  let before = energy m s and after = energy m t.target in
  let keeps_momentum = Vec.equal (momentum m s) (momentum m t.target) in
  let free = not (List.exists (is_fixed m s) (involved t.label)) in
  let broken what = Some (Printf.sprintf "%s changes %s" (Transition.label_to_string m t.label) what) in
  match t.label with
  | Time _ -> None
  | (Bind _ | Bounce _ | Weak_split _ | Strong_split _) when List.memq Rule.Steer t.rules -> None
  | (Bind _ | Bounce _ | Weak_split _ | Strong_split _) when free && not keeps_momentum -> broken "momentum"
  | Bind _ -> if Rat.compare after before > 0 then broken "energy (it grows)" else None
  | Bounce _ | Weak_split _ | Strong_split _ ->
    if Rat.equal before after then None else broken "energy"

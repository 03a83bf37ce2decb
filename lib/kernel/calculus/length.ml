open Scc_exact

type quantity = Position | Velocity | Spin | Orientation | Angular_momentum | Clock

let name = function
  | Position -> "position"
  | Velocity -> "velocity"
  | Spin -> "spin"
  | Orientation -> "orientation"
  | Angular_momentum -> "angular momentum"
  | Clock -> "time"

let of_leaves f (p : State.process) = Array.fold_left (fun most l -> Int.max most (f l)) 0 p.leaves

let of_process (p : State.process) =
  let clocks = Option.to_list p.clock @ Option.to_list p.lasts @ [ p.since ] in
  let waited (l : State.leaf) = Rat.bits l.waited in
  [
    (Position, of_leaves (fun l -> Vec.bits l.position) p);
    (Velocity, Vec.bits p.velocity);
    (Spin, Vec.bits p.spin);
    (Orientation, of_leaves (fun l -> Quaternion.bits l.turned) p);
    (Angular_momentum, Vec.bits p.kept);
    (Clock, List.fold_left (fun most r -> Int.max most (Rat.bits r)) (of_leaves waited p) clocks);
  ]

type longest = { quantity : quantity; leaf : int option; bits : int }

let longest (s : State.t) =
  let add leaf best (quantity, bits) = if bits > best.bits then { quantity; leaf; bits } else best in
  let of_time = Option.fold ~none:0 ~some:Rat.bits s.time in
  let of_step = Option.fold ~none:0 ~some:(fun (step : State.step) -> Rat.bits step.remaining) s.step in
  let network = { quantity = Clock; leaf = None; bits = Int.max of_time of_step } in
  Array.fold_left
    (fun best (p : State.process) -> List.fold_left (add (Some p.leaves.(0).leaf)) best (of_process p))
    network s.processes

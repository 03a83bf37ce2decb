open Scc_ctl
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics

let between low high t =
  let after = function None -> true | Some l -> Rat.compare l t <= 0 in
  let before = function None -> true | Some h -> Rat.compare t h <= 0 in
  after low && before high

let parts extent obstacle offset velocity =
  match (extent : Timeline.extent) with
  | Instant ->
    let touch =
      match Obstacle.relation obstacle offset with
      | Apart -> false
      | Touching | Interpenetrating -> true
    in
    Timeline.constant extent touch
  | Lasts _ | Forever -> (
      match Obstacle.meeting obstacle offset velocity with
      | None -> Timeline.constant extent false
      | Some (low, high) ->
        let cuts = Option.to_list low @ Option.to_list high in
        Timeline.of_cuts extent cuts Bool.equal (between low high))

let indices (m : Model.t) leaf = List.init (Array.length m.leaves.(leaf).parts) Fun.id

let straight m i j extent (p : State.process) (q : State.process) =
  let one = State.leaf_of p i and two = State.leaf_of q j in
  let velocity = Vec.sub q.velocity p.velocity in
  let pair (a, b) =
    let offset = Vec.sub (State.part_position m two b) (State.part_position m one a) in
    parts extent (Model.obstacle m (i, a) (j, b)) offset velocity
  in
  let pairs = List.concat_map (fun a -> List.map (fun b -> (a, b)) (indices m j)) (indices m i) in
  List.fold_left
    (fun found parts -> Timeline.map2 ( || ) found (pair parts))
    (Timeline.constant extent false) pairs
  |> Timeline.map Truth.of_bool

let along i j extent p q =
  let m = Path.model p in
  match m.rigid with
  | None -> straight m i j extent (Path.process p) (Path.process q)
  | Some { resolution; _ } -> Near.touching ~resolution extent (p, i) (q, j)

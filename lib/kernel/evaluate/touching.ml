open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion

let between low high t =
  let after = function None -> true | Some l -> Rat.compare l t <= 0 in
  let before = function None -> true | Some h -> Rat.compare t h <= 0 in
  after low && before high

let parts (semantics : Semantics.t) extent a b velocity =
  let geometry = semantics.setting.geometry in
  match (extent : Timeline.extent) with
  | Instant ->
    let touch =
      match (geometry.relation a b : Scc_geometry.Obstacle.relation) with
      | Apart -> false
      | Touching | Interpenetrating -> true
    in
    Timeline.constant extent touch
  | Lasts _ | Forever -> (
      match geometry.meeting a b velocity with
      | None -> Timeline.constant extent false
      | Some (low, high) ->
        let cuts = Option.to_list low @ Option.to_list high in
        Timeline.of_cuts extent cuts Bool.equal (between low high))

let placed (m : Model.t) (leaf : State.leaf) =
  List.init (Array.length m.leaves.(leaf.leaf).parts) (State.placed m leaf)

let straight semantics i j extent (p : State.process) (q : State.process) =
  let m = Semantics.model semantics in
  let ones = placed m (State.leaf_of p i) and twos = placed m (State.leaf_of q j) in
  let velocity = Vec.sub q.velocity p.velocity in
  let pairs = Scc_data.Lists.product ones twos in
  List.fold_left
    (fun found (a, b) -> Timeline.map2 ( || ) found (parts semantics extent a b velocity))
    (Timeline.constant extent false) pairs
  |> Timeline.map Truth.of_bool

let along semantics i j extent p q =
  match Model.resolution (Semantics.model semantics) with
  | None -> straight semantics i j extent (Path.process p) (Path.process q)
  | Some resolution -> Near.touching ~resolution extent (p, i) (q, j)

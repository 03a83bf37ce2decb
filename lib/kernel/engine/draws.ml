open Scc_exact
open Scc_calculus
open Scc_semantics

type t = {
  undrawn : State.t;  (** before anybody has drawn *)
  drawn : Given.t option array;  (** by first leaf, of those who have drawn *)
  mutable left : State.process list;  (** the others, in order *)
  mutable chances : (Given.t * Rat.t) array option;  (** of the first of them, once they have been asked for *)
}

let waiting (c : Semantics.t) undrawn =
  match Steer.drawers c undrawn with
  | [] -> None
  | _ :: _ as left ->
    Some { undrawn; drawn = Array.make (Array.length (Semantics.model c).leaves) None; left; chances = None }

let drawer d =
  match d.left with
  | p :: _ -> p
  | [] -> Scc_base.Bug.fail __POS__ "nobody is left to draw"

let chances c d =
  match d.chances with
  | Some chances -> Ok chances
  | None ->
    let* chances = Steer.chances c d.undrawn (drawer d) in
    let chances = Array.of_list chances in
    d.chances <- Some chances;
    Ok chances

let draw d given =
  d.drawn.((drawer d).leaves.(0).leaf) <- Some given;
  d.left <- List.tl d.left;
  d.chances <- None;
  d.left = []

let find d first =
  let all = d.undrawn.processes in
  let rec within low high =
    if low >= high then None
    else
      let middle = (low + high) / 2 in
      let there = all.(middle).leaves.(0).leaf in
      if there = first then Some all.(middle)
      else if there < first then within (middle + 1) high
      else within low middle
  in
  within 0 (Array.length all)

let before d (p : State.process) = d.drawn.(p.leaves.(0).leaf)
let state d = Steer.drawn (before d) d.undrawn

let drawn d processes =
  let waiting (p : State.process) = Option.value (find d p.leaves.(0).leaf) ~default:p in
  let { State.step; time; _ } = d.undrawn in
  Steer.drawn (before d) (State.make ~processes:(List.map waiting processes) ~step ~time)

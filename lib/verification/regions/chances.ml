open Scc_exact
open Scc_polyhedra
open Scc_calculus

type part = { value : Piecewise.value; set : Union.t }
type t = { ranges : Ranges.t; parts : part list }

let compare_values (a : Piecewise.value) (b : Piecewise.value) =
  Rat.compare a.least b.least <?> fun () -> Rat.compare a.most b.most

let make ranges pieces =
  let by_value = List.stable_sort (fun (_, a) (_, b) -> compare_values a b) pieces in
  let add parts (p, value) =
    match parts with
    | (other, sets) :: rest when compare_values other value = 0 -> (other, p :: sets) :: rest
    | _ -> (value, [ p ]) :: parts
  in
  let n = Array.length ranges in
  let part (value, sets) = { value; set = Where.tidy (Union.of_polyhedra n (List.rev sets)) } in
  { ranges; parts = List.rev_map part (List.fold_left add [] by_value) }

let extremes t : Piecewise.value =
  match t.parts with
  | [] -> Scc_base.Bug.fail __POS__ "a function on an empty box"
  | { value; _ } :: rest ->
    let widen (a : Piecewise.value) { value = b; _ } : Piecewise.value =
      { least = Rat.min a.least b.least; most = Rat.max a.most b.most }
    in
    List.fold_left widen value rest

let volume (ranges : Ranges.t) =
  let width (r : Ranges.range) = Rat.sub r.high.value r.low.value in
  Array.fold_left (fun product r -> Rat.mul product (width r)) Rat.one ranges

let mean t =
  let whole = volume t.ranges in
  let add sum { value; set } =
    match (sum, Where.measure set) with
    | Some (sum : Piecewise.value), Some volume ->
      let share = Rat.div volume whole in
      let plus x y = Rat.add x (Rat.mul share y) in
      Some { Piecewise.least = plus sum.least value.Piecewise.least; most = plus sum.most value.most }
    | None, _ | _, None -> None
  in
  List.fold_left add (Some { Piecewise.least = Rat.zero; most = Rat.zero }) t.parts

let equal a b =
  let same p q =
    compare_values p.value q.value = 0 && List.equal Polyhedron.equal (Union.pieces p.set) (Union.pieces q.set)
  in
  List.equal same a.parts b.parts

open Scc_exact
open Scc_polyhedra
open Scc_calculus

type value = { least : Linear.t option; most : Linear.t option }
type part = { value : value; set : Union.t }
type t = { ranges : Ranges.t; parts : part list; unknown : Union.t }
type ends = { low : Rat.t option; high : Rat.t option }

let known ranges (v : Piecewise.value) =
  let end_ x = Some (Linear.constant (Array.length ranges) x) in
  { least = end_ v.least; most = end_ v.most }

let compare_ends = Option.compare Linear.compare
let compare_values a b = compare_ends a.least b.least <?> fun () -> compare_ends a.most b.most
let is_known v = Option.equal Linear.equal v.least v.most

(* {1 The ends on a set} *)

let of_bound : Polyhedron.bound option -> Rat.t = function
  | Some (Bound { value; _ }) -> value
  | Some Unbounded | None -> Scc_base.Bug.fail __POS__ "a part is bounded and not empty"

let over_pieces end_ best { value; set } =
  let on_piece form p = of_bound (end_ p form) in
  let over form =
    match List.map (on_piece form) (Union.pieces set) with
    | [] -> Scc_base.Bug.fail __POS__ "a part without points"
    | first :: rest -> List.fold_left best first rest
  in
  fun of_value -> Option.map over (of_value value)

let ends_of part =
  {
    low = over_pieces Polyhedron.infimum Rat.min part (fun v -> v.least);
    high = over_pieces Polyhedron.supremum Rat.max part (fun v -> v.most);
  }

(* {1 Making} *)

(* On a piece without volume a form may be a constant. *)
let simplified (p, { least; most }) =
  let of_end form =
    match (Polyhedron.infimum p form, Polyhedron.supremum p form) with
    | Some (Bound { value = low; _ }), Some (Bound { value = high; _ }) when Rat.equal low high ->
      Linear.constant (Linear.dimension form) low
    | _ -> form
  in
  let flat = Polyhedron.affine_dimension p < Polyhedron.dimension p in
  (p, if flat then { least = Option.map of_end least; most = Option.map of_end most } else { least; most })

(* Parts with constants are in the order of their values, and all others in that of what they begin with. *)
let make ranges ?(unknown = []) pieces =
  let pieces = List.map simplified pieces in
  let by_value = List.stable_sort (fun (_, a) (_, b) -> compare_values a b) pieces in
  let add parts (p, value) =
    match parts with
    | (other, sets) :: rest when compare_values other value = 0 -> (other, p :: sets) :: rest
    | _ -> (value, [ p ]) :: parts
  in
  let n = Array.length ranges in
  let part (value, sets) = { value; set = Where.tidy (Union.of_polyhedra n (List.rev sets)) } in
  let parts = List.rev_map part (List.fold_left add [] by_value) in
  let infinite_last a b =
    match (a, b) with
    | None, None -> 0
    | None, Some _ -> 1
    | Some _, None -> -1
    | Some x, Some y -> Rat.compare x y
  in
  let by_ends (a, _) (b, _) = infinite_last a.low b.low <?> fun () -> infinite_last a.high b.high in
  {
    ranges;
    parts = List.map snd (List.stable_sort by_ends (List.map (fun p -> (ends_of p, p)) parts));
    unknown = Where.tidy (Union.of_polyhedra n unknown);
  }

let known_everywhere t = Union.is_empty t.unknown

let extremes t =
  match List.map ends_of t.parts with
  | [] -> Scc_base.Bug.fail __POS__ "a function without a value"
  | first :: rest ->
    let lower a b = match (a, b) with Some x, Some y -> Some (Rat.min x y) | x, None | None, x -> x in
    let higher a b = match (a, b) with Some x, Some y -> Some (Rat.max x y) | None, _ | _, None -> None in
    let widen a b = { low = lower a.low b.low; high = higher a.high b.high } in
    List.fold_left widen first rest

(* {1 The mean} *)

type mean = Between of ends | Not_known of Rat.t | Not_computed

let volume (ranges : Ranges.t) =
  let width (r : Ranges.range) = Rat.sub r.high.value r.low.value in
  Array.fold_left (fun product r -> Rat.mul product (width r)) Rat.one ranges

(* Over a polyhedron: its volume times the least value, and the volume between that and the form. *)
let integral p form =
  let n = Polyhedron.dimension p in
  let least = of_bound (Polyhedron.infimum p form) in
  let here = Where.measure (Union.of_polyhedron p) in
  if Linear.is_constant form then Option.map (Rat.mul least) here
  else
    let lifted = Linear.compose form ~dimension:(n + 1) (Array.init n (Linear.variable (n + 1))) in
    let height = Linear.variable (n + 1) n in
    let above = Constraint.at_least height (Linear.constant (n + 1) least) in
    let under = Constraint.at_most height lifted in
    let column = Polyhedron.embed p ~dimension:(n + 1) (Array.init n Fun.id) in
    match (here, Where.measure (Union.of_polyhedron (Polyhedron.add_all column [ above; under ]))) with
    | Some here, Some more -> Some (Rat.add (Rat.mul least here) more)
    | None, _ | _, None -> None

let of_set set form =
  let add sum p =
    match (sum, integral p form) with Some x, Some y -> Some (Rat.add x y) | None, _ | _, None -> None
  in
  List.fold_left add (Some Rat.zero) (Union.pieces set)

(* A part without volume does not count, not even where the value is infinite. *)
let mean_of_parts t ~whole =
  let plus set sum form =
    match (sum, form) with
    | None, _ | _, None -> Some None
    | Some sum, Some form -> Option.map (fun x -> Some (Rat.add sum (Rat.div x whole))) (of_set set form)
  in
  let add sum { value; set } =
    match (sum, Where.measure set) with
    | None, _ | _, None -> None
    | Some ends, Some v when Rat.sign v = 0 -> Some ends
    | Some { low; high }, Some _ -> (
        match (plus set low value.least, plus set high value.most) with
        | Some low, Some high -> Some { low; high }
        | None, _ | _, None -> None)
  in
  List.fold_left add (Some { low = Some Rat.zero; high = Some Rat.zero }) t.parts

let mean t =
  let whole = volume t.ranges in
  match Where.measure t.unknown with
  | None -> Not_computed
  | Some v when Rat.sign v > 0 -> Not_known (Rat.div v whole)
  | Some _ -> Option.fold ~none:Not_computed ~some:(fun ends -> Between ends) (mean_of_parts t ~whole)

let same_set u v = List.equal Polyhedron.equal (Union.pieces u) (Union.pieces v)

let equal a b =
  let same p q = compare_values p.value q.value = 0 && same_set p.set q.set in
  List.equal same a.parts b.parts && same_set a.unknown b.unknown

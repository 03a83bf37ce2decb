open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_state_sets

(* What a leaf is told by: what is discrete first, then the bounds of its coordinates and age over the zone, which
   depend on no name either, and in the end the forms as they are, which may. *)
type key = {
  leaf : int;
  process : State.process;
  behaviour : Behaviour.aged;
  numbers : Linear.t list;
  bounds : (Polyhedron.bound option * Polyhedron.bound option) list Lazy.t;
}

let bounds (z : Zone.t) form =
  if Linear.is_constant form then
    let value = Some (Polyhedron.Bound { value = form.Linear.constant; attained = true }) in
    (value, value)
  else (Polyhedron.infimum z.set form, Polyhedron.supremum z.set form)

let key (z : Zone.t) (process : State.process) (l : State.leaf) =
  let numbers = Place.coordinates z.places.(l.leaf) @ [ z.ages.(l.leaf) ] in
  { leaf = l.leaf; process; behaviour = l.behaviour; numbers; bounds = lazy (List.map (bounds z) numbers) }

let compare_bound (a : Polyhedron.bound option) (b : Polyhedron.bound option) =
  match (a, b) with
  | Some (Bound a), Some (Bound b) -> Rat.compare a.value b.value
  | Some (Bound _), (Some Unbounded | None) -> -1
  | (Some Unbounded | None), Some (Bound _) -> 1
  | (Some Unbounded | None), (Some Unbounded | None) -> 0

let compare_bounds (low, high) (low', high') =
  compare_bound low low' <?> fun () -> compare_bound high high'

let compare a b =
  let orders =
    [
      (fun () -> Int.compare (Array.length a.process.leaves) (Array.length b.process.leaves));
      (fun () -> Vec.compare a.process.velocity b.process.velocity);
      (fun () -> Behaviour.compare_aged a.behaviour b.behaviour);
      (fun () -> List.compare compare_bounds (Lazy.force a.bounds) (Lazy.force b.bounds));
      (fun () -> List.compare Linear.compare a.numbers b.numbers);
      (fun () -> Int.compare a.leaf b.leaf);
    ]
  in
  List.fold_left (fun c order -> if c <> 0 then c else order ()) 0 orders

let image ~classes (z : Zone.t) =
  if classes = [] then None
  else begin
    let image = Array.init (Array.length z.places) Fun.id in
    let keys = Array.make (Array.length z.places) None in
    let put (p : State.process) =
      Array.iter (fun (l : State.leaf) -> keys.(l.leaf) <- Some (key z p l)) p.leaves
    in
    Array.iter put z.skeleton.processes;
    let of_class members =
      let present = List.sort compare (List.filter_map (fun leaf -> keys.(leaf)) members) in
      let gone = List.filter (fun leaf -> Option.is_none keys.(leaf)) members in
      let order = List.map (fun k -> k.leaf) present @ gone in
      List.iter2 (fun leaf name -> image.(leaf) <- name) order members
    in
    List.iter of_class classes;
    let moves = ref false in
    Array.iteri (fun leaf name -> if leaf <> name then moves := true) image;
    if !moves then Some image else None
  end

open Scc_data
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets

type t = { owner : int array;  (** the process of each leaf, or -1 *) groups : Union_find.t }

let of_leaf t leaf = Union_find.find t.groups t.owner.(leaf)

let hidden t ~visible group =
  let rec from leaf =
    leaf >= Array.length t.owner
    || ((t.owner.(leaf) < 0 || of_leaf t leaf <> group || not (visible leaf)) && from (leaf + 1))
  in
  from 0

let may_touch (c : Instant.context) region ((a : Instant.part), (b : Instant.part)) =
  let facets = Half_space.still (c.obstacle a.solid b.solid) (Instant.offset a b) in
  not (Polyhedron.is_empty (Polyhedron.add_all region (Half_space.contact facets)))

let make (c : Instant.context) (z : Zone.t) region =
  let m = Semantics.model c.semantics in
  let processes = z.skeleton.processes in
  let owner = Array.make (Array.length m.leaves) (-1) in
  let own i (p : State.process) = Array.iter (fun (l : State.leaf) -> owner.(l.leaf) <- i) p.leaves in
  Array.iteri own processes;
  let t = { owner; groups = Union_find.create (Array.length processes) } in
  let join ((a : Instant.part), (b : Instant.part)) =
    if of_leaf t a.leaf <> of_leaf t b.leaf && may_touch c region (a, b) then
      ignore (Union_find.union t.groups owner.(a.leaf) owner.(b.leaf))
  in
  List.iter join (Instant.pairs m z);
  t

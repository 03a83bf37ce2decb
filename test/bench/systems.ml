(* Microseconds for each question to lib/solids/polyhedra, on systems like those of symbolic runs: 14 constraints
   over 5 variables, half of them with a point in common. *)

open Scc_polyhedra

let between state low high = low + Random.State.int state (high - low + 1)

let system state =
  let n = 5 and feasible = between state 0 1 = 0 in
  let point = Array.init n (fun _ -> between state (-3) 3) in
  let constraint_ _ =
    let normal = Array.init n (fun _ -> if between state 0 1 = 0 then 0 else between state (-3) 3) in
    let there = Array.fold_left ( + ) 0 (Array.map2 ( * ) normal point) in
    let slack = if feasible then between state 1 6 else between state (-3) 4 in
    let relation : Constraint.relation = if between state 0 2 = 0 then Less else At_most in
    Constraint.make (Array.map Z.of_int normal) relation (Z.of_int (there + slack))
  in
  List.init 14 constraint_

let measure what items f =
  let started = Unix.gettimeofday () in
  List.iter (fun x -> ignore (Sys.opaque_identity (f x))) items;
  let seconds = Unix.gettimeofday () -. started in
  Printf.printf "%-28s %10.1f us\n%!" what (1e6 *. seconds /. float_of_int (List.length items))

let () =
  let state = Random.State.make [| 1 |] in
  let systems = List.init 4000 (fun _ -> system state) in
  let make = Polyhedron.of_constraints 5 in
  let some = List.filter (fun p -> not (Polyhedron.is_empty p)) (List.map make systems) in
  Printf.printf "%d of %d have a point\n" (List.length some) (List.length systems);
  measure "empty, from constraints" systems (fun s -> Polyhedron.is_empty (make s));
  measure "one constraint more" some (fun p -> Polyhedron.add p (List.hd (List.hd systems)));
  measure "minimal form" some Polyhedron.constraints;
  let pairs = List.combine (List.tl some) (List.rev (List.tl (List.rev some))) in
  measure "inclusion" pairs (fun (p, q) -> Polyhedron.included p q);
  measure "inclusion in itself" some (fun p -> Polyhedron.included p (Polyhedron.minimal p));
  measure "interior point" some Polyhedron.interior_point;
  measure "difference" pairs (fun (p, q) -> Difference.pieces p q);
  let few = List.filteri (fun i _ -> i < 100) some in
  measure "projection of 5 onto 4" few (fun p -> Polyhedron.project p [| 0; 1; 2; 3 |]);
  let bounded p = Polyhedron.inter p (Polyhedron.box (Array.make 5 (Q.of_int (-5), Q.of_int 5))) in
  measure "volume, 24 constraints" (List.filteri (fun i _ -> i < 3) (List.map bounded few)) Volume.of_polyhedron

open Scc_exact
open Scc_polyhedra
open Chance_tree

type mode = { choice : [ `Least | `Greatest ]; chance : [ `Mean | `Least | `Greatest ] }

let known q : Piecewise.value = { least = q; most = q }

(* What an inclusion already says need not be tested again. *)
let new_constraints ~within set =
  let known = Polyhedron.constraints within in
  List.filter (fun c -> not (List.exists (Constraint.equal c) known)) (Polyhedron.constraints set)

(* The least or greatest of all values that a function over one more variable has on a set. As it has finitely
   many values, one of them is attained. *)
let over_last space choice set f =
  let n = Polyhedron.dimension set - 1 in
  let pieces = List.filter_map (fun (p, v) -> Option.map (fun v -> (p, v)) v) (Piecewise.pieces set f) in
  let by_end (end_ : Piecewise.value -> Rat.t) =
    let compare (_, v) (_, w) = Rat.compare (end_ v) (end_ w) in
    let sorted = List.stable_sort compare pieces in
    let best_first = match choice with `Least -> sorted | `Greatest -> List.rev sorted in
    let add found (p, v) =
      let there = Polyhedron.constraints (Polyhedron.project p (Array.init n Fun.id)) in
      Piecewise.first space found (Piecewise.within space there (Piecewise.constant space (known (end_ v))))
    in
    List.fold_left add (Piecewise.nowhere space) best_first
  in
  Piecewise.ends space (by_end (fun v -> v.least)) (by_end (fun v -> v.most))

let rec of_tree space mode ~within tree =
  let of_ = of_tree space mode in
  let constant least most = Piecewise.constant space { least; most } in
  let better side = match side with `Least -> Piecewise.least space | `Greatest -> Piecewise.greatest space in
  match tree with
  | Won -> constant Rat.one Rat.one
  | Lost -> constant Rat.zero Rat.zero
  | Open -> constant Rat.zero Rat.one
  | Perhaps trees ->
    let values = List.map (of_ ~within) trees in
    let by choose = List.fold_left (choose space) (Piecewise.nowhere space) values in
    Piecewise.ends space (by Piecewise.least) (by Piecewise.greatest)
  | Is _ | Gain _ -> Scc_base.Bug.fail __POS__ "a probability of a mean"
  | Cells all -> of_cells space mode ~within all
  | Drawn ways -> (
      let ways = List.map (fun (chance, tree) -> (chance, of_ ~within tree)) ways in
      match mode.chance with
      | `Mean -> Piecewise.sum space ways
      | (`Least | `Greatest) as side ->
        List.fold_left (fun best (_, f) -> better side best f) (Piecewise.nowhere space) ways)
  | Free options ->
    let option best (set, tree) =
      let f = Piecewise.within space (new_constraints ~within set) (of_ ~within:set tree) in
      better mode.choice best f
    in
    List.fold_left option (Piecewise.nowhere space) options
  | Stopping (set, tree) -> over_last space mode.choice set (of_ ~within:set tree)
  | Later { node; set; forms } ->
    let holds (s, _) = s == set || Polyhedron.included set s in
    (match List.find_opt holds node.values with
     | Some (_, f) -> Piecewise.preimage space ~dimension:(Polyhedron.dimension within) forms set f
     | None -> constant Rat.zero Rat.one)

(* The last one needs no test. *)
and of_cells space mode ~within = function
  | [] -> Piecewise.nowhere space
  | [ (set, tree) ] -> of_tree space mode ~within:set tree
  | (set, tree) :: rest ->
    let here = Piecewise.within space (new_constraints ~within set) (of_tree space mode ~within:set tree) in
    Piecewise.first space here (of_cells space mode ~within rest)

let solve ?most ~progress graph mode ~parameters =
  let space = Piecewise.space () in
  let of_node node =
    node.values <- List.map (fun (set, tree) -> (set, of_tree space mode ~within:set tree)) node.trees
  in
  let forget_all = Chance_graph.solve ?most ~progress graph ~forget:(fun node -> node.values <- []) ~of_node in
  let within = Polyhedron.universe parameters in
  let root = of_tree space mode ~within (Chance_graph.root graph) in
  forget_all ();
  root

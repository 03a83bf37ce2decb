open Scc_exact
open Scc_polyhedra
open Chance_tree

type mode = { choice : [ `Least | `Greatest ]; unknown : [ `Least | `Greatest ] }

let is_constant (_, v) =
  match v with
  | Some (Affine.Finite f) -> Linear.is_constant f
  | Some (Infinite | Unknown) | None -> true

(* The least or greatest value that a function over one more variable has on a set. It is constant on pieces, so
   that one of its values is attained. *)
let over_last space better set f =
  let n = Polyhedron.dimension set - 1 in
  let add found (p, v) =
    let there = Polyhedron.constraints (Polyhedron.project p (Array.init n Fun.id)) in
    let here : Affine.value =
      match v with
      | Affine.Finite f -> Finite (Linear.constant n f.Linear.constant)
      | (Infinite | Unknown) as v -> v
    in
    better found (Affine.within space there (Affine.constant space here))
  in
  let pieces = Affine.pieces set f in
  if not (List.for_all is_constant pieces) then Scc_base.Bug.fail __POS__ "a mean that depends on an instant";
  List.fold_left add (Affine.nowhere space) (List.filter_map (fun (p, v) -> Option.map (fun v -> (p, v)) v) pieces)

(* The values of runs that are over: with the goal, without it, and where that is not known. *)
type ends = { won : Affine.value option; lost : Affine.value; unknown : Affine.value }

let rec of_tree space mode ends ~within tree =
  let of_ = of_tree space mode ends in
  let dimension = Polyhedron.dimension within in
  let better = match mode.choice with `Least -> Affine.least space | `Greatest -> Affine.greatest space in
  let zero = Affine.Finite (Linear.constant dimension Rat.zero) in
  match tree with
  | Won -> Affine.constant space (Option.value ends.won ~default:zero)
  | Lost -> Affine.constant space ends.lost
  | Open -> (
      match mode.unknown with
      | `Least -> Affine.constant space (Option.value ends.won ~default:zero)
      | `Greatest -> Affine.constant space ends.unknown)
  | Perhaps trees ->
    let choose = match mode.unknown with `Least -> Affine.least space | `Greatest -> Affine.greatest space in
    List.fold_left (fun f tree -> choose f (of_ ~within tree)) (Affine.nowhere space) trees
  | Is form -> Affine.constant space (Finite form)
  | Gain { least; most; tree } ->
    let gain = match mode.unknown with `Least -> least | `Greatest -> most in
    Affine.plus space gain (of_ ~within tree)
  | Cells all -> of_cells space mode ends ~within all
  | Drawn ways -> Affine.sum space ~dimension (List.map (fun (chance, tree) -> (chance, of_ ~within tree)) ways)
  | Free options ->
    let option best (set, tree) =
      better best (Affine.within space (Chance_value.new_constraints ~within set) (of_ ~within:set tree))
    in
    List.fold_left option (Affine.nowhere space) options
  | Stopping (set, tree) -> over_last space better set (of_ ~within:set tree)
  | Later { node; set; forms } ->
    let holds (s, _) = s == set || Polyhedron.included set s in
    (match List.find_opt holds node.means with
     | Some (_, f) -> Affine.preimage space ~dimension forms set f
     | None -> of_ ~within Open)

(* The last one needs no test. *)
and of_cells space mode ends ~within = function
  | [] -> Affine.nowhere space
  | [ (set, tree) ] -> of_tree space mode ends ~within:set tree
  | (set, tree) :: rest ->
    let constraints = Chance_value.new_constraints ~within set in
    let here = Affine.within space constraints (of_tree space mode ends ~within:set tree) in
    Affine.first space here (of_cells space mode ends ~within rest)

let ends graph =
  match (Chance_graph.question graph).wanted with
  | Value_at _ -> { won = Some Unknown; lost = Unknown; unknown = Unknown }
  | Chance | Time | Happenings _ -> { won = None; lost = Infinite; unknown = Infinite }

let solve ?most ~progress graph mode ~parameters =
  let space = Affine.space () and ends = ends graph in
  let of_node node =
    node.means <- List.map (fun (set, tree) -> (set, of_tree space mode ends ~within:set tree)) node.trees
  in
  let forget_all = Chance_graph.solve ?most ~progress graph ~forget:(fun node -> node.means <- []) ~of_node in
  let within = Polyhedron.universe parameters in
  let root = of_tree space mode ends ~within (Chance_graph.root graph) in
  forget_all ();
  root

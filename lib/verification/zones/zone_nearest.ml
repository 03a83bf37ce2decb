open Scc_polyhedra
open Scc_symbolic
open Scc_verify

(* So many are asked, where there are parameters. *)
let most = 2_000

let unexpanded graph =
  let rec from i found =
    if i < 0 then found
    else
      let node = Zone_graph.node graph i in
      from (i - 1) (if node.expanded then found else node :: found)
  in
  from (Zone_graph.size graph - 1) []

let matters unknown (node : Zone_graph.node) =
  let values () = Union.of_polyhedron (Polyhedron.image node.zone.set node.zone.parameters) in
  Union.dimension unknown = 0 || not (Union.is_empty (Union.inter unknown (values ())))

let place (node : Zone_graph.node) =
  { Search_sets.node; states = node.zone.set; passing = false; prop = And [] }

let reason lost semantics u ~declared ~sliced graph ~unknown =
  let find () =
    let all = unexpanded graph in
    if Union.dimension unknown > 0 && List.compare_length_with all most > 0 then None
    else
      match List.filter (matters unknown) all with
      | [] -> None
      | first :: _ as left ->
        let run values = Concrete.run_within graph (place first) values in
        let shown run = Zone_witness.make semantics u ~declared ~sliced run (place first) in
        let nearest () = Option.map shown (List.find_map run (Union.pieces unknown)) in
        Lost.run lost semantics nearest
        |> Option.map (fun nearest -> Verdict.Unexplored { count = List.length left; nearest })
  in
  Option.join (Lost.attempt lost find)

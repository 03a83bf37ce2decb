open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets
open Scc_symbolic
open Scc_zones

let place (m : Model.t) ~name (z : Zone.t) leaf =
  let form = Text.form ~name in
  let x, y, z = z.places.(leaf) in
  Printf.sprintf "%s at (%s, %s, %s)" m.leaves.(leaf).name (form x) (form y) (form z)

let moving (m : Model.t) (z : Zone.t) =
  List.concat_map State.members (Array.to_list z.skeleton.processes)
  |> List.filter (fun leaf -> not m.leaves.(leaf).fixed)

let where ~name prefix p =
  if Polyhedron.is_universe p then [] else [ prefix ^ Text.polyhedron ~name p ]

let node put (s : Zone_space.t) digest ~positions (n : Zone_graph.node) =
  let m = Zone_space.model s in
  let z = n.zone in
  let name = Zone_names.variable m z in
  let rests = Zone_space.rests n in
  let all = List.exists (fun p -> Polyhedron.included z.set p) rests in
  let rest p = "at rest where " ^ Text.polyhedron ~name p in
  let lines =
    [ string_of_int n.number ]
    @ State_digest.lines digest n.number
    @ (if positions then List.map (place m ~name z) (moving m z) else [])
    @ where ~name "" z.set
    @ if all then [] else List.map rest rests
  in
  let styles = (if n.expanded then [] else [ "dashed" ]) @ if z.halted && n.expanded then [ "dotted" ] else [] in
  let style = match styles with [] -> "" | _ :: _ -> ", style=" ^ String.concat "," styles in
  let border = if rests <> [] then ", peripheries=2" else "" in
  put (Printf.sprintf "  z%d [label=%s%s%s]\n" n.number (Dot.quoted lines) style border)

let edge put (s : Zone_space.t) (n : Zone_graph.node) (e : Zone_graph.edge) =
  let m = Zone_space.model s in
  let name = Zone_names.variable m n.zone in
  let label, colour =
    match e.step with
    | Happens l -> (Transition.label_to_string m l, "")
    | Passes f -> (Printf.sprintf "time(%s)" (Text.form ~name f), ", color=gray")
    | Passes_some -> ("time(time passed)", ", color=gray")
  in
  let everywhere =
    Polyhedron.dimension e.guard = Zone.dimension n.zone && Polyhedron.included n.zone.set e.guard
  in
  let lines = label :: (if everywhere then [] else where ~name "where " (Polyhedron.minimal e.guard)) in
  put (Printf.sprintf "  z%d -> z%d [label=%s%s]\n" n.number e.target (Dot.quoted lines) colour)

let write (e : Zone_exported.t) ~positions put =
  let s = e.space in
  let m = Zone_space.model s in
  let size = Zone_graph.size s.graph in
  let skeleton i = (Zone_graph.node s.graph i).zone.skeleton in
  let digest = State_digest.make ~positions:false m ~size skeleton in
  let each f =
    for i = 0 to size - 1 do
      f (Zone_graph.node s.graph i)
    done
  in
  put (Printf.sprintf "digraph %s {\n" (Dot.quoted [ Option.value e.loaded.origin.name ~default:"model" ]));
  put "  node [shape=box, fontname=\"Helvetica\", fontsize=10]\n";
  put "  edge [fontname=\"Helvetica\", fontsize=9]\n";
  put "  start [shape=point]\n";
  let roots = Zone_space.roots s in
  List.iter (fun i -> put (Printf.sprintf "  start -> z%d\n" i)) roots;
  each (fun n ->
      node put s digest ~positions n;
      List.iter (edge put s n) n.edges);
  let some f =
    let found = ref false in
    each (fun n -> if f n then found := true);
    !found
  in
  let told f text = if some f then [ text ] else [] in
  let legend =
    Zone_exported.summary e
    @ told
      (fun n -> Zone_space.rests n <> [])
      "double border: nothing need happen any more, from all of it or where told"
    @ told (fun (n : Zone_graph.node) -> n.zone.halted) "dotted: time is halted for a split"
    @ told (fun (n : Zone_graph.node) -> not n.expanded) "dashed: not explored further"
    @ [ "gray: time passes" ]
  in
  put (Printf.sprintf "  legend [shape=plain, label=%s]\n" (Dot.quoted legend));
  put "}\n"

open Scc_data

type way = Reached | Lost | Passes

let ways (graph : Timed_graph.t) ~f ~g =
  let look s =
    match Timed_graph.flow graph s with
    | No_flow -> '\000'
    | (Lasts _ | Forever) as flow -> (
        match (Flow.entering ~f:(Positions.along f s) ~g:(Positions.along g s), flow) with
        | Reached _, _ -> '\001'
        | Passes, Lasts _ -> '\002'
        | Lost _, _ | Passes, (No_flow | Forever) -> '\000')
  in
  let ways = Bytes.init graph.size look in
  fun s -> match Bytes.get ways s with '\000' -> Lost | '\001' -> Reached | _ -> Passes

(* The set that is x at nodes, with f until g followed inside their flows to what x is at their ends. *)
let along_flows (graph : Timed_graph.t) ~join ~f ~g x =
  let along s =
    let ending =
      match Timed_graph.flow graph s with
      | Lasts (_, targets) -> join x targets
      | No_flow | Forever -> false
    in
    Flow.inside ~f:(Positions.along f s) ~g:(Positions.along g s) ending
  in
  Positions.make graph ~at:x ~along

let some index ~generous ~f ~g =
  let graph = Timed_graph.graph index in
  let way = ways graph ~f ~g in
  let w = Worklist.create graph.size in
  for s = 0 to graph.size - 1 do
    if Positions.at g s then Worklist.add w s
    else if Positions.at f s then
      if not (graph.known s) then (if generous then Worklist.add w s)
      else match way s with Reached -> Worklist.add w s | Lost | Passes -> ()
  done;
  Worklist.run w (fun t ->
      Timed_graph.iter_sources index t (fun s timed ->
          if (not (Worklist.mem w s)) && Positions.at f s then
            if not timed then Worklist.add w s
            else match way s with Passes -> Worklist.add w s | Reached | Lost -> ()));
  along_flows graph ~join:Array.exists ~f ~g (Worklist.mem w)

let successors graph way s =
  match (Timed_graph.flow graph s, way s) with
  | Lasts (_, targets), Passes -> Array.append (Timed_graph.edges graph s) targets
  | _ -> Timed_graph.edges graph s

(* [left] counts the ways of a node on which f until g is not known yet. A node on a cycle keeps some: the run that
   goes round for ever has no g. *)
let every index ~generous ~f ~g =
  let graph = Timed_graph.graph index in
  let way = ways graph ~f ~g in
  let w = Worklist.create graph.size in
  let left = Int_array.make graph.size (-1) in
  for s = 0 to graph.size - 1 do
    if Positions.at g s then Worklist.add w s
    else if Positions.at f s then
      if not (graph.known s) then (if generous then Worklist.add w s)
      else if not (Timed_graph.is_dead_end graph s) then begin
        let flow = graph.flow s in
        let edges = Array.length (graph.edges s) in
        let timed = Array.length (Timed_graph.targets flow) in
        let wait n = if n = 0 then Worklist.add w s else Int_array.set left s n in
        match (flow, way s) with
        | No_flow, _ | _, Reached -> wait edges
        | _, Passes -> wait (edges + timed)
        | _, Lost -> ()
      end
  done;
  Worklist.run w (fun t ->
      Timed_graph.iter_sources index t (fun s timed ->
          let n = Int_array.get left s in
          let counts = (not timed) || match way s with Passes -> true | Reached | Lost -> false in
          if n > 0 && counts then begin
            Int_array.set left s (n - 1);
            if n = 1 then Worklist.add w s
          end));
  along_flows graph ~join:Array.for_all ~f ~g (Worklist.mem w)

let next index ~generous f =
  let graph = Timed_graph.graph index in
  let w = Worklist.create graph.size in
  for s = 0 to graph.size - 1 do
    if graph.known s then begin
      if Array.exists (Positions.at f) (graph.edges s) then Worklist.add w s
    end
    else if generous then Worklist.add w s
  done;
  Worklist.run w (fun t -> Timed_graph.iter_sources index t (fun s timed -> if timed then Worklist.add w s));
  let along s =
    Pieces.constant (Array.exists (Worklist.mem w) (Timed_graph.targets (Timed_graph.flow graph s)))
  in
  Positions.make graph ~at:(Worklist.mem w) ~along

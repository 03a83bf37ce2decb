open Scc_calculus
open Scc_symbolic
open Scc_verify

(* Zones expanded last, and the fewest that tell something. *)
let window = 128
let fewest = 12

let resources (t : Verdict.truncation) =
  match t.limit with
  | Depth _ | States _ | Draws _ | Seconds _ | Memory _ | Interrupted -> true
  | Time _ | Instant _ | Bits _ | Omission _ -> false

let waits (node : Zone_graph.node) =
  let is_tick : Passing.due -> bool = function
    | Split_instant _ -> true
    | Contact _ | Expiry _ | Step_end | Lots -> false
  in
  List.exists (fun (c : Passing.due First.cell) -> c.due <> [] && List.for_all is_tick c.due) node.cells

let find (m : Model.t) (e : Zone_explored.t) =
  match m.splits with
  | Every step when List.exists resources e.stopped_by ->
    let all = List.init (Zone_graph.size e.graph) (fun i -> Zone_graph.node e.graph i) in
    let expanded = List.filter (fun (n : Zone_graph.node) -> n.expanded) all in
    let by_depth (a : Zone_graph.node) (b : Zone_graph.node) = Int.compare b.depth a.depth in
    let last = Scc_data.Lists.take window (List.stable_sort by_depth expanded) in
    let of_ = List.length last and states = List.length (List.filter waits last) in
    if of_ >= fewest && 3 * states >= of_ then [ Growth.Grid { states; of_; step } ] else []
  | Every _ | Any_time -> []

(* The evaluator against the naive one, on random small graphs and formulas. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
module Gen = QCheck2.Gen

type case = { graph : Small.t; formula : Timed_formula.t }

let print c = Small.print c.graph ^ "\n" ^ Small.print_formula c.formula

let case_gen ~unsure ~truncated ~depth =
  let open Gen in
  let* graph = Small.gen ~unsure ~truncated in
  let* formula = Small.formula_gen graph.unit depth in
  return { graph; formula }

let agrees (a : Naive.answer) truth =
  match truth with
  | Some true -> a.surely && a.perhaps
  | Some false -> (not a.surely) && not a.perhaps
  | None -> a.perhaps && not a.surely

(* At every node, and in every cell of every flow. *)
let same c =
  let e = Small.evaluator c.graph and naive = Naive.make c.graph in
  let node s (x : Small.node) =
    agrees (Naive.node naive c.formula s) (Eval.truth e c.formula (Positions.start s))
    && ((not x.known)
        || List.for_all
          (fun i ->
             agrees (Naive.cell naive c.formula s i)
               (Eval.truth e c.formula { node = s; offset = Small.offset c.graph i }))
          (List.init (Small.cells x) Fun.id))
  in
  List.for_all Fun.id (Array.to_list (Array.mapi node c.graph.nodes))

let exact name ~unsure ~truncated ~depth count =
  QCheck2.Test.make ~count ~name ~print (case_gen ~unsure ~truncated ~depth) same

(* What is said of a truncated graph is so however it goes on. *)
let sound =
  let gen =
    let open Gen in
    let* c = case_gen ~unsure:false ~truncated:true ~depth:2 in
    let* others = list_repeat 4 (Small.complete c.graph) in
    return (c, others)
  in
  let print (c, others) = String.concat "\n\n" (print c :: List.map Small.print others) in
  QCheck2.Test.make ~count:400 ~name:"what is decided on a truncated graph stays so" ~print gen
    (fun (c, others) ->
       let e = Small.evaluator c.graph in
       let whole = List.map Naive.make others in
       let node s =
         match Eval.truth e c.formula (Positions.start s) with
         | None -> true
         | Some v ->
           List.for_all
             (fun naive ->
                let a = Naive.node naive c.formula s in
                if v then a.surely else not a.perhaps)
             whole
       in
       List.for_all node (List.init (Array.length c.graph.nodes) Fun.id))

(* Nodes that are met only after the horizon may as well not be known. *)
let arrivals (g : Small.t) =
  let times = Array.make (Array.length g.nodes) None in
  let rec reach s time =
    match times.(s) with
    | Some t when t <= time -> ()
    | Some _ | None -> (
        times.(s) <- Some time;
        List.iter (fun t -> reach t time) g.nodes.(s).edges;
        match g.nodes.(s).flow with
        | Lasts (d, targets) -> List.iter (fun t -> reach t (time + d)) targets
        | No_flow | Ray _ -> ())
  in
  reach 0 0;
  times

let horizon =
  QCheck2.Test.make ~count:600 ~name:"nothing counts after the horizon" ~print
    (case_gen ~unsure:false ~truncated:false ~depth:2)
    (fun c ->
       let formula = Scc_property.Skeleton.to_temporal (fun _ -> Scc_property.Property.Bool true) c.formula in
       match Scc_property.Plan.latest_horizon [ formula ] with
       | None -> true
       | Some h ->
         let times = arrivals c.graph in
         let in_time s =
           match times.(s) with
           | None -> false
           | Some t -> Rat.compare (Rat.mul c.graph.unit (Rat.of_int t)) h <= 0
         in
         let cut s (x : Small.node) = { x with known = in_time s } in
         let short = { c.graph with nodes = Array.mapi cut c.graph.nodes } in
         let truth g = Eval.truth (Small.evaluator g) c.formula (Positions.start 0) in
         Option.equal Bool.equal (truth c.graph) (truth short))

let suite =
  ("ctl",
   [
     ( "random graphs",
       Scc_test_support.Property.cases
         [
           exact "one operator" ~unsure:false ~truncated:false ~depth:1 4000;
           exact "nested operators" ~unsure:false ~truncated:false ~depth:3 3000;
           exact "undecided predicates" ~unsure:true ~truncated:false ~depth:2 2000;
           exact "truncated graphs" ~unsure:true ~truncated:true ~depth:2 2000;
           sound;
           horizon;
         ] );
   ])
